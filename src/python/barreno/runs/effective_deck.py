# SPDX-License-Identifier: BSD-3-Clause
"""The text of an effective deck (deck.xml, `barreno check --print-deck`): every value that is used, in SI."""

import xml.etree.ElementTree as xml

from barreno.runs.faults import FILE, Fault

DEEPEST = 40  # lists in lists; a deck has five


def find_list(deck, path):
    """The element of a list, or None."""
    node = xml.fromstring(deck)
    for name in filter(None, path.split("/")):
        node = next((child for child in node if child.tag == "ParameterList" and child.get("name") == name), None)
        if node is None:
            return None
    return node


def lists_in(deck, path):
    """Names of the lists inside a list; none where there is no such list."""
    node = find_list(deck, path)
    return [child.get("name") for child in (() if node is None else node) if child.tag == "ParameterList"]


def value_in(deck, path):
    """Text of a parameter, or None."""
    owner, _, name = path.rpartition("/")
    node = find_list(deck, owner)
    return next((child.get("value") for child in (() if node is None else node) if child.tag == "Parameter" and child.get("name") == name),
        None)


def values_of(node, path=""):
    """{path: text} of all parameters in an element and in the lists in it."""
    found = {}
    if path.count("/") > DEEPEST:
        raise ValueError(f"its lists are nested more than {DEEPEST} times")
    for child in node:
        name = child.get("name", "")
        whole = f"{path}/{name}" if path else name
        if child.tag == "ParameterList":
            found.update(values_of(child, whole))
        else:
            found[whole] = child.get("value", "")
    return found


def all_values(deck, file="deck.xml"):
    """@param file  that a sentence names"""
    try:
        return values_of(xml.fromstring(deck))
    except (xml.ParseError, ValueError, RecursionError) as error:
        raise Fault(f"{file} is not a deck ({error}); make the run again.", FILE) from None
