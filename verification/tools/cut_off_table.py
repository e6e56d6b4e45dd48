# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/jets.md: when the hole of the main job stops growing, and which slugs arrive then."""
import json

from tools.case_list import RESULTS
from tools.depth_shots import ROCK
from tools.verification_pages import table

STORED = RESULTS / "cut_off.json"
END = "600 us"
GROWTH = 0.001  # what is still to come, where a hole counts as one that has stopped growing
ROWS = {
    "`berea_sandstone_bounded`": {ROCK: "berea_sandstone_bounded.xml"},
    "`berea_sandstone_heat`, losses returned": {"Step/Return Losses": "true"},
}
HEAD = ["card of the rock", "as wide as the jet [mm]", "not more after [us]", "its volume [cm3]", "not more after [us]",
    "slug that arrives then [km/s]", "of the tip's velocity", "tip [mm]", "not more after [us]"]  # fmt: skip


def row(name, one):
    return [
        name, f"{1e3 * one['probed_depth']:.0f}", f"{1e6 * one['time_of_probed_depth']:.0f}", f"{1e6 * one['probed_volume']:.1f}",
        f"{1e6 * one['time_of_probed_volume']:.0f}", f"{1e-3 * one['slug']:.2f}", f"{one['slug'] / one['fastest']:.2f}",
        f"{1e3 * one['depth']:.0f}", f"{1e6 * one['time_of_depth']:.0f}",
    ]  # fmt: skip


def lines():
    return table(HEAD, [row(name, one) for name, one in json.loads(STORED.read_text()).items()])
