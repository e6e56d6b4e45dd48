# SPDX-License-Identifier: BSD-3-Clause
"""A perforation into saturated sandstone at both ends of permeability: none is the undrained rock, very much the drained one."""
import numpy as np
from tools.case import Result
from tools.runs import missing_fluid
from tools.wet_perforation import dry, undrained, with_flow

STRESSES = ("stress_xx", "stress_yy", "stress_zz", "stress_xy")


def different_bits(one, other):
    """Names of fields, at all instants, and of columns of the history that both runs have and that are not the same to the bit."""
    names = set()
    for instant in range(one.instants()):
        a, b = one.particles(instant), other.particles(instant)
        names |= {name for name in a if not np.array_equal(a[name], b[name], equal_nan=True)}
    a, b = one.table("history.csv"), other.table("history.csv")
    return names | {name for name in a if not np.array_equal(a[name], b[name])}


def apart(one, other):
    """rms difference of stresses over their rms, and largest distance of particles [m], of the rock: particles with a crush curve."""
    a, b = one.particles(), other.particles()
    rock = np.isfinite(a["plastic_volume_strain"]) & (a["status"] > 0.5) & (b["status"] > 0.5)
    difference = np.mean([np.mean((a[name] - b[name])[rock] ** 2) for name in STRESSES])
    size = np.mean([np.mean(a[name][rock] ** 2) for name in STRESSES])
    distance = np.hypot(a["x"] - b["x"], a["y"] - b["y"])[rock]
    return float(np.sqrt(difference / size)), float(distance.max())


def depth(run):
    return run.summary["penetration"]["depth"]


def row(name, run, drained):
    table = run.table("history.csv")
    stress, distance = apart(drained, run)
    return [name, 1e3 * depth(run), table["plastic"][-1], stress, 1e3 * distance, missing_fluid(run)]


def run(barreno, full):
    result = Result(
        "Perforation without and with all drainage",
        "Pore flow with zero permeability changes nothing; with very high permeability rock behaves as drained rock.",
        "the undrained run, bit for bit; the run of dry rock of equal density, whose pores are empty (the pores of the others are full at "
        "zero pressure, like everything outside). Stresses: rms difference over all particles of the rock.",
        ["rock", "depth [mm]", "plastic work [J]", "stresses against drained", "particles against drained [mm]", "missing fluid"],
        [],
    )
    for end in (6.0, 20.0) if full else (6.0,):
        drained, closed = dry(barreno, end), undrained(barreno, end)
        none = with_flow(barreno, 0.0, end)
        result.rows += [row(f"drained, {end:g} us", drained, drained), row(f"undrained, {end:g} us", closed, drained)]
        result.rows.append(row(f"permeability 0, {end:g} us", none, drained))
        other = len(different_bits(closed, none))
        result.demand(f"fields and columns with permeability 0 that differ from the undrained run, {end:g} us", other, 0.0)
        for permeability in (1e-11, 1e-9, 1e-7) if full else (1e-9, 1e-7):
            result.rows.append(row(f"{permeability:g} m2, {end:g} us", with_flow(barreno, permeability, end), drained))
        where, most = f"against drained, {end:g} us", result.rows[-1]
        undrained_apart = apart(drained, closed)[0]
        result.demand(f"{where}: stresses with the highest permeability, over those of undrained rock", most[3] / undrained_apart, 0.1)
        result.demand(f"{where}: depth with the highest permeability, relative", abs(most[1] / (1e3 * depth(drained)) - 1.0), 1e-3)
        result.demand(f"against drained, {end:g} us: missing fluid", result.rows[-1][-1], 1e-9)
    return result
