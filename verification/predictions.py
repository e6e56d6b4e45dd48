#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cost that `check` predicts against the cost of the run, for shipped decks.

    predictions.py BARRENO [--document] [--costs] [--only ROW ...]     a table; with --document into docs/cost.md

--only measures these rows alone; the others of docs/cost.md and of the costs stay as they were measured.

Also prints what stress updates cost in the first steps, all particles awake as in the probe of `check`, and over the run. The latter is
scaled by how much slower the rest of a step was then, which other work on the machine makes it. --costs writes these rows into
src/measured/update_costs.csv, from which `check` and every run have them. Look at them first, and stop other work on the machine before.
"""
import argparse
import json
import pathlib
import re
import sys

from tools import foreign_python  # noqa: F401
from tools.runs import DECKS, run_deck
from tools.measured_tables import table
from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "results" / "predictions.json"
TABLE = ("perforation_quick", "perforation_plane_gimp", "perforation_plane_cpdi", "shell_coasting", "shell_squeezed", "taylor_bar",
         "taylor_bar_3d", "cone_impact", "manufactured_vortex", "colliding_disks", "spherical_wave", "jet_formation")  # fmt: skip
WATER = {"Materials/Sandstone/fluid_B0": "2.2 GPa"}
SCATTER = {"Materials/Sandstone/Weibull modulus": "8", "Materials/Sandstone/Weibull reference volume": "1e-6 m3"}
RATE = {"Materials/Sandstone/T1_rate_dependence": "1e-5", "Materials/Sandstone/T2_rate_dependence": "0.3"}
ANGLE = {"Materials/Sandstone/J3_type": "Willam-Warnke", "Materials/Sandstone/J3_psi": "0.8"}
CENTRE = {**WATER, "Materials/Sandstone/Backstress strain": "elastic centre"}
PLASTIC = {**WATER, "Materials/Sandstone/Backstress strain": "plastic"}
ARENISCA3 = {**PLASTIC, "Materials/Sandstone/Undrained moduli": "arenisca3"}
DAMAGE = {"Materials/Sandstone/Card": "berea_sandstone_damage.xml"}
HEAT = {"Materials/Sandstone/Card": "berea_sandstone_heat.xml"}
WET_HEAT = {**HEAT, **WATER, "Materials/Sandstone/Grain stiffening": "0",
    **{f"Materials/Sandstone/Transition {part}": "0" for part in ("strain", "start", "end")}}  # fmt: skip
RATE_HEAT = {"Materials/Sandstone/Card": "seeberger_sandstone_heat.xml"}
WET_RATE_HEAT = {**WET_HEAT, **RATE_HEAT}
BISECTION = {"Materials/Sandstone/Return solver": "bisection"}


def until(end, settings=None):
    return {**(settings or {}), "Time/End Time": end}


VARIANTS = {  # decks with settings of their own; the forms for comparison cost ten to a thousand times as much and end early
    "perforation_quick, wet": ("perforation_quick", WATER),
    "perforation_quick, scattered": ("perforation_quick", SCATTER),
    "perforation_quick, rate": ("perforation_quick", RATE),
    "perforation_quick, rate, wet": ("perforation_quick", {**RATE, **WATER}),
    "perforation_quick, third invariant": ("perforation_quick", ANGLE),
    "perforation_quick, third invariant, wet": ("perforation_quick", {**ANGLE, **WATER}),
    "perforation_quick, damage": ("perforation_quick", DAMAGE),
    "perforation_quick, damage, wet": ("perforation_quick", {**DAMAGE, **WATER}),
    "perforation_quick, heat": ("perforation_quick", HEAT),
    "perforation_quick, heat, wet": ("perforation_quick", WET_HEAT),
    "perforation_quick, rate, heat": ("perforation_quick", RATE_HEAT),
    "perforation_quick, rate, heat, wet": ("perforation_quick", WET_RATE_HEAT),
    "perforation_quick to 12 us": ("perforation_quick", until("12 us")),
    "perforation_quick, rate, to 12 us": ("perforation_quick", until("12 us", RATE)),
    "perforation_quick, third invariant, wet, to 12 us": ("perforation_quick", until("12 us", {**ANGLE, **WATER})),
    "perforation_quick, elastic centre, to 12 us": ("perforation_quick", until("12 us", CENTRE)),
    "perforation_quick, plastic, to 4 us": ("perforation_quick", until("4 us", PLASTIC)),
    "perforation_quick, arenisca3, to 4 us": ("perforation_quick", until("4 us", ARENISCA3)),
    "perforation_quick, bisection, to 4 us": ("perforation_quick", until("4 us", BISECTION)),
    "perforation_plane_gimp, wet": ("perforation_plane_gimp", WATER),
    "perforation, wet to 30 us": ("perforation", until("30 us", WATER)),
    "perforation, fast, to 30 us": ("perforation", {"Fidelity": "fast", "Time/End Time": "30 us"}),
    "perforation, balanced, to 12 us": ("perforation", {"Fidelity": "balanced", "Time/End Time": "12 us"}),
    "perforation_3d, balanced, to 3 us": ("perforation_3d", {"Fidelity": "balanced", "Time/End Time": "3 us"}),
}
FLOWING = ("perforation_quick", "shell_coasting", "taylor_bar", "cone_impact",
    *(row for row, (deck, _) in VARIANTS.items() if deck == "perforation_quick"))
COLUMNS = ("deck", "steps, predicted / actual", "particle-steps", "ns per particle-step", "seconds of one core", "wall seconds",
    "MB, predicted / actual")

COSTS = HERE.parent / "src" / "measured" / "update_costs.csv"
COST_COLUMNS = ("update", "elastic_ns", "running_ns", "early")
# Row of the costs -> the run that it is measured in. Other rows have the number of one of these (SAME_COST) or do not depend on the state.
RUN_OF_COST = {
    "update_stress Arenisca": "perforation_quick",
    "update_stress Arenisca wet": "perforation_quick, wet",
    "update_stress Arenisca scattered": "perforation_quick, scattered",
    "update_stress Arenisca rated": "perforation_quick, rate",
    "update_stress Arenisca rated wet": "perforation_quick, rate, wet",
    "update_stress Arenisca angled": "perforation_quick, third invariant",
    "update_stress Arenisca angled wet": "perforation_quick, third invariant, wet",
    "update_stress Arenisca damaged": "perforation_quick, damage",
    "update_stress Arenisca damaged wet": "perforation_quick, damage, wet",
    "update_stress Arenisca heated": "perforation_quick, heat",
    "update_stress Arenisca heated wet": "perforation_quick, heat, wet",
    "update_stress Arenisca rated heated": "perforation_quick, rate, heat",
    "update_stress Arenisca rated heated wet": "perforation_quick, rate, heat, wet",
    "update_stress Arenisca general, elastic centre": "perforation_quick, elastic centre, to 12 us",
    "update_stress Arenisca general, plastic": "perforation_quick, plastic, to 4 us",
    "update_stress Arenisca general, bisection": "perforation_quick, bisection, to 4 us",
    "update_stress Johnson-Cook": "taylor_bar",
}
SAME_COST = {"update_stress Arenisca general, arenisca3": "update_stress Arenisca general, plastic",
             "update_stress Johnson-Cook expanded": "update_stress Johnson-Cook"}  # fmt: skip

HEAD = """# Cost of a run, predicted and measured

`barreno check` predicts particle-steps and seconds, and every run compares them with the actual values (`prediction` in `summary.json`, the
last block on the screen). Measured by `verification/predictions.py build/release/src/barreno --document`; do not edit by hand.

- Steps: the stable step of the scene with the artificial viscosity of the bodies that collide, or the longest step of the probe run if that is
  shorter.
- Particle-steps: only computed ones count. A slug of the jet counts from its launch on. Where only a jet moves at the start, tiles are dormant
  until the disturbance arrives that the grid spreads ahead of the waves (`src/check/awake_parts.cpp`). With `Step/Subcycles` tiles that the jet
  passes through step with it. Other tiles take the steps that their material bears at rest (`src/check/body_steps.cpp`), and the parts are
  those of a jet that slows.
- Steps of an explosive: while its front is under way, the steps of the Chapman-Jouguet state with the viscosity of a front as wide as `Burn Width`.
  A liner that can collapse (no box) forms a jet as fast as the detonation.
- ns: a probe run takes the first steps of the same scene on one core (40 ms; at most 20000 particles, larger cells beyond that). Mode, shape
  function, transfer, loads and contact are thus those of the run. The stress update of materials that will yield costs more than in the first
  steps, by the factor in `src/measured/update_costs.csv`. With `Subcycles`, nodes are solved and cells looked for in every part.
- Files: 350 ns per particle and instant of `particles.e`, 12 ns per particle and row of `history.csv`.
- Not included: start-up (0.1 s), implicit solves of the pore flow, waiting of ranks.

Each cell gives predicted / actual = ratio. Seconds of one core (user and system time) are compared. Other work on the machine increases wall seconds.
"""


def end_time(deck):
    return re.search(r'name="End Time"[^>]*value="([\d.e+-]+) *(\w*)"', (DECKS / f"{deck}.xml").read_text()).groups()


def compared(summary):
    """What was predicted of a run, and what came."""
    said = summary["prediction"]
    cpu = summary["cpu_seconds"]
    steps = summary["particle_steps"]
    both = {
        "steps": (said["steps"], summary["steps"]),
        "particle_steps": (said["particle_steps"], steps),
        "ns": (said["ns_per_particle_step"], 1e9 * cpu / steps),
        "seconds": (said["wall_seconds"], cpu),
        "megabytes": (said["bytes"] / 1e6, summary["peak_resident_bytes"] / 1e6),
    }
    return {name: {"predicted": a, "came": b} for name, (a, b) in both.items()} | {"wall": summary["wall_seconds"]}


def stored_page():
    """docs/cost.md."""
    lines = ["| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
    for deck, data in json.loads(STORED.read_text()).items():
        cells = {name: f"{v['predicted']:.3g} / {v['came']:.3g} = {v['predicted'] / v['came']:.2f}"
            for name, v in data.items() if name != "wall"}
        lines.append(f"| {deck}{'' if deck in VARIANTS else '.xml'} | {cells['steps']} | {cells['particle_steps']} | {cells['ns']} | "
            f"{cells['seconds']} | {data['wall']:.3g} | {cells['megabytes']} |")
    return HEAD + "\n" + "\n".join(lines) + "\n"


def deck_of(name):
    """Deck and settings of a row."""
    return VARIANTS.get(name, (name, {}))


def growth(barreno, row, whole):
    """{stress update: (ns in the first hundredth of a row's run, ns over all of it)}"""
    deck, settings = deck_of(row)
    value, unit = end_time(deck)
    short = {**settings, "Time/End Time": f"{0.012 * float(value)} {unit}".strip(), "Output/Field Interval": "0 s",
        "Step/Skip Dormant Tiles": "false"}
    first = {}
    for _ in range(3):
        for name, phase in run_deck(barreno, f"{deck}.xml", short).summary["phases"].items():
            first[name] = min(first.get(name, 1e9), phase["ns_per_particle_step"])
    slower = whole["project_particles"]["ns_per_particle_step"] / first["project_particles"]
    return {
        name: (first[name], phase["ns_per_particle_step"] / slower)
        for name, phase in whole.items()
        if name.startswith("update_stress") and first.get(name, 0.0) > 10.0
    }


def with_costs(text, grown):
    """The file of the costs with what these runs have found; other rows stay. @param grown  {row of TABLE or VARIANTS: growth()}"""
    lines = text.splitlines()
    comments = [line for line in lines if line.startswith("#")][:-1]
    rows = {line.rsplit(",", 3)[0]: line.rsplit(",", 3)[1:] for line in lines if not line.startswith("#")}
    rows.pop(COST_COLUMNS[0])
    for cost, run in RUN_OF_COST.items():
        verb = cost.partition(", ")[0]  # forms of one verb differ by what follows
        if verb in grown.get(run, {}):
            rows[cost][:2] = [f"{ns:.1f}" for ns in grown[run][verb]]
    for cost, other in SAME_COST.items():
        rows[cost][:2] = rows[other][:2]
    return table("\n".join(comments), COST_COLUMNS, [(cost, *numbers) for cost, numbers in rows.items()])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--costs", action="store_true")
    parser.add_argument("--only", nargs="+", metavar="ROW", choices=(*TABLE, *VARIANTS), default=())
    options = parser.parse_args()
    barreno = options.barreno.resolve()
    grown, found = {}, {}
    for row in options.only or (*TABLE, *VARIANTS):
        deck, settings = deck_of(row)
        summary = run_deck(barreno, f"{deck}.xml", settings).summary
        found[row] = compared(summary)
        print(row, found[row], flush=True)
        if row in FLOWING:
            grown[row] = growth(barreno, row, summary["phases"])
            for name, (first, over) in grown[row].items():
                print(f"{name}: {first:.1f} ns at first, {over:.1f} ns over the run ({row})", flush=True)
    if options.costs:
        COSTS.write_text(with_costs(COSTS.read_text(), grown))
    if options.document:
        everything = {**json.loads(STORED.read_text()), **found}
        STORED.write_text(json.dumps({row: everything[row] for row in (*TABLE, *VARIANTS) if row in everything}, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
