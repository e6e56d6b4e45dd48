# SPDX-License-Identifier: BSD-3-Clause
"""The cases (cases.toml) and their stored results."""
import json
import pathlib
import tomllib

VERIFICATION = pathlib.Path(__file__).resolve().parents[1]
RESULTS = VERIFICATION / "results"
DOCS = VERIFICATION.parent / "docs"


def cases():
    """{name: entry} in the order of the list."""
    return tomllib.loads((VERIFICATION / "cases.toml").read_text())


def stored(name):
    """Figures of the last full run, or None."""
    file = RESULTS / f"{name}.json"
    return json.loads(file.read_text()) if file.exists() else None
