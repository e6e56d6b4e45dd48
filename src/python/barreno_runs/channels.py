# SPDX-License-Identifier: BSD-3-Clause
"""The channels of several runs side by side, each drawn as in the report of a run, with the same colours for the same values."""

import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from barreno_runs.fields import MICRO, PLASTIC_LABEL, PRESSURE_LABEL, Fields, draw_channel, flies_up, is_mirrored, size_of  # noqa: E402
from barreno_runs.join_exodus import as_one_file  # noqa: E402
from barreno_runs.pictures import save  # noqa: E402
from barreno_runs.results import NothingToDraw  # noqa: E402
from barreno_runs.run_folder import read_summary  # noqa: E402

TALL, LEAST, MOST, WIDEST = 3.6, 1.8, 6.0, 14.0  # of a channel, and of the picture [in]
LONGEST_LINE = 24  # letters over a channel
LONGEST_REASON = 200
UNREADABLE = (OSError, ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError, ValueError)


def read_fields(folder):
    with as_one_file(folder / "particles.e") as file:
        fields = Fields(file)
    if len(fields.corners) == 0:
        raise ValueError("its last step has no particle")
    return fields


def read_all(rows):
    """[Fields or None] and sentences on what cannot be read."""
    found, remarks = [], []
    for row in rows:
        found.append(None)
        if not row.scalars:
            continue
        try:
            found[-1] = read_fields(row.folder)
        except UNREADABLE as error:
            why = " ".join(str(error).split())[:LONGEST_REASON]
            remarks.append(f"channels.png lacks {row.label}, because {row.folder / 'particles.e'} cannot be read ({why}).")
    return found, remarks


def shape_of(all_fields, mirrored, columns):
    """Width of a channel in inches, rows and columns of the matrix."""
    sizes = [size_of(fields, mirrored) for fields in all_fields if fields]
    panels = 1 if mirrored else 2
    wide = panels * min(MOST, max(LEAST, TALL * max(width / height for width, height in sizes))) + 0.2
    columns = columns or min(len(all_fields), max(1, int(WIDEST / wide)))
    return wide, -(-len(all_fields) // columns), columns


def title_of(row, fields):
    depth = row.depth()
    words = f"{1e3 * depth:.1f} mm at {fields.time / MICRO:.4g} µs" if depth else f"{fields.time / MICRO:.4g} µs"
    return "\n".join([*(line for part in row.label.split(", ") for line in textwrap.wrap(part, LONGEST_LINE)), words])


def draw_one(axes, row, fields, mirrored):
    """@return what carries the colours"""
    left, right = axes[0], axes[-1]
    shapes = draw_channel(left, right, fields, mirrored, flies_up(read_summary(row.folder)))
    left.set_title(title_of(row, fields), fontsize=8)
    for one in {left, right}:
        one.tick_params(labelsize=6)
        one.label_outer()
    return shapes


def share_colours(figure, axes, shapes, side, label):
    """One range for all runs."""
    limits = [one.get_clim() for one in shapes]
    for one in shapes:
        one.set_clim(min(low for low, _ in limits), max(high for _, high in limits))
    scale = figure.colorbar(shapes[0], ax=axes, location=side, label=label, shrink=0.6 / len(axes), aspect=30, pad=0.02, extend="both")
    scale.ax.tick_params(labelsize=7)
    scale.solids.set_edgecolor("face")


def draw_channels(file, rows, columns):
    """@return sentences on runs that are not in the picture"""
    all_fields, remarks = read_all(rows)
    if not any(all_fields):
        raise NothingToDraw("no run has a particles.e that can be read")
    mirrored = all(is_mirrored(read_summary(row.folder)) for row, fields in zip(rows, all_fields) if fields)
    panels = 1 if mirrored else 2
    wide, lines, columns = shape_of(all_fields, mirrored, columns)
    figure, axes = plt.subplots(lines, panels * columns, figsize=(wide * columns + 2.0, (TALL + 0.6) * lines), squeeze=False, layout="constrained")
    shapes = []
    for i in range(lines * columns):
        place = axes[i // columns, panels * (i % columns) : panels * (i % columns + 1)]
        if i < len(rows) and all_fields[i]:
            shapes.append(draw_one(place, rows[i], all_fields[i], mirrored))
            continue
        for one in place:
            one.set_axis_off()
    pressures, strains = zip(*shapes)
    share_colours(figure, axes, pressures, "left", PRESSURE_LABEL)
    share_colours(figure, axes, strains, "right", PLASTIC_LABEL)
    save(figure, file, bbox_inches="tight")  # labels of the scales reach beyond the axes
    return remarks
