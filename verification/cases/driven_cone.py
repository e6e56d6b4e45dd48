# SPDX-License-Identifier: BSD-3-Clause
"""A cone that an explosive drives onto its axis: velocity of the jet and share of the mass in it, part by part, from the velocity with
which the parts fly."""
from tools import collapse
import numpy as np
from tools.case import Result
from tools.runs import run_deck

ANGLE, WALL, SPEED, FIRST = (
    np.radians(21.0), 2e-3, 7980.0, -47.43728e-3
)  # of driven_cone.xml: half angle, wall [m], front [m/s], where it starts [m]
LENGTH, CHARGE = 60e-3 / np.cos(ANGLE), 15e-3  # of the liner along its inner face, thickness of the charge [m]
AXIS = np.array([np.sin(ANGLE), np.cos(ANGLE)])  # along the liner from its apex
EDGES = np.arange(18e-3, 55e-3, 4e-3)  # of the slices along it [m]
ALONG = 0.5 * (EDGES[1:] + EDGES[:-1])  # their middles [m]
HALFWAY = 0.5  # V0 is taken where this share of a slice's way is left


def middles():
    """Of the slices' undeformed walls, (x, y) [m]."""
    return ALONG[:, None] * AXIS + 0.5 * WALL * np.array([np.cos(ANGLE), -np.sin(ANGLE)])


def asked():
    """Slices of which something is asked: they start six walls from the axis or more, so that the wall is thin beside the way, and no
    nearer to the open end than the charge is thick."""
    return (middles()[:, 0] >= 6.0 * WALL) & (ALONG <= LENGTH - CHARGE)


def arrivals():
    """Times at which the front is at the slices' outer faces [s]."""
    return (ALONG * np.cos(ANGLE) - WALL * np.sin(ANGLE) - FIRST) / SPEED


def ring_volumes(start):
    """Of the undeformed particles, over 2 pi [m3]."""
    return collapse.areas(start) * start["x"]


def measure(run, masses_of=ring_volumes):
    """V0 of the slices and their (jet, slug, share), found and by the theory. x of the run's particles is their distance from the axis."""
    start = run.particles(0)
    masses = masses_of(start)
    of = collapse.slices(start, np.isnan(start["burn"]), AXIS, EDGES)
    speeds = collapse.arrival_speeds(run, of, masses, len(ALONG), HALFWAY * middles()[:, 0])
    exact = collapse.theory(middles(), ANGLE, speeds, arrivals())
    return speeds, collapse.what_became(run, of, masses, exact[:, :2].mean(axis=1)), exact


def run(barreno, full):
    result = Result(
        "Cone driven by an explosive",
        "The parts of a cone that an explosive drives onto its axis become the jet that belongs to the velocities with which they fly.",
        "Pugh, Eichelberger and Rostoker 1952 with the measured velocities (`verification/tools/collapse.py`): thin, incompressible, each "
        "part on a straight way.",
        ["cell [mm]", "cells in the wall", "from the axis [mm]", "V0 [m/s]", "jet [m/s]", "slug [m/s]", "share", "jet, theory [m/s]",
            "slug, theory [m/s]", "share, theory"],
        [],
    )  # fmt: skip
    for h in (1.0, 0.5, 0.25) if full else (1.0,):
        finished = run_deck(barreno, "driven_cone.xml", {"Grid/Cell Size": f"{h} mm"})
        speeds, found, exact = measure(finished)
        for place, speed, *values in zip(middles()[:, 0], speeds, found, exact):
            result.rows.append([h, 1e3 * WALL / h, 1e3 * float(place), float(speed), *(float(value) for part in values for value in part)])
        errors = np.abs(found / exact - 1.0)[asked()].max(axis=0)
        tip = float(np.nanmax(found[:, 0]))
        result.demand(f"{h:g} mm: energy ledger remainder", abs(finished.summary["balances"]["energy"]["error"]), 1e-2)
        # Two cells in the wall resolve no jet: twice as much, and nothing of the shares.
        result.demand(f"{h:g} mm: jet against that of the measured velocities, the worst slice", errors[0], 0.1 if h < 1.0 else 0.2)
        if h < 1.0:
            result.demand(f"{h:g} mm: share of the mass in the jet, the worst slice", errors[2], 0.2)
            result.demand(f"{h:g} mm: fastest slice of the jet over 7931 m/s", tip / 7931.0, 1.0)
    result.notes = NOTES
    return result


NOTES = (
    "V0 is the mean velocity of a slice half-way to the axis. Earlier the products still drive the slice; later its inner part is faster "
    "than its outer part, as in every ring that closes. "
    "The theory's liner is thin. Nothing is required of slices that start nearer than six walls to the axis: half-way they are as thick "
    "as they are far from it. Nor is anything required of the outermost slice. It is nearer to the open end of the charge than the "
    "charge is thick, and is driven less than the slices before it. Nothing is asked of the slug, on which the products go on pressing."
)
