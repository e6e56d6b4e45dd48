# SPDX-License-Identifier: BSD-3-Clause
"""Runs with cells of several sizes: those that are there are taken, others are made or continued."""

import dataclasses
import fractions
import math
import pathlib
import xml.etree.ElementTree as xml

from barreno_converge.faults import NUMERICAL, Fault
from barreno_converge.program import as_set, body_of
from barreno_converge.quantity import read_summary

CELL_SIZE, UPPER, CELLS_PER_RADIUS = "Grid/Cell Size", "Grid/Upper", "Jet/Cells Per Radius"
ROUND_OFF = 1e-9


@dataclasses.dataclass
class Level:
    cells: float  # [m]
    words: list  # of the deck
    deck: str  # as it takes effect
    folder: pathlib.Path
    how: str = ""  # "reused", "resumed" or "computed"


def value_in(deck, path):
    """Text of a parameter of an effective deck, or None."""
    node = xml.fromstring(deck)
    *lists, name = path.split("/")
    for one in lists:
        node = next((child for child in node if child.get("name") == one), None)
        if node is None:
            return None
    return next((child.get("value") for child in node if child.get("name") == name), None)


def cells_of(size, count, ratio):
    """Cell sizes, the smallest first: one level below the deck's own, the others above."""
    return [size * ratio ** (i - 1) for i in range(count)]


def vector_in(deck, path):
    return [float(x) for x in value_in(deck, path).strip("{}").split(",")]


def bound_faces(deck):
    """Faces of the grid that a condition holds."""
    conditions = next((child for child in xml.fromstring(deck) if child.get("name") == "Conditions"), [])
    return {entry.get("value") for one in conditions for entry in one if entry.get("name") == "Face"}


def common_length(finest, count, ratio):
    """The smallest length that the cells of all levels divide."""
    step = fractions.Fraction(ratio).limit_denominator(64)
    sizes = [step**i for i in range(count)]
    return finest * math.lcm(*(size.numerator for size in sizes)) / math.gcd(*(size.denominator for size in sizes))


def common_upper(deck, length):
    """Upper corner of the box that all levels divide: the deck's own, or further out where the box is open. A face with a condition stays,
    and a cell size that does not divide such a box is refused as in any run."""
    lower, upper, bound = vector_in(deck, "Grid/Lower"), vector_in(deck, UPPER), bound_faces(deck)
    for axis, (low, high) in enumerate(zip(lower, upper)):
        count = (high - low) / length
        if abs(count - round(count)) > ROUND_OFF * count and f"{'xyz'[axis]}_upper" not in bound:
            upper[axis] = low + math.ceil(count) * length
    return upper


def box_setting(deck, length, say):
    """The override that enlarges the box of all levels; none where the deck's fits."""
    upper = common_upper(deck, length)
    if upper == vector_in(deck, UPPER):
        return []
    text = "{" + ", ".join(f"{x!r} m" for x in upper) + "}"
    say(f"{UPPER} is moved out to {{{', '.join(f'{x:.6g} m' for x in upper)}}} on all levels, so that their cells divide the box")
    return [f"{UPPER}={text}"]


def folder_name(cells):
    return f"cells-{1e3 * cells:.6g}mm"


def cell_settings(base, size):
    """The overrides that give all cells of a deck another size, those along the path of a jet too."""
    settings = [f"{CELL_SIZE}={size!r} m"]
    along_path = float(value_in(base, CELLS_PER_RADIUS) or 0.0)
    if along_path > 0.0:
        settings.append(f"{CELLS_PER_RADIUS}={along_path * float(value_in(base, CELL_SIZE)) / size!r}")
    return settings


def make_levels(program, deck, settings, base, sizes, out):
    """Every level's effective deck: what is wrong with one is said before anything is computed."""
    levels = []
    for size in sizes:
        words = [deck, *as_set([*settings, *cell_settings(base, size)])]
        levels.append(Level(size, words, program.effective_deck(words), out / folder_name(size)))
    return levels


def deck_in(folder):
    try:
        return body_of((folder / "deck.xml").read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError):
        return None


def state_of(folder):
    """(finished, version) as a run says; (False, "") of one that was killed."""
    try:
        summary = read_summary(folder)
    except Fault:
        return False, ""
    return (summary.get("finished") is True, summary.get("version", "")) if isinstance(summary, dict) else (False, "")


def find_finished(level, version, places):
    """A finished run of the same program and the same effective deck: in its own folder, or in one of the places."""
    candidates = [level.folder]
    for place in places:
        if place.is_dir():
            candidates += sorted(folder for folder in place.iterdir() if (folder / "deck.xml").is_file())
    return next((folder for folder in candidates if deck_in(folder) == level.deck and state_of(folder) == (True, version)), None)


def can_go_on(level, version):
    """An unfinished run of this deck, by this version as far as it says."""
    finished, made_by = state_of(level.folder)
    return not finished and made_by in ("", version) and deck_in(level.folder) == level.deck and (level.folder / "checkpoint.h5").exists()


def compute(program, level, version):
    """@return how the run was made, its exit code, and what it said of a failure"""
    if can_go_on(level, version):
        code, _ = program.compute(["resume", str(level.folder)])
        if code == 0 or program.asked:
            return "resumed", code, ""
    code, said = program.compute(["run", *level.words, "--out", str(level.folder), "--overwrite"])
    return "computed", code, said


def run_level(program, level, places, say):
    """Takes, continues or makes the run of a level. @raises Fault if it fails"""
    version = program.version()
    found = find_finished(level, version, places)
    if found:
        level.folder, level.how = found, "reused"
        older = " (made before the program was built last; remove it if its answer has changed since)" if program.is_newer_than(found / "deck.xml") else ""
        say(f"cells of {level.cells:.6g} m: finished run in {found}{older}")
        return
    say(f"cells of {level.cells:.6g} m: computing in {level.folder} (progress in its run.log)")
    level.how, code, said = compute(program, level, version)
    if program.asked:
        raise Fault("interrupted; the same command continues, and takes the finished runs as they are.", 128 + program.asked)
    if code:
        raise Fault(f"the run with cells of {level.cells:.6g} m ended with exit code {code}: {said or 'see its run.log in ' + str(level.folder)}", code if 0 < code < 128 else NUMERICAL)
    say(f"  {read_summary(level.folder).get('wall_seconds', 0.0):.3g} s")
