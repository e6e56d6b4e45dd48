# SPDX-License-Identifier: BSD-3-Clause
"""The number that is followed: a column of a run's tables at some times, or a number of summary.json at its end."""

import difflib
import pathlib

from barreno.runs.faults import Fault
from barreno.runs.run_folder import numbers_of, read_summary, read_table

TABLES = ("depth.csv", "history.csv", "radii.csv", "cavities.csv")


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
            import numpy as np  # slow to load, and help does without

            return [float(value) for value in np.interp(times, *self.series(folder))]
        found = numbers_of(read_summary(folder)).get(self.path)
        if found is None:
            raise Fault(f"{folder}/summary.json has no number {self.path}, which other levels have; choose another quantity.")
        return [found]
