#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and numbers of a run: report.py RUN [options], as ./barreno report (docs/report.md)."""
import sys

from barreno.report.command import main

if __name__ == "__main__":
    sys.exit(main(["report", *sys.argv[1:]]))
