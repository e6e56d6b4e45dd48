# SPDX-License-Identifier: BSD-3-Clause
"""Specimens in a laboratory: points of the library under axial strain and radial strain or stress, all at once."""

import contextlib
import os
import tempfile

import numpy

from barreno.fit.card import text_of
from barreno.fit.faults import Rejected
from barreno.materials import STRESS, Material

MEMORY = "/dev/shm"  # a file of its own for each of thousands of cards


@contextlib.contextmanager
def opened(card, library):
    """The material of a card; Rejected if the library refuses it."""
    handle, name = tempfile.mkstemp(suffix=".xml", prefix="barreno-fit-", dir=MEMORY if os.access(MEMORY, os.W_OK) else None)
    try:
        with os.fdopen(handle, "w") as file:
            file.write(text_of(card))
        try:
            rock = Material(name, library)
        except ValueError as error:
            raise Rejected(str(error).replace(name, "the card")) from None
    finally:
        os.unlink(name)
    rock.card = card
    with rock:
        yield rock


def pressure_of(stress):
    return -(stress[:, 0] + stress[:, 1] + stress[:, 2]) / 3.0


class Specimens:
    """Stress and state of points, and their strains from the start."""

    def __init__(self, rock, count):
        self.rock = rock
        self.stress, self.state = rock.virgin(count)
        self.axial, self.radial = numpy.zeros(count), numpy.zeros(count)

    def repeated(self, times):
        """Each specimen that many times."""
        out = Specimens(self.rock, 0)
        for name in ("stress", "state", "axial", "radial"):
            setattr(out, name, numpy.repeat(getattr(self, name), times, axis=0))
        return out

    def tried(self, axial, radial, want=STRESS):
        """Answer to an increment of strain."""
        strain = numpy.zeros((len(self.axial), 6))
        strain[:, 0] = -axial
        strain[:, 1] = strain[:, 2] = -numpy.asarray(radial)
        return self.rock.update(strain, self.stress, self.state, want=want)

    def strain_by(self, axial, radial):
        answer = self.tried(axial, radial)
        if answer.status.any():
            raise Rejected("the stress update fails")
        self.stress, self.state = answer.stress, answer.state
        self.axial, self.radial = self.axial + axial, self.radial + radial

    def follow(self, axial, radial, axial_stress=None, radial_stress=None):
        """Steps of all specimens, arrays (steps, specimens): increments of strain, and the stresses that are held instead of them,
        nan where none is; an increment is then a first guess. Returns the course of it."""
        strain, wanted = numpy.zeros((*axial.shape, 6)), numpy.full((*axial.shape, 6), numpy.nan)
        strain[..., 0], strain[..., 1], strain[..., 2] = -axial, -radial, -radial
        if axial_stress is not None:
            wanted[..., 0] = -axial_stress
        if radial_stress is not None:
            wanted[..., 1] = wanted[..., 2] = -radial_stress
        found = self.rock.follow(strain, wanted, self.stress, self.state)
        if found.status.any():
            raise Rejected("no strain gives the stress that is asked for")
        course = Course(found.stress, self.axial - numpy.cumsum(found.strain[..., 0], axis=0),
            self.radial - numpy.cumsum(found.strain[..., 1], axis=0))
        self.stress, self.state, self.axial, self.radial = found.stress[-1], found.state, course.axial[-1], course.radial[-1]
        return course

    def of_state(self, name):
        return self.state[:, self.rock.state_index(name)]

    @property
    def axial_stress(self):
        return -self.stress[:, 0]

    @property
    def radial_stress(self):
        return -0.5 * (self.stress[:, 1] + self.stress[:, 2])

    @property
    def pressure(self):
        return pressure_of(self.stress)


class Course:
    """Stresses and strains from the start of specimens, after each step: arrays (steps, specimens)."""

    def __init__(self, stress, axial, radial):
        self.axial, self.radial = axial, radial
        self.axial_stress = -stress[..., 0]
        self.radial_stress = -0.5 * (stress[..., 1] + stress[..., 2])
        self.pressure = -(stress[..., 0] + stress[..., 1] + stress[..., 2]) / 3.0
        self.differential_stress = self.axial_stress - self.radial_stress


def press(specimens, pressure, steps):
    """Hydrostatic loading to a pressure of each specimen, which carries its own pressure already."""
    begin = specimens.pressure
    parts = numpy.arange(1, steps + 1)[:, None] / steps
    pressures = begin + (pressure - begin) * parts
    none = numpy.zeros_like(pressures)
    return specimens.follow(none, none, pressures, pressures)
