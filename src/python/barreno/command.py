# SPDX-License-Identifier: BSD-3-Clause
"""The console script barreno: the launcher, with the same words."""

import os
import sys

from barreno import places
from barreno.runs.faults import FILE, say


def main():
    """Replaces this process by the launcher; exit code 2 with a sentence where the launcher is gone."""
    launcher = places.launcher()
    if launcher is None:
        say(f"the launcher is not found ({places.home()}, where this package came from, belongs to no source tree or installation any "
            "more); install the package again with pip from where Barreno is now.")
        return FILE
    os.execv(launcher, [str(launcher), *sys.argv[1:]])
