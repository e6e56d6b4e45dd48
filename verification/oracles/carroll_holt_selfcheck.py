# SPDX-License-Identifier: BSD-3-Clause
"""Self-check of shell_statics.py and shell_motion.py: stored numbers of another program, a column of material points
that knows no closed form, identities and limits."""
import json
import math
import pathlib

import numpy as np
from scipy.optimize import brentq

from oracles import shell_statics as statics
from oracles.shell_motion import Coasting, CompressibleShell

NUMBERS = json.loads((pathlib.Path(__file__).parent / "carroll_holt_numbers.json").read_text())
failed = []


def hold(what, value, bound, at_least=False):
    good = value >= bound if at_least else value <= bound
    print(f"{'holds' if good else 'FAILS'}  {what}: {value:.3g} {'>=' if at_least else '<='} {bound:.3g}")
    if not good:
        failed.append(what)


def relative(a, b):
    return abs(a / b - 1.0)


def stored_curves():
    standard = dict(NUMBERS["shell"])
    turn = standard.pop("turn_strain")
    for law, stored in NUMBERS["laws"].items():
        shell = statics.Shell(law=law, **standard)
        marks = statics.landmarks(shell, turn)
        hold(f"law {law}: landmarks", max(relative(marks[n], v) for n, v in stored["landmarks"].items()), 1e-12)
        rows = statics.curve(shell, [row[0] for row in stored["rows"]], turn)
        effective = max(abs(mine[3] - row[1]) for mine, row in zip(rows, stored["rows"]))
        fluid = max(abs(mine[4] - row[2]) for mine, row in zip(rows, stored["rows"]))
        hold(f"law {law}: {len(rows)} states of load and unload, error over Y", max(effective, fluid) / 300e6, 1e-12)


def column_pressure(shell, points, path, pieces):
    """(strains, P_eff) along a path of strains by integrating `points` material points with return mapping.

    Law H adds up increments; law S, linear in the displacement, counts from the last turn.
    """
    edges = np.geomspace(shell.start - 1.0, shell.start, points + 1)
    middle, s = 0.5 * (edges[1:] + edges[:-1]), np.zeros(points)
    old, strains, pressures, begin, limit = middle, [], [], 0.0, shell.strength
    for end in path:
        s_turn, c_turn = s, shell.start - statics.distension(shell, begin)
        for strain in np.linspace(begin, end, pieces + 1)[1:]:
            c = shell.start - statics.distension(shell, strain)
            x = middle - c
            trial = s + 2.0 * shell.shear_modulus * np.log(old / x)
            if shell.law == "S":
                trial = s_turn + 2.0 * shell.shear_modulus * (c - c_turn) / x
            s, old = np.clip(trial, -limit, limit), x
            strains.append(strain)
            pressures.append(2.0 / 3.0 * float(np.sum(s * np.log((edges[1:] - c) / (edges[:-1] - c)))))
        begin = end
    return strains, pressures


def column_errors(shell, turn, back):
    """max |P - closed form| / Y for columns of 250, 500 and 1000 points."""
    errors = []
    for points in (250, 500, 1000):
        strains, pressures = column_pressure(shell, points, [turn, back], 200)
        rows = statics.curve(shell, strains[:200], turn)
        alpha_turn = statics.distension(shell, turn)
        unloaded = [statics.unloading(shell, statics.distension(shell, e), alpha_turn)[0] for e in strains[200:]]
        exact = [row[3] for row in rows] + unloaded
        errors.append(float(np.max(np.abs(np.array(exact) - pressures))) / shell.strength)
    return errors


def columns():
    for name, shell, turn, back in (
        ("full yield, law H", statics.Shell(), -0.12, -0.09),
        ("full yield, law S", statics.Shell(law="S"), -0.12, -0.09),
        ("partial yield", statics.Shell(), -0.006, -0.004),
        ("small porosity", statics.Shell(porosity=0.05), -0.03, -0.0225),
    ):
        errors = column_errors(shell, turn, back)
        hold(f"column of points, {name}: error over Y at 1000 points", errors[-1], 1e-5)
        hold(f"column of points, {name}: order", math.log2(errors[0] / errors[2]) / 2.0, 1.7, at_least=True)


def identities():
    shell = statics.Shell(porosity=0.17, shear_modulus=9e9, strength=250e6, fluid_modulus=1.9e9, fluid_pressure=20e6)
    ratio = shell.strength / shell.shear_modulus
    hold("strain at full yield = -Y/2G", relative(statics.strain_of(shell, statics.full_yield(shell)), -0.5 * ratio), 1e-12)
    turn = statics.distension(shell, -0.1)
    complete = statics.strain_of(shell, statics.reverse_yield_range(shell, turn)[1])
    hold("reverse yield complete after Y/G", relative(complete + 0.1, ratio), 1e-12)
    modulus = -statics.loading(shell, statics.distension(shell, -1e-7))[0] / -1e-7
    hold("first modulus 4G/3 (1-phi)/phi", relative(modulus, 4.0 / 3.0 * 9e9 * 0.83 / 0.17), 1e-5)
    yielded = statics.loading(shell, statics.distension(shell, -0.1))[0]
    porosity = 1.0 - 1.0 / turn
    hold("fully plastic P = 2Y/3 ln(1/phi)", relative(yielded, 2.0 / 3.0 * 250e6 * math.log(1.0 / porosity)), 1e-12)
    centre = statics.elastic_centre(shell, turn)
    zeta = -3.0 * statics.fluid_pressure(shell, centre)
    backstress = 0.83 + 0.17 * math.exp((zeta + 3.0 * 20e6) / (3.0 * 1.9e9))
    hold("zeta law at the elastic centre", relative(math.exp(statics.strain_of(shell, centre)), backstress), 1e-12)
    strong, weak = statics.Shell(strength=3e5), statics.Shell(strength=3e5, law="S")
    alphas = [statics.distension(strong, e) for e in (-1e-6, -3e-6, -8e-6)]
    laws = max(abs(statics.loading(strong, a)[0] - statics.loading(weak, a)[0]) for a in alphas) / 3e5
    hold("laws H and S differ by O(Y/G), over Y", laws, 1e-5)
    hold("and are not the same, over Y", laws, 1e-8, at_least=True)

    def first_reverse_pressure(phi):
        """P_eff at first reverse yield after loading to porosity phi, small Y/G."""
        tiny = statics.Shell(porosity=0.5, strength=15e3)
        turned = 1.0 / (1.0 - phi)
        return statics.unloading(tiny, statics.reverse_yield_range(tiny, turned)[0], turned)[0]

    threshold = brentq(first_reverse_pressure, 0.05, 0.4, xtol=1e-12)
    hold("reverse yield begins at P = 0 for phi = 0.2031878700", abs(threshold - 0.2031878700), 1e-6)


def motion():
    for case in NUMBERS["coasting"]:
        coasting = Coasting(statics.Shell(fluid_modulus=case["fluid_modulus"]), case["stop_strain"])
        name = f"coasting, K_f = {case['fluid_modulus']:.2g}, to {case['stop_strain']}"
        worst = max(relative(coasting.strength, case["D"]), relative(coasting.stop_time, case["stop_time"]))
        hold(f"{name}: D and time of arrest", worst, 1e-9)
        radii = [coasting.at(row[0])[:2] for row in case["rows"]]
        worst = max(relative(mine, row[k + 1]) for mine_row, row in zip(radii, case["rows"]) for k, mine in enumerate(mine_row))
        hold(f"{name}: radii in time", worst, 1e-9)
        speed = max(abs(coasting.at(row[0])[2] - row[3]) for row in case["rows"]) / abs(case["rows"][0][3])
        hold(f"{name}: velocity in time", speed, 1e-8)
        alpha, d = coasting.state(0.5 * coasting.stop_time)
        first = coasting.inertia(coasting.shell.start) * coasting.strength**2
        kept = coasting.inertia(alpha) * d**2 + coasting.work(alpha)
        hold(f"{name}: energy half-way", relative(kept, first), 1e-9)


def compressible():
    """The one-dimensional shell with a bulk modulus: second order in cells, and tends to the exact history."""
    coasting = Coasting(statics.Shell(), -0.08)
    times = np.linspace(0.0, 1.0, 21) * coasting.stop_time
    exact = np.array([coasting.at(t)[0] for t in times])
    travel = coasting.a0 - exact[-1]

    def inner(ratio, cells):
        history = CompressibleShell(coasting, ratio * 15e9, cells).history(coasting.stop_time)
        return np.interp(times, history[0], history[1])

    coarse, middle, fine = (inner(20.0, cells) for cells in (50, 100, 200))
    order = math.log2(np.max(np.abs(coarse - middle)) / np.max(np.abs(middle - fine)))
    hold("compressible shell: order in cells", order, 1.7, at_least=True)
    hold("compressible shell: error of 200 cells over the travel", float(np.max(np.abs(middle - fine))) / travel / 3.0, 1e-4)
    errors = [float(np.max(np.abs(inner(ratio, 100) - exact))) / travel for ratio in (10.0, 40.0, 160.0)]
    hold("compressible shell: distance from the exact history at K/G = 160 over the travel", errors[2], 2e-3)
    hold("compressible shell: fall of that from K/G = 10 to 160", errors[0] / errors[2], 8.0, at_least=True)


def main():
    for part in (stored_curves, columns, identities, motion, compressible):
        part()
    print(f"{len(failed)} figures do not hold" if failed else "every figure holds")
    return 1 if failed else 0
