# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1: domain scaling in two dimensions, drawn from the corners that the code computes (src/shape/domain.hpp)."""
import os
import pathlib
import subprocess

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle
from paper_figures.lab import Table, least, most
from tools.runs import mpi_environment

TABLES = ("paper_1",)
L_CRIT = 1.0  # cells, the default of Largest Domain
HALF = 0.25  # half edge of a particle at the start, in cells: two particles per cell and direction
# Deformation gradients, from one that is left alone to one with both pairs of corners outside.
DOMAINS = {
    "within the limit": [[1.6, 0.4], [0.2, 1.3]],
    "one pair of corners outside": [[3.2, 2.2], [0.9, 1.8]],
    "both pairs outside": [[5.5, 0.6], [1.8, 1.3]],
}
RANDOM = 1000


def corners_of(edges):
    """e0 + e1, e0 - e1, and opposite to them."""
    first, second = edges
    return np.array([first + second, first - second, -first - second, -first + second])


def scaled(lab, many):
    """Corners of domains after the code's scaling, (domain, corner, axis)."""
    program = pathlib.Path(os.environ.get("BARRENO_SCALED_DOMAINS") or lab.barreno.parents[1] / "verification" / "barreno_scaled_domains")
    if not program.exists():
        raise RuntimeError(f"{program} is missing; build the target barreno_scaled_domains.")
    lines = "\n".join(" ".join(f"{x!r}" for x in [*map(float, edges.ravel()), L_CRIT]) for edges in many)
    said = subprocess.run([str(program)], input=lines, env=mpi_environment(), capture_output=True, text=True, check=True).stdout
    return np.array([float(x) for x in said.split()]).reshape(-1, 4, 2)


def domains():
    """The domains of the picture, and random ones for the rule."""
    drawn = [HALF * np.array(F, float).T for F in DOMAINS.values()]  # edge i is F times the half edge along axis i
    random = np.random.default_rng(1)
    size = 10.0 ** random.uniform(-1.0, 1.0, (RANDOM, 2, 1))
    return drawn, list(size * random.uniform(-1.0, 1.0, (RANDOM, 2, 2)))


def measure(lab):
    drawn, random = domains()
    many = drawn + random
    before, after = np.array([corners_of(edges) for edges in many]), scaled(lab, many)
    draw(lab.picture("paper_1"), before[: len(drawn)], after[: len(drawn)])
    rows = []
    names = [*DOMAINS, *(f"random {i}" for i in range(RANDOM))]
    for name, old, new in zip(names, before, after):
        lengths = [float(np.linalg.norm(corner)) for corner in (*old[:2], *new[:2])]
        turned = max(abs(float(a[0] * b[1] - a[1] * b[0])) / (np.linalg.norm(a) * np.linalg.norm(b)) for a, b in zip(old[:2], new[:2]))
        rows.append([name, *lengths, float(turned), float(np.abs(new - old).max())])
    kept = rows[: len(drawn)] + [worst_of(rows[len(drawn) :])]
    remark = (
        f"Figure 1: distance of the corners from the particle's centre, in cells, l_crit = {L_CRIT:g}; the last row is the worst of "
        f"{RANDOM} random domains."
    )
    return {"paper_1": Table(remark, ["domain", "first before", "second before", "first after", "second after", "turned", "moved"], kept)}


def worst_of(rows):
    """Largest value of every column; of what moved, that of domains within the limit."""
    inside = [row[6] for row in rows if max(row[1:3]) <= L_CRIT]
    return ["random, worst", *(max(row[k] for row in rows) for k in range(1, 6)), max(inside)]


def draw(file, before, after):
    figure, panels = plt.subplots(1, len(DOMAINS), figsize=(12.0, 4.0), sharey=True)
    for axes, name, old, new in zip(panels, DOMAINS, before, after):
        axes.add_patch(Circle((0.0, 0.0), L_CRIT, facecolor="#eef3f7", edgecolor="0.4", ls="--"))
        axes.fill(*old.T, facecolor="none", edgecolor="C0", lw=1.8, label="deformed domain, F times the particle")
        axes.fill(*new.T, facecolor="C1", alpha=0.35, edgecolor="C1", lw=1.8, label="domain of integration")
        axes.plot(*(HALF * np.array([[1, 1], [1, -1], [-1, -1], [-1, 1], [1, 1]])).T, color="0.5", lw=1.0, ls=":",
            label="particle at the start")
        for corner, moved in zip(old, new):
            if np.linalg.norm(corner - moved) > 1e-9:
                axes.annotate("", moved, corner, arrowprops={"arrowstyle": "->", "color": "k", "lw": 1.0})
        axes.plot(0.0, 0.0, "k+", ms=6)
        axes.set(title=name, xlabel="x [cells]", aspect="equal", xlim=(-2.25, 2.25), ylim=(-1.6, 1.6))
        axes.set_xticks(np.arange(-2, 2.1, 1.0))
        axes.set_yticks(np.arange(-1, 1.1, 1.0))
        axes.grid(alpha=0.5)
        axes.set_axisbelow(True)
    panels[0].set_ylabel("y [cells]")
    panels[0].annotate("$l_{crit}$", (L_CRIT * np.cos(2.4), L_CRIT * np.sin(2.4)), (-8, 6), textcoords="offset points", ha="right")
    handles, labels = panels[-1].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncols=3, frameon=False)
    figure.subplots_adjust(left=0.05, right=0.99, bottom=0.24, top=0.92, wspace=0.06)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(tables):
    table = tables["paper_1"]
    longest = max(float(table.column(name).max()) for name in ("first after", "second after"))
    alone = "within the limit"
    return [
        most("1: no corner is further from the centre than l_crit", longest, L_CRIT * (1.0 + 1e-9)),
        most("1: corners are shortened along their own direction", table.column("turned").max(), 1e-9),
        most("1: a domain within the limit is left alone", table.value("moved", domain=alone), 0.0),
        least("1: a corner outside is moved", table.value("moved", domain="both pairs outside"), 0.1),
    ]
