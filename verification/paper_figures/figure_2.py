# SPDX-License-Identifier: BSD-3-Clause
"""Figure 2: a jet formed and shot into rock in three dimensions, bent by a detonator beside the axis."""
import contextlib

import matplotlib.pyplot as plt
import netCDF4
import numpy as np
from paper_figures.lab import MICRO, MILLI, Table, least, most, summary_of

TABLES = ("paper_2",)
DECK = "../jet_formation_3d.xml"
FACE, DETONATOR = 106.0, 10.0  # mm, of the deck: y of the rock's face, x of the detonator
SHOWN = (8.0, 12.0, 20.0, 32.0)  # us
FAST = 2000.0  # m/s: what is called jet
SLICE = 3.0  # mm from the plane of symmetry: particles that are drawn
COLUMNS = ["time [us]", "fastest copper [m/s]", "jet [% of the liner]", "its angle to the axis [degrees]", "its place beside the axis [mm]", "copper in the rock, deepest [mm]", "numerical energy"]
COLOURS = {"Comp B": "0.82", "Copper": "C3", "Sandstone": "tan"}


def words(file, name):
    return ["".join(c.decode() for c in row if c).strip() for row in np.ma.filled(file[name][:], b"")]


def frames(folder):
    """{time [us]: {material: (centres [mm], velocities [m/s])}} of living particles."""
    out = {}
    with contextlib.closing(netCDF4.Dataset(folder / "particles.e")) as file:
        variables, blocks = words(file, "name_elem_var"), words(file, "eb_names")
        start = np.stack([file[f"coord{axis}"][:] for axis in "xyz"], axis=1)
        for step, time in enumerate(np.asarray(file["time_whole"][:]) / MICRO):
            nodes = start + np.stack([file[f"vals_nod_var{i + 1}"][step] for i in range(3)], axis=1)
            out[round(float(time), 6)] = {block: particles_of(file, variables, nodes, i + 1, step) for i, block in enumerate(blocks)}
    return out


def particles_of(file, variables, nodes, block, step):
    def field(name):
        return np.asarray(file[f"vals_elem_var{variables.index(name) + 1}eb{block}"][step], dtype=float)

    corners = np.asarray(nodes)[file[f"connect{block}"][:] - 1]
    alive = field("status") > 0.0
    centres = corners.mean(axis=1) / MILLI
    velocity = np.stack([field(f"velocity_{axis}") for axis in "xyz"], axis=1)
    return centres[alive], velocity[alive]


def measure(lab):
    folder = lab.run(DECK, {}, "formation-3d")
    found = frames(folder)
    rows = [row_of(time, found[time]["Copper"]) for time in sorted(found)[1:]]
    share = summary_of(folder)["balances"]["energy"]
    lost = share["stress_integration_share"] + share["transfer_share"]
    if lab.form != "quick":
        draw(lab.picture("paper_2"), found)
    remark = "Figure 2: input_xml/jet_formation_3d.xml; jet: copper faster than 2 km/s along the axis; angle and place are positive on the detonator's side; numerical energy: of the whole run"
    return {"paper_2": Table(remark, COLUMNS, [[*row, lost] for row in rows])}


def row_of(time, copper):
    """A row of the table without the energy; particles of the liner are alike in mass."""
    centres, velocity = copper
    fast = velocity[:, 1] > FAST
    angle, place = np.nan, np.nan
    if fast.any():
        angle = float(np.degrees(np.arctan2(velocity[fast, 0].mean(), velocity[fast, 1].mean())))
        place = float(centres[fast, 0].mean())
    return [time, float(velocity[:, 1].max()), float(100.0 * fast.mean()), angle, place, max(0.0, float(centres[:, 1].max() - FACE))]


def draw(file, found):
    figure, panels = plt.subplots(1, len(SHOWN), figsize=(12.0, 6.2), layout="constrained", sharey=True)
    for axes, time in zip(panels, SHOWN):
        for name, (centres, _) in found[time].items():
            near = centres[:, 2] < SLICE
            axes.plot(*centres[near][:, :2].T, ".", ms=2.2, color=COLOURS[name], label=name)
        axes.axvline(0.0, color="k", lw=0.5, ls=":")
        axes.plot([DETONATOR], [0.0], "k*", ms=5, label="detonator")
        axes.set(title=f"{time:g} µs", xlabel="x [mm]", xlim=(-40.0, 40.0), ylim=(148.0, -46.0), aspect="equal")
    panels[0].set_ylabel("y [mm]")
    panels[0].legend(loc="upper center", ncol=2, fontsize=8, markerscale=1.5)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(tables):
    table = tables["paper_2"]
    last = {name: table.column(name)[-1] for name in COLUMNS}
    return [
        least("2: a jet is formed: fastest copper [m/s]", table.column(COLUMNS[1]).max(), 5000.0),
        most("2: the jet leaves the axis, away from the detonator: its angle at the end [degrees]", last[COLUMNS[3]], -0.3),
        most("2: and its place beside the axis [mm]", last[COLUMNS[4]], -0.3),
        least("2: it enters the rock [mm]", last[COLUMNS[5]], 5.0),
        most("2: energy that the method adds or loses, over what was put in", abs(last[COLUMNS[6]]), 0.12),
    ]
