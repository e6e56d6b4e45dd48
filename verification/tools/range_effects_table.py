# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/materials/arenisca.md: the main job at both ends of every range of the rock's card."""
import json

from tools.case_list import RESULTS
from tools.verification_pages import table

STORED = RESULTS / "range_effects.json"


def crushed(answers):
    return answers["zones_in_body"].get("Rock", {}).get("crushed_to")


COLUMNS = {  # name: (what of a run's answers, factor, format)
    "tip [mm]": (lambda one: one["depth"], 1e3, ".0f"),
    "as wide as the jet [mm]": (lambda one: one["probed_depth"], 1e3, ".0f"),
    "volume [cm3]": (lambda one: one["channel_volume"], 1e6, ".1f"),
    "crushed to [mm]": (crushed, 1e3, ".1f"),
}


def shown(value, factor, form):
    return "none" if value is None else f"{factor * value:{form}}"


def ends(row):
    """Both ends of each answer."""
    return [" to ".join(shown(of(row[end]), factor, form) for end in ("at_low", "at_high")) for of, factor, form in COLUMNS.values()]


def change(row, middle):
    """The larger of both changes of the volume, by which the rows are sorted."""
    return max(abs(row[end]["channel_volume"] - middle["channel_volume"]) for end in ("at_low", "at_high"))


def lines():
    found = json.loads(STORED.read_text())
    middle = found["middle"]
    card = [shown(of(middle), factor, form) for of, factor, form in COLUMNS.values()]
    rows = sorted(found["rows"], key=lambda row: -change(row, middle))
    shown_rows = [[f"`{row['parameter']}`", f"{row['low']} to {row['high']}", row["known"], *ends(row)] for row in rows]
    return table(["parameter", "range", "known", *COLUMNS], [["(the card)", "", "", *card], *shown_rows])
