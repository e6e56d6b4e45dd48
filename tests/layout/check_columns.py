#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""No line of text has more than 140 columns: in pages, in C and C++, in Python, in scripts and styles of pages.

Excepted are rows of tables, pictures, code on pages and lines of a single word, an address for instance; blocks of text that a script
writes as they stand (in three quotes); docs/deck.md, which the program writes, and CHANGELOG.md; what is generated among the results;
built files of others in folders third_party.
`verification/tools/wrap_text.py` wraps what verification/pages.py writes.
"""
import ast
import io
import pathlib
import subprocess
import sys
import tokenize

from tools.wrap_text import KEPT, WIDTH, WORD, code_lines

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXCEPTED = {"CHANGELOG.md", "docs/deck.md"}
RESULTS = "verification/results/"
THIRD_PARTY = "third_party"


def long_lines(text):
    return [number for number, line in enumerate(text.split("\n"), 1) if len(line) > WIDTH]


def long_on_page(text):
    lines = text.split("\n")
    code = code_lines(lines)
    return [n for n in long_lines(text) if n - 1 not in code and not KEPT.match(lines[n - 1]) and len(WORD.findall(lines[n - 1])) > 1]


def descriptions(text):
    """Numbers of the lines of docstrings."""
    out = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node, clean=False) is not None:
            out.update(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return out


def blocks(text):
    """Numbers of the lines of blocks of text in three quotes: pages and files that a script writes as they stand."""
    out = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.STRING and token.start[0] < token.end[0]:
            out.update(range(token.start[0], token.end[0] + 1))
    return out


def long_in_python(text):
    kept = blocks(text) - descriptions(text)
    return [number for number in long_lines(text) if number not in kept]


CHECKS = {".md": long_on_page, ".py": long_in_python, **dict.fromkeys((".cpp", ".hpp", ".c", ".h", ".js", ".css"), long_lines)}


def files():
    """What the repository holds; without its history, what lies there but for builds."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        return [name for name in listed.stdout.splitlines() if (ROOT / name).exists()]
    return [str(path.relative_to(ROOT)) for path in sorted(ROOT.rglob("*")) if path.suffix in CHECKS
        and "build" not in path.relative_to(ROOT).parts]


def main():
    problems, seen = [], 0
    for name in files():
        check = CHECKS.get(pathlib.Path(name).suffix)
        if check is None or name in EXCEPTED or name.startswith(RESULTS) or THIRD_PARTY in pathlib.Path(name).parts:
            continue
        seen += 1
        problems += [f"{name}:{number}: more than {WIDTH} columns: wrap the line" for number in check((ROOT / name).read_text())]
    assert seen, f"no files under {ROOT}"
    print("\n".join(problems) or f"no line of text in {seen} files has more than {WIDTH} columns")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
