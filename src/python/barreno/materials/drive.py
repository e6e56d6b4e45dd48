# SPDX-License-Identifier: BSD-3-Clause
"""One material point along a path, by the program."""

import pathlib
import re
import tempfile

from barreno.runs.csv_table import read_csv
from barreno.runs.faults import Fault, needed, on_one_line
from barreno.runs.program import as_set, found_program, setting_words
from barreno.runs.tables import place


def unit_of(name):
    """Of a column of the answer; None of a state variable, whose unit its model knows."""
    kinds = {"time": "s", "strain": "-", "stress": "Pa", "pore_pressure": "Pa"}
    return kinds.get(name) or kinds.get(name.rpartition("_")[0]) or ("-" if re.fullmatch("F[1-3][1-3]", name) else None)


def table_of(path):
    """@param path  its columns by their names, or a frame"""
    pandas = needed("pandas")
    try:
        return pandas.DataFrame(path)
    except (TypeError, ValueError) as error:
        raise Fault(f"the columns of the path are no table ({on_one_line(error)}); give each the same number of rows.") from None


def drive(card, path, steps_per_row, every_step, settings):
    """See Material.drive.  @param card  its file"""
    with tempfile.TemporaryDirectory(prefix="barreno-") as folder:
        answer = pathlib.Path(folder) / "answer.csv"
        if not isinstance(path, (str, pathlib.Path)):
            table = pathlib.Path(folder) / "path.csv"
            place(table, table_of(path).to_csv(index=False))
            path = table
        words = ["drive", "--material", str(card), "--path", str(path), "--out", str(answer), "--steps-per-row", str(steps_per_row)]
        words += ["--every-step"] if every_step else []
        found_program("drive", 1).call([*words, *as_set(setting_words(settings, '{"PEAKI1": "12 MPa"}'))])
        found = read_csv(answer)
        found.attrs["units"] = {name: unit for name in found.columns if (unit := unit_of(name))}
        return found
