# SPDX-License-Identifier: BSD-3-Clause
"""The Python module of this source tree, for the tests of hosts."""

import pathlib
import sys

MATERIALS = pathlib.Path(__file__).resolve().parents[2] / "materials"
CARDS = MATERIALS / "cards"
sys.path.insert(0, str(MATERIALS / "python"))

from barreno_material import CONSISTENT, ELASTIC, STRESS, Material, load  # noqa: E402, F401
