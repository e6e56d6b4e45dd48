# SPDX-License-Identifier: BSD-3-Clause
"""Time: no end, next to no step, an end that output does not meet, a clock that cannot move."""
from tools.small_decks import BARE, attempt, elastic

CELL = 1.0


def free_block(end, velocity=(1.0, 0.5), **sections):
    """Four particles of an elastic block in free flight; c = 100 m/s, so that steps are some 4 ms."""
    deck = {
        "Grid": {"Mode": "plane strain", "Lower": (0, 0), "Upper": (8, 8), "Cell Size": CELL},
        "Materials": {"Elastic": elastic(6e6, 3e6)},
        "Bodies": {"Block": {"Material": "Elastic", "Lower": (2.1, 2.2), "Upper": (3.1, 3.2), "Velocity": velocity}},
        "Step": dict(BARE),
        "Time": {"End Time": end},
    }
    for name, more in sections.items():
        deck.setdefault(name, {}).update(more)
    return deck


def last_time(run):
    return run.table("history.csv")["time"][-1]


def rows_after(run, end):
    return float(sum(run.table("history.csv")["time"] > end))


def run(barreno, full, table):
    title = "Time"
    now = attempt(barreno, free_block(0))
    if now.finished:
        table.finishes(title, "End Time 0", now, "steps", lambda r: r.summary["steps"], 0)
    else:
        table.stops(title, "End Time 0", now, 1, "Time/End Time")
    tiny = attempt(barreno, free_block(1e-2, Step={"Initial Step": 1e-30}))
    table.finishes(title, "Initial Step 1e-30 s, which grows by 1.1", tiny, "|last time - End Time| [s]",
        lambda r: abs(last_time(r) - 1e-2), 0)
    largest = attempt(barreno, free_block(1.0, Step={"Largest Step": 1e-30}))
    table.stops(title, "Largest Step 1e-30 s to an end at 1 s", largest, 3, "Time has stalled", "Largest Step", "fastest particle")
    for end in (0.1, 1.0 / 3.0):
        done = attempt(barreno, free_block(end, Output={"Field Interval": 0.03, "History Interval": 0.007}))
        table.finishes(title, f"End Time {end:.6g} s, no multiple of the intervals", done, "|last time - End Time| [s]",
                       lambda r, end=end: abs(last_time(r) - end), 0)  # fmt: skip
        table.finishes(title, f"End Time {end:.6g} s, no multiple of the intervals", done, "rows after the end", lambda r,
            end=end: rows_after(r, end), 0)
    even = attempt(barreno, free_block(0.1, Output={"Field Interval": 0.1, "History Interval": 0.01}))
    table.finishes(title, "an output exactly at End Time", even, "rows more than 11",
        lambda r: len(r.table("history.csv")["time"]) - 11.0, 0)
    many = attempt(barreno, free_block(1e-25))
    table.finishes(title, "End Time 1e-25 s, far below a step", many, "steps", lambda r: r.summary["steps"], 2)
    for velocity in (1e30, 1e155, 1e200):
        fast = attempt(barreno, free_block(1e-3, velocity=(velocity, 0.0)), longest=30.0)
        table.stops(title, f"velocity {velocity:g} m/s", fast, 1, "Bodies/Block/Velocity", "light")
