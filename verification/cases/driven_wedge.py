# SPDX-License-Identifier: BSD-3-Clause
"""Plates that an explosive drives against each other: velocity of the jet and share of the mass in it, from the velocity with which they
arrive."""
from tools import collapse
import numpy as np
from tools.case import Result
from tools.runs import run_deck

ANGLE, SPEED, FIRST = np.radians(30.0), 7980.0, -34e-3  # of driven_wedge.xml: half angle, front [m/s], where it starts [m]
EDGES = np.arange(15e-3, 40e-3, 3e-3)  # of the slices, along the plate from where it begins [m]
NEAR = 4e-3  # twice the thickness: where a slice's velocity is taken, before the middle is felt [m]


def theory(speed):
    """(jet, slug, share) of plates that arrive with one velocity: collapse.theory of a straight plate, which is that of Birkhoff."""
    along = np.linspace(0.01, 0.05, 5)
    places = along[:, None] * np.array([np.sin(ANGLE), np.cos(ANGLE)])
    return collapse.theory(places, ANGLE, np.full(len(along), speed), (places[:, 1] - FIRST) / SPEED)[2]


def measure(run):
    """V0 and its range over the slices, (jet, slug, share) of all slices together."""
    start = run.particles(0)
    area, count = collapse.areas(start), len(EDGES) - 1
    of = collapse.slices(start, np.isnan(start["burn"]), (np.sin(ANGLE), np.cos(ANGLE)), EDGES)
    speeds = collapse.arrival_speeds(run, of, area, count, NEAR)
    exact = theory(float(np.mean(speeds)))
    middle = 0.5 * (exact[0] + exact[1])
    found = collapse.what_became(run, np.where(of >= 0, 0, -1), area, [middle])[0]
    return speeds, found, exact


def run(barreno, full):
    result = Result(
        "Wedge driven by an explosive",
        "Plates that an explosive drives against each other form the jet that belongs to the velocity with which they arrive.",
        "Birkhoff, MacDougall, Pugh and Taylor 1948 with the measured velocity: steady, incompressible, one velocity from the front on "
        "(`verification/tools/collapse.py`). "
        "Means over what starts 15 to 39 mm along the plate.",
        ["cell [mm]", "cells in the plate", "V0 [m/s]", "least V0 [m/s]", "largest V0 [m/s]", "jet [m/s]", "slug [m/s]", "share",
         "jet error", "slug error", "share error", "energy ledger remainder"],
        [],
    )  # fmt: skip
    for h in (1.0, 0.5, 0.25) if full else (2.0 / 3.0,):  # three cells in the plate are the fewest for what is asked of the jet
        finished = run_deck(barreno, "driven_wedge.xml", {"Grid/Cell Size": f"{h} mm"})
        speeds, found, exact = measure(finished)
        errors = found / exact - 1.0
        remainder = finished.summary["balances"]["energy"]["error"]
        result.rows.append([h, 2.0 / h, float(np.mean(speeds)), float(speeds.min()), float(speeds.max()), *map(float, found),
            *map(float, errors), remainder])
        result.demand(f"{h:g} mm: energy ledger remainder", abs(remainder), 1e-3)
        if h < 1.0:  # with two cells in the plate nothing is asked of the jet
            result.demand(f"{h:g} mm: jet against that of the measured velocity", abs(errors[0]), 0.05)
            result.demand(f"{h:g} mm: share of the mass in the jet", abs(errors[2]), 0.15)
    result.notes = NOTES
    return result


NOTES = (
    "Nothing is asked of the slug. The theory's plate feels no pressure from where it arrives on. Here products still press on the "
    "plate, and its slug is faster than in theory, the less so the finer the cells. "
    "V0 grows along the plate, because what starts further out is driven for longer."
)
