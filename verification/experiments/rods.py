# SPDX-License-Identifier: BSD-3-Clause
"""Rods of tungsten alloy into thick steel: depth over length against the fit of Lanz and Odermatt."""
import math
import pathlib

from tools.experiment import RECALLED, Experiment
from tools.runs import run_deck

DECK = pathlib.Path(__file__).with_name("rod.xml")
LEVELS = {1.0: 1, 0.5: 2}  # cells [mm]: Refinement/Path/Level; two and four per radius of the rod
SPEEDS = (1.5, 2.0)  # km/s
LENGTH, DIAMETER = 40.0, 4.0  # mm
ROD, STEEL, HARDNESS = 17600.0, 7850.0, 270.0  # kg/m3, kg/m3, BHN


def fitted(speed):
    """Depth over length of a rod in a thick target [speed in km/s]."""
    shape = 0.921 / math.tanh(0.283 + 0.0656 * LENGTH / DIAMETER)
    return shape * math.sqrt(ROD / STEEL) * math.exp(-(138.0 - 0.1 * HARDNESS) * HARDNESS / (ROD * speed**2))


def depth(barreno, cells, speed):
    """Of the deepest metal of the rod at the end [mm]."""
    settings = {"Refinement/Path/Level": str(LEVELS[cells]), "Bodies/Rod/Velocity": f"{{0 m/s, {1e3 * speed!r} m/s}}"}
    run = run_deck(barreno, DECK, settings)
    rod = slice(0, run.count_of_block(1))
    now = run.particles()
    return 1e3 * float(now["y"][rod][now["status"][rod] > 0.5].max())


def run(barreno, full):
    cells = list(LEVELS) if full else list(LEVELS)[:1]
    experiment = Experiment(
        "Tungsten rods into steel",
        "A long rod goes as deep into thick steel as the fit to experiments says.",
        "tungsten alloy of 17,600 kg/m3, 4 x 40 mm, into a block of steel of 40 x 90 mm (radius and depth), to 100 us. Cards "
        "`tungsten_alloy`, `steel_4340_fracture` (Rockwell C 30, about 286 BHN; the fit is taken at 270). Axisymmetric; cells near the "
        "path",
        cells=cells,
    )  # fmt: skip
    for speed in SPEEDS if full else SPEEDS[:1]:
        experiment.compare(f"depth over length at {speed:g} km/s", f"{fitted(speed):.2f}", RECALLED,
            "Lanz and Odermatt's fit; its constants were seen in a program of unnamed origin, its form is recalled",
            [depth(barreno, h, speed) / LENGTH for h in cells])
    experiment.notes = "The rod and the steel stick where they meet: the deck has no Contact."
    return experiment
