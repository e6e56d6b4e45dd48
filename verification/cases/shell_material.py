#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Arenisca under hydrostatic load against the thick spherical shell whose matrix and pores it stands for.

    shell_material.py [PNG]     draw load and unload of both, and Arenisca's meridian (docs/pictures/shell_and_arenisca.png)

Nothing is fitted. With y = p3 + ev_p the fully plastic shell has I1 = 2Y ln(1 - exp(-y)), Arenisca's crush curve
I1 = p0 + ln(y/p3)/p1; they agree to first order in the porosity for p3 = -ln(1 - phi0), p1 = 1/2Y, p0 = 2Y ln p3, and
at the start for p0 = 2Y ln phi0. B0 is the shell's first elastic modulus, the solid is incompressible. What is left is a
figure of the model, not an error of the code: the code and the oracle must both find it.
"""
import dataclasses
import math
import pathlib
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy as np

from oracles import shell_statics as statics
from oracles.arenisca_paths import hydrostatic
from oracles.arenisca_pores import model as oracle_model
from tools.case import Result
from oracles.compressible_shell import CompressibleShell
from tools.drive import drive, knows
from scipy.optimize import brentq, minimize
from scipy.special import lambertw

HERE = pathlib.Path(__file__).resolve().parent
PICTURE = HERE.parents[1] / "docs" / "pictures" / "shell_and_arenisca.png"
STRENGTH, SHEAR, FLUID, DEEPEST = 300e6, 15e9, 2.2e9, -0.12
HUGE = 1e30
STIFF = 1e16  # modulus of the solid: incompressible


@dataclasses.dataclass(frozen=True)
class Variant:
    """A form of the model; the published figures are of a third program (event-driven integration)."""

    name: str
    fluid: float  # bulk modulus [Pa]
    backstress: str  # the form; "" is the poroplastic one
    published: dict  # by crush curve: pressure error at the deepest strain over the shell's


VARIANTS = [
    Variant("drained", 0.0, "", {"2Y ln p3": -0.0445684, "2Y ln phi0": 0.0015142}),
    Variant("undrained", FLUID, "", {}),
    Variant("undrained, elastic centre", FLUID, "elastic centre", {"2Y ln p3": -0.0156, "2Y ln phi0": -0.0067}),
    Variant("undrained, published form", FLUID, "plastic", {"2Y ln p3": -0.1611107, "2Y ln phi0": -0.1516217}),
]
POROSITIES, RATIOS = (0.05, 0.1, 0.2, 0.3), (2.1667, 10.0, 100.0)
CRUSH_CURVES = ("2Y ln p3", "2Y ln phi0")


def parameters(curve, variant, porosity=0.2, shear=SHEAR):
    """Arenisca's parameters for a shell; PEAKI1 and FSLOPE do not matter under hydrostatic compression."""
    p3 = -math.log1p(-porosity)
    p0 = 2.0 * STRENGTH * math.log(p3 if curve == "2Y ln p3" else porosity)
    modulus = 4.0 / 3.0 * shear * (1.0 - porosity) / porosity
    card = {"PEAKI1": -p0, "FSLOPE": 0.3, "B0": modulus, "G0": shear, "p0_crush_curve": p0,
            "p1_crush_curve": 1.0 / (2.0 * STRENGTH), "p3_crush_curve": p3}  # fmt: skip
    if variant.fluid > 0.0:
        card.update({"fluid_B0": variant.fluid, "Matrix bulk modulus": STIFF})
    if variant.backstress:
        card["Backstress strain"] = variant.backstress
    return card


def strains(deepest=DEEPEST):
    return deepest * (np.arange(1, 241) / 240.0)


def shell_pressure(variant, at, porosity=0.2, shear=SHEAR):
    shell = statics.Shell(porosity=porosity, shear_modulus=shear, strength=STRENGTH, fluid_modulus=variant.fluid)
    rows = statics.curve(shell, list(at), float(at[-1]) - 1.0)
    return np.array([effective + fluid for _, _, _, effective, fluid in rows])


def drained_pressure(card, at):
    """Arenisca's own answer in closed form: I1 = 3 K (e - p3 (exp(p1 (I1 - p0)) - 1)) beyond crushing at p0."""
    modulus, p0, p1, p3 = (card[n] for n in ("B0", "p0_crush_curve", "p1_crush_curve", "p3_crush_curve"))
    a = 3.0 * modulus * p1 * (at + p3 - p0 / (3.0 * modulus))
    crushed = p0 + (a - lambertw(3.0 * modulus * p1 * p3 * np.exp(a)).real) / p1
    return -np.where(3.0 * modulus * at > p0, 3.0 * modulus * at, crushed) / 3.0


def oracle_pressure(card, at):
    states = hydrostatic(oracle_model(card), list(at), 1)
    return np.array([-float(state.stress[:3].sum()) / 3.0 for state in states])


def code_pressure(barreno, card, at):
    """The library's answer; None if its model has not all of these parameters."""
    if not all(knows(barreno, "Arenisca", name) for name in card):
        return None
    rows = [(float(i), np.eye(3) * math.exp(e / 3.0)) for i, e in enumerate([0.0, *at])]
    table = drive(barreno, "Arenisca", card, rows, steps=2)
    return -(table["stress_xx"] + table["stress_yy"] + table["stress_zz"])[1:] / 3.0


def compare(barreno, curve, variant, result):
    at, card = strains(), parameters(curve, variant)
    exact, oracle = shell_pressure(variant, at), oracle_pressure(card, at)
    error = (oracle - exact) / exact[-1]
    code = code_pressure(barreno, card, at)
    apart = "parameters unknown" if code is None else float(np.max(np.abs(code - oracle)) / exact[-1])
    worst = int(np.argmax(np.abs(error)))
    l2 = float(np.linalg.norm(oracle - exact) / np.linalg.norm(exact))
    result.rows.append([variant.name, curve, abs(error[worst]), at[worst], l2, error[-1], apart])
    name = f"{variant.name}, p0 = {curve}"
    if variant.published:
        result.demand(f"{name}: oracle against the published figure", abs(error[-1] - variant.published[curve]), 1e-3)
    if code is not None:
        result.demand(f"{name}: code against oracle, over the largest pressure", apart, 1e-3)
    if variant.fluid == 0.0:
        closed = drained_pressure(card, at)
        result.demand(f"{name}: oracle against the closed form", float(np.max(np.abs(oracle - closed))) / exact[-1], 1e-6)
        result.demand(f"{name}: code against the closed form", float(np.max(np.abs(code - closed))) / exact[-1], 1e-6)


def porosity_order(result):
    """The calibration is of first order in the porosity; loads to 0.54 of full collapse, all but rigid before yield."""
    variant, errors, rigid = VARIANTS[0], [], 1e4 * SHEAR
    for porosity in (0.1, 0.05, 0.025):
        at = strains(0.54 * math.log1p(-porosity))
        oracle = oracle_pressure(parameters("2Y ln p3", variant, porosity, rigid), at)
        errors.append(abs(oracle[-1] - shell_pressure(variant, at, porosity, rigid)[-1]) / STRENGTH)
    rate = math.log2(errors[-2] / errors[-1])
    result.demand("drained, p0 = 2Y ln p3: order in the porosity less 1", abs(rate - 1.0), 0.1)


def compressible_parameters(porosity, ratio):
    """Arenisca's parameters for a shell of K/G = ratio: elasticity of the hollow sphere, the rest as for incompressible solid."""
    card = parameters("2Y ln phi0", VARIANTS[1], porosity)
    solid = ratio * SHEAR
    card["B0"] = 4.0 * SHEAR * solid * (1.0 - porosity) / (4.0 * SHEAR + 3.0 * solid * porosity)
    return {**card, "Matrix bulk modulus": solid}


@dataclasses.dataclass
class Cycle:
    """Both legs of a compressible shell with fluid: pressures on it, and of its fluid."""

    strain: np.ndarray
    pressure: np.ndarray
    fluid: np.ndarray
    terzaghi: float = 0.0  # how far the shell without fluid is from it, see shell_cycle()


def shell_cycle(porosity, ratio, down, back):
    """The same pressure p on both faces of a shell shrinks every length by p/(3 K) and changes no shear stress. So the shell without fluid
    whose lengths are exp(p/(3 K)) times as large must have the effective pressure P - p.
    """
    shell = statics.Shell(porosity=porosity, shear_modulus=SHEAR, strength=STRENGTH, fluid_modulus=FLUID)
    dry = dataclasses.replace(shell, fluid_modulus=0.0)
    solid, radius = ratio * SHEAR, np.cbrt(porosity)
    thick, empty = (CompressibleShell(s, solid, radius, 1.0) for s in (shell, dry))
    wall = 1.0 - porosity

    def inner(strain):
        b = np.exp(strain / 3.0)
        low, high = np.cbrt(max(b**3 - wall, 0.01 * porosity)), min(1.02 * thick.a0, np.cbrt(b**3 - 0.8 * wall))
        return brentq(lambda a: thick.march(a)[0] - b, low, high, xtol=1e-14, rtol=1e-13)

    rows, off = [], 0.0
    for strain in [*down, *back]:
        a = inner(strain)
        pressure, fluid = thick.march(a)[1], thick.fluid(a)
        grown = math.exp(fluid / (3.0 * solid))
        outer, effective = empty.march(a * grown)
        off = max(off, abs(outer / (math.exp(strain / 3.0) * grown) - 1.0), abs(effective + fluid - pressure) / pressure)
        rows.append((pressure, fluid))
        if strain == down[-1]:
            thick.turn(a)
            empty.turn(a * grown)
    pressure, fluid = np.array(rows).T
    return Cycle(np.append(down, back), pressure, fluid, off)


def with_fluid(cycle, porosity, solid):
    """Pressures of the poroplastic form, docs/method.md (10.1) and (10.2), over the curve of the shell without fluid in place of a crush
    curve. That curve is followed along its tangent for the little by which the pore pressures differ.
    """
    effective, stretched = cycle.pressure - cycle.fluid, cycle.strain + cycle.fluid / solid
    turn = int(np.argmin(cycle.strain)) + 1
    slope = np.append(np.gradient(effective[:turn], stretched[:turn]), np.gradient(effective[turn:], stretched[turn:]))
    grains, pores, before, p, at, out = 1.0 - porosity, porosity, 0.0, 0.0, 0.0, []
    for i, strain in enumerate(cycle.strain):

        def volumes(q, i=i):
            there = effective[i] + slope[i] * (q - cycle.fluid[i]) / solid
            return there, grains * math.exp(-((there - before) / grains + q - p) / solid), pores * math.exp(-(q - p) / FLUID)

        q = brentq(lambda q: sum(volumes(q)[1:]) - math.exp(strain - at), 0.5 * cycle.fluid[i] - 1e6, 2.0 * cycle.fluid[i] + 1e6)
        before, *ends = volumes(q)
        grains, pores = (v / sum(ends) for v in ends)
        p, at = q, strain
        out.append(before + p)
    return np.array(out)


def best_crush_curve(card, cycle):
    """The card with p0 and p1 fitted to the loading of the shell without fluid: least greatest error. (p3 is the porosity.)"""
    names = ("p0_crush_curve", "p1_crush_curve")
    turn = int(np.argmin(cycle.strain)) + 1
    solid = card["Matrix bulk modulus"]
    effective, stretched = (cycle.pressure - cycle.fluid)[:turn], (cycle.strain + cycle.fluid / solid)[:turn]

    def changed(x):
        return {**card, **{name: card[name] * math.exp(v) for name, v in zip(names, x)}}

    def miss(x):
        with np.errstate(all="ignore"):  # curves that end within the loading
            off = np.abs(drained_pressure(changed(x), stretched) - effective).max()
        return off if math.isfinite(off) else HUGE

    starts = ([0.0, 0.0], [-0.3, 0.3], [-1.0, 0.5], [-0.2, -0.7])
    options = {"maxiter": 2000, "xatol": 1e-5, "fatol": 1e-6 * cycle.pressure.max()}
    found = min((minimize(miss, x, method="Nelder-Mead", options=options) for x in starts), key=lambda fit: fit.fun)
    return changed(found.x)


def compressible(barreno, result, porosity, ratio):
    """Load to a half of the pores' collapse and 1 % of strain back, undrained."""
    deepest = max(-0.5 * porosity, -0.1)
    down, back = deepest * np.arange(1, 25) / 24.0, deepest + np.array([0.002, 0.004, 0.006, 0.008, 0.01])
    cycle = shell_cycle(porosity, ratio, down, back)
    loading, peak = cycle.pressure[:24], cycle.pressure[23]
    card = compressible_parameters(porosity, ratio)
    name = f"undrained, porosity {porosity:g}, K/G {ratio:g}"
    for curve, chosen in (("fitted", best_crush_curve(card, cycle)), ("2Y ln phi0", card)):
        off = (code_pressure(barreno, chosen, cycle.strain) - cycle.pressure) / peak
        worst = int(np.argmax(np.abs(off[:24])))
        l2 = float(np.linalg.norm(off[:24] * peak) / np.linalg.norm(loading))
        result.rows.append([name, curve, abs(off[worst]), down[worst], l2, off[23], ""])
    form = (with_fluid(cycle, porosity, ratio * SHEAR) - cycle.pressure) / peak
    result.demand(f"{name}: effective pressure against the shell without fluid, relative", cycle.terzaghi, 1e-9)
    result.demand(f"{name}: poroplastic form over the shell's own drained curve, loading, over the peak", np.abs(form[:24]).max(), 0.02)
    result.demand(f"{name}: poroplastic form over the shell's own drained curve, unloading, over the peak", np.abs(form[24:]).max(), 0.02)
    result.demand(f"{name}: loading against the compressible shell, over the peak", np.abs(off[:24]).max(), 0.02)
    result.demand(f"{name}: unloading by 1 % of strain, over the peak", np.abs(off[24:]).max(), 0.02)


def run(barreno, full):
    result = Result(
        "Arenisca against the spherical shell, material point",
        "A porous rock with the parameters of the shell, nothing fitted: how well the continuum model represents the shell.",
        "Carroll and Holt's shell (`verification/oracles/shell_statics.py`), loaded to a volume strain of -0.12; Y = 300 MPa, "
        "G = 15 GPa, porosity 0.2, fluid 2.2 GPa. Errors relative to the shell's largest pressure.",
        ["form", "p0", "largest error", "at strain", "L2 error", "error at the deepest", "code against oracle"],
        [],
    )  # fmt: skip
    for variant in VARIANTS:
        for curve in CRUSH_CURVES:
            compare(barreno, curve, variant, result)
    porosity_order(result)
    for porosity in POROSITIES if full else POROSITIES[2:3]:
        for ratio in RATIOS if full else RATIOS[1:2]:
            compressible(barreno, result, porosity, ratio)
    result.notes = (
        "The compressible shells (`compressible_shell.py`) have no fitted parameters either: drained modulus of the hollow sphere, modulus "
        "of its "
        "solid, Y and porosity. None of their errors belongs to the fluid. A shell with fluid is, to round-off, a shell without fluid "
        "under the effective pressure. The poroplastic form with the drained shell's own curve in place of the crush curve finds the "
        "pressures of all shells, loading and unloading. "
        "What is left are two properties of the dry law. In loading, a shell yields from its inner wall outwards, which rounds the knee, "
        "while Arenisca is elastic up to "
        "the crush curve. The fewer the pores and the stiffer the solid, the larger the preceding elastic part. Rows `fitted` have p0 and "
        "p1 fitted to the loading "
        "of the shell without fluid, for the least greatest error. In unloading the shell yields again, from the inner wall outwards, "
        "after a few tenths of a per cent of strain. A crush curve does not yield when the pressure falls."
    )
    return result


def draw_response(axes):
    """The paper's figure 4, left: the shell's load and unload, and Arenisca's with the same parameters."""
    variant, shell = VARIANTS[2], statics.Shell(fluid_modulus=FLUID)
    back = np.linspace(DEEPEST, -0.02, 201)[1:]
    at = [0.0, *strains(), *back]
    rows = statics.curve(shell, at, DEEPEST)
    effective, fluid = (np.array([row[k] for row in rows]) / 1e6 for k in (3, 4))
    x = -np.array(at)
    axes.plot(x, effective + fluid, "k", label="shell with fluid")
    axes.plot(x, effective, "0.55", label="shell, drained")
    axes.plot(x, fluid, "C0:", label="fluid in its pore")
    axes.plot(x, np.append(0.0, oracle_pressure(parameters("2Y ln phi0", variant), at[1:])) / 1e6, "C3--", label="Arenisca with fluid")
    centre = statics.elastic_centre(shell, statics.distension(shell, DEEPEST))
    place, pressure = -statics.strain_of(shell, centre), statics.fluid_pressure(shell, centre) / 1e6
    axes.plot(place, pressure, "ko", ms=5)
    axes.annotate("elastic centre,\n$P = -\\zeta/3$", (place, pressure), (0.083, 2180), ha="right", va="center",
        arrowprops={"arrowstyle": "-", "lw": 0.6})
    axes.axhline(0.0, color="k", lw=0.5)
    axes.set_xlabel("volume strain, compression")
    axes.set_ylabel("pressure [MPa]")
    axes.legend(fontsize=8, loc="upper left")
    axes.set_title("Hydrostatic load and unload", fontsize=10)


def draw_meridian(axes):
    """The same, right: Arenisca's yield surface before and after."""
    model = oracle_model(parameters("2Y ln phi0", VARIANTS[2]))
    before, after = model.initial(), hydrostatic(model, list(strains()), 1)[-1]
    for state, colour, name in ((before, "0.5", "initial"), (after, "C3", "compressed to $-0.12$")):
        surface, zeta = model.laws.surface(state.e), model.zeta(state)
        x = surface.X + (surface.P - surface.X) * 0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, 400)))
        axes.plot((x + zeta) / 1e9, [max(0.0, surface.strength(v)) / 1e9 for v in x], color=colour, label=name)
        axes.plot(zeta / 1e9, 0.0, "o", color=colour, ms=5)
        axes.annotate("$\\zeta$", (zeta / 1e9, 0.0), (0, 7), textcoords="offset points", ha="center", color=colour)
        axes.annotate("$\\zeta + X$", ((zeta + surface.X) / 1e9, 0.0), (-4, 7), textcoords="offset points", ha="right", color=colour)
    axes.set_xlabel("$I_1$ [GPa], tension positive")
    axes.set_ylabel("$\\sqrt{J_2}$ [GPa]")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(left=axes.get_xlim()[0] - 0.9)  # room for the mark of the cap's end
    axes.legend(fontsize=8)
    axes.set_title("Arenisca's meridian; $\\zeta$: elastic centre, $X$: end of the cap", fontsize=10)


def draw(file):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8), layout="constrained")
    draw_response(left)
    draw_meridian(right)
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else PICTURE)
