# SPDX-License-Identifier: BSD-3-Clause
"""Pore fluid from nothing to ten thousand times the matrix, pores from none to 0.6, one point of Arenisca and of the linear rock."""
import math

import numpy as np
from extreme_rows.point import answer, invariants, rock, stress_of, within

MATRIX = 2e10  # bulk modulus of the grains; the dry rock has 1e10
SQUEEZE = 0.08


def wet(fluid, porosity=0.2, **more):
    return rock(**{"p3_crush_curve": -math.log(1.0 - porosity), "Matrix bulk modulus": MATRIX, "fluid_B0": fluid, **more})


def hydrostatic(barreno, parameters, strains=(SQUEEZE,), steps=200):
    return answer(barreno, "Arenisca", parameters, [-s / 3.0 * np.eye(3) for s in strains], steps)


def pressure(table, row=-1):
    return -invariants(stress_of(table, row))[0] / 3.0


def gassmann(fluid, porosity):
    """Undrained bulk modulus of rock with K = 1e10 (F. Gassmann 1951)."""
    dry = 1e10
    share = 1.0 - dry / MATRIX
    return dry + share**2 / (share / MATRIX + porosity * (1.0 / fluid - 1.0 / MATRIX))


def soft_rows(barreno, table):
    title = "Fluid modulus to 0"
    for name, more in (("B1 = 0", {}), ("B1 = 5 GPa, B2 = 100 MPa", {"B1": 5e9, "B2": 1e8, "Tolerance": 1e-9})):
        dry, sentence = hydrostatic(barreno, wet(0.0, **more))
        last = None
        for fluid in (1.0, 1e3, 1e5, 1e7):
            found, sentence = hydrostatic(barreno, wet(fluid, **more))
            bound = 1.5 * fluid * math.log(0.2 / (math.exp(-SQUEEZE) - 1.0 + 0.2)) / pressure(dry)
            within(table, title, f"Arenisca, {name}, Kf = {fluid:g} Pa, squeezed by {SQUEEZE:g}", "change of pressure from the dry rock's",
                found, sentence,
                   lambda t: abs(pressure(t) / pressure(dry) - 1.0), max(bound, 1e-11))  # fmt: skip
            change = pressure(found) - pressure(dry) if found is not None else float("nan")
            if last is not None and fluid >= 1e5:
                table.within(title, f"Arenisca, {name}, Kf = {fluid:g} Pa against {fluid / 100:g}",
                    "|change over 100 times the smaller one's, less 1|",
                             abs(change / last / 100.0 - 1.0), 0.02)  # fmt: skip
            last = change


def stiff_rows(barreno, table):
    title = "Fluid modulus to 1e4 times the matrix"
    small = 1e-6
    for ratio in (1.0, 10.0, 1e4, 1e6):
        fluid = ratio * MATRIX
        found, sentence = hydrostatic(barreno, wet(fluid), (small,), 1)
        setup = f"Arenisca, Kf = {ratio:g} Km"
        within(table, title, setup, "|undrained modulus over Gassmann's less 1|", found, sentence,
            lambda t: abs(pressure(t) / small / gassmann(fluid, 0.2) - 1.0), 1e-5)
        found, sentence = hydrostatic(barreno, wet(fluid), (0.01, 0.02), 100)
        within(table, title, f"{setup}, squeezed by 0.02", "stress that is finite", found, sentence,
            lambda t: float(np.isfinite(stress_of(t)).all()), 1.0, at_least=True)
        linear = {"Bulk Modulus": "1e10", "Shear Modulus": "8e9", "Porosity": "0.2", "Grain Bulk Modulus": repr(MATRIX),
            "Fluid Bulk Modulus": repr(fluid)}
        found, sentence = answer(barreno, "Poroelastic", linear, [-small / 3.0 * np.eye(3)])
        within(table, title, f"Poroelastic, Kf = {ratio:g} Km", "|undrained modulus over Gassmann's less 1|", found, sentence,
               lambda t: abs(pressure(t) / small / gassmann(fluid, 0.2) - 1.0), 1e-9)  # fmt: skip


def porosity_rows(barreno, table):
    title = "Porosity 0 and 0.6"
    for porosity in (0.0, 1e-12):
        found, sentence = hydrostatic(barreno, wet(0.0, porosity), (0.3,))
        within(table, title, f"Arenisca, dry, porosity {porosity:g}, squeezed by 0.3", "|pressure over K strain less 1|", found, sentence,
               lambda t: abs(pressure(t) / (1e10 * 0.3) - 1.0), 1e-9)  # fmt: skip
    for fluid in (0.0, 2e9):
        found, sentence = hydrostatic(barreno, wet(fluid, 0.6, **{"Matrix bulk modulus": 5e10}), (0.3, 0.6, 0.9, 1.2), 400)
        setup = f"Arenisca, porosity 0.6, Kf = {fluid:g} Pa, squeezed by 1.2"
        within(table, title, setup, "plastic volume strain less -p3", found, sentence,
            lambda t: t["plastic_volume_strain"].min() + (-math.log(0.4)), -1e-9,
               at_least=True)  # fmt: skip
        within(table, title, setup, "pressure rises: least difference over the largest pressure", found, sentence,
               lambda t: min(np.diff([pressure(t, i) for i in range(5)])) / pressure(t), 0.0, at_least=True)  # fmt: skip
        if fluid == 0.0:
            within(table, title, setup, "|pressure over K (strain - p3) less 1|", found, sentence,
                lambda t: abs(pressure(t) / (1e10 * (1.2 + math.log(0.4))) - 1.0), 0.02)


def run(barreno, full, table):
    soft_rows(barreno, table)
    stiff_rows(barreno, table)
    porosity_rows(barreno, table)
