# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the reference implementation of Arenisca: published numbers, limits, mechanics, convergence.

Each line: what, the largest deviation found, its limit. Numbers to compare with: arenisca_published.json (closed
forms and event-driven integrations made for docs/verification; section numbers there). A path is run with n and 2n
substeps and extrapolated (first order) where its line says so.
"""
import json
import math
import pathlib
import time

import numpy as np
from scipy.integrate import quad, solve_ivp

from oracles.arenisca_checks_mechanics import mechanics
from oracles.arenisca_checks_pores import pores
from oracles.arenisca_model import Arenisca, UNIT, invariants, weibull_coherence
from oracles.arenisca_paths import BENCHMARKS, SET_08, benchmark, hydrostatic, strain_path, stretch_path, uniaxial

PUBLISHED = json.loads((pathlib.Path(__file__).parent / "arenisca_published.json").read_text())
BENCH, HYDRO = PUBLISHED["bench"], PUBLISHED["hydro"]
PLASTIC_FORM = {"Backstress strain": "plastic"}
DILATED = {"Moduli when dilated": "B0"}


def extrapolated(run, n, order=1):
    """2 R(2n) - R(n) and like combinations, and |R(2n) - R(n)|max."""
    coarse, fine = np.array(run(n), float), np.array(run(2 * n), float)
    return fine + (fine - coarse) / (2**order - 1)


def gap(got, expected, scale):
    """Largest |difference|/scale."""
    return float(np.max(np.abs(np.asarray(got, float) - np.asarray(expected, float)) / scale))


# ------------------------------------------------------------------------------------------- published benchmarks
def simple_benchmarks():
    """01, 02, 03, 05, 07, 10, 11, 13."""
    times = [r[0] for r in BENCH["T01"]["samples"]]
    states = stretch_path(benchmark("T01"), [(1.0, (0.998, 1, 1))], times, 1)
    got = [[s.stress[0] * math.cos(2 * math.pi * t) ** 2, s.stress[0] * math.sin(2 * math.pi * t) ** 2,
            s.stress[0] * math.sin(2 * math.pi * t) * math.cos(2 * math.pi * t)]
           for s, t in zip(states, times)]  # fmt: skip
    yield "01 rotation, elastic", gap(got, np.array(BENCH["T01"]["samples"])[:, 1:], 60), 1e-13

    points = [((a, b, b), t) for t, a, b in BENCH["T02"]["waypoints_t_ea_el"][1:]]
    axes = lambda states: [s.stress[:2] for s in states]
    for pieces, rows in BENCH["T02"]["path"].items():
        got = axes(strain_path(benchmark("T02"), points, int(pieces)))
        yield f"02 vertex, {pieces} substeps a leg", gap(got, np.array(rows)[1:, 1:], 300), 1e-10
    exact = np.array(BENCH["T02"]["suite_analytic"])[:, 1:]
    yield "02 vertex, closed form (beta 0.707107)", gap(got[:5], exact, 300), 5e-7
    for beta2, expected in ((1.0, (-417.10, -102.16)), (0.25, (-222.47, -38.76))):
        model = benchmark("T02", BETA_nonassociativity=math.sqrt(beta2))
        got = strain_path(model, points[:3], 10)[-1].stress[:2]
        yield f"02 vertex, beta^2 = {beta2}", gap(got, expected, 300), 3e-5

    for name, scale in (("T03", 61.0), ("T11", 2.9e8)):
        rows = np.array(BENCH[name]["points"])
        got = axes(uniaxial(benchmark(name), rows[:, 0], 7))
        yield f"{name[1:]} von Mises, uniaxial", gap(got, rows[:, 1:3], scale), 1e-12
    state = hydrostatic(benchmark("T05"), [HYDRO["T05"][0][0]], 10)[0]
    got = state.stress[:3].sum(), state.evp, benchmark("T05").cap(state)
    yield "05 fixed cap", gap(got, np.array(HYDRO["T05"][0])[[1, 2, 4]].astype(float), (1837, 0.16, 1837)), 1e-11
    states = hydrostatic(benchmark("T07"), [r[0] for r in HYDRO["T07_lambertW"]], 10)
    yield "07 crush curve, Lambert W", gap([s.stress[:3].sum() for s in states], np.array(HYDRO["T07_lambertW"])[:, 1],
                                           1837), 1e-11  # fmt: skip
    rows = np.array([r[1:3] for r in HYDRO["T07"]])
    yield "07 crush curve, ODE (its own error 3e-7)", gap([(s.stress[:3].sum(), s.evp) for s in states], rows,
                                                          (47000, 1)), 1e-8  # fmt: skip


def j2_and_rate_benchmarks():
    """10 along log strain and along stretch, 13."""
    ends = [np.array(BENCH["T10"][k]) for k in ("strain_end_leg1", "strain_end_leg2")]
    table = np.array(BENCH["T10"]["table"])
    fractions = (0.25, 0.5, 0.75, 1.0)
    points = [(ends[0] * f, f) for f in fractions] + [(ends[0] + (ends[1] - ends[0]) * f, 1 + f) for f in fractions]
    deviators = lambda states: [s.stress[:3] - s.stress[:3].mean() for s in states]
    got = extrapolated(lambda n: deviators(strain_path(benchmark("T10"), points, n)), 200)
    yield "10 turning eigenvalues, straight in log strain", gap(got, table[:, 1:], 1.9e8), 2e-5
    yield "10 end of leg 2, closed form", gap(got[-1], BENCH["T10"]["end2"], 1.9e8), 2e-5
    legs = [(1, np.exp(ends[0])), (2, np.exp(ends[1]))]
    got = extrapolated(lambda n: deviators(stretch_path(benchmark("T10"), legs, list(table[:, 0]), n)), 200)
    yield "10 the same, straight in F (differs: see report)", gap(got, table[:, 1:], 1.9e8), 3e-3
    rows = np.array(BENCH["T13"]["rows"])
    legs = [(2, (1.01, 1, 1)), (3, (0.99, 1, 1)), (4, (1, 1, 1))]
    view = lambda s: (s.dynamic[0] - s.dynamic[1], s.stress[0] - s.stress[1], s.dynamic[0], s.dynamic[1])
    run = lambda n: [view(s) for s in stretch_path(benchmark("T13"), legs, list(rows[:, 0]), n)]
    yield "13 rate dependence", gap(extrapolated(run, 100, 2), rows[:, 2:], 5e8), 3e-6


def cap_benchmarks():
    """04, 06: shear and cap together, first order."""
    for name in ("T04", "T06"):
        rows = np.array(BENCH[name]["rows"])
        view = lambda model, s: (*s.stress[:2], *invariants(s.stress)[::2], s.evp, model.cap(s))

        def run(n):
            model = benchmark(name)
            return [view(model, s) for s in uniaxial(model, rows[:, 1], n)]

        coarse, fine, finest = (np.array(run(n)) for n in (25, 50, 100))
        scale = np.array([600, 500, 1800, 90, 0.03, 1837])
        yield f"{name[1:]} cap and shear, extrapolated", gap(2 * finest - fine, rows[:, 2:], scale), 2e-5
        ratio = np.abs(coarse - fine).max() / np.abs(fine - finest).max()
        yield f"{name[1:]} first order: |error ratio - 2|", abs(ratio - 2), 0.1


def hydrostatic_benchmarks():
    """08, 09, 12: I1, evp, zeta and X at every published point."""

    def compare(model, rows, n, order):
        strains = [r[0] for r in rows]
        view = lambda s: (s.stress[:3].sum(), s.evp, model.zeta(s), model.cap(s))
        run = lambda m: [view(s) for s in hydrostatic(model, strains, m)]
        return extrapolated(run, n, order) if order else np.array(run(n))

    numbers = lambda rows: np.array([r[1:5] for r in rows], float)
    scale = np.array([6800, 1, 3000, 1837])
    rows = HYDRO["T08"]
    got = compare(benchmark("T08", **DILATED), rows, 200, 0)
    yield "08 load, unload; K = B0 when dilated", gap(got, numbers(rows), scale), 1.5e-3
    got = compare(benchmark("T08"), rows, 200, 0)
    yield "08 the same with B0 + B1 exp(B2/I1) (differs: see report)", gap(got[:6], numbers(rows)[:6], scale), 3e-4
    for pressure in (0.0, 300.0):
        for key, moduli in (("uintah", "arenisca3"), ("correct", "gassmann without B1")):
            rows = HYDRO["T09_" + ("" if pressure else "pf0=0_") + key]
            options = dict(DILATED, **PLASTIC_FORM, **{"Undrained moduli": moduli})
            model = benchmark("T09", fluid_pressure_initial=pressure, **options)
            got = compare(model, rows, 400 if pressure else 100, 0)
            first = slice(0, 4)
            yield f"09 {moduli}, p_i = {pressure:g}: compression", gap(got[first], numbers(rows)[first], scale), 5e-7
            if pressure:
                yield f"09 {moduli}, p_i = {pressure:g}: all legs", gap(got, numbers(rows), scale), 4e-3
    rows = [HYDRO["T12"][-1]] + HYDRO["T12"][:-1]
    got = compare(benchmark("T12"), rows, 100, 2)
    scale = np.array([6.7e8, 0.0064, 1, 6.7e8])
    yield "12 nonlinear elasticity with coupling, extrapolated", gap(got, numbers(rows), scale), 3e-6
    options = dict(DILATED, **PLASTIC_FORM, **{"Undrained moduli": "arenisca3"})
    for kf, rows in PUBLISHED["kf_limit"]:
        model = Arenisca(dict(SET_08, fluid_B0=kf, **options))
        got = [s.stress[:3].sum() for s in hydrostatic(model, [r[0] for r in rows], 20)]
        yield f"Kf = {kf:g}, reference code's limit", gap(got, np.array(rows)[:, 2], 1837), 3e-5


# -------------------------------------------------------------------------------------------------- shell, laws
def shell():
    """Crush of the thick spherical shell (section 1.9): published form, and the elastic-centre form."""
    rows = np.array(PUBLISHED["shell_load"])
    p3, y2 = -math.log(0.8), 6e8
    for name, p0, end in (("asymptotic p0=2Y ln p3, p1=1/(2Y), B0=Kdry", y2 * math.log(p3), -0.016),
                          ("p0=2Y ln phi0, p1=1/(2Y), B0=Kdry", y2 * math.log(0.2), -0.007),
                          ("asymptotic, B0=secant to full plasticity", y2 * math.log(p3), None)):  # fmt: skip
        for kf in (0.0, 2.2e9):
            given = PUBLISHED["shell"][name]
            column, expected = (2 if kf else 1), given["Kf=2.2e+09" if kf else "Kf=0"]
            options = {"fluid_B0": kf, "Matrix bulk modulus": 1e19, "p0_crush_curve": p0, "p1_crush_curve": 1 / y2,
                       "p3_crush_curve": p3, "B0": given["B0"], "G0": 1e10, "PEAKI1": 1e9, "FSLOPE": 0.3}  # fmt: skip
            forms = {"published": {"Undrained moduli": "arenisca3", **PLASTIC_FORM},
                     "published, exact porosity": PLASTIC_FORM, "centre": {}}  # fmt: skip
            for form, more in forms.items() if end else [("published", forms["published"])]:
                model = Arenisca({**options, **more})
                states = hydrostatic(model, rows[1:, 0], 100)
                p = np.array([0] + [-s.stress[:3].sum() / 3 for s in states])
                off = (p - rows[:, column]) / rows[:, column].max()
                short = f"shell {name[:14]}, Kf = {kf:g}, {form}"
                if form == "published":
                    yield short + ": worst", abs(np.abs(off).max() - expected["Linf_over_Pmax"]), 1e-5
                    got = states[-1].evp / expected["evp_A_end"] - 1, p[-1] / expected["P_A_end"] - 1
                    yield short + ": evp and P at the end", gap(got, 0, 1), 1e-5
                elif kf and form != "centre":
                    key = ("asymptotic" if name[0] == "a" else "p0=2Y ln phi0") + " centre=False Kd(phi)=False"
                    yield short + ": end", abs(off[-1] - PUBLISHED["shell2"][key]["end"]), 1e-5
                elif kf:
                    yield short + f": {100 * off[-1]:.3f} % (stated {100 * end:g} %)", abs(off[-1] - end), 5e-4


def laws():
    """Gassmann, Skempton, fluid relation, Weibull, Duvaut-Lions."""
    b = PUBLISHED["berea"]
    p3 = -math.log(1 - b["phi"])
    common = {"B0": b["K"], "G0": b["G"], "Matrix bulk modulus": b["Ks"], "p3_crush_curve": p3,
              "p0_crush_curve": -1e9, "p1_crush_curve": 1e-9, "PEAKI1": 1e7, "FSLOPE": 0.3}  # fmt: skip
    law = Arenisca({**common, "fluid_B0": b["Kf"]}).laws
    got = law.bulk(-1.0, 0.0), law._skempton(b["K"], b["phi"])
    yield "Biot-Gassmann Ku and Skempton B", gap(got, (b["Ku"], b["B"]), (1e10, 1)), 1e-12
    old = Arenisca({**common, "fluid_B0": b["Kf"], "Undrained moduli": "arenisca3"}).laws
    yield "the same, reference code", gap(old.bulk(-1.0, 0.0), b["Uintah_as_coded"], 1e10), 1e-12
    worst = 0.0
    for kf, ku, skempton in PUBLISHED["skempton"][1:]:
        law = Arenisca({**common, "fluid_B0": kf}).laws
        worst = max(worst, gap((law.bulk(-1.0, 0.0) / ku, law._skempton(b["K"], b["phi"]) / skempton), 1, 1))
    yield "Skempton table, Kf 0.1 MPa ... 1e6 GPa (Kf = Km: Ku = Km, B = 1)", worst, 1e-9
    # at p_i = 0 the exact relation is the integral of the published rate
    law = Arenisca({**common, "fluid_B0": b["Kf"]}).laws
    old = Arenisca({**common, "fluid_B0": b["Kf"], "Undrained moduli": "arenisca3"}).laws
    rate = solve_ivp(lambda e, z: [old._published_rate(e, z[0])], (0, -0.15), [0.0], rtol=1e-13, atol=1e-3, method="DOP853")
    yield "p_c(e) against its published rate, e = -0.15", abs(law.zeta(-0.15) / rate.y[0, -1] - 1), 1e-10

    for m, w in PUBLISHED["weibull"].items():
        m = float(m)
        draw = lambda u: weibull_coherence(m, 1.0, 1.0, u)
        mean = quad(lambda t: weibull_coherence(m, 1, 1, math.exp(-t)) * math.exp(-t), 0, 60, limit=400)[0]
        square = quad(lambda t: weibull_coherence(m, 1, 1, math.exp(-t)) ** 2 * math.exp(-t), 0, 80, limit=400)[0]
        got = (mean, math.sqrt(square - mean**2), draw(0.99), draw(0.01), draw(0.5),
               weibull_coherence(m, 1e3, 1, None), weibull_coherence(m, 1e-3, 1, None))  # fmt: skip
        want = (1.0, w["CV"], w["q01_over_mean"], w["q99_over_mean"], w["median_over_mean"],
                w["mean_ratio_V_over_Vref_1e3"], w["mean_ratio_V_over_Vref_1em3"])  # fmt: skip
        yield f"Weibull m = {m:g}: mean, CV, quantiles, size", gap(got, want, np.maximum(1, want)), 1e-8

    d = PUBLISHED["duvaut_lions"]
    model = Arenisca(dict(B0=d["E"], G0=d["E"] / 2, STREN=d["Y"], T1_rate_dependence=d["tau"]))
    shear = np.array([0, 0, 0, 1.0, 0, 0])
    start = model.advance(model.initial(), shear * d["rate"] * d["t_yield"], d["t_yield"])
    worst = 0.0
    for t, overstress in d["overstress_vs_t_after_yield"][1:]:
        s = model.advance(start, shear * d["rate"] * t, t, 3)
        worst = max(worst, abs(s.dynamic[3] - d["Y"] - overstress) / d["Y"])
    yield "Duvaut-Lions overstress, constant rate", worst, 1e-12
    five = model.advance(start, shear * d["rate"] * 1e-4, 1e-4)
    worst = max(abs(model.advance(five, 0 * shear, k * d["tau"] or 1e-30).dynamic[3] - d["Y"] - o) / d["Y"]
                for k, o in d["hold_from_5tau"])  # fmt: skip
    yield "Duvaut-Lions relaxation", worst, 1e-12
    time_end = d["t_yield"] + 2 * d["tau"]
    exact = d["Y"] + dict(map(tuple, d["overstress_vs_t_after_yield"]))[4e-5]
    worst = 0.0
    for n, error in d["update_errors_rel"]:
        s = model.advance(model.initial(), shear * d["rate"] * time_end, time_end, n)
        worst = max(worst, abs(s.dynamic[3] / exact - 1 - error))
    yield "Duvaut-Lions error of n = 1 ... 1024 steps through yield", worst, 1e-12


def run():
    """All checks; 0 if every figure holds."""
    failed, count, begin = 0, 0, time.time()
    for group in (simple_benchmarks, j2_and_rate_benchmarks, cap_benchmarks, hydrostatic_benchmarks, shell, laws,
                  *mechanics, pores):  # fmt: skip
        clock = time.time()
        print(f"-- {group.__doc__.strip().splitlines()[0]}")
        for what, value, limit in group():
            good = value <= limit  # NaN fails
            failed, count = failed + (not good), count + 1
            print(f"{'ok  ' if good else 'FAIL'} {what:75s} {value:9.2e}  (limit {limit:.0e})")
        print(f"   {time.time() - clock:.1f} s")
    print(f"{count - failed} of {count} hold, {time.time() - begin:.0f} s")
    return 1 if failed else 0
