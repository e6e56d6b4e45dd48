# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/materials/arenisca.md: the main job with each part of the rock's law."""
import json

from tools.case_list import RESULTS
from tools.depth_shots import WET
from tools.verification_pages import table

STORED = RESULTS / "rock_cards.json"
CARD = "Materials/Sandstone/Card"
RETURNED = {"Step/Return Losses": "true"}
MAIN_JOB = "`berea_sandstone_bounded`: bounded dilatancy (the main job)"
ROWS = {  # what differs from the main job
    "`berea_sandstone`: as published": {CARD: "berea_sandstone.xml"},
    MAIN_JOB: {},
    "`berea_sandstone_bounded`, losses returned to metals": {"Materials/Sandstone/Specific heat": "0", **RETURNED},
    "`berea_sandstone_bounded`, losses returned to metals and rock": RETURNED,
    "the same, pores full of water": {**WET, **RETURNED},
    "`berea_sandstone_damage`: damage too": {CARD: "berea_sandstone_damage.xml"},
    "`berea_sandstone_shock`: bounded dilatancy, limit, stiffening": {CARD: "berea_sandstone_shock.xml"},
    "`berea_sandstone_heat`: all, and heat": {CARD: "berea_sandstone_heat.xml"},
    "`berea_sandstone_heat`, losses returned to metals and rock": {CARD: "berea_sandstone_heat.xml", **RETURNED},
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
