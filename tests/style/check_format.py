#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every C++ file is as clang-format writes it (.clang-format).

    check_format.py [--fix]
"""
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ["src", "materials", "tests", "verification"]
SKIPPED = 77  # what ctest counts as skipped


def main():
    if shutil.which("clang-format") is None:
        print("clang-format is missing: install the package clang-format.")
        return SKIPPED
    files = sorted(str(path) for folder in FOLDERS for path in (ROOT / folder).rglob("*.[ch]pp"))
    assert files, f"no C++ files under {ROOT}"
    how = ["-i"] if "--fix" in sys.argv else ["--dry-run", "--Werror"]
    return subprocess.run(["clang-format", *how, *files]).returncode


if __name__ == "__main__":
    sys.exit(main())
