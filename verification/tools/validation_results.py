# SPDX-License-Identifier: BSD-3-Clause
"""The stored results of validation.py, and the picture of craters that they give."""
import json

from tools.case_list import RESULTS

STORED = RESULTS / "validation.json"
PICTURE = {"x": "radius [mm]", "y": ["y [mm], the face at 0"], "linear": True}
PICTURE_FILE, PICTURE_TITLE = "validation_craters.png", "Craters of a steel sphere, 5 km/s"


def stored_experiments():
    """{name: what the last full run of the experiment gave}."""
    return json.loads(STORED.read_text()) if STORED.exists() else {}


def curves():
    """Of the picture."""
    return {label: points for data in stored_experiments().values() for label, points in data["profiles"].items()}
