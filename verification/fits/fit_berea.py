#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits materials/cards/berea_sandstone.xml to published data of Berea sandstone.

    fit_berea.py [PICTURE] [--document]

Prints the misfit table and the parameters; with a file name as argument writes a picture of the fit, with --document
verification/results/berea_fit.json, from which docs/materials/berea_fit.md has its table.

Every datum says where it comes from and how sure it is:
  looked up   the number was read in a stored copy of the source, or of a text that quotes it
  recalled    from memory of the source, not checked against it for this fit
  assumed     no measurement: an engineering choice
`sigma` is the relative uncertainty that weighs the datum; it holds the scatter between blocks of Berea.
Tension positive, I1 = tr(sigma), pressures in MPa and moduli in GPa as in the sources.
"""

import json
import pathlib
import sys
from typing import NamedTuple

import numpy as np

VERIFICATION = pathlib.Path(__file__).resolve().parents[1]
STORED = VERIFICATION / "results" / "berea_fit.json"
POROSITY = 0.20  # between the 19 % and 21 % of the blocks below
GRAIN_DENSITY = 2650.0  # quartz [kg/m3]


def least_squares(*arguments, **settings):
    from scipy.optimize import least_squares as solve  # only a fit needs it, not a page of the stored one

    return solve(*arguments, **settings)


class Datum(NamedTuple):
    at: float  # pressure or confining pressure [MPa]
    value: float
    sigma: float  # relative
    source: str


BULK_MODULUS = [  # drained tangent K [GPa] at a hydrostatic pressure
    Datum(10, 6.6, 0.20, "Hart & Wang 1995 JGR 100:17741, abstract, static; looked up"),
    Datum(60, 11.0, 0.25, "Zimmerman 1991, compressibility of dry Berea, static; recalled"),
    Datum(50, 15.0, 0.25, "dry ultrasonic Vp 3.85, Vs 2.4 km/s; recalled"),
    Datum(300, 18.0, 0.35, "stiff frame of 18 % porosity quartz rock before crushing; assumed"),
    Datum(5000, 36.0, 0.10, "grain modulus, Detournay & Cheng 1993 table; recalled"),
]
POISSON_RATIO = [
    Datum(10, 0.17, 0.10, "Hart & Wang 1995, abstract; looked up"),
    Datum(5000, 0.20, 0.25, "Detournay & Cheng 1993 table; recalled"),
]
CRUSH_PRESSURE = [  # P* [MPa] at porosity `at` [%]
    Datum(19, 440.0, 0.05, "Zhang, Wong & Davis 1990 JGR 95:341, as quoted in a rock physics text; looked up"),
    Datum(21, 380.0, 0.05, "Wong, David & Zhu 1997 JGR 102:3009; recalled"),
]
POROSITY_UNDER_CRUSHING = [  # part of the pore strain left at a pressure [MPa]
    Datum(600, 0.70, 0.15, "Zhang, Wong & Davis 1990, figure of the porosity drop; recalled"),
    Datum(3000, 0.01, 0.70, "shocked sandstones: pores closed at 3 to 5.5 GPa (Kieffer 1971); recalled"),
]
# Coulomb line of triaxial compression, 27.2 MPa and 27.8 degrees for confinement 0 to 200 MPa, 18.2 % porosity:
# Goodman, Introduction to Rock Mechanics, table 3.3; looked up (quoted).
COHESION, FRICTION = 27.2, np.radians(27.8)
FLOW = (1 + np.sin(FRICTION)) / (1 - np.sin(FRICTION))


def coulomb(confinement):
    return 2 * COHESION * np.sqrt(FLOW) + (FLOW - 1) * confinement


STRENGTH = [Datum(0, 73.8, 0.15, "unconfined strength, Goodman table 3.1; recalled")] + [
    Datum(p, coulomb(p), 0.10, "Coulomb line, Goodman table 3.3; looked up") for p in (10.0, 25.0, 50.0, 100.0, 150.0, 200.0)
]
TENSION = Datum(0, 3.0, 0.30, "uniaxial tensile strength 2 to 4 MPa; recalled")
# Onset of shear-enhanced compaction: differential stress over P* at mean stress over P*. Wide bounds: the pick of an
# onset, and it must not outweigh the strength, which matters more under a jet.
COMPACTION = [
    Datum(0.50, 0.58, 0.30, "common yield envelope of porous sandstones, Wong et al. 1997; recalled"),
    Datum(0.75, 0.45, 0.30, "same"),
    Datum(0.90, 0.28, 0.40, "same"),
]
YSLOPE_ASSUMED = Datum(
    0, 0.07, 0.10, "shear strength of shocked quartz rock, 0.6 to 1.4 GPa at 5 GPa; recalled, rough, held fast"
)


def pressure_term(scale, pressure):
    return np.exp(-scale / (3 * pressure))


def fit_moduli():
    def model(v, p):
        return v[0] + v[1] * pressure_term(v[2], p)

    def residual(v):
        return [np.log(model(v, d.at) / d.value) / d.sigma for d in BULK_MODULUS]

    v = least_squares(residual, [6.0, 30.0, 300.0], bounds=([1, 1, 10], [20, 60, 2000])).x
    nu0, nu1 = (d.value for d in POISSON_RATIO)
    return v, (nu0, nu1 - nu0), [(f"K at {d.at:.0f} MPa [GPa]", d, model(v, d.at)) for d in BULK_MODULUS]


def fit_crushing():
    p3 = -np.log(1 - POROSITY)
    # P* falls as (porosity times grain size)^-3/2 (Zhang et al. 1990): both blocks at this porosity.
    scaled = [d.value * (d.at / (100 * POROSITY)) ** 1.5 for d in CRUSH_PRESSURE]
    crush = float(np.exp(np.mean(np.log(scaled))))
    rows = [(f"P* at {d.at:.0f} % [MPa]", d, crush * (100 * POROSITY / d.at) ** 1.5) for d in CRUSH_PRESSURE]

    def left(p1, p):
        return np.exp(-p1 * 3 * (p - crush))

    def residual(v):
        return [np.log(left(v[0], d.at) / d.value) / d.sigma for d in POROSITY_UNDER_CRUSHING]

    p1 = least_squares(residual, [6e-4]).x[0]
    rows += [(f"pore strain left at {d.at:.0f} MPa", d, left(p1, d.at)) for d in POROSITY_UNDER_CRUSHING]
    return p3, crush, p1, rows


def limit(v, x):
    peak, slope, strength, far_slope = v[:4]
    a2 = (slope - far_slope) / (strength - far_slope * peak)
    a3 = (strength - far_slope * peak) * np.exp(-a2 * peak)
    return strength - a3 * np.exp(a2 * x) - far_slope * x


def meridian(v, x, crush):
    peak, cr, X = v[0], v[4], -3 * crush
    kappa = peak - cr * (peak - X)
    c = np.where(x < kappa, (kappa - x) / (kappa - X), 0.0)
    return limit(v, x) * np.sqrt(np.maximum(1 - c * c, 0.0))


def bisect(too_small, low, high):
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if too_small(middle) else (low, middle)
    return low


def triaxial_yield(v, crush, confinement):
    """Differential stress at which triaxial compression meets the surface with this crushing pressure."""
    return bisect(lambda q: q / np.sqrt(3) < meridian(v, -(q + 3 * confinement), crush), 0.0, 5000.0)


def compacts(v, crush, confinement):
    """Whether the surface rises with I1 at yield: then the rock compacts and hardens (associated flow)."""
    x = -(triaxial_yield(v, crush, confinement) + 3 * confinement)
    return meridian(v, x + 0.1, crush) > meridian(v, x - 0.1, crush)


def triaxial_peak(v, crush, confinement):
    """Yield, or where that compacts the plateau at which the hardened cap flows without change of volume."""
    if compacts(v, crush, confinement):
        crush = bisect(lambda c: compacts(v, c, confinement), crush, 100 * crush)
    return triaxial_yield(v, crush, confinement)


def tensile(v):
    return bisect(lambda t: t <= v[0] and t / np.sqrt(3) < limit(v, t), 0.0, 100.0)


def strength_rows(v, crush):
    rows = [(f"TXC peak at {d.at:.0f} MPa [MPa]", d, triaxial_peak(v, crush, d.at)) for d in STRENGTH]
    rows.append(("uniaxial tension [MPa]", TENSION, tensile(v)))
    for d in COMPACTION:
        x = -3 * crush * d.at
        rows.append((f"Q/P* at P/P* = {d.at}", d, np.sqrt(3) * float(meridian(v, x, crush)) / crush))
    rows.append(("YSLOPE", YSLOPE_ASSUMED, v[3]))
    return rows


def fit_strength(crush):
    def residual(v):
        return [np.log(max(value, 1e-6) / d.value) / d.sigma for _, d, value in strength_rows(v, crush)]

    start = [6.0, 0.5, 250.0, 0.05, 0.2]
    fit = least_squares(residual, start, bounds=([1, 0.1, 50, 0.0, 0.05], [80, 1.5, 2000, 0.2, 0.9]),
                        x_scale=[10, 0.5, 200, 0.05, 0.3])
    return fit.x, strength_rows(fit.x, crush)


def table_of(rows):
    """Lines of a page from rows of label, datum, model, uncertainty, source."""
    lines = ["| quantity | data | model | misfit | uncertainty | source |", "|---|---|---|---|---|---|"]
    for label, data, value, sigma, source in rows:
        lines.append(f"| {label} | {data:.4g} | {value:.4g} | {100 * (value / data - 1):+.0f} % | {100 * sigma:.0f} % | {source} |")
    squares = [(np.log(value / data) / sigma) ** 2 for _, data, value, sigma, _ in rows]
    return [*lines, "", f"Root mean square of misfit over uncertainty: {np.sqrt(np.mean(squares)):.2f} ({len(squares)} data)"]


def stored_part():
    return table_of(json.loads(STORED.read_text()))


def draw(name, v, crush):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    x = np.linspace(-3 * crush, v[0], 400)
    plt.plot(-x, meridian(v, x, crush), label="initial surface")
    plt.plot(-x, limit(v, x), "--", label="limit surface")
    for d in STRENGTH:
        plt.plot(d.value + 3 * d.at, d.value / np.sqrt(3), "ko")
    for d in COMPACTION:
        plt.plot(3 * crush * d.at, d.value * crush / np.sqrt(3), "s", color="tab:red")
    plt.xlabel("-I1 [MPa]"), plt.ylabel("sqrt(J2) [MPa]"), plt.legend(), plt.savefig(name, dpi=120)


def main():
    (B0, B1, B2), (G1, G2), moduli = fit_moduli()
    p3, crush, p1, crushing = fit_crushing()
    v, strength = fit_strength(crush)
    rows = [(label, d.value, float(value), d.sigma, d.source) for label, d, value in [*moduli, *crushing, *strength]]
    print("\n".join(table_of(rows)) + "\n")
    G0 = 1.5 * B0 * (1 - 2 * G1) / (1 + G1)
    for name, value in [
        ("Density", GRAIN_DENSITY * (1 - POROSITY)), ("PEAKI1", v[0] * 1e6), ("FSLOPE", v[1]),
        ("STREN", v[2] * 1e6), ("YSLOPE", v[3]), ("CR", v[4]), ("B0", B0 * 1e9), ("B1", B1 * 1e9),
        ("B2", B2 * 1e6), ("G0", G0 * 1e9), ("G1", G1), ("G2", G2), ("p0_crush_curve", -3 * crush * 1e6),
        ("p1_crush_curve", p1 * 1e-6), ("p3_crush_curve", p3),
    ]:
        print(f"{name:16s} {value:.6g}")
    pictures = [name for name in sys.argv[1:] if name != "--document"]
    if pictures:
        draw(pictures[0], v, crush)
    if "--document" in sys.argv[1:]:
        sys.path[:0] = [str(VERIFICATION)]
        from pages import write_pages  # it asks this file for its part

        STORED.write_text(json.dumps(rows, indent=1) + "\n")
        write_pages()


if __name__ == "__main__":
    main()
