#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the repository as a web site, build/site/html/index.html, which opens from the disk:

    docs/build_site.py [--out FOLDER]

Pages stay where they are: README.md, docs and every file that they link to are copied into a folder of the same layout, and mkdocs
(apt-get install mkdocs) builds it with docs/mkdocs.yml. A link that leads to no file or to no heading of the site is an error. Exit code 77
without mkdocs.
"""
import argparse
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[1]
CONFIGURATION = ROOT / "docs" / "mkdocs.yml"
LINK = re.compile(r"\]\(([^)\s]+)\)")
PAGES = ("docs", "verification/results")  # folders of pages
MISSING = 77  # what ctest counts as skipped


def linked_files(page):
    """Files of the repository that a page links to."""
    for target in LINK.findall(page.read_text()):
        file = (page.parent / target.partition("#")[0]).resolve()
        if not re.match(r"[a-z]+:", target) and file.is_file() and ROOT in file.parents:
            yield file


def all_files():
    """README.md, the pages of docs and of results, and what can be reached from them."""
    waiting, found = [ROOT / "README.md", *(page for folder in PAGES for page in sorted((ROOT / folder).rglob("*.md")))], set()
    while waiting:
        file = waiting.pop()
        if file in found:
            continue
        found.add(file)
        if file.suffix == ".md":
            waiting += linked_files(file)
    return sorted(found)


def gather(folder):
    shutil.rmtree(folder, ignore_errors=True)
    for file in all_files():
        copy = folder / file.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)


class Page(html.parser.HTMLParser):
    """Names that links can lead to, what the page links to, and what it loads."""

    def __init__(self, file):
        super().__init__()
        self.names, self.links, self.loads = set(), [], []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.names.add(found.get("id"))
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
        if tag in ("img", "script", "link") and (found.get("src") or found.get("href")):
            self.loads.append(found.get("src") or found["href"])


def dead_links(site):
    """What leads nowhere in the site that was built, and what a page would load from elsewhere."""
    pages = {file: Page(file) for file in sorted(site.rglob("*.html"))}
    problems = []
    for file, page in pages.items():
        place = file.relative_to(site)
        problems += [f"{place} loads {load} from elsewhere" for load in page.loads if re.match(r"(https?:)?//", load)]
        for link in page.links + page.loads:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                continue
            target = (file.parent / urllib.parse.unquote(url.path)).resolve() if url.path else file
            if not target.is_file():
                problems.append(f"{place}: {link} leads to no file")
            elif url.fragment and target in pages and urllib.parse.unquote(url.fragment) not in pages[target].names:
                problems.append(f"{place}: {link} leads to no heading")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build" / "site", help="default: build/site")
    out = parser.parse_args().out.resolve()
    if shutil.which("mkdocs") is None:
        print("mkdocs is missing; install it: apt-get install mkdocs")
        return MISSING
    gather(out / "pages")
    configuration = out / "mkdocs.yml"
    configuration.write_text(re.sub(r"\.\./build/site/", "", CONFIGURATION.read_text()))
    done = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--config-file", configuration, "--clean"], check=False)
    (out / "html" / "404.html").unlink(missing_ok=True)  # of a server
    problems = dead_links(out / "html") if done.returncode == 0 else ["mkdocs has failed (see above)"]
    print("\n".join(problems) or f"{out}/html/index.html")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
