# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that measure named rows, all or some, and keep them in one results file."""
import argparse
import json
import pathlib

from tools.write_pages import write_pages


def keep_row(stored, rows, name, found):
    """In the order of the rows, beside those that were measured before."""
    known = {**(json.loads(stored.read_text()) if stored.exists() else {}), name: found}
    stored.write_text(json.dumps({row: known[row] for row in rows if row in known}, indent=1) + "\n")


def measure_rows(description, rows, stored, measured):
    """Measures the rows that the command line names, or all, and writes the pages.

    @param rows      {name: entries of the deck}
    @param stored    the results file
    @param measured  measured(program, entries): what is kept of a row
    @return          the exit code
    """
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("rows", nargs="*", metavar="ROW")
    options = parser.parse_args()
    unknown = [row for row in options.rows if row not in rows]
    if unknown:
        parser.error(f"there is no row '{unknown[0]}'; there are {', '.join(rows)}")
    for row in options.rows or rows:
        one = measured(options.barreno.resolve(), rows[row])
        print(row, one, flush=True)
        keep_row(stored, rows, row, one)
    write_pages()
    return 0
