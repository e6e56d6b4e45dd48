# SPDX-License-Identifier: BSD-3-Clause
"""Rocks near the start of a fit, their tests in a laboratory, and the files with noise that the fit reads."""

import numpy

from barreno.fit import card as cards
from barreno.fit.data import Test

START = "berea_sandstone"
MEGA = 1e6
CARDS = 8
SHORT_CARD = 7  # whose tests end early, so that they leave parameters open
NOISES = (0.005, 0.01, 0.015, 0.02, 0.03)
LONG = ((0.0, 0.012), (0.15, 0.025), (0.6, 0.06))  # confinement over the crush pressure, last axial strain
SHORT = ((0.0, 0.012), (0.02, 0.015), (0.05, 0.02))
LOG, FACTOR = ("PEAKI1", "FSLOPE", "STREN", "B0", "B1", "B2", "p0_crush_curve", "p1_crush_curve"), 1.5
# compression is positive, logarithmic strain, unit of stress, its size, separator, decimal comma
FORMATS = (
    (True, False, "MPa", 1e6, ",", False), (False, False, "psi", 6894.757293168361, ",", False), (True, True, "Pa", 1.0, ",", False),
    (True, False, "kPa", 1e3, ";", True), (False, True, "GPa", 1e9, "\t", False),
)  # fmt: skip


def truth_of(number):
    """A rock near the start: each of its strengths and stiffnesses within a factor of 1.5 of it, drawn once for each number."""
    random, start = numpy.random.default_rng(1000 + number), cards.read(START)
    card = {name: start[name] * FACTOR ** random.uniform(-1.0, 1.0) for name in LOG}
    card.update(CR=random.uniform(0.3, 0.8), BETA_nonassociativity=random.uniform(0.3, 0.9), G1=random.uniform(0.15, 0.3),
        G2=random.uniform(-0.05, 0.05))
    card["YSLOPE"] = random.uniform(0.02, 0.3) * card["FSLOPE"]
    card["STREN"] = max(card["STREN"], 3.0 * card["YSLOPE"] * card["PEAKI1"])
    return {**start, **card, "G0": 1.5 * card["B0"] * (1.0 - 2.0 * card["G1"]) / (1.0 + card["G1"])}


def bare_test(name, kind, control, values, channels, side):
    columns = {control: values, **{channel: numpy.zeros(len(values)) for channel in channels}}
    return Test(name, kind, "", "", columns, [""] * len(values), numpy.full(len(values), 0.02), side)


def laboratory_of(card, short=False):
    """Pressed to 70 % of the pore strain with a loop of unloading; triaxial at 0, 15 and 60 % of the crush pressure.

    @param short  pressed to a tenth of the pore strain, and confined at 0, 2 and 5 %: nothing is crushed under pressure alone
    """
    crush = -card["p0_crush_curve"] / 3.0
    top = (0.1 if short else 0.7) * card["p3_crush_curve"]
    line = numpy.linspace
    strain = numpy.concatenate([line(0, 0.4 * top, 20), line(0.4 * top, 0.33 * top, 5)[1:], line(0.33 * top, top, 20)[1:]])
    tests = [bare_test("hydrostatic", "hydrostatic", "volume_strain", strain, ["pressure"], 0.0)]
    for part, last in SHORT if short else LONG:
        side = round(min(part * crush, 250 * MEGA), -5)
        tests.append(bare_test(f"triaxial_{part:g}", "triaxial", "axial_strain", line(0, last, 25),
            ["differential_stress", "volume_strain"], side))
    return tests


def column_text(values, comma):
    return [f"{value:.9g}".replace(".", ",") if comma else f"{value:.9g}" for value in values]


def write_test(folder, test, answer, card, noises, form, random):
    """@param noises  {channel: standard deviation over the largest value}"""
    positive, logarithmic, unit, size, separator, comma = form
    sign = 1.0 if positive else -1.0
    lines = [f"# kind: {test.kind}", f"# compression: {'positive' if positive else 'negative'}",
        f"# confinement: {test.confinement / MEGA:.9g} MPa"]
    lines += ["# strain: logarithmic"] if logarithmic else []
    lines += [f"# porosity: {100 * -numpy.expm1(-card['p3_crush_curve']):.12g} %"] if test.kind == "hydrostatic" else []
    names, columns = [], []
    for name, values in {**test.columns, **answer}.items():
        if name in answer:
            values = values + noises[name] * numpy.abs(values).max() * random.standard_normal(len(values))
        is_strain = name.endswith("strain")
        values = (values if logarithmic else -numpy.expm1(-values)) * 100.0 if is_strain else values / size
        names.append(f"{name} [{'%' if is_strain else unit}]")
        columns.append(column_text(sign * values + 0.0, comma))
    file = folder / f"{test.file}.csv"
    file.write_text("\n".join([*lines, separator.join(names), *map(separator.join, zip(*columns))]) + "\n")
    return str(file)


def noises_of(number):
    """Standard deviation over the largest value, of a set's stresses and of its strains: mostly unlike."""
    stress, strain = NOISES[number // CARDS % len(NOISES)], NOISES[(number // CARDS + 2 * number) % len(NOISES)]
    return {"pressure": stress, "differential_stress": stress, "volume_strain": strain}
