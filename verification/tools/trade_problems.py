# SPDX-License-Identifier: BSD-3-Clause
"""The problems of the trade between error and cost: a run of each with chosen deck words, and its errors.

A problem takes (barreno, level, words, per cell) and returns its error, a second one, and the run. Words are of Step, and
"Tolerance", "Jet" and "Jet Mass" where a problem has what they speak of.
"""
import dataclasses
import functools

import numpy as np
from cases import shell_coasting, shock_copper
from tools.manufactured_runs import Failed, box_run, displacement_error
from tools.octant import radii as radii_of
from tools.runs import run_deck

AMPLITUDE = 0.1
STRAIN, RATIO = -0.08, 10.0  # of the shell: until where, and K/G
MILLI = 1e-3
NO_SHOCK = {"Step/Linear Viscosity": "0", "Step/Quadratic Viscosity": "0"}


class Lost(Exception):
    """The run ended early or lost particles."""


def deck_words(words, bodies, per_cell, rock=None, jet=False):
    """Settings of a deck from the words of a variant; those that the problem has nothing for are left out."""
    out = {f"Bodies/{body}/Particles Per Cell": str(per_cell) for body in bodies}
    out.update({f"Step/{name}": value for name, value in words.items() if name not in ("Tolerance", "Jet")})
    if rock and "Tolerance" in words:
        out[f"Materials/{rock}/Tolerance"] = words["Tolerance"]
    if jet and "Jet" in words:
        out["Jet/Particles Per Cell"] = words["Jet"]
    return out


def finished(make):
    try:
        return make()
    except RuntimeError as error:
        raise Lost(str(error)[-120:]) from error


def box(barreno, cells, words, per_cell):
    """Axis-aligned displacement in plane strain: rms and greatest displacement error over the amplitude."""
    more = {"Step/Courant Fraction": "0.8", **deck_words(words, (), per_cell)}
    shape = more.pop("Step/Shape Function", "GIMP")
    run, motion = box_run(barreno, "plane strain", shape, AMPLITUDE, cells, per_cell, more)
    if isinstance(run, Failed):
        raise Lost(run.why)
    rms, greatest, _ = displacement_error(run, motion)
    return rms / AMPLITUDE, greatest / AMPLITUDE, run


def shell(barreno, cells, words, per_cell):
    """Coasting shell against the one-dimensional shell of its own K/G: rms path of the wall over its travel, rms pressure over Y."""
    coasting = shell_coasting.exact(STRAIN)
    settings = {**shell_coasting.settings(STRAIN, RATIO, cells), **deck_words(words, ["Shell"], per_cell, rock="Matrix")}
    run = finished(lambda: run_deck(barreno, "shell_coasting.xml", settings))
    (times, _, reference, _), (place, pressure) = shell_coasting.dense(STRAIN, RATIO)
    radii, middle = run.table("radii.csv"), run.particles(1)
    difference = radii["Shell_inner_radius"] - np.interp(radii["time"], times, reference)
    travel = coasting.a0 - coasting.at(coasting.stop_time)[0]
    noise = (middle["pressure"] - np.interp(radii_of(middle)[0], place, pressure)) / shell_coasting.MATRIX.strength
    return float(np.sqrt(np.mean(difference**2))) / travel, float(np.sqrt(np.mean(noise**2))), run


def shock(barreno, h, words, per_cell):
    """Copper plates: mean |p - exact| over the plates, over that of the exact profile; error of the plateau's internal energy."""
    settings = {**shock_copper.settings(h), **deck_words(words, ("Left plate", "Right plate"), per_cell)}
    run = finished(lambda: run_deck(barreno, "shock_copper.xml", settings))
    last = run.particles()
    reach = (shock_copper.SHOCK_SPEED - shock_copper.SPEED) * last["time"]
    exact = np.where(np.abs(last["x"]) < reach, shock_copper.PRESSURE, 0.0)
    plateau, _ = shock_copper.plateau(run)
    return float(np.abs(last["pressure"] - exact).sum() / exact.sum()), abs(plateau["internal_energy"] / shock_copper.ENERGY - 1.0), run


# The first 20 us of perforation_quick.xml in a target that is cut down to what they need.
SMALL_TARGET = {
    "Grid/Lower": "{0 mm, -16 mm}",
    "Grid/Upper": "{40 mm, 124 mm}",
    "Bodies/Casing/Upper": "{30.8 mm, 12.7 mm}",
    "Bodies/Rock/Upper": "{30.8 mm, 112.7 mm}",
    "Output/Field Interval": "0 s",
    "Output/History Interval": "0.2 us",
    "Time/End Time": "20 us",
}


def perforation(barreno, h, words, per_cell):
    """Depth and depth of the open channel in mm: answers, whose errors follow (judge_depths of trade.py)."""
    settings = {**SMALL_TARGET, "Grid/Cell Size": f"{h} mm", **deck_words(words, ("Casing", "Rock"), per_cell, "Sandstone", jet=True)}
    run = finished(lambda: run_deck(barreno, "perforation_quick.xml", settings))
    found = run.summary["penetration"]
    return found["depth"] / MILLI, found["channel_depth"] / MILLI, run


@dataclasses.dataclass
class Problem:
    name: str
    title: str
    measure: object
    levels: tuple  # coarse to fine
    finest: tuple  # further levels of the shape functions and the fidelities
    unit: str  # of a level
    error: str
    second: str
    tiny: tuple = ()


PROBLEMS = (
    Problem("box", "Manufactured motion (box, A = 0.1, plane strain)", box, (8, 16, 32), (64,), "cells", "rms displacement error / A",
            "greatest error / A", (8, 16)),
    Problem("shell", "Coasting spherical shell (axisymmetric, von Mises)", shell, (8, 16), (32,), "cells in the wall",
            "rms path error / travel", "rms pressure error / Y", ()),
    Problem("shock", "Shock in copper (plane strain)", shock, (1.0, 0.5), (0.25,), "mm", "mean pressure error / mean pressure",
            "error of internal energy", (1.0, 0.5)),
    Problem("depth", "Perforation depth at 20 us (axisymmetric, small target)", perforation, (2.0, 1.0), (), "mm",
            "error of the depth", "depth [mm]", ()),
)  # fmt: skip


@functools.lru_cache(None)
def has(problem, word):
    """Whether a word of a variant means something to a problem."""
    if word == "Tolerance":
        return problem in ("shell", "depth")
    return problem == "depth" if word == "Jet" else True
