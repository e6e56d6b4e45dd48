# SPDX-License-Identifier: BSD-3-Clause
"""Shots unlike perforation.xml, on which the interval of a depth is tried: other pressures, rocks, jets and targets."""
import pathlib

from barreno.runs.csv_table import arrays_of, read_csv
from tools.case_list import DOCS
from tools.runs import DECKS, scratch_folder

PICTURE = DOCS / "pictures" / "hole_of_cells.png"
STEP = 5.0  # of the profile of the hole [mm]
TABLE = DECKS / "jets" / "tungsten_320.csv"
TIMES = (20, 60, 90, 120, 150, 200, 240, 280, 300, 400)  # us, of a jet as fast as that of the deck; the last is not reached by all


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


AT_REST = "at rest"
ROCK = "Materials/Sandstone/Card"
UNLIKE = {"Jet/Kind", "Bodies/Rock/Pore Pressure"}  # entries of whose changes the program knows no error
CONTINUOUS, THINNED = {"Jet/Kind": "continuous"}, {"Jet/Kind": "thinned"}
BARE = {"Confinement": ""}
# Pores full of water without pressure, undrained.
WET = {ROCK: "berea_sandstone_heat_wet.xml", "Bodies/Rock/Pore Pressure": "0 Pa"}
# The deck's rock before it had damage, heat and a limit of strength, whose hole is at rest earlier.
FORMER = {ROCK: "berea_sandstone_bounded.xml", "Time/End Time": "300 us"}
# The smallest cells twice as far from the path as Cells Per Radius has them; of 1.2 and 1.8 cells per radius, whose path is one level.
WALL = {"Refinement/Wall/Lower": "{0 m, -0.01 m}", "Refinement/Wall/Upper": "{13 mm, 0.8 m}", "Refinement/Wall/Level": "1"}
HEATED = {"Materials/Sandstone/Specific heat": "1000 J/(kg K)"}  # changes no stress: losses have a place to return to
SHOTS = {  # what differs from the deck: settings, and factors of the jet's velocity and radius
    "the deck": ({}, {}),
    "the deck, to rest": ({"Time/End Time": AT_REST}, {}),
    "losses returned": ({"Step/Return Losses": "true"}, {}),
    "small cells to 13 mm from the axis": (WALL, {}),
    "no confinement": (BARE, {}),
    "confinement of 17 MPa": ({"Confinement/Pressure": "17 MPa"}, {}),
    "confinement of 34 MPa": ({"Confinement/Pressure": "34 MPa"}, {}),
    "confinement of 138 MPa": ({"Confinement/Pressure": "138 MPa"}, {}),
    "continuous jet": (CONTINUOUS, {}),
    "thinned jet": (THINNED, {}),
    "wet rock": (WET, {}),
    "wet rock, both pressures higher by 35 MPa": ({**WET, "Confinement/Pressure": "104 MPa", "Bodies/Rock/Pore Pressure": "35 MPa"}, {}),
    "continuous jet, wet rock": ({**CONTINUOUS, **WET}, {}),
    "former rock": (FORMER, {}),
    "former rock, to 560 us": ({**FORMER, "Time/End Time": "560 us"}, {}),
    "former rock, no confinement": ({**FORMER, **BARE}, {}),
    "former rock, 138 MPa": ({**FORMER, "Confinement/Pressure": "138 MPa"}, {}),
    "rock with a limit of strength and stiffening grains": ({**FORMER, ROCK: "berea_sandstone_shock.xml"}, {}),
    "former rock, jet slower by a seventh": (FORMER, {"velocity": 6.0 / 7.0}),
    "former rock, jet wider by a quarter": (FORMER, {"radius": 1.25}),
    "former rock, no steel casing": ({**FORMER, "Bodies/Casing/Material": "Sandstone"}, {}),
    "former rock, jet faster by a tenth": (FORMER, {"velocity": 1.1}),
    "rock with associated flow": ({**FORMER, ROCK: "berea_sandstone.xml"}, {}),
    "former rock, half of the confinement": ({**FORMER, "Confinement/Pressure": "5 ksi"}, {}),
    "former rock, jet faster by a tenth, no confinement": ({**FORMER, **BARE}, {"velocity": 1.1}),
    "former rock, losses returned": ({**FORMER, **HEATED, "Step/Return Losses": "true"}, {}),
}


def settings_of(shot):
    """Deck entries of a shot, its end included, and by how much it is slower."""
    entries, factors = SHOTS[shot]
    scale = 1.0 / factors.get("velocity", 1.0)
    end = entries.get("Time/End Time", f"{TIMES[-1]} us")
    found = {**entries, "Time/End Time": end if end == AT_REST else f"{scale * float(end.removesuffix(' us')):.6g} us"}
    if factors:
        found["Jet/Table"] = scaled_table(**factors)
    return found, scale
