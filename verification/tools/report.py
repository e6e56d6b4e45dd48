#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and numbers of a run: report.py RUN [options], as ./barreno report (docs/report.md)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "src" / "python"))
from barreno_report.command import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main(["report", *sys.argv[1:]]))
