# SPDX-License-Identifier: BSD-3-Clause
"""A train of slugs digs into sandstone: with metal that fails, what flies keeps its velocity, and the depth depends less on the cells."""
import numpy as np
from tools.case import Result
from tools.penetration import between_particles_and_grid
from tools.runs import run_deck

DECK = "steady_penetration.xml"
COUNT, RADIUS, LENGTH, GAP, VELOCITY = 24, 1.0, 1.0, 3.0, 2000.0  # slugs [mm, m/s]
DEEP, WIDE, CLEAR = 90.0, 14.0, 2.0  # of the target, and beside it [mm]
END = {False: 30.0, True: 60.0}  # us
CELLS = {False: (1.2, 2.4), True: (1.2, 2.4, 4.8)}  # in the radius of a slug
METALS = {"fails": "tungsten_alloy.xml", "bears any tension": "tungsten.xml"}
ABOVE = 12.0  # the bottom: where slugs fly [mm]
HEAVY = 5e3  # the density of rock is below, that of tungsten's solid above [kg/m3]
SPALL, MELTS = 1.6e9, 1723.0  # of the card that fails [Pa, K]
FIELDS = ("velocity_y", "pressure", "temperature", "density", "expansion_strain", "damage", "status")


def settings_of(metal, cells, end):
    """Lengths in mm, in whole cells."""
    cell = RADIUS / cells
    whole = lambda x: np.ceil(x / cell) * cell  # noqa: E731
    slugs = ",".join(f"{1e-3 * i * (LENGTH + GAP) / VELOCITY:.9g}, {VELOCITY:g}, {1e-3 * RADIUS:g}, {1e-3 * LENGTH:g}, 17600"
        for i in range(COUNT))  # fmt: skip
    return {
        "Materials/Rod/Card": METALS[metal], "Materials/Rod/A": "", "Materials/Rod/B": "", "Materials/Target/Card": "berea_sandstone.xml",
        "Materials/Target/A": "", "Materials/Target/B": "", "Grid/Lower": f"{{0 mm, {-whole(8.0):.12g} mm}}",
        "Grid/Upper": f"{{{whole(WIDE + CLEAR):.12g} mm, {whole(DEEP + 6.0):.12g} mm}}", "Grid/Cell Size": f"{cell:.12g} mm",
        "Jet/Cells Per Radius": "0", "Jet/Particles Per Cell": "4", "Jet/Launch Position": "-2 mm", "Jet/Slugs": f"{COUNT}x5:{{{slugs}}}",
        "Bodies/Block/Upper": f"{{{whole(WIDE):.12g} mm, {DEEP:g} mm}}", "Bodies/Block/Particles Per Cell": "1",
        "Step/Largest Strain": "0.1", "Step/Subcycles": "4", "Time/End Time": f"{end:g} us", "Output/Field Interval": f"{end:g} us",
    }  # fmt: skip


def jet_of(finished, depth):
    """Of the jet's particles at the end: velocity over that at launch of what still flies, and shares that bear what they must not."""
    last = finished.particles(only=FIELDS)
    voids = np.nan_to_num(last.get("expansion_strain", np.zeros_like(last["density"])))
    there = (np.nan_to_num(last["temperature"]) > 0.0) & (last["status"] > 0.0) & (last["density"] * np.exp(voids) > HEAVY)
    flies = there & (last["y"] > 0.0) & (last["y"] < 1e-3 * (depth - ABOVE)) & (last["velocity_y"] > 0.5 * VELOCITY)
    pressure, temperature = last["pressure"][there], last["temperature"][there]
    return {
        "flight": float(np.median(last["velocity_y"][flies]) / VELOCITY),
        "beyond spall": float(np.mean(pressure < -1.001 * SPALL)),
        "molten in tension": float(np.mean((temperature > MELTS) & (pressure < 0.0))),
    }


def run(barreno, full):
    result = Result(
        "A train of slugs",
        "With metal that fails, a train of slugs digs into sandstone without being held by what it leaves behind: slugs on their way keep "
        "their velocity, the method loses little energy, and no metal bears a tension that it could not.",
        f"The velocity at launch, and the finest cells. {COUNT} cylinders of tungsten of {RADIUS:g} mm in radius and length, {GAP:g} mm "
        f"apart, hit Berea sandstone at {VELOCITY:g} m/s; {END[full]:g} us.",
        ["metal", "cells per radius", "depth [mm]", "velocity of what flies over that at launch", "energy lost by the method",
         "mass removed, rock included, over mass of the jet", "steps", "processor time [s]"],
        [],
    )  # fmt: skip
    depths = {}
    launched = COUNT * 17600.0 * np.pi * 1e-9 * RADIUS**2 * LENGTH
    for metal in METALS:
        for cells in CELLS[full]:
            finished = run_deck(barreno, DECK, settings_of(metal, cells, END[full]))
            summary = finished.summary
            depth = depths[metal, cells] = 1e3 * summary["penetration"]["depth"]
            jet = jet_of(finished, depth)
            lost = between_particles_and_grid(finished)
            removed = summary["removed_particles"]["expanded"]["mass"] / launched
            result.rows.append([metal, cells, depth, jet["flight"], lost, removed, summary["steps"], summary["cpu_seconds"]])
            if metal != "fails" or cells < 2.0:
                continue
            name = f"metal that fails, {cells:g} cells per radius"
            result.demand(f"{name}: velocity lost in flight", 1.0 - jet["flight"], 0.02)
            result.demand(f"{name}: energy lost by the method", lost, 0.03)
            result.demand(f"{name}: share of the jet beyond its spall stress", jet["beyond spall"], 0.0)
            result.demand(f"{name}: share of the jet that is molten and in tension", jet["molten in tension"], 0.0)
    if full:
        for metal in METALS:
            change = depths[metal, 4.8] / depths[metal, 2.4] - 1.0
            result.demand(f"metal that {metal}: change of the depth from 2.4 to 4.8 cells per radius", abs(change), 0.03)
    result.notes = (
        "Slugs of metal that bears any tension stick to the spent metal and the grains of rock that line their hole, and pull them along. "
        "Metal that fails tears there, and its open voids bear nothing. A rod in pieces digs deeper than one in a whole, since the hole "
        "goes on growing in the gaps. Four particles of the jet per cell: with two, spent slugs do not flow "
        "aside as they should (late_train), and the depth changes more with the cells."
    )
    return result
