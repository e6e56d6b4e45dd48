# SPDX-License-Identifier: BSD-3-Clause
"""Tables of what a run writes, as the program has them: run_tables.json is what `barreno describe --report-tables` prints."""

import json
import pathlib

from barreno.runs.regular_file import read_text

TABLES = json.loads(read_text(pathlib.Path(__file__).with_suffix(".json")))
UNITS = TABLES["units"]  # SI, of the fields of particles.e
PUBLISHED_SURFACE = frozenset(TABLES["published_surface"])  # entries that a rock may have whose surface is Arenisca's published one


def energies(*parts):
    """Energies of the ledger that are these parts of its balance: held, supplied, worked, exchanged, numerical."""
    return [name for part in parts for name in TABLES["energy"][part]]
