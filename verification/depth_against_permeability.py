#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a perforation against permeability: the sweep, its table in docs/verification.md and its picture.

    depth_against_permeability.py BARRENO
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent

if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = [sys.executable, str(HERE / "verify.py"), sys.argv[1], "--full", "--document", "pore_sweep"]
    held = subprocess.run(command).returncode
    sys.exit(subprocess.run([sys.executable, "-m", "cases.pore_sweep"], cwd=HERE).returncode or held)
