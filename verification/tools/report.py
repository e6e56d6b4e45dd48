#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and numbers of a run: report.py RUN [options], as ./barreno report (docs/report.md)."""
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from barreno.report.command import main

if __name__ == "__main__":
    sys.exit(main(["report", *sys.argv[1:]]))
