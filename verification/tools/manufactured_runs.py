# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the manufactured motions and their errors: what the cases on them share."""
import json
import pathlib
import re

import numpy as np
from tools.runs import run_deck, scratch_folder

from oracles import manufactured as exact

BOX = exact.Solid(1e7, 0.3, 1000.0)
VORTEX = exact.Solid(1e3, 0.3, 1000.0)
RING = exact.Solid(1e7, 0.0, 1000.0)
RING_RADII = (0.4, 0.6)
PHASES = (0.0, np.pi, 0.0)
GRID_CORNER = {"plane strain": 2, "axisymmetric": 2, "3D": 3}


class Failed:
    """A run that lost particles or ended early: a finding, not an error of the case."""

    def __init__(self, why):
        self.why = why


def corner(mode, value):
    return "{" + ", ".join([f"{value!r} m"] * GRID_CORNER[mode]) + "}"


def box_run(barreno, mode, shape, amplitude, cells, per_cell, more=None):
    """Axis-aligned displacement of the unit box, half a period, with more settings; its exact motion as x(X, t)."""
    settings = {
        "Grid/Mode": mode,
        "Grid/Cell Size": repr(1.0 / cells),
        "Body Force/Amplitude": repr(amplitude),
        "Bodies/Box/Particles Per Cell": str(per_cell),
        "Step/Shape Function": shape,
    }
    if mode == "3D":
        settings.update({"Grid/Lower": corner(mode, 0.0), "Grid/Upper": corner(mode, 1.0),
                         "Bodies/Box/Lower": corner(mode, 0.0), "Bodies/Box/Upper": corner(mode, 1.0)})  # fmt: skip
        for side in ("lower", "upper"):
            settings[f"Conditions/z {side}/Face"] = f"z_{side}"
            settings[f"Conditions/z {side}/Kind"] = "symmetry"
    if mode == "axisymmetric":
        motion = lambda X, t: exact.axisymmetric(BOX, amplitude, PHASES[1], X, t)[0]  # noqa: E731
    else:
        motion = lambda X, t: exact.aligned(BOX, amplitude, PHASES[: len(X)], X, t)[0]  # noqa: E731
    return attempt(barreno, "manufactured_box.xml", {**settings, **(more or {})}), motion


def vortex_run(barreno, shape, angle, h, end=1.0, per_cell=2, domain="1", extra=None):
    settings = {
        "Step/Largest Domain": domain,
        "Grid/Cell Size": repr(h),
        "Body Force/Angle": repr(angle),
        "Bodies/Disk/Particles Per Cell": str(per_cell),
        "Step/Shape Function": shape,
        "Time/End Time": repr(end),
        "Output/Field Interval": repr(0.1 * end),
    }
    settings.update(extra or {})
    return attempt(barreno, "manufactured_vortex.xml", settings), lambda X, t: exact.vortex(VORTEX, angle, X, t)[0]


def ring_run(barreno, shape, amplitude, h, per_cell=2):
    settings = {
        "Grid/Cell Size": repr(h),
        "Body Force/Amplitude": repr(amplitude),
        "Bodies/Disk/Particles Per Cell": str(per_cell),
        "Step/Shape Function": shape,
    }
    return attempt(barreno, "manufactured_ring.xml", settings), lambda X, t: exact.ring(RING, amplitude, *RING_RADII, X, t)[0]


def attempt(barreno, deck, settings):
    """The finished run, or Failed."""
    folder = pathlib.Path(scratch_folder()) / "run"
    try:
        run = run_deck(barreno, deck, settings, folder=folder)
    except RuntimeError as error:
        if " ended with 3:" not in str(error):
            raise
        reason = json.loads((folder / "summary.json").read_text())["reason"]
        at = re.search(r"at t = [\d.e+-]+ ?\w*", reason)
        return Failed("stopped " + (at.group(0) if at else reason))
    lost = int((run.particles(only=("status",))["status"] < 0.5).sum())
    return Failed(f"{lost} particles left the grid") if lost else run


def centres(particles):
    """Particle positions: the mean of the corners that files hold."""
    return np.moveaxis(particles["corners"].mean(axis=1), -1, 0)


def displacement_error(run, motion):
    """Largest over the written instants of the rms and of the greatest |x - x_exact| over all particles [length]; and the
    largest exact displacement, for scale."""
    start = run.particles(0, only=())
    X = centres(start)
    rms = greatest = scale = 0.0
    for step in range(1, run.instants()):
        now = run.particles(step, only=())
        wanted = np.array(motion(list(X), now["time"]))
        square = ((centres(now) - wanted) ** 2).sum(axis=0)
        rms, greatest = max(rms, float(np.sqrt(square.mean()))), max(greatest, float(np.sqrt(square.max())))
        scale = max(scale, float(np.sqrt(((wanted - X) ** 2).sum(axis=0).max())))
    return rms, greatest, scale
