# SPDX-License-Identifier: BSD-3-Clause
"""A copper plate hits another: the spall strength that the velocity of the free face shows."""
import pathlib

import numpy as np
from tools.experiment import SEEN, Experiment
from tools.runs import run_deck

DECK = pathlib.Path(__file__).with_name("spall.xml")
CELLS = (0.05, 0.025)  # mm
DENSITY, SOUND = 8930.0, 3940.0  # of copper_ofhc.xml
FLAT = 1.5e-6  # by then the face has its full velocity [s]
FAR = 2.2e-6  # by then the signal of the torn copper has come to it [s]
NOMINAL = "example materials of pyko, after doi 10.1063/1.3607294: nominal, the card's own number"


def settings(cells):
    return {"Grid/Cell Size": f"{cells} mm", "Grid/Upper": f"{{8 mm, {cells} mm}}", "Bodies/Flyer/Upper": f"{{0 mm, {cells} mm}}",
        "Bodies/Target/Upper": f"{{4 mm, {cells} mm}}"}  # fmt: skip


def signal(barreno, cells):
    """Spall strength from the fall of the free face's velocity, and the largest tension in the plates [Pa]."""
    run = run_deck(barreno, DECK, settings(cells))
    times = run.times()
    face = int(np.argmax(run.particles(0)["x"]))
    frames = [run.particles(step, ("velocity_x", "pressure")) for step in range(len(times))]
    velocity = np.array([frame["velocity_x"][face] for frame in frames])
    top = velocity[times < FLAT].max()
    bottom = velocity[(times > FLAT) & (times < FAR)].min()
    return 0.5 * DENSITY * SOUND * float(top - bottom), -min(float(frame["pressure"].min()) for frame in frames)


def run(barreno, full):
    cells = CELLS if full else CELLS[:1]
    experiment = Experiment(
        "Spall of copper",
        "Copper is torn at its spall strength, and the free face shows it.",
        "a plate of copper of 2 mm on one of 4 mm, 300 m/s; 0.5 rho c0 times the fall of the velocity of the free face. Card "
        "`copper_ofhc`, "
        "whose `Spall Stress` is the measured number: no independent test. Plane strain, one cell wide; cells",
        cells=list(cells),
    )  # fmt: skip
    strength, tension = zip(*(signal(barreno, h) for h in cells))
    experiment.compare("spall strength from the free face [GPa]", "1.35", SEEN, NOMINAL, [1e-9 * value for value in strength])
    experiment.compare("largest tension in the plates [GPa]", "1.35", SEEN, NOMINAL, [1e-9 * value for value in tension])
    experiment.notes = (
        "The copper is torn at the card's number, but the free face shows little more than half of it. The reason is not known; "
        "smaller cells do not change it much. A spall stress that is taken from such a signal would have to be entered larger."
    )
    return experiment
