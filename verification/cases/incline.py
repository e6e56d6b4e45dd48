# SPDX-License-Identifier: BSD-3-Clause
"""A block on an incline under gravity: slides or sticks as Coulomb says."""
import math

import numpy as np
from tools.case import Result
from tools.runs import run_deck

FRICTION, GRAVITY = 0.3, 9.81


def run(barreno, full):
    result = Result(
        "Block on an incline",
        "Contact with friction under the body's own weight.",
        "a = g (sin - friction * cos), and no sliding below the friction angle, 16.7 degrees.",
        ["cell [m]", "angle [degrees]", "acceleration [m/s2]", "exact [m/s2]", "ledger remainder"],
        [],
    )
    for h in [0.02, 0.01] if full else [0.02]:
        for angle in (10.0, 30.0, 45.0):
            sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
            settings = {
                "Grid/Cell Size": f"{h} m",
                "Body Force/Acceleration": f"{{{-GRAVITY * cosine} m/s2, {GRAVITY * sine} m/s2}}",
                "Time/End Time": "0.2 s",
            }
            finished = run_deck(barreno, "incline.xml", settings)
            rows = finished.table("history.csv")
            velocity = rows["momentum"] / rows["mass"]
            settled = rows["time"] > 0.02  # weight sets in at once: the block rings first
            measured = np.polyfit(rows["time"][settled], velocity[settled], 1)[0]
            exact = max(0.0, GRAVITY * (sine - FRICTION * cosine))
            remainder = finished.summary["balances"]["energy"]["error"]
            result.rows.append([h, angle, measured, exact, remainder])
            name = f"{angle:g} degrees, {h} m"
            result.demand(f"{name}: error of the acceleration over g", abs(measured - exact) / GRAVITY, 0.01)
            result.demand(f"{name}: energy balance", abs(remainder), 1e-9)
    return result
