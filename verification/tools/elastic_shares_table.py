# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/output.md: elastic energy of the main job by material."""
import json

from tools import rock_cards_table
from tools.case_list import RESULTS
from tools.verification_pages import table

STORED = RESULTS / "elastic_shares.json"
INTERVAL = 0.5  # between fields [us]
ROCK = "Materials/Sandstone/"
JOB, CONTROL = "the main job with `berea_sandstone_bounded`", "rock with the constant moduli of its grains"
PRESSED, WORD = "dilated rock with the moduli of its pressure", "Dilated moduli"
ROWS = {
    JOB: {},
    CONTROL: {ROCK + "B0": "35.34e9", ROCK + "B1": "0", ROCK + "G0": "26.505e9", ROCK + "G1": "0", ROCK + "G2": "0"},
    PRESSED: {ROCK + WORD: "pressure"},
}
HEAD = ["material", "elastic", "of the energy put in", "stored at the end", "given by heat", "given by moduli", "plastic", "viscous"]
METALS = ("Tungsten", "Steel")


def stored(own):
    return own["stored"] if "stored" in own else own["cold"] + own["shear"]


def kilo(energy):
    return f"{1e-3 * energy:+.2f}"


def given(own):
    """Work that came from nothing that was stored."""
    return stored(own) - own["elastic"]


def rows_of(one):
    rows = []
    for name, own in one["materials"].items():
        gifts = (given(own), 0.0) if name in METALS else (0.0, given(own))
        rows.append([name, kilo(own["elastic"]), f"{100.0 * own['elastic'] / one['put_in']:+.1f} %", kilo(stored(own)),
            *(kilo(gift) if gift else "" for gift in gifts), kilo(own["plastic"]), kilo(own["viscous"])])  # fmt: skip
    return rows


def lines():
    found = json.loads(STORED.read_text())
    job, control, pressed = found[JOB], found[CONTROL], found[PRESSED]
    rock, own = job["materials"]["Sandstone"], control["materials"]["Sandstone"]
    heat = sum(given(job["materials"][name]) for name in METALS)
    total = heat + given(rock)
    net, coarse = (rock["gained" + of] - rock["lost" + of] for of in ("", "_coarse"))
    return [
        *table(HEAD, rows_of(job)),
        "",
        f"Energies in kJ; {1e-3 * job['put_in']:.1f} kJ were put in. Work that nothing had stored is {1e-3 * total:.1f} kJ: "
        f"{100.0 * heat / total:.0f} % of it came from the heat of the metals, {100.0 * given(rock) / total:.0f} % from the moduli of the "
        f"rock. Rock that began to dilate under load gained {1e-3 * rock['gained']:.1f} kJ, and lost {1e-3 * rock['lost']:.1f} kJ where it "
        f"was compacted again: {1e-3 * net:.1f} kJ, as much as its moduli gave ({1e-3 * given(rock):.1f} kJ) within what fields every "
        f"{INTERVAL:g} us can tell ({1e-3 * coarse:.1f} kJ with every other field). Cycles of pressure and shear are not seen beside that; "
        f"one of every particle, to the highest pressure of its fields, would create at most {1e-3 * rock['one_cycle']:.1f} kJ.",
        "",
        f"The same shot with constant moduli of the rock ({control_words()}) ends with {kilo(own['elastic'])} kJ of the rock's elastic "
        f"energy and {kilo(stored(own))} kJ stored: moduli gave {kilo(given(own))} kJ.",
        "",
        *pressed_lines(pressed),
    ]


def pressed_lines(pressed):
    """What is left where dilation changes no moduli."""
    own, published = pressed["materials"]["Sandstone"], json.loads(rock_cards_table.STORED.read_text())[rock_cards_table.BOUNDED]
    answers, before = (
        "{:.0f} mm, the hole as wide as the jet to {:.0f} mm, its volume {:.1f} cm3".format(
            1e3 * one["depth"], 1e3 * one["probed_depth"], 1e6 * one["channel_volume"]
        )
        for one in (pressed, published)
    )
    return [
        f"With `Dilated moduli` = `pressure` dilated rock keeps the moduli of its pressure, and the onset of dilation creates nothing "
        f"([closed_cycles](verification/closed_cycles.md)). The rock of the shot then ends with {kilo(own['elastic'])} kJ and "
        f"{kilo(stored(own))} kJ stored: moduli gave {kilo(given(own))} kJ. The tip is at {answers}; as published: {before}.",
    ]


def control_words():
    bulk, shear = (float(ROWS[CONTROL][ROCK + name]) / 1e9 for name in ("B0", "G0"))
    return f"K of {bulk:.1f} GPa, G of {shear:.1f} GPa"
