# SPDX-License-Identifier: BSD-3-Clause
"""The pages, written anew after a measurement.

In a process of its own, because pages.py imports the scripts that measure: each of them knows its page.
"""
import pathlib
import subprocess
import sys

PAGES = pathlib.Path(__file__).resolve().parents[1] / "pages.py"


def write_pages():
    if subprocess.run([sys.executable, str(PAGES), "--write", "--unchecked"], check=False).returncode != 0:
        raise SystemExit(f"{PAGES} has not written the pages (its message is above); the results file is written: correct that, then call "
            f"'{PAGES} --write'")
