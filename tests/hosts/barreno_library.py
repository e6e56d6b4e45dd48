# SPDX-License-Identifier: BSD-3-Clause
"""The Python module of this source tree, for the tests of hosts."""

import pathlib

from barreno.materials import CONSISTENT, ELASTIC, STRESS, Material, load  # noqa: F401

MATERIALS = pathlib.Path(__file__).resolve().parents[2] / "materials"
CARDS = MATERIALS / "cards"
