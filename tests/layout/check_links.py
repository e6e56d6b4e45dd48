#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every link of a page leads to a file and a heading of this repository, every picture is shown or linked somewhere, and every
file that a page names in backticks is there."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("cmake", "docs", "input_xml", "materials", "src", "tests", "verification")
LINK = re.compile(r"\[[^\]\[]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
FILE = re.compile(rf"(?:^|(?<= ))((?:{'|'.join(FOLDERS)})/[\w./-]+\.(?:py|md|xml|cpp|hpp|h|toml|json|csv|c|sh|f90|inp|cmake))(?= |$)")


def pages():
    return [ROOT / "README.md", *(file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.md")))]


def anchors(file):
    """Names of headings, as pages of a repository are rendered."""
    heads = re.findall(r"^#+ (.*)$", file.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower().replace("`", "")).replace(" ", "-") for head in heads}


def problems_of(page, text, shown):
    """What is wrong with the links of a page; adds to `shown` what they lead to."""
    out = []
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        shown.add(file)
        if not file.exists():
            out.append(f"{page.relative_to(ROOT)}: the link to {target} leads nowhere")
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            out.append(f"{page.relative_to(ROOT)}: {path or 'the page'} has no heading #{anchor}")
    for words in CODE.findall(text):
        out += [f"{page.relative_to(ROOT)}: there is no {name}" for name in FILE.findall(words) if not (ROOT / name).exists()]
    return out


def main():
    problems, shown = [], set()
    for page in pages():
        problems += problems_of(page, page.read_text(), shown)
    problems += [f"{file.relative_to(ROOT)} is on no page" for file in sorted((ROOT / "docs" / "pictures").iterdir()) if file.resolve() not in shown]
    print("\n".join(problems) or "every link leads somewhere")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
