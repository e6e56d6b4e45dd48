# SPDX-License-Identifier: BSD-3-Clause
"""Pore flow between none and all: permeability, length of a solve, fluid. A solve knows k dt alone: permeabilities of 1e-42 to 1e30 m2
are steps of 1e-12 to 1e12 s many times over."""
import numpy as np
from tools.small_decks import DECKS, attempt_file

PORES = (0.3, 0.9)  # part of the column's height that is looked at, away from its drained top


def column(permeability, end=5e-3, **more):
    settings = {
        "Pore Flow/Rocks/Rock/Permeability": f"{{{permeability!r} m2}}",
        "Pore Flow/Drainage": "on",
        "Time/End Time": repr(end),
        "Output/Field Interval": repr(end),
        "Output/History Interval": repr(end / 10),
    }
    return {**settings, **more}


def run_column(barreno, settings):
    return attempt_file(barreno, DECKS / "terzaghi.xml", settings, longest=120.0)


def pressures(run):
    now = run.particles()
    return now["pore_pressure"][(now["y"] > PORES[0]) & (now["y"] < PORES[1])]


def missing(run):
    return abs(float(run.table("history.csv")["fluid_error"][-1]))


def flow_rows(barreno, full, table):
    title = "Permeability and length of a solve"
    closed = run_column(barreno, {**column(1e-12), "Pore Flow/Drainage": "off"})
    if not closed.finished:
        table.finishes(title, "no drainage", closed, "exit code", lambda r: 0, 0)
        return
    reference = pressures(closed.run)
    scale = float(np.abs(reference).max())
    words = ("pore", "t = ")
    for permeability in (0.0, 1e-42, 1e-30):
        done = run_column(barreno, column(permeability))
        table.holds_or_stops(title, f"k = {permeability:g} m2", done, "largest difference from undrained pressures, relative",
                             lambda r: np.abs(pressures(r) - reference).max() / scale, 0.0 if permeability == 0.0 else 1e-8,
                             *words)  # fmt: skip
    for permeability in (1e-6, 1e0, 1e12, 1e30):
        done = run_column(barreno, column(permeability))
        table.holds_or_stops(title, f"k = {permeability:g} m2", done, "largest pore pressure over the undrained one",
            lambda r: np.abs(pressures(r)).max() / scale, 1e-3,
                             *words)  # fmt: skip
        if done.finished:
            table.within(title, f"k = {permeability:g} m2", "missing fluid", missing(done.run), 1e-8)
    plain = run_column(barreno, column(1.38580246914e-12))
    for number in (1e-12, 1e12):
        done = run_column(barreno, column(1.38580246914e-12, **{"Pore Flow/Diffusion Number": repr(number)}))
        setup = f"Diffusion Number {number:g}: {'a solve in every step' if number < 1 else 'one solve at most'}"
        if number < 1:
            table.holds_or_stops(title, setup, done, "largest difference of pressures from the default's, over the undrained one",
                                 lambda r: np.abs(pressures(r) - pressures(plain.run)).max() / scale, 0.02, *words)  # fmt: skip
        else:
            table.holds_or_stops(title, setup, done, "largest difference from undrained pressures, relative",
                                 lambda r: np.abs(pressures(r) - reference).max() / scale, 1e-8, *words)  # fmt: skip


def fluid_rows(barreno, full, table):
    title = "Fluid of the pore flow"
    for fluid in (1e12, 1e30):
        done = run_column(barreno, column(1e-12, end=2e-3, **{"Materials/Rock/Fluid Bulk Modulus": repr(fluid)}))
        setup = f"Kf = {fluid:g} Pa"
        if done.code == 1:
            table.stops(title, setup, done, 1, "Fluid Bulk Modulus")
            continue
        table.holds_or_stops(title, setup, done, "missing fluid", missing, 1e-8, "pore")
        if done.finished:
            finite = np.isfinite(pressures(done.run)).all()
            table.within(title, setup, "pressures that are finite", float(finite), 1.0, at_least=True)
    for viscosity in ("1e-30 Pa s", "1e30 Pa s"):
        done = run_column(barreno, column(1e-12, end=2e-3, **{"Pore Flow/Viscosity": viscosity}))
        table.holds_or_stops(title, f"viscosity {viscosity}", done, "missing fluid", missing, 1e-8, "pore")
    for name, value in (("Viscosity", "0 Pa s"), ("Diffusion Number", "0"), ("Rocks/Rock/Permeability", "{-1e-12 m2}")):
        done = run_column(barreno, {**column(1e-12), f"Pore Flow/{name}": value})
        table.stops(title, f"{name} = {value}", done, 1, name.split("/")[-1])


def run(barreno, full, table):
    flow_rows(barreno, full, table)
    fluid_rows(barreno, full, table)
