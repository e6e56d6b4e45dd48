#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the linker ties together points left, as includes do (check_layout.py).

A room may call only what it or a room to its left defines, and what a room defines stands in a header of that room. A function that is
declared in one room and defined in another passes every rule about includes and still ties the first room to the second.

    check_link_arrows.py BUILD_FOLDER [NM]

It reads the symbols of the object files of the library barreno_core.
"""
import pathlib
import re
import subprocess
import sys

import check_layout

ROOT = pathlib.Path(__file__).resolve().parents[2]
STRONG = "TDBRGS"  # defined once, in one room; inline functions and templates are wherever they are used
SYMBOL = re.compile(r"^[0-9a-f ]+ ([A-Za-z]) (.+)$")


def folder_of(name):
    """Folder of src that an object file was made of: of one source, or of all sources of a folder."""
    together = re.fullmatch(r"Unity/unity_folder_(\w*?)_cxx\.cxx\.o", name)
    return together.group(1) if together else str(pathlib.PurePosixPath(name).parent)


def place_of(folder):
    """(place in the order of rooms, in that of the step's rooms), and the room's name, of 'step/order', 'step_order' or '.'."""
    for room in check_layout.ORDER:
        if room != "." and (folder == room or folder.startswith((f"{room}/", f"{room}_"))):
            inner = folder[len(room) + 1 :] if room == "step" else ""
            rank = check_layout.ROOMS.index(inner) if inner in check_layout.ROOMS else len(check_layout.ROOMS)
            return (check_layout.ORDER.index(room), rank), f"step/{inner}" if inner else room
    return (check_layout.ORDER.index("."), 0), "."


def symbols_of(file, nm):
    """{name: letter}, names as they stand in the source."""
    shown = subprocess.run([nm, "-C", str(file)], capture_output=True, text=True, check=True).stdout
    return {found.group(2): found.group(1) for found in map(SYMBOL.match, shown.splitlines()) if found}


def objects_in(folder, src, members):
    """{object file: its name}; of files that an earlier build left there, none: an object stands in the library, and its source in src."""
    found = {}
    for file in sorted(folder.rglob("*.o")):
        name = file.relative_to(folder).as_posix()
        alone = not name.startswith("Unity/")
        if file.name in members and (not alone or (src / name.removesuffix(".o")).exists()):
            found[file] = name
    return found


def headers_by_room(src):
    """{room: the text of its headers}"""
    texts = {}
    for path in sorted(src.rglob("*.hpp")):
        folder = path.relative_to(src).parent.as_posix()
        texts.setdefault(place_of(folder)[1].split("/")[0], []).append(path.read_text())
    return {room: "\n".join(found) for room, found in texts.items()}


def upward_calls(symbols):
    """Sentences about what a room takes from one to its right. @param symbols  {(place, room): {symbol: letter}}"""
    home = {name: key for key, found in symbols.items() for name, letter in found.items() if letter in STRONG}
    return sorted(f"{room} needs {name}, which {home[name][1]} defines, to its right"
                  for (place, room), found in symbols.items() for name, letter in found.items()
                  if letter == "U" and name in home and home[name][0] > place)  # fmt: skip


def foreign_declarations(symbols, headers):
    """Sentences about what is defined in another room than the one whose header declares it."""
    wrong = []
    for (_, room), found in symbols.items():
        own = headers.get(room.split("/")[0], "")
        for word in sorted({name.split("::")[1].split("(")[0].split("[")[0] for name, letter in found.items()
                            if letter in STRONG and re.match(r"barreno::\w+[(:\[]", name)}):  # fmt: skip
            whole = re.compile(rf"\b{word}\b")
            if whole.search(own):
                continue
            # A declaration: a type before the name, at the beginning of a line.
            declared = re.compile(rf"^(?!//|\s)[\w:<>,&* ]+[ &*]{word}\s*[({{;]", re.MULTILINE)
            wrong += [f"{word} is declared in a header of {other} and defined in {room}"
                for other, text in headers.items() if declared.search(text)]
    return wrong


def problems(objects_folder, members, src, nm="nm"):
    symbols = {}
    for file, name in objects_in(objects_folder, src, members).items():
        place, room = place_of(folder_of(name))
        into = symbols.setdefault((place, room), {})
        for symbol, letter in symbols_of(file, nm).items():
            if into.get(symbol, "U") == "U":  # one file of a room may define what another needs
                into[symbol] = letter
    if not symbols:
        return [f"{objects_folder}: no object files (build the program first)"]
    return upward_calls(symbols) + foreign_declarations(symbols, headers_by_room(src))


def main():
    build, nm = pathlib.Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "nm"
    archive = build / "src" / "libbarreno_core.a"
    if not archive.exists():
        print(f"{archive} is missing: build the program first")
        return 1
    shown = subprocess.run([nm, "--print-file-name", str(archive)], capture_output=True, text=True, check=True).stdout
    members = set(re.findall(r"^.*?\.a:([^:]+):", shown, re.MULTILINE))
    wrong = problems(build / "src" / "CMakeFiles" / "barreno_core.dir", members, ROOT / "src", nm)
    print("\n".join(wrong) or "what the linker ties together points left, as docs/architecture.md says")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
