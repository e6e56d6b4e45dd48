# SPDX-License-Identifier: BSD-3-Clause
"""Decks written where they are used, and what became of a run: finished, stopped with a sentence, or neither."""
import dataclasses
import json
import os
import pathlib
import subprocess
import time
from xml.sax.saxutils import quoteattr

from tools.runs import DECKS, Run, call, scratch_folder  # noqa: F401

HANGS = "does not end"


def text_of(value):
    return "{" + ", ".join(text_of(v) for v in value) + "}" if isinstance(value, (tuple, list)) else str(value)


def lines_of(name, entries, depth=0):
    pad = "  " * depth
    lines = [f"{pad}<ParameterList name={quoteattr(name)}>"]
    for key, value in entries.items():
        if isinstance(value, dict):
            lines += lines_of(key, value, depth + 1)
        else:
            lines.append(f'{pad}  <Parameter name={quoteattr(key)} type="string" value={quoteattr(text_of(value))}/>')
    return lines + [f"{pad}</ParameterList>"]


def write_deck(file, sections):
    pathlib.Path(file).write_text("\n".join(lines_of("Barreno", {"Schema Version": 1, **sections})) + "\n")


@dataclasses.dataclass
class Outcome:
    code: object  # exit code, or HANGS
    sentence: str
    run: object  # Run, or None where nothing was written
    seconds: float

    @property
    def finished(self):
        return self.code == 0


def attempt(barreno, sections, settings=None, longest=60.0, ranks=1):
    """Run a deck of nested dictionaries, at most `longest` seconds."""
    folder = pathlib.Path(scratch_folder())
    write_deck(folder / "deck.xml", sections)
    return attempt_file(barreno, folder / "deck.xml", settings, longest, folder / "run", ranks)


def attempt_file(barreno, deck, settings=None, longest=60.0, folder=None, ranks=1):
    folder = folder or pathlib.Path(scratch_folder()) / "run"
    words = ["run", str(deck), "--out", str(folder)]
    for path, value in (settings or {}).items():
        words += ["--set", f"{path}={text_of(value)}"]
    began = time.monotonic()
    try:
        result = call(barreno, words, ranks, longest)
    except subprocess.TimeoutExpired:
        return Outcome(HANGS, f"no end in {longest:g} s", None, longest)
    summary = folder / "summary.json"
    lines = [line for line in result.stderr.splitlines() if not line.startswith("warning: ")]
    sentence = "\n".join(lines).strip().removeprefix("barreno: ")
    if summary.exists():
        reason = json.loads(summary.read_text()).get("reason") or ""
        sentence = reason or sentence
    run = Run(folder) if summary.exists() else None
    return Outcome(result.returncode, sentence, run, time.monotonic() - began)


def check_notes(barreno, sections, settings=None):
    """What `barreno check` says of a deck."""
    folder = pathlib.Path(scratch_folder())
    write_deck(folder / "deck.xml", sections)
    words = ["check", str(folder / "deck.xml")]
    for path, value in (settings or {}).items():
        words += ["--set", f"{path}={text_of(value)}"]
    result = call(barreno, words, longest=60)
    return result.returncode, result.stdout, result.stderr


def elastic(bulk, shear, density=1000.0, **more):
    return {"Model": "Linear Elastic", "Density": density, "Bulk Modulus": bulk, "Shear Modulus": shear, "Bad Particles": "stop", **more}


def symmetry(*faces):
    return {face: {"Face": face, "Kind": "symmetry"} for face in faces}


# Without artificial viscosity, which would hide what grows.
BARE = {"Linear Viscosity": 0, "Quadratic Viscosity": 0}
