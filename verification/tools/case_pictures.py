#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of verification cases from their stored rows, as cases.toml says, and those of depth_cost.py and validation_results.py.

    case_pictures.py        draw those in docs/pictures that are not of the stored figures

Each holds a digest of what it shows, so that pages can be checked without drawing (pages.py)."""
import hashlib
import json
import math
import struct
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools import depth_cost
from tools import validation_results
from tools.case_list import DOCS, cases, stored

KEY = "Figures"  # of the digest in the PNG file
DRAWING = 3  # raised when draw() changes what a picture looks like, so that all are drawn anew
MARKS = "osD^vP"
MOST_MARKS = 40  # of a curve; one of more points has none
MOST_TICKS = 5  # of an axis whose ticks are the values themselves
SHORT_SPAN = 200.0  # of a logarithmic axis, below which powers of ten alone would leave it without numbers


def file_of(name, entry):
    """Name in docs/pictures, or None for a case without a picture."""
    picture = entry.get("picture")
    return f"case_{name}.png" if isinstance(picture, dict) else picture


def curves_of(picture, data):
    """{label: [(x, y)]} from the rows of a case, or its curves."""
    if picture.get("curves"):
        return {label: [tuple(point) for point in points] for label, points in data["curves"].items()}
    column = {}
    for i, name in enumerate(data["columns"]):
        column.setdefault(name, i)
    wanted = picture.get("rows", {})
    rows = [row for row in data["rows"] if all(row[column[name]] in values for name, values in wanted.items())]
    curves = {}
    for row in rows:
        of = ", ".join(f"{name} {row[column[name]]}" if not isinstance(row[column[name]], str) else row[column[name]]
            for name in picture.get("by", ()))
        if "over" in picture:
            curves.setdefault(of, []).extend((x, row[column[name]]) for name, x in picture["over"].items())
            continue
        for name in picture["y"]:
            value = row[column[name]]
            if not isinstance(value, str) and math.isfinite(value) and value != 0.0:
                label = of if len(picture["y"]) == 1 and of else ", ".join(filter(None, (name, of)))
                curves.setdefault(label, []).append((row[column[picture["x"]]], abs(value)))
    return {label: sorted(points) for label, points in curves.items()}


def digest(picture, curves):
    return hashlib.sha256(json.dumps([DRAWING, picture, curves]).encode()).hexdigest()


def stored_digest(file):
    """The digest that a PNG file holds: the text chunk with our key."""
    if not file.exists():
        return None
    raw, at = file.read_bytes(), 8
    while at < len(raw):
        length, kind = struct.unpack(">I4s", raw[at : at + 8])
        key, _, text = raw[at + 8 : at + 8 + length].partition(b"\0")
        if kind == b"tEXt" and key.decode("latin-1") == KEY:
            return text.decode("latin-1")
        at += 12 + length
    return None


def number_errors(axis, low, high):
    """Ticks with numbers on the logarithmic axis of what was measured, however short it is."""
    from matplotlib.ticker import FormatStrFormatter, LogFormatterSciNotation, LogLocator, NullLocator

    parts = (1.0,) if high > SHORT_SPAN * low else (1.0, 3.0) if high > 30.0 * low else (1.0, 2.0, 5.0) if high > 5.0 * low else (1.0, 1.5,
        2.0, 3.0, 5.0, 7.0)
    axis.set_major_locator(LogLocator(10.0, parts))
    axis.set_major_formatter(LogFormatterSciNotation() if len(parts) == 1 else FormatStrFormatter("%g"))
    axis.set_minor_locator(NullLocator())


def draw(file, title, picture, curves):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["text.parse_math"] = True  # the commands, whose pictures have no formulas, may be loaded too
    import matplotlib.pyplot as plt

    from barreno.report.legends import place_legends

    figure, axes = plt.subplots(figsize=(5.6, 4.2), layout="constrained")
    for i, (label, points) in enumerate(curves.items()):
        # Hollow marks of several sizes: curves that coincide are all seen.
        marker = MARKS[i % len(MARKS)] if len(points) <= MOST_MARKS else None
        axes.plot(*zip(*points), "-", marker=marker, mfc="none", ms=4.0 + 1.2 * (len(curves) - 1 - i), lw=1.2, color=f"C{i}",
            label=label or None)
    if "over" not in picture and not picture.get("linear"):
        axes.set(xscale="log", yscale="log")
        ticks = sorted({x for points in curves.values() for x, _ in points})
        if len(ticks) > MOST_TICKS:  # measured, not chosen
            number_errors(axes.xaxis, *axes.get_xlim())
        else:
            axes.set_xticks(ticks, [f"{x:g}" for x in ticks])
            axes.minorticks_off()
        if "slope" in picture:
            x, y = next(iter(curves.values()))[0]
            axes.plot([x, ticks[-1]], [y, y * (ticks[-1] / x) ** picture["slope"]], "k--", lw=0.8, label=f"slope {picture['slope']}")
        number_errors(axes.yaxis, *axes.get_ylim())
    axes.set(title=title, xlabel=picture["x"], ylabel=picture["y"][0] if len(picture["y"]) == 1 else picture.get("label", "error"))
    axes.grid(alpha=0.3)
    if len(curves) > 1 or "slope" in picture:
        if len(axes.get_legend_handles_labels()[1]) <= 3:
            place_legends(axes, fontsize=8)
        else:
            axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.17), ncols=3, frameon=False)
    figure.savefig(file, dpi=110, metadata={"Software": None, KEY: digest(picture, curves)})
    plt.close(figure)


def drawn():
    """(file, title, picture, curves) of every picture that this script draws."""
    for name, entry in cases().items():
        data = stored(name)
        if data and isinstance(entry.get("picture"), dict):
            yield DOCS / "pictures" / file_of(name, entry), data["title"], entry["picture"], curves_of(entry["picture"], data)
    yield DOCS / "pictures" / depth_cost.FILE, depth_cost.TITLE, depth_cost.PICTURE, depth_cost.curves()
    craters = validation_results
    yield DOCS / "pictures" / craters.PICTURE_FILE, craters.PICTURE_TITLE, craters.PICTURE, craters.curves()


def outdated():
    return [file for file, _, picture, curves in drawn() if stored_digest(file) != digest(picture, curves)]


if __name__ == "__main__":
    old = outdated()
    for one in drawn():
        if one[0] in old:
            draw(*one)
            print(one[0].name)
