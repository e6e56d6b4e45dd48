# SPDX-License-Identifier: BSD-3-Clause
"""A steel sphere at 5 km/s into sandstone, dry and with water in the pores: the craters."""
import pathlib

from tools.crater import crater_of
from tools.experiment import SEEN, Experiment
from tools.runs import run_deck

DECK = pathlib.Path(__file__).with_suffix(".xml")
RADIUS = 1.25e-3  # of the sphere [m]
CARD = "berea_sandstone_damage"  # that is required; rock without confinement breaks
OTHERS = ("berea_sandstone_bounded", "berea_sandstone_shock")
LEVELS = {0.5: 2, 0.25: 3}  # cells [mm]: Refinement/Crater/Level
WATER = {"fluid_B0": 2.25e9, "Matrix bulk modulus": 36e9, "Fluid Density": 998.2}
MOSER = "Moser et al., Meteorit. Planet. Sci. (2013), doi 10.1111/maps.12000: abstract"
POELCHAU = "Poelchau et al., Meteorit. Planet. Sci. 48 (2013): dry, 50 and 90 % wet sandstone, abstract"


def settings(card, cells, more=None):
    water = {f"Materials/Sandstone/{name}": str(value) for name, value in (more or {}).items()}
    return {"Refinement/Crater/Level": str(LEVELS[cells]), "Materials/Sandstone/Card": f"{card}.xml", **water}


def shot(barreno, card, cells, more=None):
    """The crater at the end, and how far its floor moved since the output before [m]."""
    run = run_deck(barreno, DECK, settings(card, cells, more))
    block = run.count_of_block(1)
    last, before = (crater_of(run, step, block, RADIUS) for step in (-1, -2))
    return last, abs(last.depth - before.depth)


def dry_rows(experiment, dry):
    depth = experiment.compare("depth of the crater [mm]", "about 10", SEEN, MOSER, [1e3 * crater.depth for crater in dry])
    experiment.within(depth, 10.0, 0.25)
    experiment.compare("width at the face [mm]", "about 60", SEEN, MOSER, [1e3 * crater.width for crater in dry])
    experiment.compare("depth of the damage [mm]", "about 80", SEEN, MOSER, [1e3 * crater.damage for crater in dry])


def wet_rows(experiment, dry, wet):
    over = {name: [getattr(w, name) / getattr(d, name) for d, w in zip(dry, wet)] for name in ("depth", "volume", "width")}
    for name, words, limit in (("depth", "less than 1", 0.99), ("volume", "more than 1", 1.01), ("width", "more than 1", 1.01)):
        row = experiment.compare(f"{name} of the crater, wet over dry", words, SEEN, POELCHAU, over[name])
        experiment.require(row, over[name][-1], limit, at_least=limit > 1.0)
    experiment.compare("depth of the cracks over that of the dry crater, wet", "less than 1", SEEN, POELCHAU,
        [w.cracked / d.depth for d, w in zip(dry, wet)])


def run(barreno, full):
    cells = list(LEVELS) if full else list(LEVELS)[:1]
    experiment = Experiment(
        "A steel sphere into sandstone",
        "A hypervelocity impact makes a crater as deep as measured in dry rock; in wet rock the measured one is shallower and larger.",
        "steel, 2.5 mm, 5 km/s, normal, a block of 60 x 60 mm (radius and depth) without confinement, to 40 us, before waves come "
        f"back; card `{CARD}`, "
        "`steel_4340_fracture`. The cube of the experiment was 200 mm wide; its abstract names neither rock (Seeberger sandstone is "
        "recalled) nor saturation. Wet: pores full of water; 90 % in the experiments. Axisymmetric; cells near the crater",
        cells=cells,
    )  # fmt: skip
    dry, wet = ([shot(barreno, CARD, h, more) for h in cells] for more in (None, WATER))
    dry_rows(experiment, [crater for crater, _ in dry])
    wet_rows(experiment, *([crater for crater, _ in craters] for craters in (dry, wet)))
    for card in OTHERS if full else ():
        crater, _ = shot(barreno, card, cells[0])
        experiment.compare(f"depth with `{card}`, cells of {cells[0]:g} mm [mm]", "about 10", SEEN, MOSER, [1e3 * crater.depth])
    experiment.profiles = {
        f"{name}, {h:g} mm": crater.profile for name, craters in (("dry", dry), ("wet", wet)) for h, (crater, _) in zip(cells, craters)}
    moved = [1e3 * max(moved for _, moved in craters) for craters in (dry, wet)]
    experiment.notes = (
        f"In the last 10 us the floor of the dry crater moves by {moved[0]:.2g} mm, that of the wet one by {moved[1]:.2g} mm, at most. "
        "The "
        "crater is where less than half of the rock's mass is left, down to the first rock that is whole. "
        "What the width of the experiment has and ours lacks is the spall around the central pit: plates that come off where the wave "
        "meets "
        "the face. The measured damage is a fall of the wave speed, which a few cracks give; ours is rock that is more than half broken."
    )
    return experiment
