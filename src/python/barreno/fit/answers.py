# SPDX-License-Identifier: BSD-3-Clause
"""What the rock of a card answers in the tests."""

import numpy

from barreno.fit.kinds import KINDS
from barreno.fit.specimens import Specimens, press
from barreno.materials import ELASTIC

LARGEST_STEP = 2e-3  # of strain
PRESS_STEPS, CONFINE_STEPS = 16, 8
STRENGTH_STEPS = 40  # short ones first: weak rock fails early, confined rock hardens for long
TENSILE_STRAIN, TENSILE_STEPS = 3e-3, 40
SEARCH = 48  # specimens of each round of a search for yield
YIELD_STRAIN = (1e-6, 0.3)


class Program:
    """Increments of all curves, one column for each, and where their rows end."""

    def __init__(self, curves):
        self.curves = curves
        self.free = numpy.array([test.kind == "triaxial" for test in curves])
        self.confinement = numpy.array([test.confinement if test.kind == "triaxial" else 0.0 for test in curves])
        # Of the axial increment; where free, a first guess (a Poisson's ratio of 0.2).
        self.ratio = numpy.array([{"hydrostatic": 1.0, "triaxial": -0.2}.get(test.kind, 0.0) for test in curves])
        parts = [self.increments_of(test) for test in curves]
        length = max(len(p) for p, _ in parts)
        self.axial = numpy.zeros((length, len(curves)))
        self.ends = [ends for _, ends in parts]
        for i, (increments, _) in enumerate(parts):
            self.axial[: len(increments), i] = increments

    @staticmethod
    def increments_of(test):
        strain = test.columns[KINDS[test.kind].control] / (3.0 if test.kind == "hydrostatic" else 1.0)
        increments, ends = [], []
        for step in numpy.diff(strain, prepend=0.0):
            count = max(1, int(numpy.ceil(abs(step) / LARGEST_STEP)))
            increments += [step / count] * count
            ends.append(len(increments) - 1)
        return increments, ends


def curve_answers(rock, program):
    """For each curve its channels at its rows."""
    specimens = Specimens(rock, len(program.curves))
    if program.confinement.any():
        press(specimens, program.confinement, CONFINE_STEPS)
    confined = specimens.axial, specimens.radial
    held = numpy.where(program.free, program.confinement, numpy.nan) + numpy.zeros_like(program.axial)
    course = specimens.follow(program.axial, program.ratio * program.axial, radial_stress=held)
    steps = {name: getattr(course, name) for name in ("pressure", "axial_stress", "radial_stress", "differential_stress")}
    steps["radial_strain"] = course.radial - confined[1]
    steps["volume_strain"] = course.axial - confined[0] + 2.0 * steps["radial_strain"]
    return [{name: steps[name][program.ends[i], i] for name in test.channels} for i, test in enumerate(program.curves)]


def pressed(rock, test):
    specimens = Specimens(rock, test.rows)
    press(specimens, test.columns["pressure"], PRESS_STEPS)
    return specimens


def moduli(rock, test):
    """Bulk modulus and Poisson's ratio of unloading."""
    specimens = pressed(rock, test)
    zero = numpy.zeros(test.rows)
    stiffness = specimens.tried(zero, zero, ELASTIC).tangent
    bulk = stiffness[:, :3, :3].sum(axis=(1, 2)) / 9.0
    shear = stiffness[:, 3, 3]
    return {"bulk_modulus": bulk, "poissons_ratio": (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))}


def open_pores(rock, test):
    return {"open_pores": 1.0 + pressed(rock, test).of_state("plastic_volume_strain") / rock.card["p3_crush_curve"]}


def last_elastic(specimens, increments, low, high, wanted):
    """The largest multiple of increments of strain (axial, radial) that stays elastic, to 1e-6 of itself, and there the wanted value.
    Each round tries SEARCH multiples of every specimen."""
    count = len(specimens.axial)
    low, high = numpy.full(count, low), numpy.full(count, high)
    value = numpy.zeros(count)
    for _ in range(4):
        parts = numpy.linspace(0.0, 1.0, SEARCH)
        multiples = low[:, None] * (high / low)[:, None] ** parts
        many = specimens.repeated(SEARCH)
        many.strain_by(multiples.ravel() * increments[0], multiples.ravel() * increments[1])
        yields = (many.of_state("equivalent_plastic_strain") > 0.0) | (many.of_state("plastic_volume_strain") != 0.0)
        yields = yields.reshape(count, SEARCH)
        yields[:, -1] = True
        last = numpy.maximum(numpy.argmax(yields, axis=1) - 1, 0)
        rows = numpy.arange(count)
        value = numpy.where(yields[:, 0], 0.0, wanted(many).reshape(count, SEARCH)[rows, last])
        low, high = multiples[rows, last], multiples[rows, last + 1]
    return value


def crush_pressure(rock, test):
    value = last_elastic(Specimens(rock, 1), (1.0 / 3.0, 1.0 / 3.0), *YIELD_STRAIN, lambda s: s.pressure)
    return {"crush_pressure": numpy.full(test.rows, value[0])}


def compaction_onset(rock, test):
    specimens = Specimens(rock, test.rows)
    press(specimens, test.columns["mean_stress"], PRESS_STEPS)
    shear = last_elastic(specimens, (1.0, -0.5), *YIELD_STRAIN, lambda s: s.axial_stress - s.radial_stress)
    crushed = specimens.of_state("plastic_volume_strain") != 0.0
    return {"differential_stress": numpy.where(crushed, 0.0, shear)}


def triaxial_strength(rock, test):
    confinement = test.columns["confinement"]
    specimens = Specimens(rock, test.rows)
    press(specimens, confinement, PRESS_STEPS)
    steps = numpy.diff(test.strain_limit * numpy.linspace(0.0, 1.0, STRENGTH_STEPS + 1) ** 2)
    axial = numpy.repeat(steps[:, None], test.rows, axis=1)
    course = specimens.follow(axial, -0.2 * axial, radial_stress=confinement + numpy.zeros_like(axial))
    return {"differential_stress": course.differential_stress.max(axis=0)}


def tensile_strength(rock, test):
    axial = numpy.full((TENSILE_STEPS, 1), -TENSILE_STRAIN / TENSILE_STEPS)
    course = Specimens(rock, 1).follow(axial, -0.2 * axial, radial_stress=numpy.zeros_like(axial))
    return {"tensile_strength": numpy.full(test.rows, max(0.0, -course.axial_stress.min()))}


TABLES = {
    "bulk modulus": moduli,
    "poisson's ratio": moduli,
    "crush pressure": crush_pressure,
    "open pores": open_pores,
    "triaxial strength": triaxial_strength,
    "tensile strength": tensile_strength,
    "compaction onset": compaction_onset,
}


class Laboratory:
    """Tests that are made of one card after the other."""

    def __init__(self, tests):
        self.tests = tests
        curves = [test for test in tests if KINDS[test.kind].curve]
        self.program = Program(curves) if curves else None

    def answers(self, rock):
        """For each test its channels at its rows; Rejected where the rock cannot be tested so."""
        curves = iter(curve_answers(rock, self.program) if self.program else [])
        return [next(curves) if KINDS[test.kind].curve else TABLES[test.kind](rock, test) for test in self.tests]
