# SPDX-License-Identifier: BSD-3-Clause
"""A liner that an explosive drives onto an axis or a plane at x = 0: how fast its parts arrive, what they become, and what the theory says
of that.

Theory: E. M. Pugh, R. J. Eichelberger and N. Rostoker, J. Appl. Phys. 23 (1952) 532, which with one velocity for all parts is that of G.
Birkhoff, D. P. MacDougall, E. M. Pugh and G. Taylor, J. Appl. Phys. 19 (1948) 563. A part of the liner that the front reaches at T flies on
with V0, turned by d off the normal of its face: sin d = V0 / (2 U), U the speed with which the front sweeps along the face (Taylor's
relation). Where it arrives the liner makes the angle b with the axis, and it splits: jet V0 cos(a + d - b/2) / sin(b/2), slug V0 sin(a + d
- b/2) / cos(b/2), share of the jet sin^2(b/2)."""
import numpy as np


def areas(start):
    """Of the undeformed particles of a plane run or of a section through the axis [m2]."""
    x, y = start["corners"][..., 0], start["corners"][..., 1]
    return 0.5 * np.abs(np.sum(x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1), axis=1))


def slices(start, chosen, axis, edges):
    """Index of the slice between edges along the direction `axis` (x, y) that each particle starts in; -1 outside and where not chosen."""
    along = start["x"] * axis[0] + start["y"] * axis[1]
    of = np.digitize(along, edges) - 1
    return np.where(chosen & (along >= edges[0]) & (along < edges[-1]), of, -1)


def mean_of(values, masses, part):
    return float(np.average(values[part], weights=masses[part]))


def arrival_speeds(run, of, masses, count, near):
    """Speed of the mean motion of each slice when its mean distance from x = 0 falls below `near`, one for all or one for each [m/s]; nan
    if it does not."""
    times = range(run.instants())
    history = np.full((len(times), count, 2), np.nan)
    for step in times:
        now = run.particles(step, only=("status", "velocity_x", "velocity_y"))
        for number in range(count):
            part = (of == number) & (now["status"] == 1)
            if part.any():
                speed = np.hypot(mean_of(now["velocity_x"], masses, part), mean_of(now["velocity_y"], masses, part))
                history[step, number] = mean_of(now["x"], masses, part), speed
    return np.array([speed_at(history[:, number], limit) for number, limit in enumerate(np.broadcast_to(near, count))])


def speed_at(history, near):
    """Between the two outputs of which the second is the first one nearer than `near`."""
    place, speed = history[:, 0], history[:, 1]
    late = np.flatnonzero((place[1:] < near) & (place[:-1] >= near))
    if not late.size:
        return float("nan")
    i = int(late[0])
    part = (place[i] - near) / (place[i] - place[i + 1])
    return float(speed[i] + part * (speed[i + 1] - speed[i]))


def what_became(run, of, masses, middles):
    """(jet, slug, share of the jet) of each slice at the end: the jet is what is faster along y than its entry of `middles`, velocities are
    means over the mass [m/s]."""
    end, rows = run.particles(), []
    for number, middle in enumerate(middles):
        there = (of == number) & (end["status"] == 1)
        jet, slug = (there & side for side in (end["velocity_y"] > middle, end["velocity_y"] <= middle))
        if not (jet.any() and slug.any()):
            rows.append((float("nan"),) * 3)
            continue
        velocities = (mean_of(end["velocity_y"], masses, part) for part in (jet, slug))
        rows.append((*velocities, float(masses[jet].sum() / masses[there].sum())))
    return np.array(rows)


def theory(places, angle, speeds, arrivals):
    """(jet, slug, share) of parts of a straight liner. places: (x, y) of the parts [m]; angle of the liner with the axis; V0 of each [m/s];
    times at which the front is there [s]. b follows from the neighbours: at the time at which a part is on the axis, they are where their
    own flight has brought them."""
    along = np.hypot(*(places - places[0]).T)
    turned = np.arcsin(speeds * np.gradient(arrivals, along) / 2.0)
    towards, forwards = speeds * np.cos(angle + turned), speeds * np.sin(angle + turned)
    meet = arrivals + places[:, 0] / towards
    # At a fixed time: x = x0 - towards (t - T), y = y0 + forwards (t - T).
    flown = meet - arrivals
    across = np.gradient(places[:, 0], along) - np.gradient(towards, along) * flown + towards * np.gradient(arrivals, along)
    lengthwise = np.gradient(places[:, 1], along) + np.gradient(forwards, along) * flown - forwards * np.gradient(arrivals, along)
    half = 0.5 * np.arctan2(across, lengthwise)
    left = angle + turned - half
    return np.stack([speeds * np.cos(left) / np.sin(half), speeds * np.sin(left) / np.cos(half), np.sin(half) ** 2], axis=1)
