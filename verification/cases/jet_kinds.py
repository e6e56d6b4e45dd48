# SPDX-License-Identifier: BSD-3-Clause
"""One jet as discrete, thinned and continuous: depths in a target without strength against the hydrodynamic rule, and in rock."""
import math

from tools.case import Result
from tools.penetration import depth_at
from tools.runs import run_deck

KINDS = ("discrete", "continuous", "thinned")
ALPHA = 1.5  # of copper_two_thirds.csv: full over mean density
RULE = {"discrete": 1.0, "continuous": math.sqrt(2.0 * ALPHA - 1.0), "thinned": ALPHA}
LENGTH = 72.0  # of the whole jet [mm]
TIMES = (10, 20, 30, 50)  # of the shot to 120 us [us]


def hydrodynamic_depth(kind):
    """Over the length of the whole jet, into a target of the metal's density: sqrt(rho_j / rho_t), and sqrt(2 alpha - 1) / alpha of a
    continuous jet."""
    return RULE[kind] / ALPHA


def anomalies(run):
    """Particles stretched, ejected, clipped, of all materials, and those that were removed."""
    counts = run.summary["kinematic_anomalies"]["materials"].values()
    removed = sum(cause["count"] for cause in run.summary["removed_particles"].values())
    return [sum(one[word] for one in counts) for word in ("stretched", "ejected", "clipped")] + [removed]


def launched_error(run):
    """Greatest difference of launched mass, momentum and energy to the table's."""
    return max(abs(run.summary["jet"][word]["difference"]) for word in ("mass", "momentum", "kinetic"))


def row_of(name, kind, h, run, depths):
    return [name, kind, h, *depths, *anomalies(run)]


def without_strength(barreno, result, h):
    """Depths of the three kinds [mm] when all of the jet has been consumed."""
    depths = {}
    for kind in KINDS:
        run = run_deck(barreno, "jet_import_kinds.xml", {"Jet/Kind": kind, "Grid/Cell Size": f"{h} mm"})
        depths[kind] = 1e3 * run.summary["penetration"]["depth"]
        result.rows.append(row_of("without strength", kind, h, run,
            [depths[kind]] + [1e3 * depth_at(run, 1e-6 * t) for t in (10, 20, 30)] + [""]))
        result.demand(f"{kind}, {h:g} mm: launched over the table's mass, momentum and energy, less 1", launched_error(run), 1e-9)
        result.demand(f"{kind}, {h:g} mm: ledger remainder", abs(run.summary["balances"]["energy"]["error"]), 1e-3)
    for kind in KINDS[1:]:  # whole jets: what the rule gives for a target of the jet's own density
        exact = LENGTH * hydrodynamic_depth(kind)
        result.demand(f"{kind}, {h:g} mm: depth against the hydrodynamic {exact:.1f} mm", abs(depths[kind] / exact - 1.0), 0.1)
    ratio, rule = depths["thinned"] / depths["continuous"], RULE["thinned"] / RULE["continuous"]
    result.demand(f"thinned over continuous, {h:g} mm: depth ratio against the rule's {rule:.3f}", abs(ratio / rule - 1.0), 0.05)
    ratio = depths["continuous"] / depths["discrete"]
    result.demand(f"continuous over discrete, {h:g} mm: depth ratio against the rule's {RULE['continuous']:.3f}",
        abs(ratio / RULE["continuous"] - 1.0), 0.1)


def main_job(barreno, result):
    """perforation_120us.xml to 50 us in the three kinds."""
    for kind in KINDS:
        settings = {"Jet/Kind": kind, "Time/End Time": "50 us", "Output/Field Interval": "50 us"}
        if kind == "continuous":
            settings["Materials/Tungsten/Expansion Strain"] = "on"
        run = run_deck(barreno, "perforation_120us.xml", settings)
        depths = [1e3 * run.summary["penetration"]["depth"]] + [1e3 * depth_at(run, 1e-6 * t)
            for t in TIMES[:3]] + [1e3 * depth_at(run, 50e-6)]
        result.rows.append(row_of("shot to 120 us", kind, 1.0, run, depths))
        result.demand(f"shot to 120 us, {kind}: launched over the table's mass, momentum and energy, less 1", launched_error(run), 1e-9)
        result.demand(f"shot to 120 us, {kind}: ledger remainder", abs(run.summary["balances"]["energy"]["error"]), 1e-3)


def run(barreno, full):
    result = Result(
        "Kinds of a jet",
        "One jet table has its voids as gaps, as a smaller radius or as an expansion strain. Mass, momentum and energy are the same, and "
        "depths follow the hydrodynamic rule.",
        "Hydrodynamic depths, discrete : continuous : thinned = 1 : sqrt(2 alpha - 1) : alpha, alpha = full over mean density "
        "(docs/jets.md).",
        ["job", "kind", "cell [mm]", "final depth [mm]", "depth at 10 us [mm]", "depth at 20 us [mm]", "depth at 30 us [mm]",
         "depth at 50 us [mm]", "particles stretched", "ejected", "clipped", "removed"],
        [],
    )  # fmt: skip
    without_strength(barreno, result, 1.0)
    if full:
        main_job(barreno, result)
    result.notes = (
        "A target without strength does not stop: its hole goes on growing in the gaps of the discrete jet. The discrete jet therefore "
        "digs deeper than the rule, and would with longer slugs, too. "
        "The rule of the discrete jet holds where the target comes to rest in the gaps. The two whole kinds "
        "are those of the rule. In the shot to 120 us, whose rock has strength, all kinds carry the same momentum and energy. The "
        "particles counted are those of kinematic_anomalies in summary.json at the end, and those that have been removed. Until the end "
        "the jet's tip digs, which is nearly full of metal, and the grid does not see a gap that is shorter than a cell. In cells as wide "
        "as the "
        "jet's radius the three depths therefore hardly differ."
    )
    return result
