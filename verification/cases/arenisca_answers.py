# SPDX-License-Identifier: BSD-3-Clause
"""Paths and exact answers of the published benchmarks of Arenisca, in the unit of each benchmark.

A path function gives rows (time, F) and the instants at which an answer is known; an answer is an array (instant,
quantity). Tables that are no closed form are arenisca_published.json's, event-driven integrations.
"""
import json
import math
import pathlib

import numpy as np
from scipy.special import lambertw

from oracles.arenisca_paths import BENCHMARKS, benchmark, hydrostatic as oracle_hydrostatic

ORACLES = pathlib.Path(__file__).resolve().parents[1] / "oracles"
PUBLISHED = json.loads((ORACLES / "arenisca_published.json").read_text())
BENCH, HYDRO = PUBLISHED["bench"], PUBLISHED["hydro"]

STRESSES = {"PEAKI1", "STREN", "B0", "B1", "B2", "B3", "G0", "p0_crush_curve", "fluid_B0", "fluid_pressure_initial",
            "Matrix bulk modulus"}


def card(number, unit):
    """Parameters of a benchmark in Pa."""
    parameters = {"p3_crush_curve": 0.0, "FSLOPE": 0.0, "PEAKI1": 0.0, **BENCHMARKS["T" + number]}
    factor = {name: unit for name in STRESSES} | {"p1_crush_curve": 1.0 / unit}
    numbers = {name: repr(value * factor.get(name, 1.0)) for name, value in parameters.items()}
    return {**numbers, "Backstress strain": "elastic centre"} if "fluid_B0" in parameters else numbers


# ------------------------------------------------------------------------------------------ what is compared
def axes(at):
    return np.stack([at["stress_xx"], at["stress_yy"]], axis=1)


def in_plane(at):
    return np.stack([at[f"stress_{c}"] for c in ("xx", "yy", "xy", "zz")], axis=1)


def principal(at):
    return np.stack([at[f"stress_{c}"] for c in ("xx", "yy", "zz")], axis=1)


def deviator(at):
    s = principal(at)
    return s - s.mean(axis=1, keepdims=True)


def hydrostat(at):
    return np.stack([principal(at).sum(axis=1), at["plastic_volume_strain"]], axis=1)


def cap_view(at):
    root_j2 = np.sqrt(0.5 * (deviator(at) ** 2).sum(axis=1))
    return np.stack([*axes(at).T, *hydrostat(at)[:, :1].T, root_j2, at["plastic_volume_strain"]], axis=1)


# ------------------------------------------------------------------------------------------------------ paths
def straight(times, strains):
    """Rows of F = diag exp(strain), the start included; the instants are the times."""
    rows = [(0.0, np.eye(3))] + [(float(t), np.diag(np.exp(e))) for t, e in zip(times, strains)]
    return rows, [float(t) for t in times]


def axial(times, strains):
    return straight(times, [(e, 0.0, 0.0) for e in strains])


def all_round(strains):
    return straight(np.arange(1.0, len(strains) + 1), [np.full(3, v / 3.0) for v in strains])


# 01: F = R U, a turn about z while U11 goes to 0.998
def turning_path(refinement):
    count = 400 * refinement
    rows = []
    for i in range(count + 1):
        t, a = i / count, 2.0 * math.pi * i / count
        turn = np.array([[math.cos(a), -math.sin(a), 0.0], [math.sin(a), math.cos(a), 0.0], [0.0, 0.0, 1.0]])
        rows.append((t, turn @ np.diag([1.0 - 0.002 * t, 1.0, 1.0])))
    return rows, [0.125, 0.25, 0.375, 0.5, 0.75, 1.0]


def turning():
    p = BENCHMARKS["T01"]
    rows = []
    for t in turning_path(1)[1]:
        lateral = (p["B0"] - 2.0 / 3.0 * p["G0"]) * math.log(1.0 - 0.002 * t)
        more = 2.0 * p["G0"] * math.log(1.0 - 0.002 * t)  # s_axial - s_lateral
        c, s = math.cos(2.0 * math.pi * t), math.sin(2.0 * math.pi * t)
        rows.append([lateral + more * c * c, lateral + more * s * s, more * s * c, lateral])
    return np.array(rows)


# 02: the vertex and the limit line, plane of two stresses; beta^2 = 1/2
def vertex_path(_):
    legs = np.array(BENCH["T02"]["waypoints_t_ea_el"])[1:]
    return straight(legs[:, 0], [(a, b, b) for _, a, b in legs])


def vertex():
    r = math.sqrt(6.0)
    flow = (-50.0 / 3.0 * (9.0 + 4.0 * r), 50.0 / 3.0 * (2.0 * r - 9.0))
    return np.array([
        (-850.0 / 3.0, -850.0 / 3.0), flow, flow,
        (50.0 / 3.0 * (2.0 * r - 3.0), -50.0 / 3.0 * (3.0 + r)),
        (160.0 * math.sqrt(2.0 / 3.0) - 110.0, -10.0 / 3.0 * (33.0 + 8.0 * r)),
        (30.0 + 20.0 * r / 3.0, 30.0 - 10.0 * r / 3.0),
        (50.0, 50.0), (-50.0 / 3.0 * (3.0 + 2.0 * r), 50.0 / 3.0 * (r - 3.0)), flow])  # fmt: skip


# 03, 11: uniaxial strain of a von Mises solid; points are (strain, axial, lateral, ...)
def uniaxial_path(name):
    strains = [point[0] for point in BENCH[name]["points"]]
    return lambda _: axial(range(1, len(strains) + 1), strains)


def uniaxial(name):
    """s_axial - s_lateral = q follows the strain at slope 2G within +-Y, the mean stress is K strain."""
    p = BENCHMARKS[name]
    limit = math.sqrt(3.0) * p["STREN"]

    def answer():
        q, before, rows = 0.0, 0.0, []
        for strain in (point[0] for point in BENCH[name]["points"]):
            q = min(max(q + 2.0 * p["G0"] * (strain - before), -limit), limit)
            before = strain
            rows.append((p["B0"] * strain + 2.0 * q / 3.0, p["B0"] * strain - q / 3.0))
        return np.array(rows)

    return answer


# 04, 06: cap and shear together; columns t, strain, axial, lateral, I1, sqrt J2, plastic volume strain, X
def cap_path(name):
    table = np.array(BENCH[name]["rows"])
    return lambda _: axial(table[:, 0], table[:, 1])


def cap(name):
    return lambda: np.array(BENCH[name]["rows"])[:, 2:7]


# 05: a cap that does not move; hydrostatic
def fixed_cap_path(_):
    return all_round([-0.03, -0.0612, 3.0 * math.log(0.93)])


def fixed_cap():
    p = BENCHMARKS["T05"]
    rows = []
    for v in (-0.03, -0.0612, 3.0 * math.log(0.93)):
        i1 = max(3.0 * p["B0"] * v, p["p0_crush_curve"])
        rows.append((i1, v - i1 / (3.0 * p["B0"])))
    return np.array(rows)


# 07: I1 = p0 + (A - W(3 K p1 p3 e^A))/p1, A = 3 K p1 (v + p3 - p0/3K); porosity by the crush curve
def crush_strains():
    return [row[0] for row in HYDRO["T07"]]


def crush_path(_):
    return all_round(crush_strains())


def crush_view(at):
    p3 = BENCHMARKS["T07"]["p3_crush_curve"]
    i1, plastic = hydrostat(at).T
    return np.stack([i1, -np.expm1(-(p3 + plastic))], axis=1)


def crush():
    p = BENCHMARKS["T07"]
    k, p0, p1, p3 = p["B0"], p["p0_crush_curve"], p["p1_crush_curve"], p["p3_crush_curve"]
    rows = []
    for v in crush_strains():
        a = 3.0 * k * p1 * (v + p3 - p0 / (3.0 * k))
        i1 = p0 + (a - lambertw(3.0 * k * p1 * p3 * math.exp(a)).real) / p1
        rows.append((i1, -math.expm1(-p3 * math.exp(p1 * (i1 - p0)))))
    return np.array(rows)


# 08, 09, 12: hydrostatic loops; rows are volume strain, I1, plastic volume strain, ...
def hydrostatic_path(name):
    return lambda _: all_round([row[0] for row in HYDRO[name]])


def hydrostatic(name):
    return lambda: np.array([row[1:3] for row in HYDRO[name]], float)


def saturated():
    """No closed form for the elastic-centre form: the oracle. The path crosses jumps of the moduli (closing of the gas gap,
    end of dilation), where its steps fall on one side or the other: it wanders by 1e-4 of the scale (largest I1 -19304.7,
    -19307.5, -19306.9, -19306.9 MPa with 800, 1600, 2400, 3200 substeps), without an order to extrapolate."""
    model = benchmark("T09", **{"Moduli when dilated": "B0"})
    strains = [row[0] for row in HYDRO["T08"]]
    return np.array([(s.stress[:3].sum(), s.e) for s in oracle_hydrostatic(model, strains, 1600)])


def loops_rows():
    return [HYDRO["T12"][-1]] + HYDRO["T12"][:-1]


def loops_path(_):
    return all_round([row[0] for row in loops_rows()])


def loops():
    return np.array([row[1:3] for row in loops_rows()], float)


# 10: von Mises, two isochoric legs; the second turns the stress
def corner_fractions():
    return [0.25, 0.5, 0.75, 1.0]


def corner_legs():
    return (np.array(BENCH["T10"][f"strain_end_leg{i}"]) for i in (1, 2))


def corner_path(_):
    first, second = corner_legs()
    strains = [f * first for f in corner_fractions()] + [first + f * (second - first) for f in corner_fractions()]
    return straight(np.arange(1.0, 9.0), strains)


def corner():
    """tan(psi/2) = tan(psi0/2) exp(-2G |e| / R), psi the angle of stress and rate (Krieg and Krieg 1977), R = sqrt(2)
    times the strength."""
    p = BENCHMARKS["T10"]
    first, second = (leg - leg.mean() for leg in corner_legs())
    radius = math.sqrt(2.0) * p["STREN"]
    begin = radius * first / np.linalg.norm(first)
    rows = [begin] * 4  # yields in the first hundredth of the leg
    leg = second - first
    along = leg / np.linalg.norm(leg)
    across = begin - (begin @ along) * along
    across /= np.linalg.norm(across)
    start = math.acos(begin @ along / radius)
    for f in corner_fractions():
        tangent = math.tan(start / 2.0) * math.exp(-2.0 * p["G0"] * f * np.linalg.norm(leg) / radius)
        angle = 2.0 * math.atan(tangent)
        rows.append(radius * (math.cos(angle) * along + math.sin(angle) * across))
    return np.array(rows)


# 13: F linear in time, 1 -> 1.01 (2 s) -> 0.99 (3 s) -> 1 (4 s)
def rate_path(refinement):
    times = np.linspace(0.0, 4.0, 400 * refinement + 1)
    stretch = np.interp(times, [0.0, 2.0, 3.0, 4.0], [1.0, 1.01, 0.99, 1.0])
    rows = [(float(t), np.diag([f, 1.0, 1.0])) for t, f in zip(times, stretch)]
    return rows, [row[0] for row in BENCH["T13"]["rows"]]


def rate():
    return np.array([row[4:6] for row in BENCH["T13"]["rows"]])
