# SPDX-License-Identifier: BSD-3-Clause
"""Jet and rubble, which a picture tells from the bodies: particles of the jet, and loose pieces of the target in the hole."""

import dataclasses

import numpy as np

from barreno.report.hole import jet_particles, target_particles

CARRIED = ("speed", "velocity_", "temperature", "density", "cell_size", "step_length")  # fields that are looked at in the jet itself
WITHIN = 0.25  # cells inside the wall of the hole: rock at the wall, and what its particles reach over it, is no rubble


@dataclasses.dataclass
class Pieces:
    """Whether each shape of a frame is a piece of the jet, or rubble."""

    jet: np.ndarray
    rubble: np.ndarray

    @property
    def apart(self):
        return self.jet | self.rubble


def loose_within(hole):
    """(depth, radius) of the open rows: a piece of the target with its centre inside is loose."""
    rows = hole.open_rows
    return hole.depth[:rows], np.where(np.isfinite(hole.radius[:rows]), hole.radius[:rows], 0.0) - WITHIN * hole.cell


def rubble_in(shapes, target, deck, hole):
    """Shapes of the target whose centre lies inside the wall of the hole."""
    if hole.open_rows == 0:
        return np.zeros(len(shapes), bool)
    centre = shapes.mean(axis=1)
    depth = deck.direction * (centre[:, 1] - hole.face)
    return target & (np.abs(centre[:, 0]) < np.interp(depth, *loose_within(hole), left=0.0, right=0.0))


def pieces_of(frame, deck, hole=None):
    """Of the particles in the picture; without a hole there is no rubble, and only a launched jet is told apart."""
    shapes, of = frame.shapes
    none = np.zeros(len(of), bool)
    jet = jet_particles(frame, deck)[of] if deck.has_jet else none
    return Pieces(jet, none if hole is None else rubble_in(shapes, target_particles(frame, deck)[of], deck, hole))


def carried(field):
    """Whether jet and rubble have the colours of a field too."""
    return field.startswith(CARRIED)
