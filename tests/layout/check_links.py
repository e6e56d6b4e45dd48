#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every link of a page leads to a file and a heading of this repository, every picture is shown or linked somewhere, every
file that a page names in backticks is there, and so is every name in the code that the glossary gives. The navigation of the web site
(docs/mkdocs.yml) has every page of docs but those of the verification cases, which docs/verification.md lists, and the pages among the
results."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("cmake", "docs", "input_xml", "materials", "src", "tests", "verification")
LINK = re.compile(r"\[[^\]\[]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
FILE = re.compile(rf"(?:^|(?<= ))((?:{'|'.join(FOLDERS)})/[\w./-]+\.(?:py|md|xml|cpp|hpp|h|toml|json|csv|c|sh|f90|inp|cmake))(?= |$)")


def pages():
    return [*sorted(ROOT.glob("*.md")), *(file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.md")))]


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


def missing_names(glossary, sources):
    """Names of the glossary's column 'in the code' that stand in no source."""
    out, column = [], None
    for line in glossary.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        column = None if not line.startswith("|") else cells.index("in the code") if "in the code" in cells else column
        for name in CODE.findall(cells[column]) if column is not None and column < len(cells) else ():
            last = name.split("::")[-1].split("/")[-1].rstrip("*").removesuffix(".hpp").removesuffix(".cpp")
            if last and not re.search(rf"\b{re.escape(last)}", sources):
                out.append(f"docs/notation.md: no source has the name {name}")
    return out


def navigation_faults():
    """Pages that the web site's navigation lacks, or has and that are not there."""
    listed = re.findall(r"^ +- .*: (\S+\.md)$", (ROOT / "docs" / "mkdocs.yml").read_text(), re.MULTILINE)
    wanted = {str(file.relative_to(ROOT)) for file in (ROOT / "docs").rglob("*.md") if file.parent.name != "verification"} | {"README.md",
        "input_xml/README.md"}
    wanted |= {str(file.relative_to(ROOT)) for file in (ROOT / "verification" / "results").glob("*.md")}
    out = [f"docs/mkdocs.yml lists {name} twice" for name in sorted({name for name in listed if listed.count(name) > 1})]
    out += [f"docs/mkdocs.yml does not list {name}" for name in sorted(wanted - set(listed))]
    return out + [f"docs/mkdocs.yml lists {name}, which is not there" for name in sorted(set(listed) - wanted)]


def main():
    problems, shown = navigation_faults(), set()
    for page in pages():
        problems += problems_of(page, page.read_text(), shown)
    problems += [f"{file.relative_to(ROOT)} is on no page"
        for file in sorted((ROOT / "docs" / "pictures").iterdir()) if file.resolve() not in shown]
    sources = "\n".join(f"{file}\n{file.read_text()}" for folder in ("src", "materials") for file in sorted((ROOT / folder).rglob("*.?pp")))
    problems += missing_names((ROOT / "docs" / "notation.md").read_text(), sources)
    print("\n".join(problems) or "every link leads somewhere")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
