#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages, parts of pages and measured numbers of the program that are made of results files.

    pages.py            compare them with what verification/results gives; exit code 1 if one differs
    pages.py --write    write them, and draw the pictures of cases anew whose figures have changed
    pages.py --write --unchecked    the same without the comparison

A part of a page stands between two marks, <!-- NAME --> and <!-- end of NAME -->; a mark without a writer is an error. Outside of marks a
page of WRITTEN gives no time, memory, rate or share, which would be a measurement without a file: what is set and not measured is in
SETTINGS.
"""
import argparse
import pathlib
import re
import subprocess
import sys

from tools import foreign_python  # noqa: F401

from tools import case_pictures
from tools import extremes_page
from tools import page_parts
from tools import validation_part
from tools import verification_pages
from tools.demands import FAILS, judge_all, open_demands, read_open
from tools.extreme import RED
from tools.wrap_text import wrapped

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
MARK = re.compile(r"<!-- (?!end of )([\w.]+) -->\n(.*?)<!-- end of \1 -->", re.DOTALL)
FIGURE = re.compile(r"\d[\d.,e+-]*(?: (?:to|and|or) \d[\d.,e+-]*)* ?(?:%|(?:[nmu]?s|min|minutes?|seconds?|hours?|[KMG]B|[KMG]B/s|times)\b)")
CODE = re.compile(r"`[^`\n]*`|\]\([^)\n]*\)|^ {4}.*$|\w+\.xml", re.MULTILINE)  # and targets of links, and decks
WRITTEN = ("README.md", "input_xml/README.md", "docs/architecture.md", "docs/checkpoints.md", "docs/converge.md", "docs/development.md",
           "docs/drive.md", "docs/extending.md", "docs/figures.md", "docs/finite_elements.md", "docs/materials/arenisca.md",
           "docs/materials/poroelastic.md", "docs/method.md", "docs/output.md", "docs/paper.md", "docs/performance.md", "docs/sweep.md",
           "docs/uncertainty.md", "verification/trade_notes.md")  # fmt: skip
SETTINGS = {
    "docs/checkpoints.md": ("1 MB",),  # of a chunk
    **dict.fromkeys(("docs/converge.md", "docs/figures.md", "docs/method.md"), ("120 us",)),  # which a deck is called by
    "docs/finite_elements.md": ("2 %",),  # of strain, in the example
    "docs/paper.md": ("5 %", "30 us", "60 us"),  # of pores, in a deck; when depths are compared
    "docs/performance.md": ("1 MB",),
    "docs/uncertainty.md": ("90 %", "95 %", "2 %", "5 %"),  # of intervals, and widths that are assumed
}
PAGES_WITH_PARTS = ["README.md", "input_xml/README.md",
    *sorted(str(file.relative_to(ROOT)) for folder in ("docs", "docs/materials") for file in (ROOT / folder).glob("*.md"))]


def with_parts(text):
    """The page with every marked part as its writer gives it."""

    def part(found):
        name = found.group(1)
        if name not in page_parts.PARTS:
            raise SystemExit(f"the mark <!-- {name} --> has no writer in verification/tools/page_parts.py")
        return f"<!-- {name} -->\n\n" + wrapped("\n".join(page_parts.PARTS[name]()).strip()) + f"\n\n<!-- end of {name} -->"

    return MARK.sub(part, text)


def pages():
    """{file: text} of everything that is made of results files."""
    out = {ROOT / "docs" / name: wrapped(text) for name, text in verification_pages.pages().items()}
    whole = page_parts.whole_pages().items()
    out.update({ROOT / name: wrapped(text) if name.endswith(".md") else text for name, text in whole})
    for name in PAGES_WITH_PARTS:
        file = ROOT / name
        if file not in out and "<!-- end of " in file.read_text():
            out[file] = with_parts(file.read_text())
    return out


def loose_figures(name, text):
    """Figures of a page that look measured and stand outside of marks and code."""
    text = CODE.sub("", MARK.sub("", text))
    return [found.group(0) for found in FIGURE.finditer(text) if found.group(0) not in SETTINGS.get(name, ())]


def failing():
    """Stored demands that fail, and red rows of the extremes that are not open: what a page would have to call so."""
    out = []
    for name in case_pictures.cases():
        data = case_pictures.stored(name)
        judged, _ = judge_all(data["checks"], open_demands(name, True)) if data else ([], [])
        out += [f"results/{name}.json: {check['what']}: {words}" for check, verdict, words in judged if verdict == FAILS]
    known = {what for (case, form), demands in read_open().items() if case.startswith("extremes/") and form == "full" for what in demands}
    rows = extremes_page.stored_rows()
    out += [f"results/extremes.json: {row.name}" for row in rows if (row.verdict == RED) != (row.name in known)]
    return out + validation_part.failing()


def left_over():
    """Pages of cases that are no longer in the list."""
    listed = {f"{name}.md" for name in case_pictures.cases()}
    return [file for file in sorted((ROOT / "docs" / "verification").glob("*.md")) if file.name not in listed]


def write_pages():
    for file, text in pages().items():
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
    if case_pictures.outdated():
        subprocess.run([sys.executable, "-m", "tools.case_pictures"], cwd=HERE, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--unchecked", action="store_true")
    options = parser.parse_args()
    if options.unchecked and not options.write:
        parser.error("--unchecked belongs to --write")
    if options.write:
        write_pages()
    if options.unchecked:
        return 0
    wrong = [f"{file.relative_to(ROOT)} does not match verification/results" for file, text in pages().items() if not file.exists()
        or file.read_text() != text]
    wrong += [f"{file.relative_to(ROOT)} was not drawn from the present verification/results" for file in case_pictures.outdated()]
    wrong += ["`verification/pages.py --write` writes them"] if wrong else []
    wrong += [f"{file.relative_to(ROOT)} belongs to no case: remove it" for file in left_over()]
    wrong += [f"{name}: '{figure}' comes from no results file: put it into a marked part, or say it in words" for name in WRITTEN
        for figure in loose_figures(name, (ROOT / name).read_text())]
    wrong += [f"{line}; measure it again (--full --document)" for line in failing()]
    print("\n".join(wrong or ["every figure matches its results file"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
