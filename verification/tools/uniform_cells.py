# SPDX-License-Identifier: BSD-3-Clause
"""Depths of perforation_120us.xml with cells of one size (results/perforation_cells.csv), and errors of steady penetration
(results/steady_penetration.csv): what a depth is compared with."""
import math

from barreno.runs.csv_table import WORDS, read_csv
from tools.case_list import RESULTS

REFERENCE = 0.25  # mm, cells of the runs that the others are compared with
TIP = 1.0  # mm, radius of the jet's tip


def read(name):
    """Rows {column: text}: pages show the digits as they stand."""
    return read_csv(RESULTS / name, cells=WORDS).to_dict("records")


def depths():
    """{(cells [mm], time [us]): depth [mm]}"""
    return {(float(row["cells_mm"]), float(row["time_us"])): float(row["depth_mm"]) for row in read("perforation_cells.csv")}


def depth_of(cells, time):
    return depths()[cells, time]


def doubt():
    """How far the reference is from half its cells, where that was run."""
    found = depths()
    finest = min(cells for cells, _ in found)
    return max(abs(found[REFERENCE, time] / depth - 1.0) for (cells, time), depth in found.items() if cells == finest)


def errors_with(cells_per_radius):
    """Least and greatest error of a depth that was measured with so many cells in the radius of the tip: all of perforation_120us.xml at
    that size of cells, and steady penetration of the same rock."""
    found, size = depths(), TIP / cells_per_radius
    if size == REFERENCE:
        return -doubt(), doubt()
    errors = [depth / found[REFERENCE, time] - 1.0 for (cells, time), depth in found.items() if cells == size]
    rows = [row for row in read("steady_penetration.csv") if float(row["cells_per_radius"]) == cells_per_radius
        and "sandstone" in row["target"]]
    return tuple(choose([*errors, *(0.01 * float(row[side]) for row in rows)]) for choose, side in ((min, "low"), (max, "high")))


def range_of_errors(cells_per_radius):
    """The same between the measured sizes, by the logarithm of the cells, as `check` and every run of a jet give it
    (jet/depth_error.cpp)."""
    measured = sorted({TIP / cells for cells, _ in depths() if cells >= REFERENCE})
    upper = next((i for i, cells in enumerate(measured) if i > 0 and cells_per_radius <= cells), len(measured) - 1)
    part = math.log(cells_per_radius / measured[upper - 1]) / math.log(measured[upper] / measured[upper - 1])
    return tuple(a + part * (b - a) for a, b in zip(errors_with(measured[upper - 1]), errors_with(measured[upper])))


def interval(depth, cells_per_radius):
    """Where a depth lies that was computed with such cells."""
    low, high = range_of_errors(cells_per_radius)
    return depth / (1.0 + high), depth / (1.0 + low)


def error_text(error):
    """-14 % (-15 to -3 %)"""
    percent = lambda share: f"{round(100.0 * share):+d}" if round(100.0 * share) else "0"  # noqa: E731
    return f"{percent(error['value'])} % ({percent(error['low'])} to {percent(error['high'])} %)"


def depth_table():
    """Lines: depth and error by cell size and time."""
    found = depths()
    times = sorted({time for _, time in found})
    lines = ["| cells | cells per radius of the tip | " + " | ".join(f"{time:g} us" for time in times) + " |",
        "|---|---|" + "---|" * len(times)]
    for cells in sorted({cells for cells, _ in found}, reverse=True):
        row = []
        for time in times:
            depth, reference = found.get((cells, time)), found.get((REFERENCE, time))
            shown = "" if depth is None else f"{depth:.1f}"
            row.append(shown if depth is None or cells == REFERENCE else f"{shown} ({100.0 * (depth / reference - 1.0):+.1f} %)")
        lines.append(f"| {cells:g} mm | {TIP / cells:g} | " + " | ".join(row) + " |")
    return lines


def percent_range(low, high):
    if float(low) == float(high) == 0.0:
        return "reference"
    signed = lambda text: "0" if float(text) == 0.0 else f"{float(text):+g}"  # noqa: E731
    return f"{signed(low)} %" if low == high else f"{signed(low)} to {signed(high)} %"


def steady_table():
    """Lines: error of the rate of steady penetration by cells per radius."""
    rows = read("steady_penetration.csv")
    pairs = list(dict.fromkeys((row["jet"], row["target"]) for row in rows))
    lines = ["| cells per radius | " + " | ".join(f"{jet} into {target}" for jet, target in pairs) + " |", "|---|" + "---|" * len(pairs)]
    for cells in dict.fromkeys(row["cells_per_radius"] for row in rows):
        at = {(row["jet"], row["target"]): row for row in rows if row["cells_per_radius"] == cells}
        lines.append(f"| {cells} | " + " | ".join(percent_range(at[pair]["low"], at[pair]["high"]) for pair in pairs) + " |")
    return lines
