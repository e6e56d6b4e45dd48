# SPDX-License-Identifier: BSD-3-Clause
"""What a sweep leaves: table.csv, pictures, lines of the screen."""

from barreno.compare.results import FINISHED, Row, draw_into, finished_row, write_results
from barreno.runs.tables import aligned, number
from barreno.sweeps.flows import EFFICIENCY
from barreno.sweeps.plan import short_names, si_values

CHANNEL, PROBED = "penetration.channel_depth", "penetration.probed_depth"
SAME = 0.01  # of a depth: what a hole that is as wide as the jet down to its bottom may lack
COLUMNS = {  # number of summary.json: head and factor on the screen
    "penetration.depth": ("depth [mm]", 1e3),
    "penetration.through_since": ("through since [us]", 1e6),
    CHANNEL: ("open channel [mm]", 1e3),
    PROBED: ("as wide as the jet [mm]", 1e3),
    EFFICIENCY: ("core flow efficiency", 1.0),
    "balances.energy.error": ("energy error", 1.0),
    "wall_seconds": ("wall time [s]", 1.0),
}
MOST_MATRIX_COLUMNS = 8


class Column:
    """A varied parameter in the results: in its unit if all runs have the same, else in SI, or as text."""

    def __init__(self, variation, index, points):
        values, unit = [point.values[index] for point in points], variation.common_unit()
        self.texts, self.numbers, head = [value.text for value in values], None, ""
        if unit is not None:
            self.numbers, head = [value.number for value in values], unit
        elif all(value.number is not None for value in values):
            self.numbers, head = si_values(variation.path, points), "SI"
        if self.numbers:
            self.texts = [value.text.removesuffix(unit).strip() if unit is not None else repr(number)
                for value, number in zip(values, self.numbers)]
        self.head = f"{variation.path} [{head}]" if self.numbers and head else variation.path


def columns_of(variations, points):
    return [Column(variation, i, points) for i, variation in enumerate(variations)]


def state_of(point):
    return FINISHED if point.how and not point.code else "failed" if point.code else "missing"


def row_of(point, values):
    """@param values  of what was varied, as texts"""
    state = state_of(point)
    if state != FINISHED:
        return Row(point.label, point.folder, values, state)
    row = finished_row(point.label, point.folder, values)
    row.scalars.update(point.more)
    return row


def rows_of(points, columns):
    return [row_of(point, [column.texts[i] for column in columns]) for i, point in enumerate(points)]


def is_narrow(row):
    """Whether its hole goes on below where it is as wide as the jet."""
    return PROBED in row.scalars and row.scalars[PROBED] < (1.0 - SAME) * row.scalars.get(CHANNEL, 0.0)


def screen_table(columns, rows):
    shown = [name for name in COLUMNS if any(is_narrow(row) if name == PROBED else name in row.scalars for row in rows)]
    lines = [[*(column.head for column in columns), *(COLUMNS[name][0] for name in shown), "run"]]
    for row in rows:
        numbers = [number(row.scalars[name] * COLUMNS[name][1], 4) if name in row.scalars else "-" for name in shown]
        lines.append([*row.values, *numbers, row.folder.name if row.state == FINISHED else f"{row.folder.name} ({row.state})"])
    return aligned(lines)


def matrix_columns(variations, sample):
    """Of a grid of two parameters: the values of the second; None where as many as fit are best."""
    wanted = len(variations[-1].values) if sample == "grid" and len(variations) == 2 else None
    return wanted if wanted and wanted <= MOST_MATRIX_COLUMNS else None


def write_against(out, variations, columns, rows, remarks):
    """The depth over what is varied, of the runs that have one."""
    found = [i for i, row in enumerate(rows) if row.depth() is not None]
    if not found or len(columns) > 2:
        return []

    def draw(aside):
        from barreno.sweeps.picture import Axis, draw_against  # slow to load

        axes = [Axis(column.head, column.numbers and [column.numbers[i] for i in found], [column.texts[i] for i in found])
            for column in columns]
        name = short_names(variations)[-1]
        labels = [f"{name} = {rows[i].values[-1]} {variations[-1].common_unit() or ''}".strip() for i in found]
        draw_against(aside, axes, labels, [rows[i].depth() for i in found])

    return draw_into(out / "depth_against.png", draw, "python3-matplotlib", remarks)


def write_sweep(out, variations, sample, points, say):
    """Files and lines of all that has finished."""
    columns = columns_of(variations, points)
    rows = rows_of(points, columns)
    for line in screen_table(columns, rows):
        say(line)
    if not any(row.scalars for row in rows):
        return
    files, remarks = write_results(out, [column.head for column in columns], rows, matrix_columns(variations, sample))
    files += write_against(out, variations, columns, rows, remarks)
    for remark in remarks:
        say(remark)
    say(f"Written to {out}: {', '.join(files)}")
