#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rules of docs/architecture.md that a script can hold: includes point left, also between the rooms of the step, files
and rooms stay small, third-party headers stay in their folders, what is built is listed, every header of the step stands
in a test, scripts do not import each other in a circle, the parts of the Python package import to the left, no script changes the path of
Python. What the linker ties together: check_link_arrows.py."""
import ast
import pathlib
import re
import subprocess
import sys

import import_cycles
import tested_headers

ROOT = pathlib.Path(__file__).resolve().parents[2]
ORDER = ["base", "files", "geometry", "deck", "scene", "grid", "shape", "state", "jet", "pore_flow", "step", "output", "checkpoint",
    "drive", "check", "."]
# Of src/step; files directly in it stand to the right of all rooms, but for headers that include none.
ROOMS = ["order", "ranks", "jet", "dormant", "subcycle", "boundary", "nodes", "contact", "loads", "transfer", "particles"]
LARGEST_ROOM = 20  # files
LARGEST_FOLDER = 50  # files, of every other folder of src
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
    "CLI/": {"."},
    "nlohmann": {"output", "pore_flow", "check"},
}
LONGEST = 500
# Of the top folder, so that none is forgotten there: what these are, README.md and docs/architecture.md say.
TOP_LEVEL = {".ci", ".clang-format", ".clang-tidy", ".gitignore", "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json",
    "CONTRIBUTING.md",
             "LICENSE", "README.md", "barreno", "cmake", "docs", "input_xml", "materials", "packaging", "src", "tests",
             "verification"}  # fmt: skip
VERSIONED = {  # file -> how it says the version
    "CMakeLists.txt": r"project\(barreno VERSION (\S+)",
    "materials/CMakeLists.txt": r"project\(barreno_materials VERSION (\S+)",
    "CITATION.cff": r"(?m)^version: (\S+)",
    "CHANGELOG.md": r"(?m)^## (\S+)",
    "src/python/barreno/__init__.py": r"(?m)^__version__ = \"(\S+)\"",
    "packaging/spack/package.py": r"sanity_version = \"(\S+)\"",
}
# Of src/python/barreno, each imports those to its left.
PARTS = ["runs", "materials", "fit", "imports", "jet", "converge", "report", "flow", "compare", "sweeps", "uncertainties", "interface"]
PATH_OF_PYTHON = "sys" + ".path"
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


def rooms_in(path):
    """(line, room) of what a file includes from the rooms of the step."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = re.match(r'#include "step/([^"/]+)/', line)
        if found:
            yield number, found.group(1)


def check_rooms(step):
    """A room includes only itself and those to its left."""
    for folder in sorted(path for path in step.iterdir() if path.is_dir()):
        if folder.name not in ROOMS:
            problems.append(f"src/step/{folder.name} is no room of this script's list")
            continue
        files = sorted(folder.iterdir())
        if len(files) > LARGEST_ROOM:
            problems.append(f"src/step/{folder.name}: {len(files)} files, more than {LARGEST_ROOM}")
        for path in files:
            for number, room in rooms_in(path):
                if room not in ROOMS or ROOMS.index(room) > ROOMS.index(folder.name):
                    problems.append(f"{path.relative_to(ROOT)}:{number}: {folder.name} must not include {room}")
            for outside in re.findall(r'^#include "step/([^"/]+)"', path.read_text(), re.MULTILINE):
                if any(rooms_in(step / outside)):
                    problems.append(f"{path.relative_to(ROOT)}: a room must not include {outside}, which includes rooms")


def check_folders():
    """Folders stay small; what a section of the deck holds does not depend on the files that it is read from."""
    for folder in sorted(path for path in (ROOT / "src").rglob("*") if path.is_dir()):
        count = sum(path.is_file() for path in folder.iterdir())
        if count > LARGEST_FOLDER:
            problems.append(f"{folder.relative_to(ROOT)}: {count} files, more than {LARGEST_FOLDER}")
    for path in sorted((ROOT / "src" / "deck" / "sections").iterdir()):
        if '#include "deck/files/' in path.read_text():
            problems.append(f"{path.relative_to(ROOT)}: deck/sections must not include deck/files")


def check_tests():
    """Every verb of the step is tested by itself, so a test includes its header."""
    tested = tested_headers.included_in_tests()
    for folder, headers in tested_headers.headers_by_folder().items():
        if pathlib.Path(folder).parts[:1] == ("step",):
            problems.extend(f"src/{name}: no test includes it" for name in headers if name not in tested)


def in_top_folder():
    """Names that the repository has there, without what users leave; of a copy without its history, those of the list."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=False)
    names = {line.split("/")[0] for line in listed.stdout.splitlines()} if listed.returncode == 0 else TOP_LEVEL
    return {name for name in names if (ROOT / name).exists()}


def check_top_level():
    there = in_top_folder()
    problems.extend(f"{name}: not in the list of the top folder (TOP_LEVEL of this script)" for name in sorted(there - TOP_LEVEL))
    problems.extend(f"{name}: missing from the top folder" for name in sorted(TOP_LEVEL - there))


def check_versions():
    """One version everywhere; the newest in CHANGELOG.md stands first."""
    found = {name: re.search(pattern, (ROOT / name).read_text()) for name, pattern in VERSIONED.items() if (ROOT / name).exists()}
    said = {name: match.group(1) if match else "none" for name, match in found.items()}
    if len(set(said.values())) > 1:
        problems.append("versions differ: " + ", ".join(f"{name} says {version}" for name, version in said.items()))


def parts_of_package(file):
    """(line, part) of what a file of the Python package imports from the other parts."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        else:
            continue
        for name in names:
            if name.startswith("barreno."):
                yield node.lineno, name.split(".")[1]


def check_package():
    """The parts of the Python package import only themselves and those to their left."""
    package = ROOT / "src" / "python" / "barreno"
    found = {path.name for path in package.iterdir() if path.is_dir() and any(path.glob("*.py"))}
    problems.extend(f"src/python/barreno/{name} is no part of this script's list" for name in sorted(found - set(PARTS)))
    table = (ROOT / "docs" / "architecture.md").read_text().partition("| part of src/python/barreno |")[2].partition("\n\n")[0]
    named = re.findall(r"^\| ([\w/]+) \|", table, re.MULTILINE)
    if [name for name in named if "/" not in name] != PARTS:
        problems.append(f"docs/architecture.md has the parts {', '.join(named)} of src/python/barreno, this script {', '.join(PARTS)}")
    problems.extend(f"docs/architecture.md names {name}, which is no folder" for name in named if not (package / name).is_dir())
    for name in PARTS:
        for file in sorted((package / name).rglob("*.py")):
            for line, part in parts_of_package(file):
                if part != "places" and part not in PARTS[: PARTS.index(name) + 1]:
                    problems.append(f"{file.relative_to(ROOT)}:{line}: {name} must not import {part}")


def check_paths():
    """Where Python finds the package and the scripts is said once, by the launcher and by cmake/python_path.cmake."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=False).stdout.splitlines()
    for name in listed:
        path = ROOT / name
        if path.suffix not in (".py", ".sh", ".md", ".in", "") or not path.is_file() or path.is_symlink():
            continue
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            if PATH_OF_PYTHON in line:
                problems.append(f"{name}:{number}: {PATH_OF_PYTHON} is changed or read; set PYTHONPATH where the script is started")


def check_imports():
    """Scripts of verification, and files of the package, do not import each other in a circle."""
    for circle in import_cycles.circles(ROOT / "verification") + import_cycles.circles(ROOT / "src" / "python"):
        names = ", ".join(str(path.relative_to(ROOT)) for path in circle)
        problems.append(f"{names} import each other in a circle: move what they share to a file of its own")


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
    check_rooms(ROOT / "src" / "step")
    check_folders()
    check_tests()
    check_imports()
    check_package()
    check_paths()
    check_top_level()
    check_versions()
    print("\n".join(problems) or "layout is as docs/architecture.md says")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
