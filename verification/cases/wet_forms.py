# SPDX-License-Identifier: BSD-3-Clause
"""One perforation with the two laws that wet rock has had by default: the poroplastic form and the elastic centre before it."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck
from tools.wet_perforation import WET, short_target

DECK = "perforation_quick.xml"
OLD = {**WET, "Materials/Sandstone/Backstress strain": "elastic centre"}
ROCKS = {"dry": {}, "wet, elastic centre (before)": OLD, "wet, poroplastic (now)": WET}
FINE = {"Grid/Cell Size": "1 mm", "Time/End Time": "20 us", "Output/Field Interval": "0 us", "Materials/Sandstone/Density": "2320 kg/m3"}
INSTANTS = (5e-6, 10e-6, 20e-6)  # s


def row(name, run):
    depth, particles = run.table("depth.csv"), run.particles()
    depths = [1e3 * float(np.interp(t, depth["time"], depth["depth"])) for t in INSTANTS]
    pressure = float(np.nanmax(particles["pore_pressure"])) / 1e9 if "pore_pressure" in particles else 0.0
    return [name, *depths, run.table("history.csv")["plastic"][-1], pressure]


def run(barreno, full):
    result = Result(
        "Wet rock before and now",
        "What the pore pressure does to a perforation in the form of today and in the one before it.",
        f"none, a comparison. `{DECK}`" + (" with cells of 1 mm" if full else ", a plug in cells of 4 mm")
        + ", water in the pores, rock of equal density.",
        ["rock", "depth at 5 us [mm]", "at 10 us [mm]", "at 20 us [mm]", "plastic work at 20 us [J]", "highest pore pressure [GPa]"],
        [],
    )  # fmt: skip
    settings = FINE if full else short_target(20.0)
    for name, more in ROCKS.items():
        result.rows.append(row(name, run_deck(barreno, DECK, {**settings, **more})))
    dry, old, new = (r[4] for r in result.rows)
    result.demand("plastic work of wet rock over that of dry rock", new / dry, 0.9)
    result.demand("before: plastic work of wet rock over that of dry rock", old / dry, 0.95, at_least=True)
    result.demand("depth at 20 us, wet rock over dry rock", result.rows[2][3] / result.rows[0][3], 1.0, at_least=True)
    result.notes = (
        "Water takes a part of the load from the grains, and friction acts between grains. Saturated rock that cannot drain therefore "
        "resists shear less than dry rock under the same total stress. "
        "The form before did not show it. Its strength followed the part of the pore pressure that comes from crushing alone. Where the "
        "jet compresses the rock elastically, water under gigapascals did not weaken the rock. A wet target then behaved as a dry one "
        "in depth and in plastic work. Today strength is that of dry rock at the total pressure less the whole "
        "pore pressure. The plastic work falls by about a third. The depth grows by a few percent only, because at these velocities the "
        "inertia of the rock, not its strength, stops the jet. "
        "Expect more where strength decides: at late times, at the wall of the hole and around it.\n\n"
        "Cells of 1 mm are as wide as the jet's radius at its tip: the depths are not converged (docs/trade.md), and only their comparison "
        "at equal cells counts. "
        "Results of decks with `fluid_B0` that were computed with the form before are to be computed again; `Backstress strain` = `elastic "
        "centre` reproduces them."
    )
    return result
