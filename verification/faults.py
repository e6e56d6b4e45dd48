#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a run survives: signals, damaged checkpoints, a full disk, another number of ranks, very many steps,
input of any kind. All cases in full, with their tables in docs/verification.md.

    faults.py BARRENO
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
CASES = ["kills", "damaged_checkpoints", "full_disk", "restarts", "long_run", "fuzzed_decks"]

if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(subprocess.run([sys.executable, str(HERE / "verify.py"), sys.argv[1], "--full", "--document", *CASES]).returncode)
