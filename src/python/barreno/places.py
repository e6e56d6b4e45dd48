# SPDX-License-Identifier: BSD-3-Clause
"""Where launcher, program and library are: in the source tree or in the installation that the package belongs to."""

import os
import pathlib
import shutil

PACKAGE = pathlib.Path(__file__).resolve().parent
NOTE = "installed_from.txt"  # setup.py writes it into a package that pip installs


def home():
    """The folder of the package as Barreno ships it: src/python of the tree, share/barreno/python of an installation. A package that pip
    has installed knows where it came from."""
    note = PACKAGE / NOTE
    return pathlib.Path(note.read_text(encoding="utf-8").strip()) if note.is_file() else PACKAGE.parent


def root():
    """(the source tree, None), or (None, the prefix of an installation), or (None, None)."""
    parents = home().parents
    if len(parents) > 1 and (parents[1] / "barreno").is_file():
        return parents[1], None
    return None, parents[2] if len(parents) > 2 and (parents[2] / "bin" / "barreno").is_file() else None


def commands():
    """commands.sh, which the launcher reads."""
    return home().parent / "commands.sh"


def launcher():
    """./barreno of the tree or bin/barreno of the installation; None where neither is there."""
    tree, prefix = root()
    return tree / "barreno" if tree else prefix / "bin" / "barreno" if prefix else None


def is_console_script(path):
    """Whether a file is the command that pip made: a Python script, not the program."""
    with open(path, "rb") as stream:
        return b"python" in stream.readline(200)


def program():
    """The program that BARRENO_PROGRAM names, that of the installation or of the tree, or the first on the path; None if there is none."""
    named = os.environ.get("BARRENO_PROGRAM")
    if named:
        return named
    tree, prefix = root()
    found = tree / "build" / "release" / "src" / "barreno" if tree else prefix / "libexec" / "barreno" / "barreno" if prefix else None
    if found and found.is_file():
        return str(found)
    on_path = shutil.which("barreno")
    return None if on_path is None or is_console_script(on_path) else on_path


def cards():
    """The folder of the cards that Barreno comes with; None where there is none."""
    tree, _ = root()
    folder = tree / "materials" / "cards" if tree else home().parent / "cards"
    return folder if folder.is_dir() else None


def library():
    """libBARRENO.so that BARRENO_LIBRARY names, or that of the installation or of the tree; None if there is none."""
    named = os.environ.get("BARRENO_LIBRARY")
    if named:
        return pathlib.Path(named)
    for folder in home().parents:
        for found in sorted(folder.glob("lib*/libBARRENO.so")) + sorted(folder.glob("lib*/*/libBARRENO.so")):
            return found
    tree, _ = root()
    built = tree / "build" / "release" / "materials" / "libBARRENO.so" if tree else None
    return built if built and built.is_file() else None
