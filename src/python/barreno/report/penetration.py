# SPDX-License-Identifier: BSD-3-Clause
"""Depth of the jet, the rate at which it grows, and what the jet has left."""

import numpy as np

from barreno.report.hole import jet_particles
from barreno.report.particles import areas_of

MILLI, MICRO = 1e-3, 1e-6
WINDOW = 0.05  # of the run: over which the rate is a mean
LEAST_ROWS = 5  # in a window
STOPPED = 0.02  # of the fastest slug's speed: slower jet material has stopped


def window_of(time):
    """Length of the window of the rate [s]."""
    span = float(time[-1] - time[0])
    return max(WINDOW * span, LEAST_ROWS * span / max(len(time) - 1, 1))


def smooth_rate(time, depth, window):
    """Slope of the line of least squares through the rows within half a window of each row: jet material in pieces gets to the bottom
    in blows, and the speed of the deepest piece says nothing of the hole."""
    half = 0.5 * window * (1.0 + 1e-9)  # a row at the very end of a window is in it, whatever the round-off
    first, last = np.searchsorted(time, time - half), np.searchsorted(time, time + half)
    scale = time[-1] - time[0] or 1.0
    sums = lambda values: (lambda total: total[last] - total[first])(np.concatenate([[0.0], np.cumsum(values)]))  # noqa: E731
    t = (time - time[0]) / scale
    n, st, sd, stt, std = sums(np.ones_like(t)), sums(t), sums(depth), sums(t * t), sums(t * depth)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = (n * std - st * sd) / (n * stt - st * st)
    return np.where(last - first > 1, slope, np.nan) / scale


def depth_and_rate(table):
    """(time, depth, rate, window) from the hit on; rows before it have no rate."""
    hit = np.flatnonzero(table["depth"] > 0.0)
    if len(hit) < LEAST_ROWS:
        return np.empty(0), np.empty(0), np.empty(0), 0.0
    time, depth = table["time"][hit[0] :], table["depth"][hit[0] :]
    window = window_of(time)
    return time, depth, smooth_rate(time, depth, window), window


def volumes_of(frame, deck):
    """Volume of every particle of a frame, of its shape: rings, hexahedra, or slabs one metre thick [m3]."""
    corners = frame.corners
    if corners.shape[1] == 8:
        edges = [corners[:, corner] - corners[:, 0] for corner in (1, 3, 4)]
        return np.abs(np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2]))
    shapes = corners if corners.shape[1] == 4 else frame.squares()
    around = 2.0 * np.pi * np.abs(shapes[:, :, 0].mean(axis=1)) if deck.mode == "axisymmetric" else 1.0
    return areas_of(shapes) * around


def jet_shares(file, deck, rate_at):
    """[(time, spent, stopped)] of the mass of jet material launched by then, at every time of the file: spent is slower along its flight
    than the hole grows, so it never gets to the bottom, and stopped hardly moves.

    A particle's mass is density times volume when the file first has it, still hardly deformed.
    """
    slugs = deck.slugs()
    if not len(slugs):
        return []
    mass = np.full(file.elements, np.nan)
    fastest, shares = float(slugs[:, 1].max()), []
    for step in range(len(file.times)):
        frame = file.frame(step)
        jet = np.flatnonzero(frame.alive)[jet_particles(frame, deck)]
        new = jet[np.isnan(mass[jet])]
        if len(new):
            whole = np.full(file.elements, np.nan)
            whole[frame.alive] = volumes_of(frame, deck)
            mass[new] = (frame.variable("density") * whole)[new]
        speed = deck.direction * frame.variable("velocity_y")[jet]
        total = float(mass[jet].sum())
        if total > 0.0:
            slow = lambda limit: float(mass[jet][speed < limit].sum()) / total  # noqa: B023, E731
            shares.append((frame.time, slow(max(rate_at(frame.time), STOPPED * fastest)), slow(STOPPED * fastest)))
    return shares


def launched_share(deck, time):
    """Share of the jet's mass that has been launched by a time, of its table."""
    slugs = deck.slugs()
    masses = slugs[:, 2] ** 2 * slugs[:, 3] * slugs[:, 4]
    return float(masses[slugs[:, 0] <= time].sum() / masses.sum()) if len(slugs) and masses.sum() > 0.0 else float("nan")
