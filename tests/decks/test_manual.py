#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/deck.md is what the program says about its decks, and every section of it can be asked for.

    test_manual.py BARRENO
"""
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

DECKS = pathlib.Path(__file__).resolve().parents[2] / "input_xml"
# What these hold is in the words of another library.
ELSEWHERE = {"Belos", "Ifpack2", "MueLu"}
OUTPUT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "output.md"
TABLES = pathlib.Path(__file__).resolve().parents[2] / "src" / "python" / "barreno" / "report" / "run_tables.json"
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "deck.md"


def describe(*words):
    result = subprocess.run([sys.argv[1], "describe", *words], capture_output=True, text=True)
    assert result.returncode == 0, f"describe {words}: {result.stderr}"
    return result.stdout


def words_of(parameters):
    """Names of all parameters in a list of a deck and in the lists in it."""
    for child in parameters:
        if child.tag == "Parameter":
            yield child.get("name")
        elif child.get("name") not in ELSEWHERE:
            yield from words_of(child)


def main():
    manual = describe("--markdown")
    page = OUTPUT.read_text()
    for file, option in (("particles.e", "--fields"), ("history.csv", "--history")):
        mine = re.search(rf"<!-- words of {file} -->\n\n(.*?)\n<!-- end of words -->", page, re.DOTALL).group(1)
        assert mine == describe(option), f"the table of {file} in docs/output.md is old; write it with: barreno describe {option}"
    ledger = describe("--ledger")
    assert ledger.count("\n") > 30 and "\n" + ledger in page, (
        "the rows of the ledger in docs/output.md (summary.json) are old; write them with: barreno describe --ledger")
    assert TABLES.read_text() == describe("--report-tables"), f"{TABLES} is old; write it with: barreno describe --report-tables"
    assert PAGE.read_text() == manual, "docs/deck.md is old; write it with: barreno describe --markdown > docs/deck.md"
    # A list of free name has its entries under "NAME/*"; a model is asked for by its name.
    sections = re.findall(r"^## (?:Model )?([A-Z][A-Za-z -]*)$", manual, re.MULTILINE)
    assert len(sections) > 10, f"only the sections {sections}"
    for section in set(sections) - {"Top of the deck"}:
        assert describe(section).strip(), f"describe {section} says nothing"
    known = set(re.findall(r"^\| ([^|]*) \|", manual, re.MULTILINE))
    for deck in sorted(DECKS.glob("*.xml")):
        missing = set(words_of(ElementTree.parse(deck).getroot())) - known
        assert not missing, f"{deck.name} has {sorted(missing)}, of which docs/deck.md says nothing"


if __name__ == "__main__":
    main()
