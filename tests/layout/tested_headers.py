#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The headers of src that a unit test includes, folder by folder.

    tested_headers.py [--missing]

--missing also names those that stand in no test.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def headers_by_folder(root=ROOT):
    """Folder below src -> names of its headers, as an include gives them."""
    folders = {}
    for path in sorted((root / "src").rglob("*.hpp")):
        name = path.relative_to(root / "src")
        folders.setdefault(str(name.parent), []).append(str(name))
    return folders


def included_in_tests(root=ROOT):
    """What the files of tests include by name; scripts, which start the program as a whole, do not count."""
    names = set()
    for path in sorted((root / "tests").rglob("*.[ch]pp")):
        names.update(re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE))
    return names


def main():
    tested, count, all_tested = included_in_tests(), 0, 0
    for folder, headers in headers_by_folder().items():
        missing = [name for name in headers if name not in tested]
        count += len(headers)
        all_tested += len(headers) - len(missing)
        print(f"{folder:20} {len(headers) - len(missing):3} of {len(headers):3}")
        if "--missing" in sys.argv:
            print("".join(f"    {name}\n" for name in missing), end="")
    print(f"{'all':20} {all_tested:3} of {count:3} headers of src stand in a test")


if __name__ == "__main__":
    main()
