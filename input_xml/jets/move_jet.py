#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A jet table as it stands at another plane, further along the jet's flight.

    python3 move_jet.py TABLE --by "50 mm" > moved.csv

Every row is a slice that flies on with its own speed u: it passes the new plane at t2 = t + D / u, D being the distance
(--by). Rows touch there: a slice lasts dt2, from half-way to the row before it to half-way to the row behind it, so that
dt2 / dt = 1 - D u' / u^2 for short slices, u' = du/dt along the table. As long as the jet is whole its metal keeps its
density and thins, r2 = r sqrt(dt / dt2), length u dt2. A slice that has broken up keeps radius and length; gaps grow.

Rows that catch up with those before them (an inverse velocity gradient, at the tip of a formed jet) merge on the way:
mass and momentum stay, the kinetic energy that is lost is reported as heat.

When a slice breaks (--break-up), counted from the virtual origin, --origin before the plane of the table:
  never            it stays whole (default)
  TIME             "90 us"
  hirsch           t_b = 2 r / V_PL: E. Hirsch's plastic velocity, --plastic-velocity. Recalled, not found again: the
                   formula, and 80 to 200 m/s, usually 100 to 120, for copper
  chou-carleone    t_b = (r / Cp) (3.75 - 0.125 r s / Cp + Cp / (r s)), Cp = sqrt(Y / rho), s the stretch rate -u' / u, Y
                   --yield. Recalled, not found again: form and numbers of P. C. Chou and J. Carleone
They differ by a factor of two to four: treat a break-up time as an input with a range.

--target DENSITY --cut-off SPEED prints on stderr the depth of penetration from the virtual origin into a strengthless
target (W. A. Allison, R. Vitali, BRL report 1184, 1963; R. DiPersio, J. Simon, BRL memorandum report 1542, 1964; derived
anew, see virtual_origin_depth).

A table may be of any kind of Jet/Kind. Quantities have the units of decks, "50 mm", or are in SI without one; tables are in SI. Only the
standard library is used.
"""

import argparse
import math
import sys

from quantity import quantity, value_of

HEADER = "time,velocity,radius,length,density"


class TableError(ValueError):
    """A sentence on what is wrong."""


def hirsch(radius, plastic_velocity):
    """Break-up time [s] after the virtual origin, t_b = 2 r / V_PL (recalled)."""
    return 2.0 * radius / plastic_velocity


def chou_carleone(radius, rate, yield_stress, density):
    """Break-up time [s] of a jet of this radius [m] that stretches at this rate [1/s] (recalled); infinite if it does not."""
    if rate <= 0.0:
        return math.inf
    plastic_speed = math.sqrt(yield_stress / density)
    strain = radius * rate / plastic_speed
    return radius / plastic_speed * (3.75 - 0.125 * strain + 1.0 / strain)


def virtual_origin_depth(standoff, tip, cut_off, break_up, jet_density, target_density):
    """Depth [m] in a target without strength of a jet from a virtual origin `standoff` before its face, from `tip` to the
    speed `cut_off` below which nothing penetrates; it breaks up at the time `break_up` after the origin.

    A whole jet of speed u at the depth P is there at t = (S + P) / u and digs at dP/dt = u / (1 + g), g = sqrt(rho_t / rho_j):
    P = S ((V0 / Vm)^(1/g) - 1). A broken one keeps the lengths that it had at the break-up."""
    g = math.sqrt(target_density / jet_density)
    start = standoff / tip
    if break_up >= start * (tip / cut_off) ** ((1.0 + g) / g):
        return standoff * ((tip / cut_off) ** (1.0 / g) - 1.0)
    if break_up <= start:
        return (tip - cut_off) * break_up / g
    whole = (1.0 + g) * (tip * break_up) ** (1.0 / (1.0 + g)) * standoff ** (g / (1.0 + g))
    return (whole - cut_off * break_up) / g - standoff


def read_table(lines, source):
    """Rows (time, velocity, radius, length, density) in SI of a jet table with plain numbers. Without pandas: needs Python alone."""
    rows, header = [], False
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if text.startswith("#"):
            if "units:" in text and text.split("units:")[1].strip() != "SI":
                raise TableError(f"{source}, line {number}: this tool reads SI alone; convert the table.")
            continue
        if not text:
            continue
        if not header:
            if text.replace(" ", "") != HEADER:
                raise TableError(f'{source}, line {number} = "{text}" is not the header of a jet table; write "{HEADER}".')
            header = True
            continue
        try:
            row = tuple(float(cell) for cell in text.split(","))
        except ValueError:
            raise TableError(f'{source}, line {number} = "{text}" is not five plain numbers; correct it.') from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise TableError(f'{source}, line {number} = "{text}" is not five plain numbers; correct it.')
        if min(row[1:]) <= 0.0:
            raise TableError(f"{source}, line {number}: velocity, radius, length and density must be above 0; correct it.")
        if rows and row[0] <= rows[-1][0]:
            raise TableError(f"{source}, line {number}: time {row[0]:g} s is not after the row before it; sort the rows.")
        rows.append(row)
    if len(rows) < 2:
        raise TableError(f"{source} has {len(rows)} rows (a jet that stretches needs at least two); give the whole table.")
    return rows


def durations(times):
    """How long each row's slice takes to pass: from half-way to the one before to half-way to the one behind."""
    steps = [b - a for a, b in zip(times, times[1:])]
    return [0.5 * (before + behind) for before, behind in zip(steps[:1] + steps, steps + steps[-1:])]


def mass_of(row):
    return row[4] * math.pi * row[2] ** 2 * row[3]


def totals(rows):
    """Mass, momentum, kinetic energy."""
    return tuple(sum(mass_of(row) * row[1] ** power / (2.0 if power == 2 else 1.0) for row in rows) for power in range(3))


def meeting(ahead, behind):
    """How far beyond the plane the row behind catches up with the one ahead; infinite if never."""
    if behind[1] <= ahead[1]:
        return math.inf
    return (behind[0] - ahead[0]) / (1.0 / ahead[1] - 1.0 / behind[1])


def merged(ahead, behind, distance):
    """One row of both, which go on together from where they meet; it fills as much of its room as they did."""
    mass = mass_of(ahead) + mass_of(behind)
    velocity = (mass_of(ahead) * ahead[1] + mass_of(behind) * behind[1]) / mass
    density = mass / sum(mass_of(row) / row[4] for row in (ahead, behind))
    radius = math.sqrt(sum(mass_of(row) * row[2] ** 2 for row in (ahead, behind)) / mass)
    filled = sum(mass_of(row) * row[5] for row in (ahead, behind)) / mass
    time = ahead[0] + distance / ahead[1] - distance / velocity
    return (time, velocity, radius, mass / (density * math.pi * radius**2), density, filled)


def with_filled_part(rows):
    """Rows with the part of its room along the jet that each fills: its length over velocity times duration."""
    lasting = durations([row[0] for row in rows])
    result = [(*row, row[3] / (row[1] * dt)) for row, dt in zip(rows, lasting)]
    for number, row in enumerate(result, 1):
        if row[5] > 1.001:
            raise TableError(
                f"row {number} is {row[3]:.6g} m long, with {row[3] / row[5]:.6g} m of room between its neighbours (slugs overlap); "
                "correct the table."
            )
    return result


def merge_colliding(rows, distance):
    """Rows after all that meet within the distance have become one, in the order in which they meet."""
    rows = list(rows)
    while len(rows) > 1:
        meet, first = min((meeting(rows[i], rows[i + 1]), i) for i in range(len(rows) - 1))
        if meet > distance:
            break
        rows[first : first + 2] = [merged(rows[first], rows[first + 1], meet)]
    return rows


def break_up_times(rows, choice):
    """Seconds after the virtual origin at which each row breaks. choice: a function of (radius, stretch rate, density)."""
    times = [row[0] for row in rows]
    result = []
    for i, row in enumerate(rows):
        a, b = max(0, i - 1), min(len(rows) - 1, i + 1)
        rate = -(rows[b][1] - rows[a][1]) / (times[b] - times[a]) / row[1]
        result.append(choice(row[2], rate, row[4]))
    return result


def move(rows, distance, origin=0.0, choice=None):
    """The rows at the plane `distance` further on, and the heat of those that merged [J].

    origin: of the virtual origin before the table's plane [m]; choice: as for break_up_times, None: never."""
    if not distance > 0.0:
        raise TableError(f"--by = {distance:g} m is not above 0 (a jet flies on); give the distance to the new plane.")
    energy = totals(rows)[2]
    rows = merge_colliding(with_filled_part(rows), distance)
    heat = max(0.0, energy - totals(rows)[2])
    if len(rows) < 2:
        raise TableError(f"all rows merge within {distance:g} m (the speed rises along the table); check its order.")
    breaks = break_up_times(rows, choice) if choice else [math.inf] * len(rows)
    last = durations([row[0] + distance / row[1] for row in rows])
    result = []
    for i, row in enumerate(rows):
        time, velocity, radius, length, density, filled = row
        whole = min(distance, max(0.0, velocity * breaks[i] - origin))  # flown before it breaks
        # While it is whole its metal fills the same part of its room.
        longer = filled * velocity * durations([each[0] + whole / each[1] for each in rows])[i]
        if longer > 1.001 * velocity * last[i]:
            raise TableError(
                f"row {i + 1} would be {longer:.6g} m long at the new plane, with {velocity * last[i]:.6g} m of room between its "
                "neighbours (slugs overlap: it has broken up, and those behind come nearer); let it break later."
            )
        result.append((time + distance / velocity, velocity, radius * math.sqrt(length / longer), longer, density))
    return result, heat


def arguments(given):
    parser = argparse.ArgumentParser(description="A jet table at another plane.", allow_abbrev=False)
    parser.add_argument("table")
    parser.add_argument("--by", type=quantity("length"), required=True, help='distance to the new plane, "50 mm"')
    parser.add_argument("--origin", type=quantity("length"), default=0.0, help="of the virtual origin before the table's plane")
    parser.add_argument("--break-up", default="never", help='never, a time ("90 us"), hirsch or chou-carleone')
    parser.add_argument("--plastic-velocity", type=quantity("speed"), default=110.0, help="of hirsch (default 110 m/s); recalled")
    parser.add_argument("--yield", dest="yield_stress", type=quantity("stress"), default=200e6, help="of chou-carleone (default 200 MPa)")
    parser.add_argument("--target", type=quantity("density"), help='density of a strengthless target, "2.3 g/cm3"')
    parser.add_argument("--cut-off", type=quantity("speed"), help='speed below which nothing penetrates, "2 km/s"')
    return parser.parse_args(given)


def choice_of(asked):
    """The break-up time as a function of (radius, stretch rate, density), or None."""
    if asked.break_up == "never":
        return None
    if asked.break_up == "hirsch":
        if not asked.plastic_velocity > 0.0:
            raise TableError("--plastic-velocity must be above 0 m/s; for copper 80 to 200 is usual.")
        return lambda radius, rate, density: hirsch(radius, asked.plastic_velocity)
    if asked.break_up == "chou-carleone":
        if not asked.yield_stress > 0.0:
            raise TableError("--yield must be above 0 Pa; give the flow stress of the jet.")
        return lambda radius, rate, density: chou_carleone(radius, rate, asked.yield_stress, density)
    try:
        time = value_of(asked.break_up, "time")
    except ValueError as error:
        raise TableError(f"--break-up is none of never, hirsch and chou-carleone, and {error}.") from None
    if time < 0.0:
        raise TableError(f"--break-up = {asked.break_up} is before the virtual origin; give a time of 0 or more.")
    return lambda radius, rate, density: time


def print_depth(rows, choice, asked):
    """The depth of Allison and Vitali, with the break-up time of the middle row."""
    if not (asked.cut_off and 0.0 < asked.cut_off < rows[0][1]):
        raise TableError(f"--cut-off must be given, above 0 and below the tip's {rows[0][1]:g} m/s.")
    if not (asked.target > 0.0 and asked.origin > 0.0):
        raise TableError("--target needs a density above 0 and --origin above 0 (the depth counts from a virtual origin); give both.")
    break_up = break_up_times(rows, choice)[len(rows) // 2] if choice else math.inf
    standoff = asked.origin + asked.by
    depth = virtual_origin_depth(standoff, rows[0][1], asked.cut_off, break_up, rows[0][4], asked.target)
    print(f"depth from a virtual origin {standoff:g} m before the target: {depth:.4g} m", file=sys.stderr)


def main(given=None):
    asked = arguments(given)
    try:
        with open(asked.table, encoding="utf-8") as stream:
            rows = read_table(stream, asked.table)
        if asked.origin < 0.0:
            raise TableError(f"--origin = {asked.origin:g} m is negative (the origin lies before the plane); give its distance.")
        choice = choice_of(asked)
        moved, heat = move(rows, asked.by, asked.origin, choice)
        if asked.target is not None:
            print_depth(rows, choice, asked)
    except (TableError, OSError) as error:
        raise SystemExit(f"move_jet.py: {error}") from None
    before, after = totals(rows), totals(moved)
    print("# units: SI")
    print(f"# Made by move_jet.py: {asked.table.rsplit('/', 1)[-1]} moved by {asked.by:g} m, break-up {asked.break_up}")
    for name, unit, a, b in zip(("mass", "momentum", "kinetic energy"), ("kg", "kg m/s", "J"), before, after):
        print(f"# {name} {b:.9g} {unit}, of the table {a:.9g}")
    print(f"# rows {len(moved)} of {len(rows)}; heat of those that merged {heat:.6g} J")
    print(HEADER)
    shift = min(0.0, moved[0][0])  # a table begins at or after 0
    for row in moved:
        print(",".join(f"{value:.9g}" for value in (row[0] - shift, *row[1:])))


if __name__ == "__main__":
    main()
