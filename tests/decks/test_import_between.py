#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""barreno import-ups says what bodies of Uintah do to each other without a word in the file: they pass through each other where no
contact holds, and heat flows between them.

    test_import_between.py BARRENO
"""
import pathlib
import tempfile

from test_import_losses import Folder, face, material, piece, told, ups


def temperature(value):
    return f"<temperature>{value}</temperature>"


def check_heat(folder):
    """Uintah conducts heat unless the file says no: it flows where temperatures differ."""
    warm = material(objects=piece("a", extra=temperature(300)) + piece("c", extra=temperature(100), left=0.6))
    folder.incomplete(ups(warm), "several temperatures, from 100 to 300, is left out")
    folder.valid(ups(warm, "<DoExplicitHeatConduction>false</DoExplicitHeatConduction>"))
    hot = '<BCType id="all" label="Temperature" var="Dirichlet"><value>{}</value></BCType>'
    one = material(objects=piece("a", extra=temperature(300)))
    folder.valid(ups(one, faces=face("x-", hot.format(300))), "BCType Dirichlet Temperature")
    answer = folder.run(ups(one, faces=face("x-", hot.format(500))))
    assert "from 300 to 500, is left out" in answer and "Dirichlet" not in answer and "geom_object/temperature" not in answer, answer


def check_free_pairs(folder):
    """Materials without a contact between them pass through each other in Uintah."""
    one, other, third = material(), material("Other", objects=piece("c", left=0.6)), material("Third",
        objects=piece("d").replace("[0.2, 0.2,", "[0.2, 0.7,").replace(", 0.6, ", ", 0.9, "))
    none = ups(one + other).replace(told("single_velocity"), "")
    folder.incomplete(none,
        "No contact of the file holds for Block and Other: in Uintah they pass through each other, in the deck they stick")
    rubs = told("friction", mu=0.3, materials="[0, 1]")
    folder.incomplete(ups(one + other + third + rubs), "No contact of the file holds for Block and Third; Other and Third: in Uintah")
    folder.valid(ups(one + other + third + rubs + told("single_velocity", materials="[0, 2]")
        + told("single_velocity", materials="[1, 2]")))
    moved = told("specified", direction="[1, 1, 1]", master_material=0)
    folder.incomplete(ups(one + other + third + moved), "No contact of the file holds for Other and Third: in Uintah")
    folder.valid(ups(one + told("null", materials="[0, 1, 2]", stop_time="999999.9")),
        "A contact names materials that the file does not have (1, 2; it has 1, counted from 0)")


def main():
    for check in (check_heat, check_free_pairs):
        with tempfile.TemporaryDirectory() as name:
            check(Folder(pathlib.Path(name)))
    print("what bodies do to each other is in the remarks")


if __name__ == "__main__":
    main()
