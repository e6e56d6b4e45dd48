# SPDX-License-Identifier: BSD-3-Clause
"""Input files of Uintah (.ups): elements with text in XML, and files that they include."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree

from barreno_runs.faults import FILE, Fault

MOST_INCLUDES = 100  # a file that includes itself


class Ups:
    """One element of the file. @param where  its path, for sentences"""

    def __init__(self, element, where):
        self.element, self.where = element, where

    @property
    def tag(self):
        return self.element.tag

    def attribute(self, name):
        return self.element.get(name, "").strip()

    def children(self, *tags):
        return [Ups(child, f"{self.where}/{child.tag}") for child in self.element if isinstance(child.tag, str) and (not tags or child.tag in tags)]

    def find(self, *tags):
        """The first child of these names, or an empty element: what is sought in it is not there either."""
        return next(iter(self.children(*tags)), Ups(ElementTree.Element(tags[0]), f"{self.where}/{tags[0]}"))

    def has(self, *tags):
        return any(child.tag in tags for child in self.element)

    def text(self, *tags, default=None):
        """Of the child of one of these names. @raises Fault if there is none and no default"""
        if not self.has(*tags):
            if default is None:
                raise Fault(f"{self.where} has no <{tags[0]}> (the deck needs it); add it.")
            return default
        return (self.find(*tags).element.text or "").strip()

    def number(self, *tags, default=None):
        text = self.text(*tags, default=None if default is None else str(default))
        try:
            return float(text)
        except ValueError:
            raise Fault(f'{self.where}/{tags[0]} is "{text}", which is not a number; write one, for example 1.5e-6.') from None

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
        if len(numbers) != 3:
            raise Fault(f'{self.where}/{tags[0]} is "{" ".join(text.split())}", which is not a vector; write three numbers, for example [0.0, 1.0, 0.0].')
        return numbers

    def flag(self, *tags, default=False):
        return self.text(*tags, default=str(default)).lower() == "true"


def parse(path):
    try:
        return ElementTree.parse(path).getroot()
    except OSError as error:
        raise Fault(f"{path} cannot be read ({error.strerror}); check the path.", FILE) from None
    except ElementTree.ParseError as error:
        raise Fault(f"{path} is not XML ({error}); correct it.") from None


def found_include(name, beside):
    """Beside the file or above it: Uintah resolves such names from the folder it is started in."""
    for folder in (beside, *beside.parents):
        if (folder / name).is_file():
            return folder / name
    raise Fault(f'{name} does not exist (named by an <include> in {beside}, and sought there and in the folders above); bring the file to its place.', FILE)


def insert_includes(element, beside, left):
    """Replaces every <include href="..."/> by what its file holds. @param left  how many more may come"""
    for position, child in reversed(list(enumerate(element))):
        if child.tag != "include":
            left = insert_includes(child, beside, left)
            continue
        if left == 0:
            raise Fault(f"more than {MOST_INCLUDES} files are included (one of them may include itself); remove the circle.")
        path = found_include(child.get("href", ""), beside)
        root = parse(path)
        left = insert_includes(root, path.resolve().parent, left - 1)
        # A file of one material constant is that element; others hold several in a root of their own.
        element[position : position + 1] = list(root) if root.tag in ("Uintah_Include", "Uintah_specification") else [root]
    return left


def read_ups(path):
    """@return the root of the file, with what it includes"""
    path = pathlib.Path(path)
    root = parse(path)
    if root.tag != "Uintah_specification":
        raise Fault(f"{path} begins with <{root.tag}>, not with <Uintah_specification> (it is no input file of Uintah); give another file.")
    insert_includes(root, path.resolve().parent, MOST_INCLUDES)
    return Ups(root, path.name)
