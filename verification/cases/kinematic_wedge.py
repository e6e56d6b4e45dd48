# SPDX-License-Identifier: BSD-3-Clause
"""Plates that meet at an angle, moved by their own inertia: velocity of jet and slug, and share of the mass in the jet."""
from tools import collapse
import numpy as np
from tools.case import Result
from tools.runs import run_deck

SPEED, THICKNESS, HALF_ANGLE = 1000.0, 4e-3, np.radians(45.0)  # of kinematic_wedge.xml
# Birkhoff, MacDougall, Pugh and Taylor, J. Appl. Phys. 19 (1948) 563: steady, incompressible, without strength. Where the plates meet moves
# with V0 / sin b, and there they come with V0 cot b, which jet and slug keep.
MEETING = SPEED / np.sin(HALF_ANGLE)
JET, SLUG = SPEED / np.tan(0.5 * HALF_ANGLE), SPEED * np.tan(0.5 * HALF_ANGLE)
SHARE = np.sin(0.5 * HALF_ANGLE) ** 2
INFLOW = THICKNESS * SPEED / np.tan(HALF_ANGLE)  # [m2/s] of the undeformed plate
START = 5e-6  # the first jet, that of a plate's corner, is left out [s]


def mean_velocity(particles, area, chosen):
    return float(np.average(particles["velocity_y"][chosen], weights=area[chosen]))


def at(particles, area):
    """Area that is in the jet, velocity of the jet and of the slug; both of what was formed after START and has left the corner behind."""
    time, y = particles["time"], particles["y"]
    there = particles["status"] == 1
    corner, margin = MEETING * time, 0.5 * THICKNESS
    in_jet = there & (particles["velocity_y"] > 0.5 * (MEETING + JET))
    formed = time - START
    jet = in_jet & (y > corner + margin) & (y < MEETING * START + JET * formed)
    # The outer face of the plate is on the middle plane THICKNESS / sin b behind the corner.
    slug = there & (y < corner - THICKNESS / np.sin(HALF_ANGLE) - margin) & (y > MEETING * START + SLUG * formed)
    return float(area[in_jet].sum()), mean_velocity(particles, area, jet), mean_velocity(particles, area, slug)


def measure(run):
    """Velocities, the means over the outputs of the last quarter of the run, and the share: the slope of the jet's area over what comes
    in."""
    area = collapse.areas(run.particles(0))
    times = run.times()
    late = [step for step in range(run.instants()) if times[step] >= 0.75 * times[-1]]
    jet, slug = np.mean([at(run.particles(step), area)[1:] for step in late], axis=0)
    steady = [step for step in range(run.instants()) if times[step] >= START]
    grown = [float(area[(p["status"] == 1) & (p["velocity_y"] > 0.5 * (MEETING + JET))].sum()) for p in map(run.particles, steady)]
    return float(jet), float(slug), float(np.polyfit(times[steady], grown, 1)[0] / INFLOW)


def run(barreno, full):
    result = Result(
        "Kinematic wedge",
        "Plates without strength that meet at an angle split into a jet and a slug as the theory of lined charges says.",
        "Steady incompressible flow (Birkhoff, MacDougall, Pugh and Taylor 1948): jet V0 cot(b / 2), slug V0 tan(b / 2), mass share of "
        "the jet sin^2(b / 2). The plates move along their normals with V0 = 1000 m/s and have b = 45 degrees to the middle.",
        ["cell [mm]", "cells in the plate", "jet [m/s]", "slug [m/s]", "share", "jet error", "slug error", "share error",
            "energy ledger remainder"],
        [],
    )  # fmt: skip
    for h in (0.5, 0.25, 0.125) if full else (0.5,):
        finished = run_deck(barreno, "kinematic_wedge.xml", {"Grid/Cell Size": f"{h} mm"})
        jet, slug, share = measure(finished)
        errors = [jet / JET - 1.0, slug / SLUG - 1.0, share / SHARE - 1.0]
        remainder = finished.summary["balances"]["energy"]["error"]
        result.rows.append([h, 1e3 * THICKNESS / h, jet, slug, share, *errors, remainder])
        for what, error, limit in zip(("jet", "slug", "mass share"), errors, (0.03, 0.05, 0.1)):
            result.demand(f"{what}, {h:g} mm", abs(error), limit)
        result.demand(f"energy ledger remainder, {h:g} mm", abs(remainder), 1e-3)
    return result
