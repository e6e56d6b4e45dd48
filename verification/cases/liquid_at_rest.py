# SPDX-License-Identifier: BSD-3-Clause
"""Water under pressure between two blocks, and water under gravity: both stay at rest."""
import numpy as np
from case import Result
from runs import run_deck

DENSITY, C0 = 998.2, 1483.0  # of water.xml
SPEED = C0  # velocities are told in parts of it


def fastest(run):
    """Largest velocity of a particle at the end [m/s]."""
    last = run.particles(-1)
    return float(np.sqrt(sum(last[f"velocity_{axis}"] ** 2 for axis in "xy")).max())


def spread(run, pressure):
    """Largest difference to this pressure at the end, over it."""
    return float(np.abs(run.particles(-1)["pressure"] / pressure - 1.0).max())
