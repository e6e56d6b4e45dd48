# SPDX-License-Identifier: BSD-3-Clause
"""Ranges that nobody gave: of the cards of a deck, of its jet and of its pressures."""

import json
import os
import pathlib
import xml.etree.ElementTree as xml

from barreno import places
from barreno.runs.effective_deck import lists_in, value_in
from barreno.runs.faults import FILE, Fault
from barreno.runs.regular_file import read_text
from barreno.uncertainties.decks import FACTORS, RADIUS, VELOCITY
from barreno.uncertainties.ranges import Range, read_file

SHIPPED = "ranges"  # folder beside the cards
ASSUMED = {VELOCITY: 0.02, RADIUS: 0.05}  # half widths, relative; docs/uncertainty.md says so
ASSUMED_PRESSURE = 0.05
PRESSURES = ("Confinement/Pressure",)
PORE_PRESSURES = ("fluid_pressure_initial", "Initial Pore Pressure")  # of materials
ASSUMPTION = "no measurement stands behind it: give your own"


def cards_of(options):
    """{material: card} as the deck and --set name them."""
    try:
        root = xml.fromstring(read_text(pathlib.Path(options.deck)))
    except (xml.ParseError, ValueError):
        return {}  # the program has read it; what this reader cannot is left out
    found = {}
    for materials in root.findall("ParameterList[@name='Materials']"):
        for material in materials.findall("ParameterList"):
            for entry in material.findall("Parameter[@name='Card']"):
                found[material.get("name")] = entry.get("value", "")
    for setting in options.settings:
        path, _, value = setting.partition("=")
        parts = [part.strip() for part in path.split("/")]
        if len(parts) == 3 and parts[0] == "Materials" and parts[2] == "Card":
            found[parts[1]] = value.strip()
    return {material: card for material, card in found.items() if card}


def card_at(folder, card):
    """In exactly these letters, with or without ending; None if there is none."""
    return next((file for file in (folder / card, folder / f"{card}.xml") if file.exists() and not file.is_dir()), None)


def plain_name(name):
    """In small letters, and without the ending."""
    return name.lower().removesuffix(".xml")


def card_named(folder, card):
    """In exactly these letters, else in others."""
    exact = card_at(folder, card)
    if exact or not folder.is_dir():
        return exact
    return next((file for file in sorted(folder.glob("*.xml")) if plain_name(file.name) == plain_name(card)), None)


def find_card(card, deck):
    """The file of a card, by the rule of materials/src/find_card.cpp: beside the deck, in BARRENO_MATERIALS, among those that Barreno comes
    with; None where it is not found. The program says no more of a card than its name."""
    folders = [pathlib.Path(folder) for folder in os.environ.get("BARRENO_MATERIALS", "").split(":") if folder]
    folders += [places.cards()] if places.cards() else []
    beside = card_at(pathlib.Path(deck).parent, card)
    return beside or next(filter(None, (card_named(folder, card) for folder in folders)), None)


def fitted_ranges(file, material):
    """Of the numbers that fit writes beside a card."""
    try:
        parameters = json.loads(read_text(file))["parameters"]
        entries = [(entry["name"], entry["low"], entry["high"]) for entry in parameters if entry["low"] is not None]
        return [Range(f"Materials/{material}/{name}", f"{low:.6g}", f"{high:.6g}", "fitted", f"{file.name}, 95 % range",
            f'{file}, "{name}"') for name, low, high in entries]
    except (OSError, ValueError, LookupError, TypeError) as error:
        raise Fault(f"{file} does not hold the ranges that fit writes ({error}); make the card again with barreno fit, or move the "
            "file away.", FILE) from None


def is_of_fit(file):
    try:
        return '"cards_tried"' in read_text(file)
    except (OSError, ValueError):
        return False


def card_ranges(card, material, deck):
    """[] of a card whose ranges nobody has written down."""
    file = find_card(card, deck)
    if file is None:
        return []
    beside, shipped = file.with_suffix(".json"), file.parent / SHIPPED / f"{file.stem}.csv"
    if beside.is_file() and is_of_fit(beside):
        return fitted_ranges(beside, material)
    return read_file(shipped, f"Materials/{material}") if shipped.is_file() else []


def around(path, value, part, unit=""):
    low, high = f"{value * (1.0 - part):.4g}{unit}", f"{value * (1.0 + part):.4g}{unit}"
    return Range(path, low, high, "assumed", f"{100.0 * part:g} % to either side; {ASSUMPTION}", f'"{path}"')


def jet_ranges(base):
    return [around(path, 1.0, part) for path, part in ASSUMED.items()] if value_in(base, "Jet/Slugs") is not None else []


def pressure_ranges(base):
    paths = [*PRESSURES, *(f"Materials/{material}/{name}" for material in lists_in(base, "Materials") for name in PORE_PRESSURES)]
    found = []
    for path in paths:
        value = float(value_in(base, path) or 0.0)
        if value > 0.0:
            found.append(around(path, value / 1e6, ASSUMED_PRESSURE, " MPa"))
    return found


def known_ranges(options, base, say):
    """Of all that the deck uses; a card without ranges is named."""
    found = []
    for material, card in cards_of(options).items():
        ranges = card_ranges(card, material, options.deck)
        found += ranges
        if not ranges:
            say(f"{material} is held: no ranges of the card {card} are known (docs/uncertainty.md says where they are looked for).")
    return found + jet_ranges(base) + pressure_ranges(base)


def drop_changed(ranges, options, say):
    """A range of a card is about the card's value: a deck that has another one, or sets it, is left alone."""
    fixed = {setting.partition("=")[0].strip() for setting in options.settings}
    kept = []
    for one in ranges:
        if one.path in fixed:
            say(f"{one.path} is held: --set fixes it.")
        elif one.path not in FACTORS and (one.own is None or not one.low <= one.own <= one.high):
            own = "none" if one.own is None else format(one.own, "g")
            say(f"{one.path} is held: the deck's value {own} lies outside of the known "
                f"range, {one.text()}.")
        else:
            kept.append(one)
    return kept
