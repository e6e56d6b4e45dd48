# SPDX-License-Identifier: BSD-3-Clause
"""Figure 2: a jet formed and shot into rock in three dimensions, bent by a detonator beside the axis."""
import contextlib

import matplotlib.pyplot as plt
import numpy as np
from barreno.report.energy_picture import put_in
from barreno.report.run import Run
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from paper_figures.lab import MICRO, MILLI, Table, least, most

TABLES = ("paper_2",)
DECK = "../jet_formation_3d.xml"
FACE, DETONATOR = 106.0, 10.0  # mm, of the deck: y of the rock's face, x of the detonator
SHOWN = (8.0, 12.0, 20.0, 32.0)  # us
QUICK = (8.0, 12.0)  # us, of the short form: when the liner collapses, in cells twice as wide
FAST = 2000.0  # m/s: what is called jet
COLUMNS = ["time [us]", "fastest copper [m/s]", "jet [% of the liner]", "its angle to the axis [degrees]", "its place beside the axis [mm]",
    "copper in the rock, deepest [mm]", "numerical energy"]
SIDES = ["time [us]", "towards the axis, on the detonator's side [m/s]", "on the other [m/s]"]
COLOURS = {"Comp B": "0.86", "Sandstone": "tan", "Copper": "C3"}  # what is drawn later covers what was drawn before
BEHIND = "#e88080"  # copper behind the plane
NAMES = {"Comp B": "explosive and its products", "Sandstone": "sandstone", "Copper": "copper"}


def measure(lab):
    folder = lab.run(DECK,
        lab.of_form({"Time/End Time": f"{QUICK[-1]:g} us", "Grid/Cell Size": "4 mm", "Grid/Upper": "{42 mm, 150 mm, 44 mm}"}, {}),
        "formation-3d")
    with contextlib.ExitStack() as stack:
        run = Run(folder, stack)
        lost = numerical_energy(run)
        rows = [row_of(run.file.frame(step), lost) for step in range(1, len(run.file.times))]
        draw(lab.picture("paper_2"), run, lab.of_form(QUICK, SHOWN))
        sides = Table("Figure 2: inward speed of the liner's halves", SIDES,
            [[frame.time / MICRO, *inward(frame)] for frame in (run.frame(QUICK[0] * MICRO),)])
    remark = (
        "Figure 2: input_xml/jet_formation_3d.xml; jet: copper faster than 2 km/s along the axis; angle and place are positive on the "
        "detonator's side; numerical energy: until then, over what was put in until then"
    )
    return {"paper_2": Table(remark, COLUMNS, rows)} | ({"sides": sides} if lab.form == "quick" else {})


def numerical_energy(run):
    """Time to what the method has added or lost by then, over what was put in."""
    table = run.history_table()
    given = put_in(table, run.summary)
    share = np.divide(table["stress_integration"] + table["transfer"], given, out=np.zeros_like(given),
        where=given > 0.0)  # nothing burns at the start
    return lambda time: float(np.interp(time, table["time"], share))


def row_of(frame, lost):
    """A row of the table; particles of the liner are alike in mass."""
    copper = frame.block == frame.file.block_names.index("Copper")
    centres = frame.centres[copper] / MILLI
    across, along = (frame.of_alive([f"velocity_{axis}"])[copper] for axis in "xy")
    fast = along > FAST
    angle, place = np.nan, np.nan
    if fast.any():
        angle = float(np.degrees(np.arctan2(across[fast].mean(), along[fast].mean())))
        place = float(centres[fast, 0].mean())
    deepest = max(0.0, float(centres[:, 1].max() - FACE))
    return [round(frame.time / MICRO, 6), float(along.max()), float(100.0 * fast.mean()), angle, place, deepest, lost(frame.time)]


def inward(frame):
    """Mean speed of copper towards the axis, in m/s: on the detonator's side, on the other."""
    copper = frame.block == frame.file.block_names.index("Copper")
    x, across = frame.centres[copper, 0], frame.of_alive(["velocity_x"])[copper]
    return [float(-across[x > 0.0].mean()), float(across[x < 0.0].mean())]


def draw_frame(axes, frame):
    """Particles that the plane of symmetry cuts, in their deformed shapes, over the centres of the liner's others: few are cut of a jet
    that is thin."""
    centres = frame.centres[frame.block == frame.file.block_names.index("Copper")] / MILLI
    axes.plot(centres[:, 0], centres[:, 1], ".", color=BEHIND, ms=2.5, mew=0, zorder=1.5, rasterized=True)
    shapes, of = frame.shapes
    names = np.array(frame.file.block_names)[frame.block[of]]
    for name, colour in COLOURS.items():
        axes.add_collection(PolyCollection(shapes[names == name] / MILLI, facecolors=colour, edgecolors="none", linewidths=0,
            antialiased=False, rasterized=True, zorder=2.0 if name == "Copper" else 1.0))


def draw(file, run, shown):
    figure, panels = plt.subplots(1, len(shown), figsize=(3.0 * len(shown), 6.4), layout="constrained", sharey=True)
    for axes, time in zip(panels, shown):
        draw_frame(axes, run.frame(time * MICRO))
        axes.axvline(0.0, color="k", lw=0.5, ls=":")
        axes.plot([DETONATOR], [0.0], "k*", ms=7)
        axes.set(title=f"{time:g} µs", xlabel="x [mm]", xlim=(-40.0, 40.0), ylim=(148.0, -26.0), aspect="equal")
    panels[0].set_ylabel("y [mm]")
    legend = [*(Patch(color=colour, label=NAMES[name]) for name, colour in COLOURS.items()),
        Line2D([], [], color=BEHIND, marker=".", ls="none", ms=8, label="copper behind the plane"),
        Line2D([], [], color="k", marker="*", ls="none", ms=8, label="detonator")]
    figure.legend(handles=legend, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=len(legend), frameon=False)
    figure.savefig(file, dpi=110, bbox_inches="tight")  # the legend is below the panels
    plt.close(figure)


def trends(tables):
    table = tables["paper_2"]
    last = {name: table.column(name)[-1] for name in COLUMNS}
    lost = [most("2: numerical energy over energy put in", abs(last[COLUMNS[6]]), 0.12)]
    if last["time [us]"] <= QUICK[-1]:
        lit, other = (tables["sides"].value(name) for name in SIDES[1:])
        return [
            least("2: collapsing liner: fastest copper [m/s]", table.column(COLUMNS[1]).max(), 1000.0),
            least("2: side that is lit first over the other: speed towards the axis", lit / other, 1.1),
            *lost,
        ]
    return [
        least("2: formed jet: fastest copper [m/s]", table.column(COLUMNS[1]).max(), 5000.0),
        most("2: jet at the end, negative away from the detonator: angle to the axis [degrees]", last[COLUMNS[3]], -0.3),
        most("2: jet at the end, negative away from the detonator: place beside the axis [mm]", last[COLUMNS[4]], -0.3),
        least("2: jet: depth in the rock [mm]", last[COLUMNS[5]], 5.0),
        *lost,
    ]
