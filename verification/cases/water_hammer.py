# SPDX-License-Identifier: BSD-3-Clause
"""A column of water hits a wall, parts from it behind a void, and hits it again: pressures and times of characteristics."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DENSITY, C0, SLOPE, VAPOUR = 998.2, 1483.0, 1.921, -98986.0  # of water.xml
LENGTH, RESERVOIR, SPEED = 0.1, 0.5e6, 1.0  # of water_hammer.xml [m, Pa, m/s]
TRIP = 2.0 * LENGTH / C0  # there and back [s]
RISE = DENSITY * C0 * SPEED  # Joukowsky [Pa]
# A void keeps the wall at the vapour pressure; every trip the reservoir turns the column by 2 (p_r - p_v) / (rho c).
TURN = (RESERVOIR - VAPOUR) / (DENSITY * C0)


def void_closes():
    """When the void at the wall is closed, and with which velocity the water then comes [s, m/s].

    The void opens at t = TRIP. Water beside it has the velocity u_k = -SPEED + (2 k - 1) TURN in the k-th trip from then on, towards the
    wall positive; the width of the void is minus its integral."""
    width, k = 0.0, 1
    while True:
        velocity = -SPEED + (2 * k - 1) * TURN
        if velocity > 0.0 and velocity * TRIP >= width:
            return (k * TRIP) + width / velocity, velocity
        width -= velocity * TRIP
        k += 1


def settings(cells):
    h = LENGTH / cells
    closes, _ = void_closes()
    return {
        "Grid/Cell Size": f"{h!r} m",
        "Grid/Upper": f"{{{LENGTH + 4 * h!r} m, {h!r} m}}",
        "Bodies/Column/Upper": f"{{{LENGTH!r} m, {h!r} m}}",
        "Time/End Time": f"{closes + 0.8 * TRIP!r} s",
        "Output/Field Interval": f"{TRIP / 40!r} s",
    }


def wall_history(run, h):
    """Times, mean pressure and void of the particles that start in the first cell."""
    first = run.particles(0)["x"] < h
    times = run.times()
    frames = [run.particles(step, ("pressure", "void_volume")) for step in range(len(times))]
    return times, np.array([f["pressure"][first].mean() for f in frames]), np.array([f["void_volume"][first].mean() for f in frames])


def mean_between(times, values, low, high):
    return float(values[(times > low) & (times < high)].mean())


def crossing(times, values, level, after):
    """First time after `after` at which the values rise through the level, linear between outputs."""
    rows = np.flatnonzero((times[1:] > after) & (values[1:] >= level) & (values[:-1] < level))
    i = int(rows[0])
    return float(times[i] + (level - values[i]) / (values[i + 1] - values[i]) * (times[i + 1] - times[i]))


def run(barreno, full):
    closes, speed = void_closes()
    result = Result(
        "Water hammer with column separation",
        "The pressure at the wall, the void behind the rebound, and the blow when it closes.",
        f"Characteristics: rise rho c v = {RISE:.5g} Pa for 2 L / c = {TRIP:.5g} s; then the vapour pressure until the void closes at "
        f"{closes:.5g} s with {speed:.4g} m/s, and a rise of rho c times that.",
        ["cells", "first rise error", "least pressure below the vapour pressure [Pa]", "void error at 1.7 trips", "closing time error",
         "second rise error", "energy ledger remainder"],
        [],
    )  # fmt: skip
    seen = 1.7  # trips, before the reservoir turns the column
    width = (SPEED - TURN) * (seen - 1.0) * TRIP
    for cells in (50, 100, 200) if full else (50, 100):
        finished = run_deck(barreno, "water_hammer.xml", settings(cells))
        times, pressure, _ = wall_history(finished, LENGTH / cells)
        first = mean_between(times, pressure, 0.3 * TRIP, 0.8 * TRIP) - RESERVOIR
        least = min(float(finished.particles(step, ("pressure",))["pressure"].min()) for step in range(len(times)))
        # All voids of the column, as a length.
        frame = finished.particles(int(np.argmin(np.abs(times - seen * TRIP))), ("void_volume",))
        void = float(frame["void_volume"].sum() / 4.0 * LENGTH / cells)  # four particles per cell
        second = mean_between(times, pressure, closes + 0.06 * TRIP, closes + 0.3 * TRIP) - VAPOUR
        when = crossing(times, pressure, VAPOUR + 0.5 * DENSITY * C0 * speed, 1.5 * TRIP)
        errors = [first / RISE - 1.0, max(0.0, VAPOUR - least), void / width - 1.0, when / closes - 1.0,
                  second / (DENSITY * C0 * speed) - 1.0, finished.summary["balances"]["energy"]["error"]]  # fmt: skip
        result.rows.append([cells, *errors])
        result.demand(f"first rise, {cells} cells", abs(errors[0]), 0.01)
        result.demand(f"least pressure below the vapour pressure over it, {cells} cells", errors[1] / abs(VAPOUR), 1e-12)
        result.demand(f"void at 1.7 trips, {cells} cells", abs(errors[2]), 0.05)
        result.demand(f"time at which the void closes, {cells} cells", abs(errors[3]), 0.02)
        result.demand(f"second rise, {cells} cells", abs(errors[4]), 0.05)
    result.notes = (
        "The front is some cells wide, so that the void opens and closes a little late and early. Three trips widen the front of the "
        "second blow further. Behind the first reflection the whole column is at the vapour pressure: small voids open and close in it too."
    )
    return result
