# SPDX-License-Identifier: BSD-3-Clause
"""Shots unlike perforation.xml, on which the interval of a depth is tried: other pressures, rocks, jets and targets."""
import pathlib

from barreno.runs.csv_table import arrays_of, read_csv
from tools.case_list import DOCS
from tools.runs import DECKS, scratch_folder

PICTURE = DOCS / "pictures" / "hole_of_cells.png"
STEP = 5.0  # of the profile of the hole [mm]
TABLE = DECKS / "jets" / "tungsten_320.csv"
TIMES = (20, 60, 90, 120, 150, 200, 240, 280, 300)  # us, of a jet as fast as that of the deck


def widest_slug():
    """Its radius in the deck's jet [m]."""
    return float(max(read_csv(TABLE)["radius"]))


def scaled_table(velocity=1.0, radius=1.0):
    """The deck's jet with all velocities, and all radii, times a factor; its lengths stay."""
    table = arrays_of(read_csv(TABLE))
    table["time"] = table["time"] / velocity
    table["velocity"] = table["velocity"] * velocity
    table["radius"] = table["radius"] * radius
    file = pathlib.Path(scratch_folder()) / "scaled.csv"
    lines = [",".join(f"{value:.9g}" for value in row) for row in zip(*table.values())]
    file.write_text("\n".join([",".join(table), *lines]) + "\n")
    return file


ROCK = "Materials/Sandstone/Card"
KINDS = {"Jet/Kind"}  # entries of whose changes the program knows no error
CONTINUOUS = {"Jet/Kind": "continuous", "Step/Largest Expansion": "40"}
# Pores full of water without pressure, undrained.
WET = {"Materials/Sandstone/fluid_B0": "2.25 GPa", "Bodies/Rock/Pore Pressure": "0 Pa", "Materials/Sandstone/Density": "2320 kg/m3"}
SHOTS = {  # what differs from the deck: settings, and factors of the jet's velocity and radius
    "the deck": ({}, {}),
    "the deck, to 560 us": ({"Time/End Time": "560 us"}, {}),
    "no confinement": ({"Confinement": ""}, {}),
    "confinement of 138 MPa": ({"Confinement/Pressure": "138 MPa"}, {}),
    "rock with a limit of strength and stiffening grains": ({ROCK: "berea_sandstone_shock.xml"}, {}),
    "jet slower by a seventh": ({}, {"velocity": 6.0 / 7.0}),
    "jet wider by a quarter": ({}, {"radius": 1.25}),
    "no steel casing": ({"Bodies/Casing/Material": "Sandstone"}, {}),
    "jet faster by a tenth": ({}, {"velocity": 1.1}),
    "sandstone with associated flow": ({ROCK: "berea_sandstone.xml"}, {}),
    "half of the confinement": ({"Confinement/Pressure": "5 ksi"}, {}),
    "jet thinner by a fifth": ({}, {"radius": 0.8}),
    "jet faster by a tenth, no confinement": ({"Confinement": ""}, {"velocity": 1.1}),
    "jet slower by a seventh, 138 MPa": ({"Confinement/Pressure": "138 MPa"}, {"velocity": 6.0 / 7.0}),
    "losses returned": ({"Step/Return Losses": "true"}, {}),
    "continuous jet": (CONTINUOUS, {}),
    "continuous jet, wet rock": ({**CONTINUOUS, **WET}, {}),
    "thinned jet": ({"Jet/Kind": "thinned"}, {}),
}


def settings_of(shot):
    """Deck entries of a shot, its end included, and by how much it is slower."""
    entries, factors = SHOTS[shot]
    scale = 1.0 / factors.get("velocity", 1.0)
    found = {"Time/End Time": f"{scale * TIMES[-1]:.6g} us", **entries}
    if factors:
        found["Jet/Table"] = scaled_table(**factors)
    return found, scale
