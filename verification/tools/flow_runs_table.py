# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/flow.md: how much flows into whole holes, from flow_runs.json."""
import json
import statistics

from tools.case_list import RESULTS
from tools.verification_pages import table

DISTANCES = (1, 2, 3, 4, 6, 8, 10, 12, 14, 16)  # mm from the wall, as flow_runs.py keeps them
HALF = 1  # of the three depths
VIRGIN = 0.2  # porosity of the deck's rock
RINGS = ("0.5", "0.25")  # mm


def runs():
    """{cells: {courant: what was measured}}"""
    found = json.loads((RESULTS / "flow_runs.json").read_text())
    return {cells: dict(sorted(of.items(), reverse=True)) for cells, of in sorted(found.items(), key=lambda one: float(one[0]))}


def row(cells, courant, one):
    coarse, fine = (one["flow"][ring] for ring in RINGS)
    half = one["rock"][HALF]
    return [cells, courant, f"{1e3 * coarse['length']:.0f}", f"{coarse['whole']['efficiency']:.3f}",
        f"{coarse['broken']['efficiency']:.3f}", f"{coarse['broken']['skin']:.0f}", f"{fine['broken']['efficiency']:.3f}",
        f"{fine['broken']['skin']:.0f}", f"{half['skin']:.0f}", ", ".join(f"{1e3 * ring['impaired']:.1f}" for ring in one["rock"])]


def flow_runs():
    head = ["cells per radius", "Courant Fraction", "hole in rock [mm]", "CFE, grains whole", "CFE", "skin", "CFE, rings of 0.25 mm",
        "skin, the same", "skin half-way down", "impaired zone, three depths [mm]"]  # fmt: skip
    return table(head, [row(cells, courant, one) for cells, of in runs().items() for courant, one in of.items()])


def spread(values):
    """Half the range over the mean."""
    return 0.5 * (max(values) - min(values)) / statistics.mean(values)


def lost_pores(of):
    """Of runs with one size of cells: what has gone of the virgin porosity at all DISTANCES within the crushed zone, at all depths."""
    return [1.0 - porosity / VIRGIN for one in of.values() for ring in one["rock"]
        for distance, porosity in zip(DISTANCES, ring["porosity"]) if 1e-3 * distance <= ring["crushed"] and porosity < VIRGIN]  # fmt: skip


def sentences():
    """What runs that should agree differ by, and what the cells change."""
    found, lines = runs(), []
    for cells, of in found.items():
        whole_hole = [one["flow"]["0.5"]["broken"]["efficiency"] for one in of.values()]
        skins = [one["flow"]["0.5"]["broken"]["skin"] for one in of.values()]
        half = [one["rock"][HALF]["skin"] for one in of.values()]
        if len(of) == 1:
            lines.append(f"- {cells} cells per radius, one run: CFE {whole_hole[0]:.3f}, its skin {skins[0]:.0f}; the skin half-way down "
                f"{half[0]:.0f}.")  # fmt: skip
            continue
        lines.append(f"- {cells} cells per radius, {len(of)} runs that should agree: CFE {statistics.mean(whole_hole):.3f} +- "
            f"{spread(whole_hole):.0%}, its skin {statistics.mean(skins):.0f} +- {spread(skins):.0%}; the skin half-way down "
            f"{statistics.mean(half):.0f} +- {spread(half):.0%}.")  # fmt: skip
    means = [statistics.mean(one["flow"]["0.5"]["broken"]["efficiency"] for one in of.values()) for of in found.values()]
    zones = [1e3 * ring["impaired"] for of in found.values() for one in of.values() for ring in one["rock"]]
    least = {cells: min(min(ring["porosity"]) for one in of.values() for ring in one["rock"]) for cells, of in found.items()}
    lines.append(f"- The zone below 70 % of the virgin permeability is {min(zones):.0f} to {max(zones):.0f} mm thick, "
        f"{statistics.mean(zones):.1f} mm in the mean of all depths and runs.")  # fmt: skip
    lines.append("- The lowest porosity of a ring is " + ", ".join(f"{value:.3f} with {cells}" for cells, value in least.items())
        + " cells per radius.")  # fmt: skip
    for cells, of in found.items():
        lost = lost_pores(of)
        within = sum(0.1 <= part <= 0.5 for part in lost) / len(lost)
        lines.append(f"- {cells} cells per radius: crushed rock has lost {statistics.mean(lost):.0%} of its porosity in the mean, "
            f"{max(lost):.0%} at most; at {within:.0%} of the places it has lost 10 to 50 %, as measured.")  # fmt: skip
    for coarse, fine, before, after in zip(list(found), list(found)[1:], means, means[1:]):
        lines.append(f"- From {coarse} to {fine} cells per radius the CFE changes by {after / before - 1.0:+.0%}.")
    return lines


def flow_distances():
    """Rock half-way down against the distance from the wall: the mean of the runs of one size of cells."""
    head = ["cells per radius", "", *(f"{distance} mm" for distance in DISTANCES)]
    rows = []
    for cells, of in runs().items():
        for name, words in (("porosity", "porosity"), ("breakage", "breakage"), ("whole", "k / k_0, grains whole"),
                ("permeability", "k / k_0")):  # fmt: skip
            columns = zip(*(one["rock"][HALF][name] for one in of.values()))
            rows.append([cells, words, *(f"{statistics.mean(values):.2f}" for values in columns)])
    return table(head, rows)


def lines():
    return flow_runs() + ["", *sentences(), "", "Half-way down the hole, against the distance from the wall:", "", *flow_distances()]
