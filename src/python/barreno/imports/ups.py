# SPDX-License-Identifier: BSD-3-Clause
"""One element of an input file of Uintah (.ups), which keeps a record of what was read of the file: an element that was sought
by its name, an attribute, a text. What nobody read is listed in the end (unread.py)."""

import math
import re
import xml.etree.ElementTree as ElementTree

from barreno.runs.faults import Fault

MOST = 2e9  # of what is counted
LARGEST = 1e100  # of a property of a material
TEXT, ALL = "#text", "*"  # of the record, beside names of attributes; "" is the element itself


class Ups:
    """@param where  its path, for sentences  @param record  (element, what was read of it), shared by the whole file"""

    def __init__(self, element, where, record=None):
        self.element, self.where, self.record = element, where, set() if record is None else record

    @property
    def tag(self):
        return self.element.tag

    def mark(self, what=""):
        self.record |= {(self.element, ""), (self.element, what)}

    def cover(self):
        """A sentence tells of the whole element."""
        self.mark(ALL)

    def attribute(self, name):
        self.mark("@" + name)
        return self.element.get(name, "").strip()

    def attribute_number(self, name):
        """None without the attribute."""
        return to_number(self.attribute(name), f"{self.where}, {name}") if name in self.element.attrib else None

    def children(self, *tags):
        """Those of these names are read; without names it is a look that reads nothing."""
        found = [Ups(child, f"{self.where}/{child.tag}", self.record) for child in self.element if isinstance(child.tag, str)
            and (not tags or child.tag in tags)]
        for child in found if tags else ():
            child.mark()
        return found

    def find(self, *tags):
        """The first child of these names, or an empty element: what is sought in it is not there either."""
        for child in self.element:
            if child.tag in tags:
                found = Ups(child, f"{self.where}/{child.tag}", self.record)
                found.mark()
                return found
        return Ups(ElementTree.Element(tags[0]), f"{self.where}/{tags[0]}", self.record)

    def has(self, *tags):
        return any(child.tag in tags for child in self.element)

    def own_text(self):
        self.mark(TEXT)
        return (self.element.text or "").strip()

    def text(self, *tags, default=None):
        """Of the child of one of these names. @raises Fault if there is none and no default"""
        if not self.has(*tags):
            if default is None:
                raise Fault(f"{self.where} has no <{tags[0]}> (the deck needs it); add it.")
            return default
        return self.find(*tags).own_text()

    def number(self, *tags, default=None):
        if default is not None and not self.has(*tags):
            return float(default)
        return to_number(self.text(*tags), f"{self.where}/{tags[0]}")

    def index(self, *tags, default=None):
        """A whole number that counts something, -1 for what counts nothing."""
        value = self.number(*tags, default=default)
        return int(value) if 0.0 <= value < MOST and value == int(value) else -1

    def positive(self, *tags):
        value = self.number(*tags)
        if not 0.0 < value < LARGEST:
            raise Fault(f"{self.where}/{tags[0]} is {value:g}, which is not positive and finite; correct it.")
        return value

    def vector(self, *tags, default=None):
        """[x, y, z] as three numbers."""
        if default is not None and not self.has(*tags):
            return list(default)
        text = self.text(*tags)
        parts = re.fullmatch(r"\[(.*)\]", text, re.DOTALL)
        try:
            numbers = [float(part) for part in parts.group(1).split(",")] if parts else []
        except ValueError:
            numbers = []
        if len(numbers) != 3 or not all(map(math.isfinite, numbers)):
            raise Fault(f'{self.where}/{tags[0]} is "{" ".join(text.split())}", which is not a vector; write three numbers, for example '
                '[0.0, 1.0, 0.0].')
        return numbers

    def flag(self, *tags, default=False):
        return self.text(*tags, default=str(default)).lower() == "true"


def to_number(text, where):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if math.isnan(value):
        raise Fault(f'{where} is "{" ".join(text.split())}", which is not a number; write one, for example 1.5e-6.')
    return value
