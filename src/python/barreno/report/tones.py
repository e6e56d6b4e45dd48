# SPDX-License-Identifier: BSD-3-Clause
"""Colours of materials: a material has one colour in every picture of a page, and in the pages of other runs."""

import zlib

JET = "#d62728"
RUBBLE = "#cbb58e"
VOID = "#e3ebf1"  # unlike the ends and the middles of the colours of fields
WITHOUT = "0.75"  # a material that does not carry the field
KINDS = {
    "rock": ("#7a3b00", "#a8641f", "#4f5d1d"), "metal": ("#111111", "#4a4e69", "#5f5f5f"), "liquid": ("#0b6fb8", "#005f73", "#2a9df4"),
    "explosive": ("#e07a00", "#c9184a", "#b08900"), "other": ("#5a189a", "#386641", "#b5179e"),
}  # fmt: skip
MODELS = {"Arenisca": "rock", "Poroelastic": "rock", "Johnson-Cook": "metal", "Steinberg": "metal", "Liquid": "liquid", "JWL": "explosive"}


def kind_of(deck, name):
    """Which of KINDS a material is, after the model of its card."""
    model = deck.text(f"Materials/{name}/Model")
    return next((kind for start, kind in MODELS.items() if model.startswith(start)), "other")


def tones_of(deck, names):
    """{material: colour}. The kind of its model gives the family and its name the place in it; of two materials with one place the later
    name in the alphabet moves on. A launched jet is red."""
    jet, found = deck.text("Jet/Material"), {}
    for name in sorted(names):
        family = KINDS[kind_of(deck, name)]
        first = zlib.crc32(name.encode()) % len(family)
        order = [*family[first:], *family[:first]]
        found[name] = JET if name == jet else next((tone for tone in order if tone not in found.values()), order[0])
    return found
