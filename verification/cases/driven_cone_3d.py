# SPDX-License-Identifier: BSD-3-Clause
"""The cone of driven_cone in three dimensions, its axis between the planes of the grid, against axisymmetry with the same cells."""
import numpy as np
from case import Result
from cases import driven_cone
from runs import run_deck

JET = 3000.0  # of the liner, what is faster along the axis [m/s]


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
        "In three dimensions the driven cone collapses with the velocities of the axisymmetric one, and its jet stays on the axis; that the jet is the same, too, is asked and does not hold yet.",
        "the axisymmetric run with the same cells, two particles per cell in the liner and one in the charge. The axis of the cone in three dimensions, a half, lies 0.3 mm beside "
        "a plane of the grid.",
        ["cell [mm]", "mode", "from the axis [mm]", "V0 [m/s]", "jet [m/s]", "slug [m/s]", "share", "processor time [s]"],
        [],
    )  # fmt: skip
    for h, end in ((2.0, "36 us"), (1.0, "36 us")) if full else ((2.5, "24 us"),):
        same = {"Grid/Cell Size": f"{h!r} mm", "Output/Field Interval": "1 us", "Time/End Time": end}
        plane = run_deck(barreno, "driven_cone.xml", {**same, "Bodies/Liner/Particles Per Cell": "2", "Bodies/Charge/Particles Per Cell": "1"})
        space = run_deck(barreno, "driven_cone_3d.xml", same)
        found = {"axisymmetric": driven_cone.measure(plane), "3D": driven_cone.measure(Turned(space), volumes)}
        for (mode, (speeds, parts, _)), of in zip(found.items(), (plane, space)):
            asked = driven_cone.asked()
            for place, speed, part in zip(driven_cone.middles()[asked, 0], speeds[asked], parts[asked]):
                result.rows.append([h, mode, 1e3 * float(place), float(speed), *map(float, part), of.summary["cpu_seconds"]])
        add_demands(result, h, found, space, h <= 1.0)
    result.notes = NOTES
    return result


NOTES = (
    "The slices are those of which driven_cone asks something. With two cells in the wall the velocity of the liner is that of axisymmetry, while the jet is a handful of "
    "particles in either mode."
)


def add_demands(result, h, found, space, fine):
    """With cells that resolve nothing only the balances and the drift are asked for."""
    name = f"{h:g} mm"
    result.demand(f"{name}: mean velocity of the jet across its axis over that along it", drift(space), 0.01)
    result.demand(f"{name}: energy ledger remainder in three dimensions", abs(space.summary["balances"]["energy"]["error"]), 1e-2)
    if not fine:
        return
    (flat, flat_parts, _), (round_, round_parts, _) = found.values()
    asked = driven_cone.asked()
    result.demand(f"{name}: V0 in three dimensions against axisymmetry, the worst slice", np.abs(round_ / flat - 1.0)[asked].max(), 0.05)
    for column, what in ((0, "jet"), (2, "share of the mass in the jet")):
        result.demand(f"{name}: {what}, the same", np.abs(round_parts[:, column] / flat_parts[:, column] - 1.0)[asked].max(), 0.05)
