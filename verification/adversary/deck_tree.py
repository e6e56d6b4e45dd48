# SPDX-License-Identifier: BSD-3-Clause
"""A deck as a tree that can be changed and written: lists and parameters by their path."""
import copy
import re
import xml.etree.ElementTree as ElementTree

# Not the exponents and the 1 of a unit: 7 of "7 kg/m3", 3 of "3 1/s".
NUMBER = re.compile(r"(?<![\w.+-])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.]|\s*/)")
LENGTHS = {"": 1.0, "m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6}


class Deck:
    def __init__(self, path):
        self.root = ElementTree.parse(path).getroot()

    def copy(self):
        return copy.deepcopy(self)

    def find(self, path):
        """The element of a list or a parameter, None without one."""
        here = self.root
        for name in path.split("/"):
            here = next((child for child in here if child.get("name") == name), None)
            if here is None:
                return None
        return here

    def lists(self, path):
        """Names of the lists in a list."""
        here = self.find(path)
        return [] if here is None else [child.get("name") for child in here if child.tag == "ParameterList"]

    def value(self, path):
        here = self.find(path)
        return None if here is None else here.get("value")

    def set(self, path, value):
        """Gives a parameter its value; lists on the way come into being."""
        here = self.root
        *lists, name = path.split("/")
        for part in lists:
            inner = next((child for child in here if child.get("name") == part), None)
            here = ElementTree.SubElement(here, "ParameterList", name=part) if inner is None else inner
        self.remove(path)
        ElementTree.SubElement(here, "Parameter", name=name, type="string", value=str(value))

    def remove(self, path):
        here = self.find(path)
        if here is not None:
            parent = self.find(path.rpartition("/")[0]) if "/" in path else self.root
            parent.remove(here)

    def write(self, path):
        ElementTree.ElementTree(self.root).write(path)


def numbers_in(text):
    return [float(number) for number in NUMBER.findall(text)]


def metres(text):
    """Components of "{0 mm, -40 mm}"."""
    return [float(n) * LENGTHS[unit] for n, unit in re.findall(rf"({NUMBER.pattern})\s*([a-z]*)", text)]
