#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A set of files (Particle Files = "one per rank") as one: join_exodus.py FILE OUT writes OUT.

FILE is particles.e, which then stands for particles.e.N.0 and so on beside it, or any file of the set.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from barreno_report.exodus_sets import as_one_file, files_of, join  # noqa: E402, F401


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        join(files_of(sys.argv[1]), sys.argv[2])
    except OSError as error:
        print(f"cannot join '{sys.argv[1]}' ({error}).", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
