# SPDX-License-Identifier: BSD-3-Clause
"""Energy that a perforation loses between particles and grid: what the order of a step and its length change, and what Return Losses
leaves."""
import numpy as np
from tools.case import Result
from tools.penetration import between_particles_and_grid, depth_at
from tools.runs import run_deck

DECK = "perforation_120us.xml"
CASING = 4  # us: until then the tip of the jet is in the casing
LATER = 12  # us: by then the jet has been in the rock for most of the time
USUAL, RETURNED, HALVED = "as in the deck", "Return Losses", "half the step"
STEPS = {
    USUAL: {},
    RETURNED: {"Step/Return Losses": "true"},
    HALVED: {"Step/Courant Fraction": "0.4"},
    "modified stress last": {"Step/Order": "modified stress last"},
    "stress first": {"Step/Order": "stress first"},
}
PATH = {"Jet/Cells Per Radius": "2", "Step/Subcycles": "4"}
ON_PATH = "0.5 mm along the path, Subcycles 4"


def row(name, run):
    summary = run.summary
    energy, end = summary["balances"]["energy"], summary["time"]
    return [name, 1e6 * end, 1e3 * depth_at(run, end), -energy["stress_integration"], -energy["transfer"], between_particles_and_grid(run),
        summary["steps"]]


def run(barreno, full):
    result = Result(
        "Energy lost between particles and grid",
        "The energy that stress_integration and transfer take falls with the step, and is small in orders of the step where the two "
        "cancel. With `Step/Return Losses` it heats the metals that lost it.",
        f"nothing is lost. `{DECK}`, cells of 1 mm.",
        ["step", "end [us]", "depth [mm]", "lost in stress_integration [J]", "lost in transfer [J]", "lost, over what was put in", "steps"],
        [],
    )

    def of(name, end, path=False):
        finished = run_deck(barreno, DECK,
            {**STEPS[name], **(PATH if path else {}), "Time/End Time": f"{end} us", "Output/Field Interval": "0 us"})
        result.rows.append(row(f"{name}, {ON_PATH}" if path else name, finished))
        return finished

    early = {name: between_particles_and_grid(of(name, CASING)) for name in (STEPS if full else (USUAL, RETURNED))}
    for name in early:
        if name != USUAL:
            result.demand(f"{name}: energy lost by {CASING} us, over that of the deck", abs(early[name] / early[USUAL]),
                {RETURNED: 0.1, HALVED: 0.75}.get(name, 0.5))
    usual, kept = (of(name, CASING, path=True) for name in (USUAL, RETURNED))
    result.demand(f"{RETURNED}, {ON_PATH}: energy lost by {CASING} us, over that without it",
        abs(between_particles_and_grid(kept) / between_particles_and_grid(usual)), 0.1)
    result.demand(f"{RETURNED}, {ON_PATH}: difference of depth at {CASING} us",
        abs(depth_at(kept, 1e-6 * CASING) / depth_at(usual, 1e-6 * CASING) - 1.0), 0.005)
    if full:
        pair = [of(name, LATER) for name in (USUAL, RETURNED)]
        depths = [depth_at(one, 1e-6 * LATER) for one in pair]
        result.demand(f"{RETURNED}: energy lost by {LATER} us, over what was put in", abs(between_particles_and_grid(pair[1])), 0.02)
        result.demand(f"{RETURNED}: difference of depth at {LATER} us", abs(depths[1] / depths[0] - 1.0), 0.005)
        result.demand(f"{RETURNED}: energy balance", np.abs(pair[1].table("history.csv")["energy_error"]).max(), 1e-4)
    result.notes = (
        "Losses are energies that a step takes from the motion and gives to no material: where they come from, docs/method.md (2.13). They "
        "are large where velocities jump within few steps, as where the jet meets the casing. Metals lose nearly all of the energy that "
        "is lost in the first 4 us. Rock has no temperature that heat could go into, so that "
        "its own losses remain when those of the metals are returned."
    )
    return result
