# SPDX-License-Identifier: BSD-3-Clause
"""A perforation with small cells where the jet passes, against the same small cells everywhere."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DECK = "perforation_120us.xml"
COMMON = {"Time/End Time": "10 us", "Output/Field Interval": "0 us", "Output/History Interval": "0.25 us"}
AS_FIDELITIES = {"Step/Subcycles": "4", "Bodies/Casing/Particles Per Cell": "1", "Bodies/Rock/Particles Per Cell": "1"}
INSTANTS = (5e-6, 10e-6)  # s


def channel(level):
    """The region of input_xml/perforation_refined.xml."""
    inside = "Refinement/Channel/"
    return {inside + "Lower": "{0 mm, -40 mm}", inside + "Upper": "{6 mm, 330 mm}", inside + "Level": str(level)}


def row(name, run):
    depth, summary = run.table("depth.csv"), run.summary
    depths = [1e3 * float(np.interp(t, depth["time"], depth["depth"])) for t in INSTANTS]
    million_steps = 1e-6 * summary["particle_steps"]
    return [name, summary["particles"], *depths, 1e3 * depth["channel_radius_mid"][-1], million_steps, summary["cpu_seconds"]]


def run(barreno, full):
    cell, level = (1.0, 2) if full else (2.0, 1)
    fine = cell / 2**level
    result = Result(
        "Small cells where the jet is",
        "A grid that is refined around the channel gives the depth of a grid that is as fine everywhere.",
        f"the uniform grid. `{DECK}` to 10 us; refined: cells of {fine:g} mm to a radius of 8 mm, {cell:g} mm far from the jet.",
        ["cells", "particles", "depth at 5 us [mm]", "at 10 us [mm]", "channel radius [mm]", "particle-steps [10^6]", "processor time [s]"],
        [],
    )  # fmt: skip
    grids = {
        f"{cell:g} mm": {"Grid/Cell Size": f"{cell!r} mm"},
        f"refined to {fine:g} mm": {"Grid/Cell Size": f"{cell!r} mm", **channel(level)},
        f"{fine:g} mm": {"Grid/Cell Size": f"{fine!r} mm"},
    }
    few = f"refined to {fine:g} mm, as fidelities do"
    if full:
        grids[few] = {"Grid/Cell Size": f"{cell!r} mm", **channel(level), **AS_FIDELITIES}
    runs = {}
    for name, settings in grids.items():
        runs[name] = run_deck(barreno, DECK, {**COMMON, **settings})
        result.rows.append(row(name, runs[name]))
    _, refined, uniform = result.rows[:3]
    compare(result, refined, uniform, "")
    balances = runs[f"refined to {fine:g} mm"].table("history.csv")
    result.demand("axial momentum, refined", np.abs(balances["momentum_error"]).max(), 1e-12)
    result.demand("energy balance, refined", np.abs(balances["energy_error"]).max(), 1e-4)
    if full:
        result.demand("processor time, uniform over refined", uniform[6] / refined[6], 10.0, at_least=True)
        compare(result, result.rows[3], uniform, ", as fidelities do")
        result.demand("processor time, uniform over refined, as fidelities do", uniform[6] / result.rows[3][6], 10.0, at_least=True)
    result.notes = (
        "Rock that is at rest costs nothing on either grid (docs/method.md 9), so the gain is less than the ratio of the particles. The "
        "gain is the ratio of the particles that move, near the jet, and all of them take the step of the smallest cells. "
        "*As fidelities do* is with one particle per cell in casing and rock and with steps of "
        "several lengths."
    )
    return result


def compare(result, refined, uniform, how):
    for i, instant in enumerate(INSTANTS, 2):
        result.demand(f"difference of depth at {1e6 * instant:g} us{how}", abs(refined[i] / uniform[i] - 1.0), 0.01)
    result.demand(f"difference of the channel's radius at 10 us{how}", abs(refined[4] / uniform[4] - 1.0), 0.05)
