# SPDX-License-Identifier: BSD-3-Clause
"""Columns of saturated rock that drain at their top: settings of input_xml/terzaghi.xml and what its runs left."""

import numpy as np
from tools.manufactured_runs import centres
from tools.runs import run_deck

from oracles import consolidation as exact

ROCK = exact.BEREA
HEIGHT, LOAD, RAMP = 1.0, 1e6, 1e-3  # m, Pa, s: of the deck
VISCOSITY, DIFFUSIVITY = 1e-3, 10.0  # Pa s, m2/s: of the deck
PRESSURE = ROCK.uniaxial_loading * LOAD  # that the load leaves in the pores
# The deck drains fast enough for the waves of the load to matter by some 0.1 %; a quarter of its permeability does not.
SLOWER = 4.0


def permeability(slower):
    """[m2]"""
    return DIFFUSIVITY * ROCK.uniaxial_storage * VISCOSITY / slower


def diffusion_number(steps, dt, h, slower):
    """The Diffusion Number that solves every so many steps of dt: half a step less, so that rounding decides nothing."""
    return (steps - 0.5) * dt * permeability(slower) / VISCOSITY / ROCK.storage / h**2


def column_settings(mode, h, slower=SLOWER):
    """Two cells wide, so that all cells are full."""
    wide = 2.0 * h
    sides = f"{wide!r} m, {{height!r}} m" + (f", {wide!r} m" if mode == "3D" else "")
    settings = {
        "Grid/Mode": mode,
        "Grid/Cell Size": repr(h),
        "Grid/Lower": "{0 m, 0 m, 0 m}" if mode == "3D" else "{0 m, 0 m}",
        "Grid/Upper": "{" + sides.format(height=1.2 * HEIGHT) + "}",
        "Bodies/Column/Lower": "{0 m, 0 m, 0 m}" if mode == "3D" else "{0 m, 0 m}",
        "Bodies/Column/Upper": "{" + sides.format(height=HEIGHT) + "}",
        "Pore Flow/Rocks/Rock/Permeability": f"{{{permeability(slower)!r} m2}}",
        "Step/Damping": "1000 1/s",
    }
    if mode == "3D":
        for side in ("lower", "upper"):
            settings[f"Conditions/z {side}/Face"] = f"z_{side}"
            settings[f"Conditions/z {side}/Kind"] = "symmetry"
    return settings


def column_run(barreno, mode, h, times, slower=SLOWER, more=None):
    """A run to the last of so many times T = c t / height^2, with fields at each multiple of the first."""
    second = slower * HEIGHT**2 / DIFFUSIVITY
    settings = column_settings(mode, h, slower)
    settings.update({"Time/End Time": repr(times[-1] * second), "Output/Field Interval": repr(times[0] * second)})
    return run_deck(barreno, "terzaghi.xml", {**settings, **(more or {})})


def state_of(run, instant, slower=SLOWER):
    """T, depths of the particles below the top over the height, their pressures over PRESSURE, settlement of the top [m]."""
    particles = run.particles(instant)
    T = particles["time"] * DIFFUSIVITY / slower / HEIGHT**2
    depth = 1.0 - centres(particles)[1] / HEIGHT
    return T, depth, particles["pore_pressure"] / PRESSURE, HEIGHT - float(particles["corners"][..., 1].max())
