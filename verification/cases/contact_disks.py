# SPDX-License-Identifier: BSD-3-Clause
"""Two elastic disks that meet with contact and part: when, with which momentum and how much of their speed."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

SPEED, GAP = 10.0, 0.04


def surface_gap(particles, low):
    y = particles["corners"][..., 1]
    return y[~low].min() - y[low].max()


def run(barreno, full):
    result = Result(
        "Collision of two elastic disks",
        "Contact begins when the surfaces meet, conserves momentum, and lets the bodies separate.",
        "both disks rebound with their initial speed, except for a small part that remains as vibration; momentum is conserved.",
        ["cell [m]", "gap one step of output before contact [cells]", "smallest gap [cells]", "speed after / before",
            "energy lost to transfer", "ledger remainder"],
        [],
    )
    for h in [0.02, 0.01, 0.005, 0.0025] if full else [0.02, 0.01]:
        finished = run_deck(barreno, "contact_disks.xml", {"Grid/Cell Size": f"{h} m"})
        first = finished.particles(0)
        low = first["y"] < 0.15
        states = [finished.particles(step) for step in range(51)]
        gaps = np.array([surface_gap(state, low) for state in states]) / h
        free = [step for step in range(51) if np.ptp(states[step]["velocity_y"][low]) < 1e-9]
        after = states[-1]["velocity_y"]
        ratio = 0.5 * (after[~low].mean() - after[low].mean()) / SPEED
        rows = finished.table("history.csv")
        lost = -rows["transfer"][-1] / rows["kinetic"][0]
        result.rows.append([h, gaps[free[-1]], gaps.min(), ratio, lost, rows["energy_error"][-1]])
        # In 0.1 ms they approach by 2 mm.
        result.demand(f"gap before contact less what the next step of output closes, {h} m", gaps[free[-1]] - 0.002 / h, 0.1)
        result.demand(f"overlap, {h} m", -gaps.min(), 0.15)
        result.demand(f"momentum of both over that of one, {h} m", np.max(np.abs(rows["momentum_error"])), 1e-13)
        result.demand(f"energy balance, {h} m", np.max(np.abs(rows["energy_error"])), 1e-12)
        result.demand(f"gap at the end, {h} m", gaps[-1] * h, GAP / 2, at_least=True)
    result.demand("speed after / before, 0.01 m", result.rows[1][3], 0.92, at_least=True)
    if full:
        # What is missing halves with the cell: 0.203, 0.063, 0.040, 0.019.
        result.demand("speed missing at 0.0025 m over that at 0.005 m", (1 - result.rows[3][3]) / (1 - result.rows[2][3]), 0.6)
    result.notes = (
        "The ratio tends to 1 as cells are refined. Of the kinetic and elastic energy lost, half is lost between particles and grid "
        "(transfer) and half in the work of the nodal forces (stress_integration). The likely cause was not isolated: nodes whose "
        "fields come into contact take a common velocity. This is an inelastic impact of the masses within about a cell of the surface. "
        "The rest of the deficit in mean speed remains in the disks as vibration."
    )
    return result
