# SPDX-License-Identifier: BSD-3-Clause
"""The parts of docs/performance.md that scripts write, each between two marks with the script's name."""
import pathlib

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "performance.md"


def write_part(name, lines):
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    head, rest = PAGE.read_text().split(begin)
    PAGE.write_text(f"{head}{begin}\n\n" + "\n".join(lines).strip() + f"\n\n{end}{rest.split(end)[1]}")
