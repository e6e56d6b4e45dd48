# SPDX-License-Identifier: BSD-3-Clause
"""One material point along a path, by the program."""

import pathlib
import tempfile

from barreno.runs.csv_table import read_csv
from barreno.runs.faults import needed
from barreno.runs.program import as_set, found_program
from barreno.runs.tables import place


def drive(card, path, steps_per_row, every_step, settings):
    """See Material.drive.  @param card  its file"""
    pandas = needed("pandas")
    with tempfile.TemporaryDirectory(prefix="barreno-") as folder:
        answer = pathlib.Path(folder) / "answer.csv"
        if not isinstance(path, (str, pathlib.Path)):
            table = pathlib.Path(folder) / "path.csv"
            place(table, pandas.DataFrame(path).to_csv(index=False))
            path = table
        words = ["drive", "--material", str(card), "--path", str(path), "--out", str(answer), "--steps-per-row", str(steps_per_row)]
        words += ["--every-step"] if every_step else []
        found_program("drive", 1).call([*words, *as_set(f"{name}={value}" for name, value in (settings or {}).items())])
        return read_csv(answer)
