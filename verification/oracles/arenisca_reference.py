#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Independent reference implementation of the sandstone model Arenisca: its command line.

    arenisca_reference.py CARD PATHFILE --out CSV     drive one material point along a path (arenisca_paths.py)
    arenisca_reference.py --self-check                consistency and published numbers (arenisca_selfcheck.py)

The model is arenisca_model.py; around it, for wet rock, arenisca_pores.py unless the card names a published form.
"""
import argparse
import sys
import xml.etree.ElementTree as ElementTree

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from oracles import arenisca_selfcheck
from oracles.arenisca_laws import DEFAULTS, BadParameter
from oracles.arenisca_paths import drive_file
from oracles.arenisca_pores import model


def read_card(path):
    """Parameters of a material card: (parameters, other entries)."""
    root = ElementTree.parse(path).getroot()
    parameters, other = {}, {}
    for entry in root.iter("Parameter"):
        name, value = entry.get("name"), entry.get("value")
        if name in parameters or name in other:
            raise BadParameter(f"{name} is given twice")
        if name not in DEFAULTS:
            other[name] = value
        elif entry.get("type") == "string":
            parameters[name] = value
        else:
            parameters[name] = int(value) if entry.get("type") == "int" else float(value)
    return parameters, other


def main(arguments=None):
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("card", nargs="?")
    parser.add_argument("path", nargs="?")
    parser.add_argument("--out", default="-")
    parser.add_argument("--self-check", action="store_true")
    choice = parser.parse_args(arguments)
    if choice.self_check:
        return arenisca_selfcheck.run()
    if not choice.path:
        parser.error("CARD and PATHFILE are needed")
    parameters, _ = read_card(choice.card)
    drive_file(model(parameters), choice.path, choice.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
