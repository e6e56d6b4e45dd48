# SPDX-License-Identifier: BSD-3-Clause
"""Coasting implosion of a thick shell, resolved by particles: arrest radius against Carroll and Holt's shell.

The exact answer is for an incompressible matrix. Runs at K/G = 10, 20 and 40 are extrapolated linearly in G/K to it;
beside that, every run is compared with a one-dimensional shell of its own K/G, which has no error of space worth
the name: what is left there is the error of the particles and the grid.
"""
import functools
import math

import numpy as np
from tools.case import Result
from tools.octant import radii as radii_of
from tools.runs import order, run_deck

from oracles.shell_motion import Coasting, CompressibleShell
from oracles.shell_statics import Shell

RATIOS = (10.0, 20.0, 40.0)
MATRIX = Shell(porosity=0.2, shear_modulus=15e9, strength=300e6)


@functools.lru_cache(None)
def exact(stop_strain):
    return Coasting(MATRIX, stop_strain)


@functools.lru_cache(None)
def dense(stop_strain, ratio):
    """The one-dimensional shell: history, and pressure profile half-way."""
    coasting = exact(stop_strain)
    shell = CompressibleShell(coasting, ratio * MATRIX.shear_modulus)
    early = shell.history(0.5 * coasting.stop_time)
    half = shell.profile()
    late = shell.history(1.15 * coasting.stop_time)
    return np.hstack([early, late[:, 1:]]), half


def settings(stop_strain, ratio, cells):
    coasting = exact(stop_strain)
    h = (coasting.b0 - coasting.a0) / cells
    side = math.ceil(coasting.b0 / h + 1.0) * h
    return {
        "Grid/Cell Size": repr(h),
        "Grid/Upper": f"{{{side!r}, {side!r}}}",
        "Materials/Matrix/B0": repr(ratio * MATRIX.shear_modulus),
        "Bodies/Shell/Radial Velocity": repr(-coasting.strength / coasting.a0**2),
        "Time/End Time": repr(1.15 * coasting.stop_time),
        "Output/Field Interval": repr(0.5 * coasting.stop_time),
    }


def smallest(time, value):
    """First minimum of a sampled curve (time, value), by the parabola through three points."""
    i = int(np.clip(np.argmin(value), 1, len(value) - 2))
    a, b, c = np.polyfit(time[i - 1 : i + 2] - time[i], value[i - 1 : i + 2], 2)
    return time[i] - 0.5 * b / a, c - 0.25 * b * b / a


def measure(barreno, stop_strain, ratio, cells, more=None):
    """Figures of one run, lengths over the travelled distance of the inner wall; `more` are settings beside the usual."""
    coasting = exact(stop_strain)
    travel = coasting.a0 - coasting.at(coasting.stop_time)[0]
    run = run_deck(barreno, "shell_coasting.xml", {**settings(stop_strain, ratio, cells), **(more or {})})
    radii, history = run.table("radii.csv"), run.table("history.csv")
    (times, _, reference, kinetic), (place, pressure) = dense(stop_strain, ratio)
    difference = radii["Shell_inner_radius"] - np.interp(radii["time"], times, reference)
    start, middle = run.particles(0), run.particles(1)
    r0, r = (radii_of(p)[0] for p in (start, middle))
    c = (r0**3 - r**3) / (coasting.a0**3 - coasting.at(middle["time"])[0] ** 3)
    noise = (middle["pressure"] - np.interp(r, place, pressure)) / MATRIX.strength
    return {
        "cells": cells,
        "stopped": (coasting.a0 - smallest(radii["time"], radii["Shell_inner_radius"])[1]) / travel,
        "dense": (coasting.a0 - smallest(times, reference)[1]) / travel,
        "path": float(np.sqrt(np.mean(difference**2))) / travel,
        "time": smallest(history["time"], history["kinetic"])[0] / smallest(times, kinetic)[0] - 1.0,
        "spread": float(np.std(c)),
        "pressure": float(np.sqrt(np.mean(noise**2))),
        "pressure 99 %": float(np.percentile(np.abs(noise), 99.0)),
        "remainder": abs(run.summary["balances"]["energy"]["error"]),
        "plastic": history["plastic"][-1] / history["kinetic"][0],
        "loss": abs(history["transfer"][-1] + history["stress_integration"][-1]) / history["kinetic"][0],
        "left": float(np.min(history["kinetic"])) / history["kinetic"][0],
    }


def extrapolated(values):
    """Value at G/K = 0 of the line through those at RATIOS, by least squares."""
    return float(np.polyfit([1.0 / ratio for ratio in RATIOS], values, 1)[1])


def refine(barreno, stop_strain, meshes, result):
    """Rows of all runs to one strain; returns figures by K/G and mesh."""
    runs = {}
    for ratio in RATIOS:
        for cells in meshes:
            m = runs[ratio, cells] = measure(barreno, stop_strain, ratio, cells)
            rate = order([runs[ratio, cells // 2]["path"], m["path"]])[0] if cells > meshes[0] else float("nan")
            result.rows.append([stop_strain, f"{ratio:g}", cells, m["stopped"] - 1.0, m["stopped"] - m["dense"], m["path"],
                                rate, m["time"], m["spread"], m["pressure"], m["pressure 99 %"]])  # fmt: skip
    for cells in meshes:
        stopped = extrapolated([runs[ratio, cells]["stopped"] for ratio in RATIOS])
        dense_stop = extrapolated([runs[ratio, cells]["dense"] for ratio in RATIOS])
        result.rows.append([stop_strain, "infinite", cells, stopped - 1.0, stopped - dense_stop] + [""] * 6)
    return runs


def demand(stop_strain, runs, meshes, result):
    name = f"to a strain of {stop_strain}"
    arrest = [extrapolated([runs[ratio, cells]["stopped"] for ratio in RATIOS]) for cells in meshes]
    dense_stop = extrapolated([runs[ratio, meshes[0]]["dense"] for ratio in RATIOS])
    result.demand(f"arrest radius, K/G extrapolated, {meshes[2]} cells, over the travel, {name}", abs(arrest[2] - 1.0), 5e-3)
    errors = [abs(value - dense_stop) for value in arrest]
    result.demand(f"its error against the dense shell falls, {meshes[1]} over {meshes[0]} cells, {name}", errors[1] / errors[0], 0.5)
    result.demand(f"and at {meshes[2]} cells is, {name}", errors[2], 1e-3)
    for ratio in RATIOS:
        path = [runs[ratio, cells]["path"] for cells in meshes]
        result.demand(f"K/G = {ratio:g}: order of the path of the inner wall, {name}", min(order(path)[:2]), 1.5, at_least=True)
        noise = [runs[ratio, cells]["pressure"] for cells in meshes]
        result.demand(f"K/G = {ratio:g}: order of the pressures, {name}", order([noise[0], noise[2]], 4.0)[0], 0.8, at_least=True)
    fine = [runs[ratio, meshes[2]] for ratio in RATIOS]
    result.demand(f"instant of least kinetic energy, relative, {name}", max(abs(m["time"]) for m in fine), 5e-3)
    result.demand(f"kinetic energy left then, relative, {name}", max(m["left"] for m in fine), 2e-3)
    result.demand(f"energy ledger remainder, {name}", max(m["remainder"] for m in fine), 1e-3)
    result.demand(f"energy lost by projection and stress integration, over the initial, {name}", max(m["loss"] for m in fine), 2e-3)


def run(barreno, full):
    result = Result(
        "Coasting implosion of a thick shell",
        "GIMP, axisymmetric, von Mises: plastic work, inertia and curved free surfaces combined.",
        "Carroll and Holt's shell with inertia, law H (`verification/oracles/shell_motion.py`), incompressible; "
        "and a one-dimensional shell of the same K/G (dense). Lengths relative to the travel of the inner wall, pressures relative to Y, "
        "half-way.",
        ["stop strain", "K/G", "cells in the wall", "travel, error against exact", "against dense", "rms path error against dense",
         "order", "time of least kinetic energy, error", "spread of r^3 - R^3", "rms pressure error", "99 % of pressure errors"],
        [],
    )  # fmt: skip
    meshes = (8, 16, 32, 64) if full else (6, 12, 24)
    demand(-0.08, refine(barreno, -0.08, meshes, result), meshes, result)
    if full:
        demand(-0.15, refine(barreno, -0.15, meshes[:3], result), meshes[:3], result)
    result.notes = (
        "The inner radius is that of `radii.csv`: from the mass average of r^3 and the volume. The remaining error of the extrapolated "
        "travel at fine meshes is that of the extrapolation: the shell rings at a period that depends on K/G. Pressures of single "
        "particles are noisy, the more so the stiffer the matrix, which suggests volumetric locking; the noise decreases with the cells "
        "and hardly affects the motion."
    )
    return result
