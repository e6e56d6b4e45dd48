# SPDX-License-Identifier: BSD-3-Clause
"""Specimens in a laboratory: points of the library under axial strain and radial strain or stress, all at once."""

import contextlib
import os
import tempfile

import numpy
from barreno_material import CONSISTENT, STRESS, Material

from barreno_fit.card import text_of
from barreno_fit.faults import Rejected

EXACT = 1e-7  # of the stress
ENOUGH = 1e-4  # where Newton's method stalls at a jump of the update
MOST_STEPS = 60


@contextlib.contextmanager
def opened(card, library):
    """The material of a card; Rejected if the library refuses it."""
    handle, name = tempfile.mkstemp(suffix=".xml", prefix="barreno-fit-")
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

    def take(self, answer, axial, radial):
        if answer.status.any():
            raise Rejected("the stress update fails")
        self.stress, self.state = answer.stress, answer.state
        self.axial, self.radial = self.axial + axial, self.radial + radial

    def strain_by(self, axial, radial):
        self.take(self.tried(axial, radial), axial, radial)

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


def scale_of(answer):
    return numpy.maximum(numpy.abs(answer.stress).max(axis=1), 1e5)


def newton(measure, start, target, free):
    """Increments of strain that give the targets, where free; elsewhere they stay. Newton's method for each specimen by itself, shortened
    while a miss grows.

    @param measure  increments -> answer, what is controlled, its slope
    """
    weight = free.astype(float)  # no miss where nothing is free
    x = start
    answer, value, slope = measure(x)
    miss = weight * (value - target)
    size, scale = numpy.abs(miss), scale_of(answer)
    for _ in range(MOST_STEPS):
        enough = EXACT * scale
        if not (size > enough).any():
            break
        step = -miss / numpy.where(slope > 0.0, slope, numpy.inf)
        bound = numpy.maximum(size, enough)  # what is small already may grow within what is enough
        for _ in range(8):
            tried = measure(x + step)
            left = weight * (tried[1] - target)
            grown = numpy.abs(left)
            worse = grown > bound
            if not worse.any():
                break
            step = numpy.where(worse, 0.5 * step, step)
        x = x + step
        (answer, _, slope), miss, size = tried, left, grown
        scale = scale_of(answer)
    if answer.status.any() or not (size <= ENOUGH * scale).all():
        raise Rejected("no strain gives the stress that is asked for")
    return answer, x


def press(specimens, pressure, steps):
    """Hydrostatic loading to a pressure of each specimen, by isotropic strain."""
    begin = specimens.pressure
    last = numpy.zeros(len(begin))

    def measure(x):
        answer = specimens.tried(x, x, CONSISTENT)
        return answer, pressure_of(answer.stress), answer.tangent[:, :3, :3].sum(axis=(1, 2)) / 3.0

    for k in range(1, steps + 1):
        answer, last = newton(measure, last, begin + (pressure - begin) * k / steps, numpy.full(len(begin), True))
        specimens.take(answer, last, last)


def compress(specimens, axial, radial, confinement, free):
    """An increment of axial strain; where free, the radial strain is what keeps the confinement.

    @param radial  increments, the first guess where free
    @return the radial increments
    """

    def measure(x):
        answer = specimens.tried(axial, x, CONSISTENT)
        value = -0.5 * (answer.stress[:, 1] + answer.stress[:, 2])
        return answer, value, answer.tangent[:, 1, 1] + answer.tangent[:, 1, 2]

    if not free.any():
        specimens.strain_by(axial, radial)
        return radial
    answer, radial = newton(measure, radial, confinement, free)
    specimens.take(answer, axial, radial)
    return radial
