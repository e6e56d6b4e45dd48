# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6: the channel in plane strain with GIMP, CPDI and B-splines, and which is nearest to its limit."""
import math

import matplotlib.pyplot as plt
import numpy as np
from paper_figures.lab import RESULTS, Table, least, most, read_table
from paper_figures.shots import draw_channels, measured

TABLES = ("paper_6", "paper_6_limits")
DECK = "plane.xml"
SHAPES = ("GIMP", "CPDI", "quadratic B-spline", "cubic B-spline")
CELLS = {"quick": (4.0, 2.0), "default": (2.0, 1.0, 0.5), "fine": (2.0, 1.0, 0.5, 0.25)}  # mm; the jet's half thickness is 2.0 to 2.1 mm


def measure(lab):
    cells, shapes = CELLS[lab.form], SHAPES[:2] if lab.form == "quick" else SHAPES
    asked = [(shape, h) for h in cells for shape in shapes]
    runs = [(DECK, {"Grid/Cell Size": f"{h:g} mm", "Step/Shape Function": shape}, f"plane-{shape.replace(' ', '-')}-{h:g}")
        for shape, h in asked]
    folders, rows = lab.runs(runs), []
    for (shape, h), folder in zip(asked, folders):
        shot = measured(folder)
        # A slot: its area per thickness stands where the volume of a round hole would.
        rows.append([shape, h, shot.depth, shot.volume])
    columns = ["shape function", "cells [mm]", "depth [mm]", "slot [cm2]"]
    table = Table(f"Figure 6: input_xml/paper/{DECK}, plane strain; depth and area of the slot at 30 us", columns,
        [[*row[:3], 0.01 * row[3]] for row in rows])
    if lab.form != "quick":
        shown = min(cells)
        channels = [(f"{shape}, cells of {h:g} mm\n{row[2]:.1f} mm deep at 30 µs", folder)
            for (shape, h), row, folder in zip(asked, rows, folders) if h == shown]
        fields, limits = ("pressure", "equivalent_plastic_strain"), ((0.0, 1500.0), (0.0, 2.0))
        draw_channels(lab.picture("paper_6"), channels, fields, limits, (20.0, -10.0, 46.0))
        draw_convergence(lab.picture("paper_6_convergence"), table)
    return {"paper_6": table, "paper_6_limits": limits_of(table)}


def by_cells(table, shape):
    """(cells, depths) from coarse to fine."""
    h, depth = (table.column(name, **{"shape function": shape}) for name in ("cells [mm]", "depth [mm]"))
    order = np.argsort(-h)
    return h[order], depth[order]


def limit_of(h, depth):
    """(limit, order) through the three finest levels, each half as wide as the one before (Richardson); nan where there are fewer, or the
    differences do not fall to less than half: of an order below 1 the limit would lie far beyond what was computed."""
    if len(depth) < 3:
        return math.nan, math.nan
    coarse, middle, fine = depth[-3:]
    ratio = (middle - coarse) / (fine - middle) if fine != middle else math.nan
    if not ratio > 2.0:
        return math.nan, math.log2(ratio) if ratio > 0.0 else math.nan
    return fine + (fine - middle) / (ratio - 1.0), math.log2(ratio)


def limits_of(table):
    """Order and limit of every shape function, and how far its depths are from the mean limit."""
    rows = [[shape, *limit_of(*by_cells(table, shape)), *by_cells(table, shape)] for shape in dict.fromkeys(table.column("shape function"))]
    limits = [row[1] for row in rows if math.isfinite(row[1])]
    common = float(np.mean(limits)) if limits else math.nan
    cells = list(rows[0][3])
    columns = ["shape function", "order", "limit [mm]", *(f"cells of {h:g} mm: off the mean limit" for h in cells)]
    remark = (
        f"Figure 6: limits of the depth through the three finest cells, where it converges at first order or better; mean {common:.4g} mm"
    )
    return Table(remark, columns,
        [[shape, order, limit, *(float(d / common - 1.0) for d in depth)] for shape, limit, order, _, depth in rows])


def stored_limit():
    """Mean of the limits of docs/paper.md [mm]: of the live short form, whose cells are too coarse to have one."""
    known = read_table(RESULTS / "paper_6_limits.csv").column("limit [mm]")
    return float(known[np.isfinite(known)].mean())


def draw_convergence(file, table):
    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for i, shape in enumerate(SHAPES):
        h, depth = by_cells(table, shape)
        axes.plot(h, depth, "o-", color=f"C{i}", label=shape)
        limit, order = limit_of(h, depth)
        if math.isfinite(limit):
            axes.plot([0.0, h[-1]], [limit, depth[-1]], ":", color=f"C{i}")
            axes.plot(0.0, limit, "x", color=f"C{i}", ms=8)
    axes.set(xlabel="cells [mm] (cross: limit, of order 1 or more)", ylabel="depth at 30 µs [mm]", xlim=(-0.08, None))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    figure.savefig(file, dpi=110)
    plt.close(figure)


DRAWN = {"paper_6_convergence": lambda file, tables: draw_convergence(file, tables["paper_6"])}  # of the tables alone


def trends(tables):
    table = tables["paper_6"]
    shapes = list(dict.fromkeys(table.column("shape function")))
    finest, coarse = {}, {}
    for shape in shapes:
        h, depth = by_cells(table, shape)
        finest[shape], coarse[shape] = depth[-1], depth[0]
    out = [least("6: coarsest cells: depth, GIMP over CPDI, difference", abs(coarse["GIMP"] / coarse["CPDI"] - 1.0), 0.01)]
    if len(shapes) == 2:
        off = {shape: abs(finest[shape] / stored_limit() - 1.0) for shape in shapes}
        out.append(most("6: cells of 2 mm (against the paper's guess): distance from the stored mean limit, GIMP over CPDI",
            off["GIMP"] / off["CPDI"], 0.8))
    if len(shapes) > 2:
        values, limits = list(finest.values()), tables["paper_6_limits"]
        known = limits.column("limit [mm]")
        off = {shape: abs(limits.value("cells of 1 mm: off the mean limit", **{"shape function": shape})) for shape in shapes}
        out += [
            most("6: finest cells, all shape functions: largest difference of depth, relative", max(values) / min(values) - 1.0, 0.04),
            least("6: first order or better: number of shape functions", np.isfinite(known).sum(), 2.0),
            most("6: these shape functions: largest difference of limits, relative", np.nanmax(known) / np.nanmin(known) - 1.0, 0.02),
            most("6: cells of 1 mm (against the paper's guess): distance from the mean limit, GIMP over CPDI",
                off["GIMP"] / off["CPDI"], 0.5),
        ]
    return out
