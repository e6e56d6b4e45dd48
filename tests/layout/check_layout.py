#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rules of docs/architecture.md that a script can hold: includes point left, files stay small, third-party
headers stay in their folders, what is built is listed."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ORDER = ["base", "geometry", "deck", "scene", "grid", "shape", "state", "pore_flow", "step", "output", "checkpoint", "drive", "check", "."]
ALLOWED_IN = {  # header prefix -> folders of src/ that may include it
    "exodusII": {"output"},
    "hdf5": {"checkpoint"},
    "mpi.h": {"base", "grid", "."},
    "Tpetra_": {"grid", "pore_flow", "."},
    "Belos": {"pore_flow"},
    "Ifpack2_": {"pore_flow"},
    "MueLu_": {"pore_flow"},
    "Teuchos_XML": {"deck"},
    "Teuchos_ParameterList": {"deck", "pore_flow"},
    "CGAL": {"deck"},
}
LONGEST = 500
problems = []


def folder_of(path):
    relative = path.relative_to(ROOT / "src")
    return relative.parts[0] if len(relative.parts) > 1 else "."


def check_includes(path, lines):
    mine = folder_of(path)
    for number, line in enumerate(lines, 1):
        own = re.match(r'#include "([^"/]+)/', line)
        if own and own.group(1) in ORDER and ORDER.index(own.group(1)) > ORDER.index(mine):
            problems.append(f"{path.relative_to(ROOT)}:{number}: {mine} must not include {own.group(1)}")
        other = re.match(r"#include <([^>]+)>", line)
        for prefix, folders in ALLOWED_IN.items():
            if other and other.group(1).startswith(prefix) and mine not in folders:
                problems.append(f"{path.relative_to(ROOT)}:{number}: <{other.group(1)}> belongs in {sorted(folders)}")


def main():
    sources = sorted((ROOT / "src").rglob("*.[ch]pp"))
    listed = (ROOT / "src" / "CMakeLists.txt").read_text()
    for path in sources + sorted((ROOT / "materials").rglob("*.[ch]pp")):
        lines = path.read_text().splitlines()
        if len(lines) > LONGEST:
            problems.append(f"{path.relative_to(ROOT)}: {len(lines)} lines, more than {LONGEST}")
        if ROOT / "src" not in path.parents:
            continue
        check_includes(path, lines)
        name = str(path.relative_to(ROOT / "src"))
        if path.suffix == ".cpp" and name not in listed:
            problems.append(f"src/{name} is not built: it is not in src/CMakeLists.txt")
    print("\n".join(problems) or "layout is as docs/architecture.md says")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
