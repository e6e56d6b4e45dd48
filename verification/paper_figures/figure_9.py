# SPDX-License-Identifier: BSD-3-Clause
"""Figure 9: an aluminium rod into a Drucker-Prager block: associated flow, with porosity, and nonassociated flow."""
import contextlib

import numpy as np
from barreno.report.run import Run
from paper_figures.lab import MICRO, MILLI, Table, least, most
from paper_figures.shots import draw_channels

TABLES = ("paper_9",)
DECK = "rod.xml"
BLOCK = "Materials/Block"
# Pores of 5 % whose cap lies at 2 GPa, beyond what the rod exerts: they close after dilation only, which moves the cap to lower pressures.
FORMS = {
    "associated": {},
    "with porosity": {f"{BLOCK}/p3_crush_curve": "0.05", f"{BLOCK}/p0_crush_curve": "-6 GPa", f"{BLOCK}/p1_crush_curve": "1e-10 1/Pa"},
    "nonassociated": {f"{BLOCK}/BETA_nonassociativity": "0.2"},
}
CELLS = {"quick": 2.0, "default": 1.0, "fine": 0.5}  # mm; the rod's radius is 5 mm
SWOLLEN = 1.2  # volume over that of the start
ABOVE = 2.0  # mm above the face: what is there has been thrown out


def measured(folder):
    """[depth of the rod's nose, volume gained and share of swollen block, fastest of what was thrown out, removed]"""
    with contextlib.ExitStack() as stack:
        run = Run(folder, stack)
        start, fastest = run.file.frame(0), 0.0
        volume = np.zeros(len(start.alive))
        volume[start.alive] = 2.0 * np.pi * start.centres[:, 0] * np.ptp(start.corners, axis=1).prod(axis=1)
        for step in range(len(run.file.times)):
            frame = run.file.frame(step)
            block = frame.block == run.file.block_names.index("Block")
            out = block & (frame.centres[:, 1] < -ABOVE * MILLI)
            fastest = max(fastest, float(-frame.of_alive(["velocity_y"])[out].min(initial=0.0)))
        ratio, first = frame.of_alive(["volume_ratio"])[block], volume[frame.alive][block]
        gained = float(np.sum(first * (ratio - 1.0))) * 1e6
        share = float(first[ratio > SWOLLEN].sum()) * 1e6
        nose = float(frame.centres[~block][:, 1].max()) / MILLI
        return [nose, gained, share, fastest, float(sum(kind["count"] for kind in run.summary["removed_particles"].values()))]


def measure(lab):
    cells = CELLS[lab.form]
    folders = lab.runs([(DECK, {"Grid/Cell Size": f"{cells:g} mm", **more}, f"rod-{name.replace(' ', '-')}")
        for name, more in FORMS.items()])
    rows = [[name, *measured(folder)] for name, folder in zip(FORMS, folders)]
    with contextlib.ExitStack() as stack:
        time = Run(folders[0], stack).file.times[-1] / MICRO
    columns = ["flow", "depth of the nose [mm]", "volume gained [cm3]", "swollen by more than a fifth [cm3]", "fastest ejecta [m/s]",
        "particles removed"]
    if lab.form != "quick":
        channels = [(f"{row[0]}\nnose {row[1]:.1f} mm deep at {time:g} µs", folder) for row, folder in zip(rows, folders)]
        fields, limits = ("pressure", "plastic_volume_strain"), ((0.0, 1000.0), (-0.6, 0.6))
        draw_channels(lab.picture("paper_9"), channels, fields, limits, (30.0, -32.0, 40.0), edges=True)
    return {"paper_9": Table(f"Figure 9: input_xml/paper/{DECK}, cells of {cells:g} mm, {time:g} us", columns, rows)}


def trends(tables):
    table = tables["paper_9"]
    depth, gained, fastest = ({name: float(table.value(column, flow=name)) for name in FORMS}
        for column in ("depth of the nose [mm]", "volume gained [cm3]", "fastest ejecta [m/s]"))
    associated, porous, nonassociated = FORMS
    return [
        least("9: associated over nonassociated flow: volume gained", gained[associated] / gained[nonassociated], 3.0),
        least("9: associated flow over porosity: volume gained", gained[associated] / gained[porous], 3.0),
        most("9: associated over nonassociated flow: depth", depth[associated] / depth[nonassociated], 0.7),
        most("9: porosity over nonassociated flow, less 1: depth", abs(depth[porous] / depth[nonassociated] - 1.0), 0.4),
        least("9: associated over nonassociated flow: fastest ejecta", fastest[associated] / fastest[nonassociated], 1.1),
    ]
