# SPDX-License-Identifier: BSD-3-Clause
"""The number that is followed: a column of a run's tables at some times, or a number of summary.json at its end."""

import csv
import difflib
import json
import pathlib

import numpy as np

from barreno_converge.faults import FILE, Fault

TABLES = ("depth.csv", "history.csv", "radii.csv", "cavities.csv")


def read_table(file):
    """Columns of a CSV file as arrays; a line that was cut off is left out."""
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.reader(line for line in stream if line.strip() and not line.startswith("#")))
    whole = [row for row in rows[1:] if len(row) == len(rows[0])]
    values = np.array([[float(cell) for cell in row] for row in whole], float).reshape(len(whole), len(rows[0]))
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def numbers_of(tree, path=""):
    """{dotted path: number} of a JSON object."""
    found = {}
    for name, value in tree.items():
        whole = f"{path}.{name}" if path else name
        if isinstance(value, dict):
            found.update(numbers_of(value, whole))
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            found[whole] = float(value)
    return found


def read_summary(folder):
    file = pathlib.Path(folder) / "summary.json"
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Fault(f"{file} cannot be read ({error}); remove the folder, so that the run is made again.", FILE) from None


class Quantity:
    """Where a name stands in the files of a run."""

    def __init__(self, name, folder):
        self.name, self.table, self.path = name, None, None
        folder = pathlib.Path(folder)
        columns = {}
        for table in TABLES:
            if (folder / table).exists():
                columns[table] = [column for column in read_table(folder / table) if column != "time"]
        self.table = next((table for table, names in columns.items() if name in names), None)
        if self.table:
            return
        numbers = numbers_of(read_summary(folder))
        matches = [path for path in numbers if path == name or path.endswith(f".{name}")]
        if len(matches) == 1 or name in matches:
            self.path = name if name in matches else matches[0]
            return
        known = sorted({column for names in columns.values() for column in names} | set(numbers))
        if len(matches) > 1:
            raise Fault(f'--quantity "{name}" stands for several numbers of summary.json ({", ".join(matches)}); name one of them.')
        near = difflib.get_close_matches(name, [*known, *(path.split(".")[-1] for path in numbers)], 1)
        hint = f"did you mean {near[0]}" if near else "take depth, a column of history.csv or a number of summary.json"
        raise Fault(f'--quantity "{name}" is neither a column of {", ".join(columns)} nor a number of summary.json; {hint}?' if near else
                    f'--quantity "{name}" is neither a column of {", ".join(columns)} nor a number of summary.json; {hint}.')  # fmt: skip

    def series(self, folder):
        """(times, values) of a column, or None of a number of the summary."""
        if not self.table:
            return None
        table = read_table(pathlib.Path(folder) / self.table)
        return table["time"], table[self.name]

    def at(self, folder, times):
        """Values at times, between rows on a straight line; of a number of the summary at the end alone."""
        if self.table:
            return [float(value) for value in np.interp(times, *self.series(folder))]
        found = numbers_of(read_summary(folder)).get(self.path)
        if found is None:
            raise Fault(f"{folder}/summary.json has no number {self.path}, which other levels have; choose another quantity.")
        return [found]
