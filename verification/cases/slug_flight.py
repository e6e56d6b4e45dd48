# SPDX-License-Identifier: BSD-3-Clause
"""A slug of a jet that flies through a channel and touches nothing keeps its velocity."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DECK = "steady_penetration.xml"
RADIUS, CELLS = 1.0, 2.4  # of the slug [mm], and cells in it
VELOCITY, LAUNCH = 2000.0, -3.0  # [m/s, mm]
WIDTH, BEHIND, BEYOND = 5.0, 8.0, 10.0  # of the grid: beside the axis, before and beyond the channel, about [mm]
HEAVY = 1e4  # the density of rock is below, that of tungsten above [kg/m3]
WAYS = {False: 60.0, True: 200.0}  # length of the channel in the cheap and in the full form, in radii of the slug
MOST = 5e-3  # of the velocity and of the energy that a flight may lose
CONTACT = {f"Contact/Wall/{name}": word for name, word in (("Material", "Rod"), ("Other Material", "Target"), ("Kind", "frictionless"))}
RIGID = {"Bodies/Block/Motion": "{0 m/s, 0 m/s}"}
# Name: (channel's radius over the slug's, the slug's length over its radius, settings)
FLIGHTS = {
    "far from any wall": (4.0, 1.0, {}),
    "rigid wall": (2.3, 1.0, {**CONTACT, **RIGID}),
    "rock": (2.3, 1.0, {}),
    "rock, steps of four parts": (2.3, 1.0, {"Step/Subcycles": "4"}),
    "rock, slug of a third of a cell": (2.3, 0.15, {}),
    "rock, contact": (2.3, 1.0, CONTACT),
    "narrow, rock": (1.6, 1.0, {}),
    "narrow, rock, steps of four parts": (1.6, 1.0, {"Step/Subcycles": "4"}),
    "narrow, rock, CPDI": (1.6, 1.0, {"Step/Shape Function": "CPDI"}),
    "narrow, rock, 4.8 cells per radius": (1.6, 1.0, {"cells": 2.0 * CELLS}),
    "narrow, rock, contact": (1.6, 1.0, CONTACT),
}


def settings_of(way, channel, length, settings):
    """Lengths in mm, in whole cells."""
    change = dict(settings)
    cell = RADIUS / change.pop("cells", CELLS)
    whole = lambda x: np.ceil(x / cell) * cell  # noqa: E731
    lower, right = -whole(BEHIND), whole(WIDTH)
    end = way * RADIUS
    return {
        "Materials/Rod/Card": "tungsten.xml", "Materials/Rod/A": "", "Materials/Rod/B": "", "Materials/Target/Card": "berea_sandstone.xml",
        "Materials/Target/A": "", "Materials/Target/B": "", "Grid/Lower": f"{{0 mm, {lower:.12g} mm}}",
        "Grid/Upper": f"{{{right:.12g} mm, {whole(end + BEYOND):.12g} mm}}", "Grid/Cell Size": f"{cell:.12g} mm",
        "Jet/Cells Per Radius": "0", "Jet/Launch Position": f"{LAUNCH:g} mm",
        "Jet/Slugs": f"1x5:{{0, {VELOCITY:g}, {1e-3 * RADIUS:g}, {1e-3 * length * RADIUS:g}, 17600}}",
        "Bodies/Block/Lower": f"{{{channel * RADIUS:g} mm, 0 mm}}", "Bodies/Block/Upper": f"{{{right - 2.0 * cell:.12g} mm, {end:g} mm}}",
        "Bodies/Block/Particles Per Cell": "1", "Step/Largest Strain": "0.1", "Time/End Time": f"{1e3 * (end - LAUNCH) / VELOCITY:.12g} us",
        "Output/Field Interval": "0 us", **change,
    }  # fmt: skip


def lost(finished):
    """Shares of the slug's velocity and of its kinetic energy that are gone at the end, pieces that were torn off left out."""
    last = finished.particles(only=("velocity_x", "velocity_y", "density", "status"))
    slug = (last["density"] > HEAVY) & (last["status"] > 0.0) & (last["velocity_y"] > 0.05 * VELOCITY)
    corners = last["corners"][slug]
    (x, y), turned = np.moveaxis(corners, 2, 0), np.roll(corners, -1, axis=1)
    area = 0.5 * np.abs(np.sum(x * turned[:, :, 1] - turned[:, :, 0] * y, axis=1))
    mass = area * last["x"][slug] * last["density"][slug]
    mean = lambda values: float(np.sum(mass * values[slug]) / np.sum(mass))  # noqa: E731
    return 1.0 - mean(last["velocity_y"]) / VELOCITY, 1.0 - mean(last["velocity_x"] ** 2 + last["velocity_y"] ** 2) / VELOCITY**2


def run(barreno, full):
    way = WAYS[full]
    result = Result(
        "A slug in free flight",
        "A slug that shares no node with a wall flies on as it was launched; one that does is held by the wall, unless jet and rock have a "
        "contact.",
        f"The velocity at launch. A cylinder of tungsten with {CELLS:g} cells in its radius flies {way:g} radii far through a channel of "
        "2.3 radii, or a narrow one of 1.6, at 2 km/s. It touches nothing; the wall of the narrow channel is 1.4 cells beside it.",
        ["flight", "channel over slug radius", "cells beside the slug", "velocity lost", "energy lost", "steps", "processor time [s]"],
        [],
    )  # fmt: skip
    for name, (channel, length, settings) in FLIGHTS.items():
        finished = run_deck(barreno, DECK, settings_of(way, channel, length, settings))
        velocity, energy = lost(finished)
        cells = settings.get("cells", CELLS)
        summary = finished.summary
        result.rows.append([name, channel, (channel - 1.0) * cells, velocity, energy, summary["steps"], summary["cpu_seconds"]])
        result.demand(f"{name}: velocity lost", abs(velocity), MOST)
        result.demand(f"{name}: energy lost", abs(energy), MOST)
    result.notes = (
        "Particles of two bodies whose distance is less than about two cells share nodes, and without a contact a node has one "
        "velocity. The wall, or debris that lies beside the path, then shears the slug and takes momentum from it, as if both "
        "were glued together. Steps of several lengths change nothing of this, and CPDI makes it worse. A contact, which gives "
        "the jet a velocity field of its own, removes it, and so do cells of which more than two lie in between. Spent jet is "
        "of the jet's own material, so no contact with it is possible."
    )
    return result
