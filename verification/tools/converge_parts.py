# SPDX-License-Identifier: BSD-3-Clause
"""Parts of docs/converge.md, from results/converge.json (converge_examples.py)."""
import json

from tools.case_list import RESULTS
from tools.uniform_cells import depths, error_text

MILLI, MICRO = 1e-3, 1e-6


def example(name):
    return json.loads((RESULTS / "converge.json").read_text())[name]


def millimetres(value, digits):
    return "" if value is None else f"{value / MILLI:.{digits}f}"


def lines(name, digits):
    """The command and its answer; lengths in mm."""
    data = example(name)
    out = [f"`./barreno converge {data['words']}`", ""]
    sizes = " | ".join(f"cells of {size / MILLI:g} mm" for size in reversed(data["cells"]))
    out += [f"| time [us] | {sizes} | order | extrapolated | interval | verdict |", "|---|" + "---|" * (len(data["cells"]) + 4)]
    for one in data["results"]:
        values = " | ".join(millimetres(value, digits) for value in reversed(one["values"]))
        order = "" if one["order"] is None else f"{one['order']:.2f}"
        interval = f"{millimetres(one['low'], digits)} to {millimetres(one['high'], digits)}"
        out.append(f"| {one['time'] / MICRO:g} | {values} | {order} | {millimetres(one['extrapolated'], digits)} | {interval} | "
            f"{one['verdict']} |")
    error = data["depth_error"]
    if error and "value" in error:
        out += ["", f"Measured error with the smallest of these cells, {error['cells_per_radius']:g} per radius of the tip: "
            f"{error_text(error)}."]
    return out


def shell():
    return lines("shell", 4)


def jet():
    return lines("jet", 2)


def fine_jet():
    data, found = example("fine jet"), depths()
    last, finest = data["results"][-1], min(cells for cells, _ in found)
    depth = found[finest, round(last["time"] / MICRO)] * MILLI
    inside = "lies inside" if last["low"] <= depth <= last["high"] else "lies outside"
    return [*lines("fine jet", 2), "", f"The depth of {millimetres(depth, 1)} mm at {last['time'] / MICRO:g} us with cells of {finest:g} "
        f"mm ([trade.md](trade.md)) {inside} the last interval."]
