# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/materials/arenisca.md: the main job at both ends of every range of the rock's card."""
import json

from tools.case_list import RESULTS
from tools.verification_pages import table

STORED = RESULTS / "range_effects.json"
STRENGTH = ("STREN", "YSLOPE", "Strength limit")
OF_THE_JOB = "berea_sandstone_heat"  # the card of perforation.xml


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


def changes(row, middle, name):
    """Of an answer at both ends, over that of the card."""
    return [row[end][name] / middle[name] - 1.0 for end in ("at_low", "at_high")]


def largest(row, middle, name="channel_volume"):
    return max(map(abs, changes(row, middle, name)))


def sentence(rows, middle):
    """What decides, and how little the rest does."""
    words = []
    strongest = rows[:2]
    for row in strongest:
        tip, volume = (" and ".join(f"{100.0 * one:+.0f}" for one in changes(row, middle, name)) for name in ("depth", "channel_volume"))
        words.append(f"`{row['parameter']}` changes the tip by {tip} %, the volume by {volume} % (low and high end)")
    tip, volume = (100.0 * max(largest(row, middle, name) for row in rows[2:]) for name in ("depth", "channel_volume"))
    of_strength = all(row["parameter"] in STRENGTH for row in strongest)
    begin = "Strength at high pressure decides" if of_strength else "These decide"
    return f"{begin}: {'; '.join(words)}. No other range changes the tip by more than {tip:.1f} %, " \
        f"or the volume by more than {volume:.0f} %."


def cards():
    """{card: {middle, rows}} of those that were measured, the rows that change the volume most first."""
    found = json.loads(STORED.read_text())
    return {card: {**one, "rows": sorted(one["rows"], key=lambda row: -largest(row, one["middle"]))} for card, one in found.items()}


def lines():
    return [line for card, found in cards().items() for line in [heading(card, found), "", *card_lines(found), ""]][:-1]


def heading(card, found):
    return f"`{card}`{' (the main job)' if card == OF_THE_JOB else ''}" + (f", to {found['until']}:" if found.get("until") else ":")


def card_lines(found):
    middle, rows = found["middle"], found["rows"]
    card = [shown(of(middle), factor, form) for of, factor, form in COLUMNS.values()]
    shown_rows = [[f"`{row['parameter']}`", f"{row['low']} to {row['high']}", row["known"], *ends(row)] for row in rows]
    return [*table(["parameter", "range", "known", *COLUMNS], [["(the card)", "", "", *card], *shown_rows]), "", sentence(rows, middle)]
