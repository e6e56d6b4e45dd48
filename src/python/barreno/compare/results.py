# SPDX-License-Identifier: BSD-3-Clause
"""Several runs side by side: table.csv, depth.png and channels.png."""

import csv
import dataclasses
import io
import pathlib

from barreno.runs.faults import Fault, NothingToDraw, on_one_line
from barreno.runs.run_folder import read_summary, read_table, scalars_of
from barreno.runs.tables import place

FINISHED = "finished"
DEPTH = "penetration.depth"
CHANGED = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)  # what files that no run wrote lead to
MOST_CHANNELS = 40  # one picture of more would show nothing


@dataclasses.dataclass
class Row:
    """A run with what tells it from the others."""

    label: str
    folder: pathlib.Path
    values: list  # texts of what differs
    state: str = FINISHED
    scalars: dict = dataclasses.field(default_factory=dict)  # of summary.json

    def depth(self):
        """[m], None without a jet or before it has met the target"""
        return self.scalars.get(DEPTH)


def finished_row(label, folder, values):
    return Row(label, folder, values, scalars=scalars_of(read_summary(folder)))


def names_of(rows):
    """Of the scalars, those that any run has."""
    return list(dict.fromkeys(name for row in rows for name in row.scalars))


def cell(value):
    return {True: "true", False: "false"}[value] if isinstance(value, bool) else repr(value) if isinstance(value, float) else str(value)


def as_csv(heads, rows):
    """@param heads  of the values of the rows"""
    out = io.StringIO()
    out.write("# SI units but where a head has another one; names behind 'state' are those of summary.json (docs/output.md)\n")
    writer, names = csv.writer(out, lineterminator="\n"), names_of(rows)
    writer.writerow(["run", *heads, "state", *names])
    for row in rows:
        writer.writerow([str(row.folder), *row.values, row.state, *(cell(row.scalars.get(name, "")) for name in names)])
    return out.getvalue()


def depths_of(rows):
    """[(label, times, depths)] of the runs with a depth.csv"""
    found = []
    for row in rows:
        file = row.folder / "depth.csv"
        if row.scalars and file.exists():
            table = read_table(file)
            if not {"time", "depth"} <= table.keys():
                raise Fault(f"{file} has no columns time and depth; make the run again.")
            found.append((row.label, table["time"], table["depth"]))
    return found


def draw_into(file, draw, package, remarks):
    """Draws a picture if there is what it needs.  @return [its name], or nothing with a remark"""
    try:
        place(file, draw)
    except ImportError as error:
        remarks.append(f"{file.name} is not drawn, because Python has no {error.name} (Debian package {package}).")
        return []
    except NothingToDraw as reason:
        remarks.append(f"{file.name} is not drawn, because {reason}.")
        return []
    return [file.name]


def write_depths(out, rows, remarks):
    series = depths_of(rows)
    if not series:
        remarks.append("depth.png is not drawn, because no run has a depth.csv (their decks have no Jet).")
        return []

    def draw(aside):
        from barreno.runs.pictures import draw_depths  # slow to load

        draw_depths(aside, series)

    return draw_into(out / "depth.png", draw, "python3-matplotlib", remarks)


def write_channels(out, rows, columns, remarks):
    """@param columns  of the matrix, None: as many as fit"""
    if not any(row.scalars for row in rows):
        return []
    if len(rows) > MOST_CHANNELS:
        remarks.append(f"channels.png has the first {MOST_CHANNELS} of {len(rows)} runs.")

    def draw(aside):
        from barreno.compare.channels import draw_channels  # slow to load

        try:
            remarks.extend(draw_channels(aside, rows[:MOST_CHANNELS], columns))
        except CHANGED as error:
            raise NothingToDraw(f"a file of a run was changed ({on_one_line(error)[:200]})") from error

    return draw_into(out / "channels.png", draw, "python3-netcdf4" if has_matplotlib() else "python3-matplotlib", remarks)


def has_matplotlib():
    import importlib.util

    return importlib.util.find_spec("matplotlib") is not None


def write_results(out, heads, rows, columns=None):
    """table.csv and the pictures.  @return names of the files, and remarks on what is not there"""
    remarks = []
    place(out / "table.csv", as_csv(heads, rows))
    return ["table.csv", *write_depths(out, rows, remarks), *write_channels(out, rows, columns, remarks)], remarks


def list_of(names):
    """a, b and c"""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
