# SPDX-License-Identifier: BSD-3-Clause
"""The effective deck of a run (deck.xml): every value that was used, in SI."""

import re
import xml.etree.ElementTree as xml

import numpy as np

from barreno.report.files import reading
from barreno.runs.regular_file import read_text


class Deck:
    def __init__(self, root):
        self.root = root

    def list_at(self, *names):
        """A list by the names that lead to it; an empty one where it is missing."""
        node = self.root
        for name in names:
            node = next((child for child in node if child.tag == "ParameterList" and child.get("name") == name),
                xml.Element("ParameterList"))
        return node

    def text(self, path, default=""):
        *lists, name = path.split("/")
        return next((one.get("value", default) for one in self.list_at(*lists) if one.tag == "Parameter" and one.get("name") == name),
            default)

    def number(self, path, default=float("nan")):
        return float(self.text(path) or default)

    def vector(self, path):
        return [float(x) for x in self.text(path).strip("{}").split(",") if x.strip()]

    def entries(self, *names):
        """{name: list} of the lists in a list."""
        return {child.get("name", ""): child for child in self.list_at(*names) if child.tag == "ParameterList"}

    def parameters(self, *names):
        """{name: text} of the values in a list."""
        return {child.get("name", ""): child.get("value", "") for child in self.list_at(*names) if child.tag == "Parameter"}

    @property
    def mode(self):
        return self.text("Grid/Mode", "axisymmetric")

    @property
    def has_jet(self):
        return bool(self.text("Jet/Material"))

    @property
    def direction(self):
        """Sign of y along which the jet flies."""
        said = self.text("Jet/Direction") or self.text("Jet Monitor/Direction") or "+y"
        return -1.0 if said.strip().startswith("-") else 1.0

    @property
    def forms_jet(self):
        """Whether a jet is formed in the run, rather than launched: its monitor's plane lies between what forms it and the target."""
        return bool(self.text("Jet Monitor/Position")) and not self.has_jet

    def mirrored(self):
        """Whether x = 0 is an axis or a plane of symmetry at the edge of the grid: the other half is the mirror image."""
        if self.mode == "axisymmetric":
            return True
        lower = self.vector("Grid/Lower")
        symmetric = any(self.text(f"Conditions/{name}/Face") == "x_lower" and self.text(f"Conditions/{name}/Kind") == "symmetry"
            for name in self.entries("Conditions"))
        return symmetric and bool(lower) and abs(lower[0]) < 1e-12

    def materials_of_bodies(self):
        """{material: largest particle count per cell and direction}"""
        found = {}
        for name in self.entries("Bodies"):
            material = self.text(f"Bodies/{name}/Material")
            found[material] = max(found.get(material, 0), int(self.number(f"Bodies/{name}/Particles Per Cell", 2)))
        return found

    def slugs(self):
        """Rows of the jet's table: time, velocity, radius, length, density; none where the deck does not hold them."""
        text = self.text("Jet/Slugs")
        head = re.match(r"\s*(\d+)x(\d+):", text)
        if not head:
            return np.empty((0, 5))
        numbers = [float(x) for x in text[head.end() :].strip(" {}").split(",")]
        return np.array(numbers).reshape(int(head.group(1)), int(head.group(2)))


def read_deck(file):
    """An empty deck where there is none."""
    if not file.exists():
        return Deck(xml.Element("ParameterList"))
    with reading(file):
        return Deck(xml.fromstring(read_text(file)))
