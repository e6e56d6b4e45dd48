# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a perforation against the permeability of saturated rock, from undrained to drained.

    pore_sweep.py [PNG]     draw the stored measurement (docs/pictures/depth_against_permeability.png)
"""
import json
import pathlib
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy as np
from tools.case import Result
from tools.runs import missing_fluid
from tools.wet_perforation import dry, undrained, with_flow

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE.parent / "results" / "pore_sweep.json"
PICTURE = HERE.parents[1] / "docs" / "pictures" / "depth_against_permeability.png"
PERMEABILITIES = (0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9)  # m2
END = 20.0  # us
FINE_END = 10.0  # us
FINE_CELLS = (1.0, 0.5)  # mm; the jet's radius is 1.0 mm at its tip


def removed(run):
    table = run.table("history.csv")
    return sum(table[name][-1] for name in table if name.startswith("removed_") and name != "removed_kinetic")


def row(name, permeability, run):
    table, particles = run.table("history.csv"), run.particles()
    drained = -100.0 * table["fluid_inflow"][-1] / table["fluid"][0 if table["fluid"][0] > 0.0 else 1] if "fluid_inflow" in table else 0.0
    pressure = float(np.nanmax(particles["pore_pressure"])) / 1e6 if "pore_pressure" in particles else 0.0
    return [name, permeability, 1e3 * run.summary["penetration"]["depth"], table["plastic"][-1], pressure, drained, missing_fluid(run),
        removed(run)]


def fine(barreno):
    """Depth [mm] and plastic work [J] of dry and of undrained rock of equal density in fine cells, as sentences."""
    told = []
    for cell in FINE_CELLS:
        rocks = [dry(barreno, FINE_END, cell), undrained(barreno, FINE_END, cell)]
        depths = [1e3 * rock.summary["penetration"]["depth"] for rock in rocks]
        works = [rock.table("history.csv")["plastic"][-1] for rock in rocks]
        told.append(
            f"cells of {cell:g} mm: depth {depths[0]:.2f} mm in dry and {depths[1]:.2f} mm in undrained rock "
            f"({100 * (depths[1] / depths[0] - 1):+.1f} %), "
            f"plastic work {works[0]:.0f} J and {works[1]:.0f} J ({100 * (works[1] / works[0] - 1):+.0f} %)"
        )
    return (
        f" In cells fine enough to hold the jet, to {FINE_END:g} us and from the outer face of the casing; " + "; ".join(told)
        + ". The jet's radius"
        " is 1.0 mm at its tip, twice the size of the smallest of these cells. Compare the effect of the fluid with that of the cell size: "
        "the "
        "depth is not yet independent of the cells. Both rocks are plugs of 24 mm radius, and the waves reach their sides within this time."
    )


def run(barreno, full):
    end = END if full else 6.0
    result = Result(
        "Depth against permeability",
        "One deck, from undrained to drained rock.",
        "none between the limits; permeability 0 is the undrained run, the largest is close to the drained one (dry rock of equal "
        "density).",
        ["rock", "permeability [m2]", "depth [mm]", "plastic work [J]", "highest pore pressure [MPa]", "fluid that left [%]",
            "missing fluid",
         "particles removed"],
        [],
    )  # fmt: skip
    result.rows.append(row("undrained", float("nan"), undrained(barreno, end)))
    for permeability in PERMEABILITIES if full else (0.0, 1e-11, 1e-9):
        result.rows.append(row("saturated", permeability, with_flow(barreno, permeability, end)))
    result.rows.append(row("drained", float("inf"), dry(barreno, end)))
    result.demand("depth with permeability 0 less the undrained one [mm]", abs(result.rows[1][2] - result.rows[0][2]), 0.0)
    result.demand("depth with the highest permeability over the drained one", abs(result.rows[-2][2] / result.rows[-1][2] - 1.0), 5e-3)
    result.demand("missing fluid, maximum", max(r[-2] for r in result.rows), 1e-9)
    gone = max(r[-1] for r in result.rows)
    result.demand("particles removed, maximum", gone, 0.0)
    result.notes = (
        "`verification/depth_against_permeability.py BARRENO` runs the sweep and draws it. The cells of 4 mm only serve the comparison "
        "with the limits. They are twice as wide as the jet, so its depth says little about rock and nothing about the effect of the "
        "fluid."
    )
    if full:
        result.notes += fine(barreno)
    return result


def draw(file):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = json.loads(STORED.read_text())["rows"]
    flow = [r for r in rows if r[0] == "saturated" and r[1] > 0.0]
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
    for one, column, label, unit in ((axes[0], 2, "depth [mm]", 1.0), (axes[1], 3, "plastic work [kJ]", 1e3)):
        one.semilogx([r[1] for r in flow], [r[column] / unit for r in flow], "o-", ms=4, color="C0", label="saturated, pore flow")
        one.axhline(rows[0][column] / unit, color="C1", ls="--", label="undrained")
        one.axhline(rows[-1][column] / unit, color="C2", ls="--", label="drained, equal density")
        one.set_xlabel("permeability [m²]")
        one.set_ylabel(label)
        one.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.savefig(file, dpi=110)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else PICTURE)
