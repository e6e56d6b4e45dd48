#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Both readers of tables, that of decks and `drive` and that of `fit`, read one table alike in all forms that spreadsheets and laboratories
write, and refuse alike what they cannot know: test_table_variants.py BARRENO."""

import pathlib
import subprocess
import sys
import tempfile

import numpy
from table_variants import form_of, forms, forms_in_thousands

from barreno.fit.data import numbers_of, read_test
from barreno.fit.laboratory import Said, known_names
from barreno.fit.table import decoded, split_table
from barreno.runs.csv_table import read_csv
from barreno.runs.faults import Fault

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROWS = [(i, 0.05 * i, 1.25 * i) for i in range(9)]  # s, %, MPa
PATH = (("compression: positive",), ("time", "axial_strain", "confinement"), ("s", "%", "MPa"),
    [(f"{t}", f"{e:.2f}", f"{p:.2f}") for t, e, p in ROWS])
LARGE = (*PATH[:2], ("s", "%", "kPa"), [(f"{t}", f"{e:.2f}", f"{1e3 * p:.1f}") for t, e, p in ROWS])
CURVE = (
    ("kind: triaxial", "compression: positive", "confinement: 40 MPa"), ("axial_strain", "differential_stress", "volume_strain"),
    ("%", "MPa", "%"),
    [(f"{e:.2f}", f"{40.5 * e:.3f}", f"{0.4 * e:.3f}") for _, e, _ in ROWS],
)  # fmt: skip
UNCLEAR = {  # form: words of both sentences
    "thousands or comma": (b"# compression: positive\ntime;axial_strain [%];confinement [MPa]\n0;0;0\n1;1,234;1\n", "# decimal: comma"),
    "two marks": (b"# compression: positive\ntime;axial_strain [%];confinement [MPa]\n0;0,0;0.0\n1;0,5;1.5\n",
        "a table has one decimal mark"),
    "odd word": (b"# decimal: dot\ntime;axial_strain [%];confinement [MPa]\n0;0;0\n1;1;1\n", "neither comma nor point"),
    "decimal commas between commas": (b"# compression: positive\ntime,axial_strain [%],confinement [MPa]\n0,0,0,0,0,0\n1,0,0,5,1,5\n",
        "decimal commas"),
    "text": (b"# compression: positive\ntime,axial_strain [%],confinement [MPa]\n0,0,0\n1,much,1\n", "line 4"),
    "nan": (b"# compression: positive\ntime,axial_strain [%],confinement [MPa]\n0,0,0\n1,nan,1\n", "line 4"),
    "zero byte": (b"time,axial_strain [%],confinement [MPa]\n0,0,0\n1,1,\0\n", "is not text"),
}  # fmt: skip


def driven(barreno, folder, raw):
    """Strain along the axis and stress on the side at each row of a path, and what is said."""
    path, out = folder / "path.csv", folder / "out.csv"
    path.write_bytes(raw)
    out.unlink(missing_ok=True)
    done = subprocess.run([barreno, "drive", "--material", "berea_sandstone", "--path", path, "--out", out], capture_output=True, text=True)
    assert done.returncode in (0, 1) and out.exists() == (done.returncode == 0), done.stderr
    if done.returncode:
        return None, done.stderr
    return read_csv(out)[["time", "strain_xx", "stress_yy"]].to_numpy(float), done.stdout + done.stderr


def columns_of(raw):
    """The same by the reader of `fit`."""
    text = decoded(raw)
    if text is None:
        raise Fault("path.csv is not text")
    table = split_table("path.csv", text, known_names(Said()))
    for number, cells in table.rows:
        if len(cells) != len(table.names):
            raise Fault(f"line {number}: decimal commas?")
    columns = []
    for name in PATH[1]:
        at = table.names.index(name)
        columns.append(numbers_of("path.csv", name, table.units[at] or "s", at, table.rows))
    return numpy.array(columns).T


def check_agreement(barreno, folder):
    expected = numpy.array([(t, numpy.log1p(-e / 100.0), -p * 1e6) for t, e, p in ROWS])
    count = 0
    for name, raw in [*forms(PATH), *forms_in_thousands(LARGE)]:
        answer, said = driven(barreno, folder, raw)
        assert answer is not None, f"{name}: {said}"
        numpy.testing.assert_allclose(answer, expected, rtol=1e-7, atol=1e-12, err_msg=name)
        columns = columns_of(raw)
        columns[:, 1], columns[:, 2] = numpy.log1p(-columns[:, 1]), -columns[:, 2]
        numpy.testing.assert_allclose(columns, expected, rtol=1e-12, atol=1e-15, err_msg=name)
        assert (";" not in name) or "separated by semicolons" in said, f"{name}: {said}"
        count += 1
    assert count >= 42, count
    print(f"  {count} forms, both readers")


def check_unclear(barreno, folder):
    for name, (raw, words) in UNCLEAR.items():
        answer, said = driven(barreno, folder, raw)
        assert answer is None and words in said and said.startswith("barreno: path.csv") and said.count("\n") == 1, f"{name}: {said}"
        try:
            columns_of(raw)
        except Fault as fault:
            assert words in str(fault), f"{name}: {fault}"
        else:
            raise AssertionError(f"{name} is read")
    said_comma = UNCLEAR["thousands or comma"][0].replace(b"1,234", b"0,234").replace(b"# c", b"# decimal: comma\n# c")
    assert driven(barreno, folder, said_comma)[0] is not None and columns_of(said_comma)[1, 1] == 0.00234


def check_fit(folder):
    """Curves: each form is the same test."""
    file = folder / "curve.csv"
    file.write_bytes(form_of(CURVE))
    first = read_test(file)
    for name, raw in forms(CURVE):
        file.write_bytes(raw)
        test = read_test(file)
        for column, values in first.columns.items():
            numpy.testing.assert_allclose(test.columns[column], values, rtol=1e-12, atol=1e-15, err_msg=f"{name}, {column}")
        assert test.confinement == 40e6
    for unreadable in (b"PK\x03\x04" + bytes(80), b"\xff\xfea", b"%PDF-1.4\n"):
        file.write_bytes(unreadable)
        try:
            read_test(file)
        except Fault as fault:
            assert "save it as CSV" in str(fault), fault
        else:
            raise AssertionError(f"{unreadable[:4]} is read")


JET = "time [us];velocity [km/s];radius [mm];length [mm];density [g/cm3]\r\n1;0,5;1;1;1\r\n4;0,4;1;1;1\r\n"


def check_decks(barreno, folder):
    """A deck with a byte-order mark, and its jet table as a spreadsheet writes it; the same deck in UTF-16 is refused by name."""
    deck = (ROOT / "tests" / "decks" / "bad" / "jet_header.xml").read_text().replace("header.csv", "jet.csv")
    file = folder / "deck.xml"
    (folder / "jet.csv").write_bytes(JET.encode("utf-8-sig"))
    file.write_bytes(deck.encode("utf-8-sig"))
    done = subprocess.run([barreno, "check", file], capture_output=True, text=True)
    assert done.returncode == 0 and "jet.csv: the decimal mark is the comma." in done.stdout, done.stdout + done.stderr
    file.write_bytes(b"\xff\xfe" + deck.encode("utf-16-le"))
    done = subprocess.run([barreno, "check", file], capture_output=True, text=True)
    assert done.returncode == 1 and "UTF-16" in done.stderr and done.stderr.count("\n") == 1, done.stderr


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_agreement(barreno, folder)
        check_unclear(barreno, folder)
        check_fit(folder)
        check_decks(barreno, folder)
    print("both readers read the same tables")


if __name__ == "__main__":
    main()
