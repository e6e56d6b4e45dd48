# SPDX-License-Identifier: BSD-3-Clause
"""Cards: read for a start, shortened for a test, written with what is known of each parameter."""

import pathlib
import re
import xml.etree.ElementTree as xml

from barreno import places
from barreno.fit import units
from barreno.fit.parameters import DIMENSION_OF
from barreno.runs.faults import FILE, Fault

DEFAULTS = {"YSLOPE": 0.0, "STREN": 0.0, "BETA_nonassociativity": 1.0, "CR": 0.5}  # of parameters that a card may leave out
HEAD = {"Schema Version": 1, "Units": "SI", "Model": "Arenisca"}
# A test is slow, on dry or drained rock of mean strength: what a card says beyond that has no part in it.
NOT_IN_TESTS = ("fluid_B0", "Fluid stiffening", "fluid_pressure_initial", "Matrix bulk modulus", "T1_rate_dependence", "T2_rate_dependence",
                "Weibull modulus", "Weibull reference volume", "Weibull seed", "Weibull volume", "Weibull scatter")  # fmt: skip
TOLERANCE = 1e-5  # of the stress update while a fit differentiates its answers


def find(name):
    """A card by path, or by name among those that Barreno comes with."""
    cards = places.cards()
    for file in [pathlib.Path(name), *([cards / f"{name.lower().removesuffix('.xml')}.xml"] if cards else [])]:
        if file.is_file():
            return file
    raise Fault(f"{name} is neither a file nor the name of a card; check the path of --start.", FILE)


def read(name):
    """{parameter: value} of an Arenisca card, SI."""
    file = find(name)
    try:
        root = xml.parse(file).getroot()
    except (xml.ParseError, OSError, UnicodeDecodeError) as error:
        raise Fault(f"{file} cannot be read as a card ({error}); check it with barreno drive.", FILE) from None
    card = dict(HEAD)
    for entry in root.iter("Parameter"):
        card[entry.get("name")] = entry.get("value", "")
    if card["Model"] != "Arenisca" or card["Units"] != "SI":
        raise Fault(f"{file} is a card of {card['Model']} in {card['Units']} units; --start needs one of Arenisca in SI.")
    card.update({key: value for key, value in DEFAULTS.items() if key not in card})
    for key, dimension in DIMENSION_OF.items():
        if key in card:
            card[key] = units.quantity(str(card[key]), dimension, f"{file}, '{key}'", plain=True)
    return card


def entry(name, value):
    kind = "string" if isinstance(value, str) and not re.fullmatch(r"[-+]?[\d.]+([eE][-+]?\d+)?", value) else "double"
    if name in ("Schema Version",):
        kind = "int"
    text = f"{value:.12g}" if isinstance(value, float) else str(value)
    return f'  <Parameter name="{name}" type="{kind}" value="{text}"/>'


def text_of(card):
    return "\n".join(['<ParameterList name="Fit">', *(entry(*item) for item in card.items()), "</ParameterList>\n"])


def in_a_test(card, **more):
    """The card as a slow test on dry rock meets it."""
    return {**{name: value for name, value in card.items() if name not in NOT_IN_TESTS}, **more}


def comment(text, indent="  "):
    """As XML allows it, in lines of readable length."""
    words, lines, line = text.replace("--", "- -").split(), [], f"{indent}<!--"
    for word in words:
        if len(line) + len(word) > 118:
            lines.append(line)
            line = f"{indent}    "
        line += " " + word
    return "\n".join([*lines, line + " -->"])


def written(name, card, head, about):
    """The text of a card: head is a list of comments, about a comment for some parameters."""
    parts = [comment(text, "") for text in head] + [f'<ParameterList name="{name}">']
    for key, value in card.items():
        if key in about:
            parts.append(comment(about[key]))
        parts.append(entry(key, value))
    return "\n".join([*parts, "</ParameterList>\n"])
