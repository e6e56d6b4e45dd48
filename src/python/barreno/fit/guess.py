# SPDX-License-Identifier: BSD-3-Clause
"""Where the optimiser starts: rough values that are read off the data, on a coarse grid."""

import itertools

import numpy

MARGIN = 1.02


def loading(test):
    """Strain and pressure of a hydrostatic test up to its largest pressure."""
    pressure, strain = test.columns["pressure"], test.columns["volume_strain"]
    top = int(numpy.argmax(pressure)) + 1
    return strain[:top], pressure[:top]


def first_slope(strain, stress):
    few = max(3, len(strain) // 8)
    return max(numpy.polyfit(strain[:few], stress[:few], 1)[0], 1e6)


def largest_slope(test):
    strain, pressure = test.columns["volume_strain"], test.columns["pressure"]
    wide = max(2, len(strain) // 12)
    change = strain[wide:] - strain[:-wide]
    sound = numpy.abs(change) > 1e-2 * numpy.abs(strain).max()
    slopes = (pressure[wide:] - pressure[:-wide])[sound] / change[sound]
    return slopes.max() if slopes.size else first_slope(strain, pressure)


def crushing_starts(tests, card):
    """From the hydrostatic curve that goes furthest."""
    curves = [test for test in tests if test.kind == "hydrostatic"]
    if not curves:
        pressures = [p for test in tests if test.kind == "crush pressure" for p in test.columns["crush_pressure"]]
        return [{"p0_crush_curve": -3.0 * float(numpy.mean(pressures))} if pressures else {}]
    test = max(curves, key=lambda t: t.columns["pressure"].max())
    strain, pressure = loading(test)
    top, soft = float(pressure.max()), float(first_slope(strain, pressure))
    stiff = max(largest_slope(test), MARGIN * soft)
    lost = max(test.columns["volume_strain"].max() - top / stiff, 1e-3)
    pores = [-numpy.log(1.0 - test.porosity)] if test.porosity else [p for p in (0.05, 0.1, 0.2, 0.35) if p > lost] or [MARGIN * lost]
    grid = itertools.product(
        [part * top for part in (0.25, 0.4, 0.55, 0.7, 0.85, 1.2)], [part * (stiff - soft) for part in (1.0, 2.0, 4.0)],
        [part * top for part in (0.3, 1.0, 3.0)], pores, [part / (3.0 * top) for part in (0.3, 1.0, 3.0)],
    )  # fmt: skip
    return [
        {"B0": soft, "p0_crush_curve": -3.0 * crush, "B1": B1, "B2": B2, "p3_crush_curve": p3, "p1_crush_curve": p1}
        for crush, B1, B2, p3, p1 in grid
    ]


def peaks(tests):
    """(I1, sqrt(J2)) of the strongest state of each test in triaxial compression."""
    out = []
    for test in tests:
        if test.kind == "triaxial":
            q = test.columns.get("differential_stress", test.columns.get("axial_stress", 0.0) - test.confinement).max()
            out.append((q + 3.0 * test.confinement, q / numpy.sqrt(3.0)))
        elif test.kind == "triaxial strength":
            q, side = test.columns["differential_stress"], test.columns["confinement"]
            out += list(zip(q + 3.0 * side, q / numpy.sqrt(3.0)))
    return sorted(out)


def strength_starts(tests, card):
    found = peaks(tests)
    if not found:
        return [{}]
    strongest = max(q for _, q in found)
    slope = 0.5
    if len(found) > 1:
        (x0, q0), (x1, q1) = found[0], found[1]
        slope = float(numpy.clip((q1 - q0) / max(x1 - x0, 1e3), 0.1, 1.0))
    apex = max(found[0][1] / slope - found[0][0], 0.02 * found[0][0])
    grid = itertools.product(
        [part * slope for part in (0.8, 1.2, 2.0)], [part * apex for part in (0.3, 1.0)],
        [part * strongest for part in (MARGIN, 1.5, 3.0)], (0.2, 0.5, 0.8), [card.get("YSLOPE", 0.0), 0.0],
    )  # fmt: skip
    return [
        {"FSLOPE": F, "PEAKI1": P, "STREN": max(S, 1.5 * Y * P), "CR": CR, "YSLOPE": min(Y, 0.5 * F)} for F, P, S, CR, Y in grid
    ]
