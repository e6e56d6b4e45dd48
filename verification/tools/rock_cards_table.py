# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/materials/arenisca.md: the main job with each part of the rock's law."""
import json

from tools.case_list import RESULTS
from tools.depth_shots import FORMER, ROCK, WET
from tools.verification_pages import table

STORED = RESULTS / "rock_cards.json"
LOST = {"Step/Return Losses": "false"}
RETURNED = {"Step/Return Losses": "true"}
HEATED = "`berea_sandstone_heat`: all of it, and heat (the main job)"
BOUNDED = "`berea_sandstone_bounded`: bounded dilatancy"
STAYS = {"Materials/Sandstone/Broken dilatancy": "0"}
ROWS = {  # what differs from the main job
    "`berea_sandstone`: as published": {**FORMER, ROCK: "berea_sandstone.xml"},
    BOUNDED: FORMER,
    "`berea_sandstone_damage`: damage too": {**FORMER, ROCK: "berea_sandstone_damage.xml"},
    "`berea_sandstone_shock`: bounded dilatancy, limit, stiffening": {**FORMER, ROCK: "berea_sandstone_shock.xml"},
    HEATED: LOST,
    "the same, losses returned to metals and rock": RETURNED,
    "the same, broken rock that does not dilate": {**STAYS, **LOST},
    "`berea_sandstone_cracks`: a bound on tension too": {ROCK: "berea_sandstone_cracks.xml", **LOST},
    "`berea_sandstone_heat_wet`: pores full of water": {**WET, **LOST},
}


def row(name, one):
    zones = one["zones_in_body"].get("Rock", {})
    crushed = f"{1e3 * zones['crushed_to']:.1f}" if "crushed_to" in zones else "none"
    skin = f"{zones['skin']:.1f}" if "skin" in zones else ""
    return [
        name, f"{1e3 * one['depth']:.0f}", f"{1e3 * one['probed_depth']:.0f}", f"{1e6 * one['channel_volume']:.1f}", crushed, skin,
        f"{100.0 * one['lost']:.1f} %", f"{one['steps']}", f"{one['cpu_seconds']:.0f}",
    ]  # fmt: skip


def lines():
    found = json.loads(STORED.read_text())
    head = ["card", "tip [mm]", "as wide as the jet [mm]", "volume [cm3]", "crushed to [mm]", "skin", "lost by the method", "steps",
        "processor time [s]"]  # fmt: skip
    return table(head, [row(name, one) for name, one in found.items()])
