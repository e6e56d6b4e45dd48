# SPDX-License-Identifier: BSD-3-Clause
"""Pore pressures that alternate from one row of particles to the next in a wave through saturated rock: what they are, and which shape
function has none."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DECK = "perforation_drainage.xml"
CELL, FACE = 3e-3, 9e-3  # m: of the deck's grid, and y of its rock
TIMES = (90, 100)  # us: waves run to and fro in the rock, far from the hole
COLUMNS, ROWS = 8, (25, 40)  # particles from the axis; cells from the face: rock that has not been torn
SEALED = {"Pore Flow/Rocks/Sandstone/Permeability": "{1e-25 m2}"}
RUNS = {  # name: settings
    "GIMP, sealed": {"Step/Shape Function": "GIMP", **SEALED},
    "GIMP": {"Step/Shape Function": "GIMP"},
    "GIMP, Diffusion Number 0.1": {"Step/Shape Function": "GIMP", "Pore Flow/Diffusion Number": "0.1"},
    "quadratic B-spline": {"Step/Shape Function": "quadratic B-spline"},
}
CHEAP = ("GIMP, sealed", "quadratic B-spline")


def strains(start, now):
    """Logarithmic strains of particles from their corners: axial, radial, and that of the volume with the hoop."""
    edge = lambda at, axis, ends: at["corners"][:, ends[0], axis] + at["corners"][:, ends[1], axis] - at["corners"][:, ends[2],
        axis] - at["corners"][:, ends[3], axis]  # noqa: E731
    with np.errstate(divide="ignore", invalid="ignore"):  # the jet is not there at the start
        along = [np.log(edge(now, axis, ends) / edge(start, axis, ends)) for axis, ends in ((1, (2, 3, 0, 1)), (0, (1, 2, 0, 3)))]
        return [*along, np.log(now["volume_ratio"] / start["volume_ratio"])]


def pairs(start, values):
    """Of the two particles of a cell, one behind the other along the axis: their difference, and half of what the means of the cells around
    change by from cell to cell, which it would be if the field were smooth."""
    column, row = np.floor(start["x"] / (CELL / 2)), np.floor((start["y"] - FACE) / (CELL / 2))
    rock = np.isfinite(start["plastic_volume_strain"]) & (column < COLUMNS)
    field = np.full((COLUMNS, 2 * (ROWS[1] + 1)), np.nan)
    inside = rock & (row >= 0) & (row < field.shape[1])
    field[column[inside].astype(int), row[inside].astype(int)] = values[inside]
    cells = 0.5 * (field[:, 0::2] + field[:, 1::2])
    difference, slope = field[:, 1::2] - field[:, 0::2], np.gradient(cells, axis=1) / 2.0
    return difference[:, ROWS[0] : ROWS[1]].ravel(), slope[:, ROWS[0] : ROWS[1]].ravel()


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def part(difference, slope):
    """How much of the slope the difference is, by least squares."""
    return float(difference @ slope / (slope @ slope))


def row(name, start, now):
    axial, radial, volume = (pairs(start, values) for values in strains(start, now))
    across = [whole - along for whole, along in zip(volume, axial)]  # radial and hoop
    pore = pairs(start, now["pore_pressure"] / 1e6)
    stripes = volume[0] - volume[1]
    return [
        name, round(1e6 * now["time"], 3), part(*axial), part(*across), part(stripes, -axial[1]),
        float(np.corrcoef(stripes, -axial[1])[0, 1]),
        rms(pore[1]), rms(pore[0] - pore[1]),
    ]  # fmt: skip


def run(barreno, full):
    result = Result(
        "Pore pressures that alternate from particle to particle",
        "With GIMP the axial strain of a cell is the same for both particles in it, while the radial and hoop strains follow the wave. "
        "Where these nearly cancel, as in a wave that hardly changes the "
        "volume of saturated rock, the rest is a volume strain that alternates from particle to particle. The grid does not feel it, and "
        "the stiff fluid makes it a pressure. Quadratic B-splines have none.",
        "a smooth field: the difference of the two particles of a cell is half of the change from cell to cell.",
        ["run", "time [us]", "axial strain", "radial and hoop", "alternating volume strain over the missing axial", "their correlation",
            "smooth part of the pore pressure [MPa]", "alternating part [MPa]"],
        [],
    )
    for name in RUNS if full else CHEAP:
        shot = run_deck(barreno, DECK, {**RUNS[name], "Time/End Time": f"{TIMES[-1]} us", "Output/Field Interval": "10 us"})
        start, steps = shot.particles(0), [int(np.abs(shot.times() - 1e-6 * time).argmin()) for time in TIMES]
        result.rows += [row(name, start, shot.particles(step)) for step in steps]
    of = lambda name, column: [found[column] for found in result.rows if found[0] == name]  # noqa: E731
    ratios = {name: [rough / smooth for rough, smooth in zip(of(name, 7), of(name, 6))]
        for name in dict.fromkeys(found[0] for found in result.rows)}
    result.demand("GIMP, sealed: part of the axial strain's slope that the particles of a cell have", max(of("GIMP, sealed", 2)), 0.3)
    result.demand("GIMP, sealed: part of the radial and hoop strains' slope that they have", min(of("GIMP, sealed", 3)), 0.9, at_least=True)
    result.demand("GIMP, sealed: correlation of the alternating volume strain with the missing axial strain", min(of("GIMP, sealed", 5)),
        0.95, at_least=True)
    result.demand("GIMP, sealed: alternating over smooth part of the pore pressure: it is no effect of the flow",
        min(ratios["GIMP, sealed"]), 2.0, at_least=True)
    result.demand("quadratic B-spline: alternating over smooth part of the pore pressure", max(ratios["quadratic B-spline"]), 0.2)
    result.notes = (
        "Strains: part of the slope that the two particles of a cell have between them, 1 where a field is smooth, 0 where a cell has one "
        "value. A "
        "solve of the pore flow evens the pressures of a cell by moving fluid from one particle to the other (7.4), at the state that "
        "the wave happens to have then. For a later state that fluid is in the wrong place, and there can be more stripes than in "
        "sealed rock, or fewer. "
        "Solves that follow the wave (`Diffusion Number`) keep them small. The flow between cells sees their means only."
    )
    return result
