#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Jet table of a self-similar stretching jet.

    python3 make_jet.py > tungsten_154.csv
    python3 make_jet.py --tail > tungsten_320.csv    # with the slow tail of the same jet, down to 400 m/s
    python3 make_jet.py --tail --slugs 80            # the same in fewer, longer slugs
    python3 make_jet.py thinned          # the slugs that Jet/Kind = thinned makes of that table; or continuous

At time 0 the jet has full density and lies on the axis behind the launch plane: material coordinate X from
the virtual origin, velocity v = v_tip X / L0, tip at the plane, X = L0. It stretches freely, x = X (1 + v_tip t / L0),
so X passes the plane at t = (L0 - X) / v. It is cut at time 0 into cylinders that keep their length: the stretch
appears as gaps between them. L0 follows from the velocities of the first and the last cylinder and the time
between them. Lengths and radii go linearly from tip to tail, lengths scaled to fill the jet without gap at time 0.
Mass, momentum and kinetic energy of the slugs of every kind are compared with the integrals over the stretching jet; more than
a thousandth of difference is an error.
"""

import argparse
import collections
import math

TIP_VELOCITY = 7830.0  # m/s
TIP_RADIUS = 1.0e-3  # m
TIP_LENGTH, TAIL_LENGTH = 1.0, 0.3  # relative, before scaling to fill the jet
DENSITY = 17600.0  # kg/m3
# Number of slugs, velocity of the last one [m/s], time from the first launch to the last [s], radius of the last one [m].
Jet = collections.namedtuple("Jet", "count tail_velocity duration tail_radius")
SHORT = Jet(154, 1292.0, 77.5e-6, 2.2e-3)


def with_tail(jet, count, velocity):
    """The same stretching jet with another end: its radius goes on growing linearly along it."""
    share = (1.0 - velocity / TIP_VELOCITY) / (1.0 - jet.tail_velocity / TIP_VELOCITY)  # of its length
    duration = jet.duration * share * jet.tail_velocity / velocity
    return Jet(count, velocity, duration, TIP_RADIUS + (jet.tail_radius - TIP_RADIUS) * share)


TAILED = with_tail(SHORT, 320, 400.0)


def slugs(jet):
    """Rows (time, velocity, radius, length, density), and the initial jet length L0."""
    slowing = 1.0 - jet.tail_velocity / TIP_VELOCITY
    origin = jet.duration * jet.tail_velocity / slowing
    share = [i / (jet.count - 1) for i in range(jet.count)]
    length = [TIP_LENGTH + s * (TAIL_LENGTH - TIP_LENGTH) for s in share]
    # Distance of each centre behind the first one, neighbours touching.
    behind = [0.0]
    for i in range(1, jet.count):
        behind.append(behind[-1] + 0.5 * (length[i - 1] + length[i]))
    scale = origin * slowing / behind[-1]
    rows = []
    for i in range(jet.count):
        x = origin - scale * behind[i]
        velocity = TIP_VELOCITY * x / origin
        radius = TIP_RADIUS + (jet.tail_radius - TIP_RADIUS) * behind[i] / behind[-1]
        rows.append(((origin - x) / velocity, velocity, radius, scale * length[i], DENSITY))
    return rows, origin


def slugs_of_kind(rows, kind):
    """What is launched of the discrete rows: the same, or slugs that touch, thinned or with the mean density."""
    if kind == "discrete":
        return rows
    times = [row[0] for row in rows]
    steps = [b - a for a, b in zip(times, times[1:])]
    result = []
    for (time, velocity, radius, length, density), before, behind in zip(rows, steps[:1] + steps, steps + steps[-1:]):
        whole = 0.5 * velocity * (before + behind)
        filled = length / whole
        if kind == "thinned":
            result.append((time, velocity, radius * math.sqrt(filled), whole, density))
        else:
            result.append((time, velocity, radius, whole, density * filled))
    return result


def totals(rows):
    mass = [d * math.pi * r * r * l for _, _, r, l, d in rows]
    momentum = sum(m * row[1] for m, row in zip(mass, rows))
    energy = sum(0.5 * m * row[1] ** 2 for m, row in zip(mass, rows))
    return sum(mass), momentum, energy


def integrals(jet, rows, origin, points=20000):
    """The same of the continuous jet, by the midpoint rule over X, from the tail's end to the tip's."""
    first, last = rows[0], rows[-1]
    x_tip, x_tail = origin, origin * last[1] / first[1]
    low, high = x_tail - 0.5 * last[3], x_tip + 0.5 * first[3]
    mass = momentum = energy = 0.0
    for k in range(points):
        x = low + (k + 0.5) * (high - low) / points
        radius = TIP_RADIUS + (jet.tail_radius - TIP_RADIUS) * (x_tip - x) / (x_tip - x_tail)
        dm = DENSITY * math.pi * radius**2 * (high - low) / points
        velocity = TIP_VELOCITY * x / origin
        mass, momentum, energy = mass + dm, momentum + dm * velocity, energy + 0.5 * dm * velocity**2
    return mass, momentum, energy


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("kind", nargs="?", default="discrete", help="discrete, thinned or continuous")
    asked.add_argument("--tail", action="store_true", help="with the slow tail, down to 400 m/s")
    asked.add_argument("--slugs", type=int, metavar="N", help="how many, at least 2: fewer are longer, and so are the gaps between them")
    asked = asked.parse_args()
    kind, jet = asked.kind, TAILED if asked.tail else SHORT
    if asked.slugs is not None:
        if asked.slugs < 2:
            raise SystemExit(f"make_jet.py: --slugs {asked.slugs} is too few; write 2 or more.")
        jet = jet._replace(count=asked.slugs)
    if kind not in ("discrete", "thinned", "continuous"):
        raise SystemExit(f'make_jet.py: "{kind}" is no kind of a jet; write discrete, thinned or continuous.')
    pieces, origin = slugs(jet)
    rows = slugs_of_kind(pieces, kind)
    launched, exact = totals(rows), integrals(jet, pieces, origin)
    for name, a, b in zip(("mass", "momentum", "energy"), launched, exact):
        if abs(a / b - 1.0) > 1e-3:
            raise SystemExit(f"{name} of the slugs, {a}, is not that of the continuous jet, {b}")
    print("# units: SI")
    form = {
        "discrete": "cut into full-density cylinders",
        "thinned": "in touching cylinders of full density and less radius",
        "continuous": "in touching cylinders of the mean density",
    }
    print(f"# Made by make_jet.py: self-similar stretching jet, v = v_tip X / L0, {form[kind]}.")
    print(f"# v_tip = {TIP_VELOCITY} m/s, L0 = {origin:.6g} m, {jet.count} slugs over {jet.duration:.6g} s")
    print(f"# launched mass {launched[0]:.9g} kg, momentum {launched[1]:.9g} kg m/s, kinetic energy {launched[2]:.9g} J")
    print(f"# continuous    mass {exact[0]:.9g} kg, momentum {exact[1]:.9g} kg m/s, kinetic energy {exact[2]:.9g} J")
    print("time,velocity,radius,length,density")
    for row in rows:
        print(",".join(f"{value:.9g}" for value in row))


if __name__ == "__main__":
    main()
