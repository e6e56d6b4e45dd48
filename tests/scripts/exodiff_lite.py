#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two Exodus files value by value, matching elements and nodes by their id maps.

    exodiff_lite.py [-f TOLERANCES] OLD NEW        exit code 0: the same, 2: different, 1: error

particles.e stands for a set of files (particles.e.2.0, particles.e.2.1) where there is no file of that name.

A tolerance file is a subset of exodiff's:
    DEFAULT TOLERANCE relative 1e-8 floor 1e-14
    COORDINATES absolute 1e-12
    TIME STEPS relative 1e-12
    ELEMENT VARIABLES (all) relative 1e-8     (also NODAL, GLOBAL; an absent section is not compared)
    <tab>pressure absolute 1.0
    <tab>!status
relative: |a-b| / max(|a|, |b|); absolute: |a-b|; combined: |a-b| / max(1, |a|, |b|); ignore.
Pairs that both lie within the floor are equal. Not a number equals nothing, not even itself.
"""
import argparse
import re
import sys

import numpy as np
from netCDF4 import Dataset, chartostring

from barreno.runs.join_exodus import as_one_file

KINDS = ("relative", "absolute", "combined", "ignore")


class Tolerance:
    def __init__(self, kind="relative", value=1e-6, floor=0.0):
        self.kind, self.value, self.floor = kind, value, floor

    def changed_by(self, words):
        """A copy with the words of a tolerance line applied."""
        result = Tolerance(self.kind, self.value, self.floor)
        words = iter(word.lower() for word in words)
        for word in words:
            if word == "floor":
                result.floor = float(next(words))
            elif word in KINDS:
                result.kind = word
            else:
                result.value = float(word)
        return result

    def worst(self, a, b):
        """Index and size of the largest difference beyond the tolerance, or None."""
        a, b = np.ravel(np.asarray(a, float)), np.ravel(np.asarray(b, float))
        if self.kind == "ignore" or a.size == 0:
            return None
        if a.size != b.size:
            return 0, np.inf
        size = np.maximum(np.abs(a), np.abs(b))
        difference = np.abs(a - b)
        if self.kind == "relative":
            difference = difference / np.where(size > 0, size, 1.0)
        elif self.kind == "combined":
            difference = difference / np.maximum(1.0, size)
        difference = np.where(size <= self.floor, 0.0, difference)
        difference = np.where(np.isnan(a) | np.isnan(b), np.inf, difference)
        i = int(np.argmax(difference))
        return (i, difference[i]) if difference[i] > self.value else None


class Section:
    """Tolerances of the variables of one kind."""

    def __init__(self, tolerance, everything):
        self.tolerance, self.everything = tolerance, everything
        self.named, self.excluded = {}, set()

    def of(self, name):
        name = name.lower()
        if name in self.excluded:
            return None
        if name in self.named:
            return self.named[name]
        return self.tolerance if self.everything or not self.named else None


class Tolerances:
    def __init__(self, file=None):
        self.default = Tolerance()
        self.coordinates = Tolerance("absolute", 1e-6)
        self.time = Tolerance("relative", 1e-6, 1e-15)
        self.sections = {}
        if file is None:
            for kind in ("global", "nodal", "element"):
                self.sections[kind] = Section(self.default, True)
            return
        section = None
        with open(file, encoding="utf-8") as lines:
            for line in lines:
                line = line.split("#")[0].rstrip()
                words = line.split()
                if not words:
                    continue
                if line[0] in " \t":
                    self.read_name(section, words)
                else:
                    section = self.read_heading(words)

    def read_heading(self, words):
        heading = " ".join(words).upper()
        if heading.startswith("DEFAULT TOL"):
            self.default = self.default.changed_by(words[2:])
        elif heading.startswith("COORD"):
            self.coordinates = self.coordinates.changed_by(words[1:])
        elif heading.startswith("TIME STEPS"):
            self.time = self.time.changed_by(words[2:])
        else:
            match = re.match(r"(GLOBAL|NODAL|ELEMENT) VARIABLES", heading)
            if match is None:
                raise ValueError(f"unknown tolerance line '{' '.join(words)}'")
            rest = [word for word in words[2:] if word.lower() != "(all)"]
            section = Section(self.default.changed_by(rest), "(ALL)" in heading)
            self.sections[match.group(1).lower()] = section
            return section
        return None

    @staticmethod
    def read_name(section, words):
        if section is None:
            raise ValueError(f"'{words[0]}' stands under no VARIABLES line")
        if words[0].startswith("!"):
            section.excluded.add(words[0][1:].lower())
        else:
            section.named[words[0].lower()] = section.tolerance.changed_by(words[1:])


class Exodus:
    """Values sorted by element and node ids."""

    def __init__(self, file):
        self.data = Dataset(file)
        self.data.set_auto_mask(False)
        variables = self.data.variables
        self.times = variables["time_whole"][:]
        self.sizes = [
            self.size(f"num_el_in_blk{b + 1}") for b in range(self.size("num_el_blk"))
        ]
        ends = np.cumsum([0] + self.sizes)
        elements = self.map("elem_num_map", int(ends[-1]))
        self.element_order, self.element_ids = [], []
        for begin, end in zip(ends[:-1], ends[1:]):
            order = np.argsort(elements[begin:end], kind="stable")
            self.element_order.append(order)
            self.element_ids.append(elements[begin:end][order])
        nodes = self.map("node_num_map", self.size("num_nodes"))
        self.node_order = np.argsort(nodes, kind="stable")
        self.node_ids = nodes[self.node_order]

    def size(self, dimension):
        dimensions = self.data.dimensions
        return len(dimensions[dimension]) if dimension in dimensions else 0

    def map(self, name, count):
        variables = self.data.variables
        return variables[name][:] if name in variables else np.arange(1, count + 1)

    def names(self, kind):
        key = {"global": "name_glo_var", "nodal": "name_nod_var", "element": "name_elem_var"}[kind]
        if key not in self.data.variables:
            return []
        texts = np.atleast_1d(chartostring(self.data.variables[key][:]))
        return [str(text).split("\0")[0].strip() for text in texts]

    def coordinates(self):
        return {
            axis: self.data.variables["coord" + axis][:][self.node_order]
            for axis in "xyz"
            if "coord" + axis in self.data.variables
        }

    def values(self, kind, index, step):
        """Pairs of a place and its values; None where the truth table has none."""
        variables = self.data.variables
        if kind == "global":
            return [("", None, np.atleast_1d(variables["vals_glo_var"][step, index]))]
        if kind == "nodal":
            values = variables[f"vals_nod_var{index + 1}"][step][self.node_order]
            return [("node", self.node_ids, values)]
        parts = []
        for b, order in enumerate(self.element_order):
            name = f"vals_elem_var{index + 1}eb{b + 1}"
            values = variables[name][step][order] if name in variables else None
            parts.append((f"block {b + 1} element", self.element_ids[b], values))
        return parts


def same_mesh(a, b):
    return (
        a.sizes == b.sizes
        and all(np.array_equal(x, y) for x, y in zip(a.element_ids, b.element_ids))
        and np.array_equal(a.node_ids, b.node_ids)
    )


def compare_variable(a, b, kind, indices, step, tolerance):
    name = a.names(kind)[indices[0]]
    pairs = zip(a.values(kind, indices[0], step), b.values(kind, indices[1], step))
    for (place, ids, x), (_, _, y) in pairs:
        if x is None and y is None:
            continue
        if x is None or y is None:
            yield f"{name}: only one file has it in {place}"
            continue
        worst = tolerance.worst(x, y)
        if worst is not None:
            i, size = worst
            where = f"{place} {ids[i]}" if ids is not None else ""
            yield (
                f"step {step + 1} {name}: {np.ravel(x)[i]:.9e} ~ {np.ravel(y)[i]:.9e}, "
                f"{tolerance.kind} {size:.3e} {where}"
            )


def differences(a, b, tolerances):
    if not same_mesh(a, b):
        yield "blocks or ids differ"
        return
    other = b.coordinates()
    for axis, values in a.coordinates().items():
        if axis not in other or tolerances.coordinates.worst(values, other[axis]) is not None:
            yield f"coordinates {axis} differ"
    if len(a.times) != len(b.times):
        yield f"{len(a.times)} time steps ~ {len(b.times)}"
    steps = range(min(len(a.times), len(b.times)))
    for step in steps:
        if tolerances.time.worst(a.times[step], b.times[step]) is not None:
            yield f"time of step {step + 1}: {a.times[step]} ~ {b.times[step]}"
    for kind, section in tolerances.sections.items():
        others = [name.lower() for name in b.names(kind)]
        for i, name in enumerate(a.names(kind)):
            tolerance = section.of(name)
            if tolerance is None:
                continue
            if name.lower() not in others:
                yield f"{kind} variable {name} is missing in the second file"
                continue
            indices = (i, others.index(name.lower()))
            for step in steps:
                yield from compare_variable(a, b, kind, indices, step, tolerance)


def compare_files(old, new, tolerance_file=None):
    """@return what differs, a line each"""
    with as_one_file(old) as one, as_one_file(new) as other:
        return list(differences(Exodus(one), Exodus(other), Tolerances(tolerance_file)))


def main():
    parser = argparse.ArgumentParser(description="Compare two Exodus files.")
    parser.add_argument("-f", "--file", help="tolerance file")
    parser.add_argument("old")
    parser.add_argument("new")
    options = parser.parse_args()
    try:
        found = compare_files(options.old, options.new, options.file)
    except (OSError, KeyError, ValueError, StopIteration) as error:
        print(f"exodiff_lite: {error!r}", file=sys.stderr)
        return 1
    shown = 50
    for line in found[:shown]:
        print(line)
    if len(found) > shown:
        print(f"and {len(found) - shown} more")
    print("exodiff_lite: files are", "different" if found else "the same")
    return 2 if found else 0


if __name__ == "__main__":
    sys.exit(main())
