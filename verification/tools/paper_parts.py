# SPDX-License-Identifier: BSD-3-Clause
"""Marked parts of docs/paper.md: tables and trends of the figures, from verification/results/paper_*.csv."""
import math

from paper_figures import FIGURES, figure, spall
from paper_figures.lab import RESULTS, read_table
from tools.verification_pages import name_and_condition, table

LONG = {"paper_3_curve", "paper_4", "paper_5", "paper_5_paths"}  # drawn, not tabulated

CORES = 2
RUN_IN_EACH_ROW = (7, 8, 10)  # figures whose tables have a row for every run


def cell(value):
    if isinstance(value, str):
        return value
    return "" if math.isnan(value) else f"{value:.4g}"


def stored(number):
    return {name: read_table(RESULTS / f"{name}.csv") for name in figure(number).TABLES}


def remark_of(found, number):
    """As a sentence's beginning, but for words that are a file's name."""
    remark = found.remark.replace(f"Figure {number}: ", "").rstrip(".")
    return remark if "/" in remark.split()[0] else remark[0].upper() + remark[1:]


def part(number):
    """Remark and table of every short results file of a figure, then its trends."""
    lines, tables = [], stored(number)
    for name, found in tables.items():
        if name in LONG:
            lines += [remark_of(found, number) + f" (`verification/results/{name}.csv`).", ""]
        else:
            shown = [[cell(value) for value in row] for row in found.rows]
            lines += [remark_of(found, number) + ":", "", *table(found.columns, shown), ""]
    return [*lines, *table(["trend", "condition", "measured", "must be", "verdict"],
        [row_of(trend) for trend in figure(number).trends(tables)])]


def row_of(trend):
    bound = f"{'at least' if trend.at_least else 'at most'} {trend.limit:.4g}"
    name, condition = name_and_condition(trend.what.split(": ", 1)[1])
    return [name, condition, f"{trend.value:.4g}", bound, "holds" if trend.holds else "**does not hold**"]


def unmeasured(costs, count_of):
    """{figure: runs whose processor time is not known}: tables that were made later than the last measurement of a figure as a whole.

    @param costs     {figure: runs that were measured}
    @param count_of  number of runs behind a figure's stored tables
    """
    lacking = {number: count_of(number) - costs.get(number, 0) for number in RUN_IN_EACH_ROW}
    return {number: int(count) for number, count in lacking.items() if count > 0}


def rows_of(number):
    return sum(len(found.rows) for found in stored(number).values())


def unmeasured_words(lacking):
    if not lacking:
        return []
    which = ", ".join(f"{count} runs of figure {number}" for number, count in lacking.items())
    return ["", f"Not in these times: {which} (`verification/paper.py BARRENO {' '.join(f'--only {number}' for number in lacking)}` "
        "measures them)."]


def time():
    found = read_table(RESULTS / "paper_time.csv")
    total = sum(row[2] for row in found.rows)
    wall = sum(row[2] / min(CORES, max(row[1], 1.0)) for row in found.rows)  # a single run has one core
    rows = [[f"{row[0]:.0f}", f"{row[1]:.0f}", f"{row[2]:.0f}"] for row in found.rows]
    return [*table(found.columns, [*rows, ["all", f"{sum(row[1] for row in found.rows):.0f}", f"{total:.0f}"]]), "",
        f"On two idle cores that is {wall / 60.0:.0f} minutes or more: a core idles while the last run of a figure ends. Pictures take "
        "seconds.",
            *unmeasured_words(unmeasured({int(row[0]): row[1] for row in found.rows}, rows_of))]  # fmt: skip


def spall_falls():
    """What confinement does without and with a spall stress."""
    found = spall.falls_of(read_table(RESULTS / "paper_7_spall.csv"))
    return table(found.columns, [[cell(value) for value in row] for row in found.rows])


PARTS = {"paper_time": time, "paper_spall": spall_falls} | {f"paper_{number}": (lambda number=number: part(number)) for number in FIGURES}
