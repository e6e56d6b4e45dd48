#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The extremes: every row runs to its criterion or stops with the sentence that names what and why. None hangs, none is
wrong without a word.

    extremes.py BARRENO [--full] [--document] [ROWS ...]

ROWS: names of files in extreme_rows; all without. --full takes longer forms of some rows; --document writes
verification/results/extremes.md and extremes.json. Exit code 1 if a row is red that is not open (open_demands.toml), or an open one is
worse than known, or holds.
"""
import argparse
import dataclasses
import importlib
import json
import pathlib
import sys
import time

from tools import foreign_python  # noqa: F401

from tools.demands import open_demands
from tools.extreme import Table
from tools.extremes_page import HEAD, STORED, one_line, page_of
from tools.write_pages import write_pages

FILES = ["point", "porous_point", "stable_step", "flight", "impact", "stretch", "grid_edge", "units", "rock", "pore_flow", "time"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("rows", nargs="*", metavar="ROWS")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--document", action="store_true")
    options = parser.parse_intermixed_args()
    unknown = set(options.rows) - set(FILES)
    if unknown:
        parser.error(f"no rows {sorted(unknown)}; there are {FILES}")
    if options.document and options.rows:
        parser.error("--document writes the whole table: name no rows")
    table, failed = Table(), []
    for name in options.rows or FILES:
        began, first = time.monotonic(), len(table.rows)
        table.known = open_demands(f"extremes/{name}", options.full)
        importlib.import_module(f"extreme_rows.{name}").run(options.barreno.resolve(), options.full, table)
        failed += table.unmeasured(first)
        for row in table.rows[first:]:
            print(f"{row.verdict:6} {row.extreme}: {row.setup}: {one_line(row.criterion)}: {one_line(row.found)} {one_line(row.note)}")
        print(f"       {name}: {len(table.rows) - first} rows in {time.monotonic() - began:.1f} s", flush=True)
    print(page_of(table.rows).splitlines()[len(HEAD.splitlines()) + 1])
    if options.document:
        STORED.write_text(json.dumps([dataclasses.asdict(row) for row in table.rows], indent=1) + "\n")
        write_pages()
    failed += table.failures()
    for line in failed:
        print(line, file=sys.stderr)
    return 1 if failed or not table.rows else 0


if __name__ == "__main__":
    sys.exit(main())
