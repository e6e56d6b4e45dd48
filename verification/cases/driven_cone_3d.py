# SPDX-License-Identifier: BSD-3-Clause
"""The cone of driven_cone in three dimensions: its axis between the planes of the grid against axisymmetry with the same cells, and a
quarter against axisymmetry with cells half as large."""
import numpy as np
from tools.case import Result
from cases import driven_cone
from tools.runs import run_deck

JET = 3000.0  # of the liner, what is faster along the axis [m/s]

# The deck's half, cut by a second plane of symmetry: four cells in the wall can be afforded.
QUARTER = {
    "Grid/Cell Size": "0.5 mm",
    "Grid/Lower": "{0 mm, -60 mm, 0 mm}",
    "Grid/Upper": "{60 mm, 200 mm, 60 mm}",
    "Conditions/Side/Face": "x_lower",
    "Conditions/Side/Kind": "symmetry",
    "Shapes/Other Half/Shape": "half-space",
    "Shapes/Other Half/Point": "{0 mm, 0 mm, 0 mm}",
    "Shapes/Other Half/Normal": "{-1, 0, 0}",
    "Shapes/Half Charge/Parts": "{Cone Of The Charge, This Half, Other Half}",
    "Shapes/Half Cone/Parts": "{Outer Cone, This Half, Other Half}",
}


class Turned:
    """A run in three dimensions as one in axisymmetry: x and velocity_x are those across the axis, away from it."""

    def __init__(self, run):
        self.run = run

    def instants(self):
        return self.run.instants()

    def particles(self, step=-1, only=None):
        wanted = None if only is None else (*only, "velocity_z")
        found = self.run.particles(step, wanted)
        x, z = found["x"], found["z"]
        distance = np.hypot(x, z)
        return {**found, "x": distance, "velocity_x": (x * found["velocity_x"] + z * found["velocity_z"]) / distance}


def volumes(start):
    """Of the undeformed particles, boxes along the axes [m3]."""
    return np.prod(np.ptp(start["corners"], axis=1), axis=1)


def drift(run):
    """Mean velocity of the jet across its axis and in the plane of symmetry, over that along it."""
    masses, end = volumes(run.particles(0)), run.particles()
    jet = np.isnan(end["burn"]) & (end["status"] == 1) & (end["velocity_y"] > JET)
    across, along = (np.average(end[f"velocity_{axis}"][jet], weights=masses[jet]) for axis in "xy")
    return abs(float(across / along))


def run(barreno, full):
    result = Result(
        "Cone driven by an explosive, in three dimensions",
        "In three dimensions the driven cone collapses with the velocities of the axisymmetric one. Its jet stays on the axis, and with "
        "four cells in the wall the jet is as fast. The jet's share of the mass is required to be the same; this does not hold yet.",
        "the axisymmetric run. For cells of 2 and 1 mm: with the same cells, two particles per cell and direction in the liner and one "
        "in the charge. The axis of the cone in three dimensions, a half, lies 0.3 mm beside a plane of the grid. "
        "For 0.5 mm, a quarter between two planes of symmetry: with cells of 0.25 mm, as driven_cone runs it.",
        ["cell [mm]", "mode", "from the axis [mm]", "V0 [m/s]", "jet [m/s]", "slug [m/s]", "share", "processor time [s]"],
        [],
    )  # fmt: skip
    for h, end in ((2.0, "36 us"), (1.0, "36 us")) if full else ((2.5, "24 us"),):
        same = {"Grid/Cell Size": f"{h!r} mm", "Output/Field Interval": "1 us", "Time/End Time": end}
        plane = run_deck(barreno, "driven_cone.xml",
            {**same, "Bodies/Liner/Particles Per Cell": "2", "Bodies/Charge/Particles Per Cell": "1"})
        space = run_deck(barreno, "driven_cone_3d.xml", same)
        found = [add_rows(result, h, plane), add_rows(result, h, space)]
        name = f"{h:g} mm"
        result.demand(f"{name}: mean velocity of the jet across its axis over that along it", drift(space), 0.01)
        add_balance(result, name, space)
        if h <= 1.0:
            compare(result, name, *found)
    if full:
        add_quarter(result, barreno)
    result.notes = NOTES
    return result


def add_rows(result, h, run):
    """V0 of the slices of which driven_cone asks something, and their (jet, slug, share)."""
    asked, space = driven_cone.asked(), "z" in run.particles(0)
    speeds, parts, _ = driven_cone.measure(Turned(run), volumes) if space else driven_cone.measure(run)
    mode = "3D" if space else "axisymmetric"
    for place, speed, part in zip(driven_cone.middles()[asked, 0], speeds[asked], parts[asked]):
        result.rows.append([h, mode, 1e3 * float(place), float(speed), *map(float, part), run.summary["cpu_seconds"]])
    return speeds[asked], parts[asked]


def add_quarter(result, barreno):
    """A quarter's jet cannot leave its axis: nothing is asked of its drift."""
    same = {"Output/Field Interval": "1 us", "Time/End Time": "34 us"}
    plane = run_deck(barreno, "driven_cone.xml", {**same, "Grid/Cell Size": "0.25 mm"})
    space = run_deck(barreno, "driven_cone_3d.xml", {**same, **QUARTER})
    found = [add_rows(result, 0.25, plane), add_rows(result, 0.5, space)]
    add_balance(result, "0.5 mm", space)
    compare(result, "0.5 mm against 0.25 mm", *found)


NOTES = (
    "The slices are those of which driven_cone asks something. With two cells in the wall the velocity of the liner is that of "
    "axisymmetry, while the jet is a handful of "
    "particles in either mode. With four in three dimensions the jet's velocity is within 5 % of that with eight in axisymmetry, and its "
    "share of the mass is too large in every slice."
)


def add_balance(result, name, space):
    result.demand(f"{name}: energy ledger remainder in three dimensions", abs(space.summary["balances"]["energy"]["error"]), 1e-2)


def compare(result, name, flat, space):
    (speeds, parts), (speeds_3d, parts_3d) = flat, space
    result.demand(f"{name}: V0 in three dimensions against axisymmetry, the worst slice", np.abs(speeds_3d / speeds - 1.0).max(), 0.05)
    for column, what in ((0, "jet"), (2, "share of the mass in the jet")):
        result.demand(f"{name}: {what}, the same", np.abs(parts_3d[:, column] / parts[:, column] - 1.0).max(), 0.05)
