# SPDX-License-Identifier: BSD-3-Clause
"""Paths for one material point: prescribed strain, prescribed stress, mixtures, and the 13 published benchmarks.

Path file: CSV, '#' starts a comment. Header: `time`, one column for each of xx yy zz xy yz zx, named e.. where the
logarithmic strain and s.. where the stress [Pa] is prescribed (for example time,exx,syy,szz,exy,eyz,ezx; a column
that is left out is zero strain), and optionally `substeps` (default 100). Each row is a point of a polygon, reached
linearly in time. A column 'e' whose field is empty keeps its value; a row must have the header's meaning throughout.
The first row may be at time 0, otherwise the path starts at zero strain and the initial stress.
"""
import csv
import math
import sys

import numpy as np
from barreno.runs.csv_table import WORDS, read_csv

from oracles.arenisca_model import Arenisca, as_six, invariants, lode_angle, UNIT

NAMES = ("xx", "yy", "zz", "xy", "yz", "zx")


def record(model, s, time):
    """One row of output: everything another implementation can be compared with. SI."""
    i1, dev, rho = invariants(s.stress)
    k, g = model.moduli(s)
    row = {"time": time}
    row.update({f"e{n}": v for n, v in zip(NAMES, s.strain)})
    row.update({f"s{n}": v for n, v in zip(NAMES, s.dynamic)})
    row.update({f"q{n}": v for n, v in zip(NAMES, s.stress)})  # quasi-static
    row.update({f"p{n}": v for n, v in zip(NAMES, s.plastic)})
    row.update(I1=i1, sqrtJ2=rho, theta=lode_angle(dev, rho), evp=s.evp, ec=s.e, zeta=model.zeta(s), X=model.cap(s),
               pore_pressure=model.pore_pressure(s), porosity=model.porosity(s), fluid_mass_ratio=s.mu, K=k, G=g,
               yield_value=model.yield_value(s), dissipation=s.dissipation)  # fmt: skip
    return row


def strain_path(model, points, substeps, state=None):
    """States at each (strain, time) of a polygon in strain; strain 3, 6 or 3x3, from the state's strain."""
    s, states, clock = state or model.initial(), [], 0.0
    for target, time in points:
        target = np.asarray(target, float)
        target = np.append(target, np.zeros(3)) if target.shape == (3,) else as_six(target)
        s = model.advance(s, target - s.strain, time - clock, substeps)
        clock = time
        states.append(s)
    return states


def hydrostatic(model, volume_strains, substeps, state=None):
    """States at a list of volume strains."""
    points = [(np.full(3, v / 3), k + 1.0) for k, v in enumerate(volume_strains)]
    return strain_path(model, points, substeps, state)


def uniaxial(model, strains, substeps):
    """States at a list of axial strains (xx), lateral strain zero."""
    return strain_path(model, [((e, 0, 0), k + 1.0) for k, e in enumerate(strains)], substeps)


def stretch_path(model, legs, samples, pieces):
    """States at sample times; stretches linear in time between the legs' (time, (F1, F2, F3)).

    The unrotated rate F'/F is not constant in a leg: each piece is one substep of exact logarithmic strain.
    """
    s, states, clock = model.initial(), [], 0.0
    corners = [0.0] + [t for t, _ in legs]
    shapes = np.array([[1, 1, 1]] + [f for _, f in legs], float)
    at = lambda t: np.log([np.interp(t, corners, shapes[:, k]) for k in range(3)])
    for end in sorted(set(samples) | set(corners[1:])):
        for time in np.linspace(clock, end, pieces + 1)[1:]:
            s = model.advance(s, np.append(at(time), np.zeros(3)) - s.strain, time - clock)
            clock = time
        if end in samples:
            states.append(s)
    return states


def mixed_step(model, s, stressed, target, dt, guess, tolerance=1e-9):
    """State at prescribed strains and, where stressed, prescribed stresses; Newton with differences."""
    where = np.flatnonzero(stressed)
    scale = max(1.0, np.abs(target[where]).max() if len(where) else 1.0, np.abs(s.dynamic).max())
    k, g = model.moduli(s)
    step = np.where(stressed, guess, target - s.strain)
    for _ in range(50):
        new = model.advance(s, step, dt)
        miss = new.dynamic[where] - target[where]
        if len(where) == 0 or np.abs(miss).max() <= tolerance * scale:
            return new, step
        slope = np.empty((len(where), len(where)))
        h = 1e-4 * max(np.abs(step).max(), 1e-9)
        for column, i in enumerate(where):
            probe = step.copy()
            probe[i] += h
            slope[:, column] = (model.advance(s, probe, dt).dynamic[where] - new.dynamic[where]) / h
        change = np.linalg.solve(slope + 1e-9 * (k + g) * np.eye(len(where)), miss)
        step[where] -= change
    raise ArithmeticError("the prescribed stress is not reached: beyond the strength?")


def mixed_path(model, points, stressed, substeps, state=None):
    """States at each (six targets, time); stressed: six flags. Stress columns start at the state's stress."""
    s, states, clock = state or model.initial(), [], 0.0
    stressed = np.asarray(stressed, bool)
    for target, time in points:
        begin = np.where(stressed, s.dynamic, s.strain)
        guess = np.zeros(6)
        for k in range(substeps):
            part = begin + (np.asarray(target, float) - begin) * (k + 1) / substeps
            s, guess = mixed_step(model, s, stressed, part, (time - clock) / substeps, guess)
        clock = time
        states.append(s)
    return states


def triaxial_compression(model, pressure, axial_strains, substeps):
    """Squeeze to a hydrostatic pressure, then axial (zz) strain at constant lateral stress."""
    p = -pressure
    squeezed = mixed_path(model, [((p, p, p, 0, 0, 0), 1.0)], [1, 1, 1, 0, 0, 0], substeps)[-1]
    start = squeezed.strain[2]
    points = [((p, p, start + e, 0, 0, 0), k + 2.0) for k, e in enumerate(axial_strains)]
    return mixed_path(model, points, [1, 1, 0, 0, 0, 0], substeps, squeezed)


def read_path(path):
    """(stressed flags, [(targets, time, substeps)])."""
    rows = read_csv(path, cells=WORDS).to_dict("records")
    if not rows:
        raise ValueError(f"{path}: no points")
    header = [name.strip() for name in rows[0]]
    allowed = {"time", "substeps"} | {a + n for a in "es" for n in NAMES}
    for name in header:
        if name not in allowed:
            raise ValueError(f"{path}: unknown column {name}; known are {sorted(allowed)}")
    stressed = [f"s{n}" in header for n in NAMES]
    points, last = [], np.zeros(6)
    for row in rows:
        fields = [row.get(("s" if f else "e") + n) for n, f in zip(NAMES, stressed)]
        last = np.array([old if v in (None, "") else float(v) for v, old in zip(fields, last)])
        points.append((last, float(row["time"]), int(row.get("substeps") or 100)))
    return stressed, points


def drive_file(model, path, out):
    """Drive along a path file; one output row per substep."""
    stressed, points = read_path(path)
    s, clock, rows = model.initial(), 0.0, []
    rows.append(record(model, s, 0.0))
    for target, time, substeps in points:
        if time == clock:
            continue
        begin = np.where(stressed, s.dynamic, s.strain)
        guess = np.zeros(6)
        for k in range(substeps):
            part = begin + (target - begin) * (k + 1) / substeps
            dt = (time - clock) / substeps
            s, guess = mixed_step(model, s, np.array(stressed), part, dt, guess)
            rows.append(record(model, s, clock + (k + 1) * dt))
        clock = time
    file = sys.stdout if out == "-" else open(out, "w", newline="")
    writer = csv.DictWriter(file, list(rows[0]))
    writer.writeheader()
    for row in rows:
        writer.writerow({k: repr(float(v)) for k, v in row.items()})
    if file is not sys.stdout:
        file.close()
    return rows


# ------------------------------------------------------------------------------------------- published benchmarks
SET_A = dict(PEAKI1=612.3724356953976, FSLOPE=0.057735026919, p0_crush_curve=-1837.0724, p1_crush_curve=1 / 1500,
             p3_crush_curve=0.5, CR=0.5)  # fmt: skip
SET_08 = dict(SET_A, B0=6000.0, B1=2e4, B2=1500.0, G0=6000.0)
SET_09 = dict(SET_08, fluid_B0=3000.0, fluid_pressure_initial=300.0)
SET_12 = dict(PEAKI1=20e6, FSLOPE=0.435, B0=1.003e9, B1=14.7e9, B2=41e6, B3=1e9, B4=4e-3, G0=1e9,
              p0_crush_curve=-30e6, p1_crush_curve=5.4e-11, p3_crush_curve=0.189, CR=0.5)  # fmt: skip
STEEL = 165e6
BENCHMARKS = {
    "T01": dict(SET_A, B0=1e4, G0=1.5e4),
    "T02": dict(PEAKI1=150.0, FSLOPE=math.sqrt(2) / 6, BETA_nonassociativity=0.707107, B0=1e4, G0=3750.0),
    "T03": dict(STREN=25 * math.sqrt(2), B0=1e4, G0=3750.0),
    "T04": dict(SET_A, B0=1e4, G0=1.5e4),
    "T05": dict(SET_A, B0=1e4, G0=3750.0, p1_crush_curve=1e99),
    "T06": dict(SET_A, B0=1e4, G0=3750.0),
    "T07": dict(SET_A, B0=1e4, G0=1.5e4),
    "T08": dict(SET_08),
    "T09": dict(SET_09),
    "T10": dict(STREN=STEEL, B0=7.9e11, G0=79e9),
    "T11": dict(STREN=STEEL, B0=79e9, G0=70e9),
    "T12": dict(SET_12),
    "T13": dict(STREN=494999336.19349426 / math.sqrt(3), B0=142e9, G0=79e9, T1_rate_dependence=0.1,
                T2_rate_dependence=0.1),
}  # fmt: skip


def benchmark(name, **options):
    """Model of a published benchmark."""
    return Arenisca(dict(BENCHMARKS[name], **options))
