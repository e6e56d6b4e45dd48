# SPDX-License-Identifier: BSD-3-Clause
"""Hole of the main job against pressures, from depth_shots.json of verification/results: a part of docs/paper.md and its picture."""
import math

from tools.case_list import DOCS
from tools.depth_shots import BARE, SHOTS, TIMES
from tools.depth_shots_table import APART, deviation, repeats, shots
from tools.verification_pages import table

PICTURE = DOCS / "pictures" / "shot_stress.png"
DECK, WET, RAISED = "the deck", "wet rock", "wet rock, both pressures higher by 35 MPa"
DECK_MPA = 69.0  # 10 ksi
KSI = 6.894757  # MPa
# Harvey, Grove and Zhan, SPE 151846 (2012). Seen, in the abstract: an exponential of strength, porosity, overburden and pore pressure.
# Recalled: the index UCS + b Pc of dry rock [psi], b, and the slope of ln(depth).
STRENGTH = 78.0 / KSI  # ksi, of the card
SLOPES = (0.04, 0.08)  # per ksi
FALL, MOST_COLLAPSE = (0.15, 0.40), 0.03
SIZES = {"as wide as the jet": ("wide_depth", 1e3), "tip": ("tip", 1e3), "volume": ("channel_volume", 1e6),
    "core flow efficiency": ("efficiency", 1.0)}  # fmt: skip


def pressures(shot):
    """Confining and pore pressure of a shot of the deck [MPa]."""
    entries = SHOTS[shot][0]
    given = entries.get("Confinement/Pressure", f"{DECK_MPA} MPa")
    confining = 0.0 if BARE.items() <= entries.items() else float(given.removesuffix(" MPa"))
    return confining, float(entries.get("Bodies/Rock/Pore Pressure", "0 Pa").removesuffix(" MPa").removesuffix(" Pa"))


def value_of(one, name):
    key, factor = SIZES[name]
    return factor * (one["depth"][-1] if key == "tip" else one[key])


def dry_shots():
    """{cells: {confining pressure: what was measured}}"""
    found, by_cells = shots(), {}
    for shot in (DECK, *(name for name in SHOTS if name == "no confinement" or name.startswith("confinement of"))):
        for cells, one in found.get(shot, {}).items():
            by_cells.setdefault(cells, {})[pressures(shot)[0]] = one
    return {cells: dict(sorted(runs.items())) for cells, runs in sorted(by_cells.items()) if {0.0, DECK_MPA} <= set(runs)}


def recalled(confining, slope):
    """Depth over that without confinement."""
    factor = 0.7336 - 1.813e-5 * 1e3 * STRENGTH
    return math.exp(-slope * factor * confining / KSI)


def row_of(words, cells, confining, pore, one):
    values = [f"{value_of(one, name):.{0 if factor == 1e3 else 1 if factor == 1e6 else 2}f}" for name, (_, factor) in SIZES.items()]
    return [words, f"{cells:g}", f"{confining:g}", f"{pore:g}", *values]


def rows():
    found = [row_of("dry", cells, confining, 0.0, one) for cells, runs in dry_shots().items() for confining, one in runs.items()]
    wet = shots()
    for shot in (WET, RAISED):
        found += [row_of("wet, undrained", cells, *pressures(shot), one) for cells, one in wet.get(shot, {}).items()]
    return found


def trends():
    """[what, cells, measured, wanted, whether it holds]"""
    found, lines = shots(), []
    for cells, runs in dry_shots().items():
        depths = {confining: value_of(one, "as wide as the jet") for confining, one in runs.items()}
        fall = 1.0 - depths[DECK_MPA] / depths[0.0]
        lines.append(["fall of the depth from 0 to 69 MPa", cells, fall, "0.15 to 0.40", FALL[0] <= fall <= FALL[1]])
        steps = [before - after for before, after in zip(list(depths.values()), list(depths.values())[1:])]
        least, noise = min(steps) / depths[0.0], APART * max(deviation(several, "probed depth", 400) for several in repeats().values())
        lines.append(["least fall from one pressure to the next, over the depth at 0", cells, least, f"at least -{noise:.2f}, the scatter",
            least >= -noise])  # fmt: skip
        highest = max(depths)
        if highest > DECK_MPA:
            beyond = (depths[DECK_MPA] - depths[highest]) / (highest - DECK_MPA) / ((depths[0.0] - depths[DECK_MPA]) / DECK_MPA)
            lines.append([f"slope from 69 to {highest:g} MPa over that from 0 to 69", cells, beyond, "below 1", beyond < 1.0])
    for cells in sorted(set(found.get(WET, {})) & set(found[DECK])):
        ratio = value_of(found[WET][cells], "as wide as the jet") / value_of(found[DECK][cells], "as wide as the jet")
        lines.append(["depth in wet, undrained rock over dry, 69 MPa", cells, ratio, "above 1", ratio > 1.0])
    for cells in sorted(set(found.get(WET, {})) & set(found.get(RAISED, {}))):
        ratio = value_of(found[RAISED][cells], "as wide as the jet") / value_of(found[WET][cells], "as wide as the jet")
        lines.append(["depth in wet rock, both pressures higher by 35 MPa, over that before", cells, ratio, "1 within 0.03",
            abs(ratio - 1.0) <= MOST_COLLAPSE])  # fmt: skip
    return lines


def fall(bare, held, what, time=None):
    """Of a depth, from no confinement to 69 MPa; of the tip at one of TIMES."""
    if what == "tip":
        at = TIMES.index(time)
        return 1.0 - held["depth"][at] / bare["depth"][at]
    return 1.0 - held["wide_depth"] / bare["wide_depth"]


def factors():
    """The fall by what may hide it: the time, what is called the depth, and the card of the rock."""
    found, lines = shots(), []
    for rock, (bare, held, end) in {"berea_sandstone_heat": ("no confinement", DECK, 400),
            "berea_sandstone_bounded": ("former rock, no confinement", "former rock", 300)}.items():  # fmt: skip
        for cells in sorted(set(found[bare]) & set(found[held])):
            ends = found[bare][cells], found[held][cells]
            falls = [fall(*ends, "tip", 60), fall(*ends, "tip", 120), fall(*ends, "tip", end), fall(*ends, "wide")]
            lines.append([f"`{rock}`", f"{cells:g}", *(f"{100 * -one:+.1f} %" for one in falls)])
    return table(["rock", "cells per radius", "tip, 60 us", "tip, 120 us", "tip at the end", "as wide as the jet at the end"], lines)


def lines():
    head = ["rock", "cells per radius", "confining [MPa]", "pore [MPa]", "as wide as the jet [mm]", "tip [mm]", "volume [cm3]",
        "core flow efficiency"]  # fmt: skip
    judged = [[what, f"{cells:g}", f"{value:.3f}", wanted, "holds" if holds else "does not hold"]
        for what, cells, value, wanted, holds in trends()]  # fmt: skip
    trend = ["trend, of the hole as wide as the jet", "cells per radius", "measured", "wanted", "verdict"]
    return [f"After {TIMES[-1]} us:", "", *table(head, rows()), "", *table(trend, judged)]


def draw():
    """Depth against confinement, over that without, beside the recalled law."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7.0, 3.6))
    for cells, runs in dry_shots().items():
        depths = {confining: value_of(one, "as wide as the jet") for confining, one in runs.items()}
        axes.plot(list(depths), [depth / depths[0.0] for depth in depths.values()], "o-",
            label=f"as wide as the jet, {cells:g} cells per radius")  # fmt: skip
    across = [5.0 * i for i in range(29)]
    axes.fill_between(across, *([recalled(at, slope) for at in across] for slope in SLOPES), color="0.85",
        label="Harvey, Grove and Zhan (2012), constants recalled")  # fmt: skip
    axes.set(xlabel="confining pressure [MPa]", ylabel="depth over that without", ylim=(0.4, 1.1))
    axes.legend(fontsize=7, loc="lower left")
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=100)
    plt.close(figure)
