# SPDX-License-Identifier: BSD-3-Clause
"""Runs with cells of several sizes: those that are there are taken, others are made or continued."""

import dataclasses
import fractions
import math
import re

from barreno.runs.effective_deck import find_list, value_in
from barreno.runs.faults import Fault
from barreno.runs.make_runs import Making, Run, finished_in, take_finished
from barreno.runs.program import as_set
from barreno.runs.run_folder import read_summary

CELL_SIZE, UPPER, CELLS_PER_RADIUS = "Grid/Cell Size", "Grid/Upper", "Jet/Cells Per Radius"
ROUND_OFF = 1e-9


@dataclasses.dataclass
class Level(Run):
    cells: float = 0.0  # Grid/Cell Size [m]

    def refined_to(self):
        """Size of the smallest cells that its run had, [m]."""
        shares = read_summary(self.folder).get("particle_steps_by_cell_size")
        found = [re.fullmatch(r"(\d[\d.e+-]*) mm", name) for name in shares] if isinstance(shares, dict) else []
        sizes = [1e-3 * float(one.group(1)) for one in found if one]
        return min([self.cells, *sizes])

    def name(self, unit="m", size=1.0):
        """Of its cells, and where they lie.

        @param size  of the unit [m]"""
        finest = self.refined_to()
        if finest > 0.999 * self.cells:
            return f"{self.cells / size:.4g} {unit}"
        where = "along the jet's path" if float(value_in(self.deck, CELLS_PER_RADIUS) or 0.0) > 0.0 else "where refined"
        return f"{self.cells / size:.4g} {unit} ({finest / size:.4g} {unit} {where})"


def cells_of(size, count, ratio):
    """Cell sizes, the smallest first: one level below the deck's own, the others above."""
    return [size * ratio ** (i - 1) for i in range(count)]


def vector_in(deck, path):
    return [float(x) for x in value_in(deck, path).strip("{}").split(",")]


def bound_faces(deck):
    """Faces of the grid that a condition holds."""
    conditions = find_list(deck, "Conditions")
    return {entry.get("value") for one in (() if conditions is None else conditions) for entry in one if entry.get("name") == "Face"}


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
        levels.append(Level(words, program.effective_deck(words), out / folder_name(size), cells=size))
    return levels


def run_level(program, level, places, say):
    """Takes, continues or makes the run of a level. @raises Fault if it fails"""
    version = program.version()
    if take_finished(level, version, finished_in(places, version)):
        older = (
            " (made before the program was built last; remove it if its answer has changed since)"
            if program.is_newer_than(level.folder / "deck.xml") else ""
        )
        say(f"cells of {level.cells:.6g} m: finished run in {level.folder}{older}")
        return
    say(f"cells of {level.cells:.6g} m: computing in {level.folder} (progress in its run.log)")
    Making(program, level, version).wait()
    if program.asked:
        raise Fault("interrupted; the same command continues, and takes the finished runs as they are.", 128 + program.asked)
    if level.code:
        raise Fault(f"the run with cells of {level.cells:.6g} m {level.failure()}", level.failure_code())
    say(f"  {read_summary(level.folder).get('wall_seconds', 0.0):.3g} s")
