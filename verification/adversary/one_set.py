# SPDX-License-Identifier: BSD-3-Clause
"""A random option set as a deck, and how a command may end."""
import dataclasses
import pathlib
import re
import shutil

import numpy as np
from adversary.deck_tree import Deck
from adversary.draw import draw_set
from adversary.small_scene import shrink

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECKS = ROOT / "input_xml"
# Particle-steps of one run: a twentieth of a second, and half a second of it under sanitizers.
WORK = {"plain": 6e4, "sanitized": 1.5e4}
# Of a fidelity or Cells Per Radius that makes a small deck large again, six steps may be more.
TOO_MUCH = {"plain": 2e6, "sanitized": 2e5}
MOST_STEPS = 200
MOST_REFUSALS = 12
# Exit codes of a run: finished; refused by a sentence; a file; no numerical answer. Signals are 128 and their number.
FINISHED, REFUSED, FILE, NUMERICAL = 0, 1, 2, 3


@dataclasses.dataclass
class Tally:
    """What came of some option sets."""

    counts: dict = dataclasses.field(default_factory=dict)
    drawn: set = dataclasses.field(default_factory=set)
    decks: set = dataclasses.field(default_factory=set)
    refusals: dict = dataclasses.field(default_factory=dict)
    findings: list = dataclasses.field(default_factory=list)

    def add(self, what, number=1):
        self.counts[what] = self.counts.get(what, 0) + number


class Finding(Exception):
    """Something that must not be."""


def said_by(ended):
    """Its last words; after a signal the first, before the addresses."""
    text = (ended.err.strip() or ended.out.strip())[-6000:]
    found = re.search(r"(runtime error|ERROR: AddressSanitizer|Kokkos|Assertion).*", text, re.DOTALL)
    return found.group(0)[:1500] if found else text[:300] if ended.kind == "signal" else text[-1500:]


def sentence_of(ended):
    """The one line that says why a command was refused. @raises Finding  if there is not one"""
    # That it waits for another process is said before.
    lines = [line for line in ended.err.splitlines() if line.strip() and "waiting up to" not in line]
    if len(lines) != 1 or not lines[0].startswith("barreno: ") or "internal error" in lines[0]:
        raise Finding(f"{ended.text()} without one sentence: {ended.err.strip()[-1500:] or 'nothing'}")
    return lines[0]


def must_end(ended, *codes):
    """One of these exit codes, and a sentence where it is a refusal."""
    if ended.kind != "exit" or ended.code not in codes:
        raise Finding(f"{ended.words[0]}: {ended.text()}: {said_by(ended)}")
    if ended.code in (REFUSED, FILE):
        sentence_of(ended)
    return ended.code


def tolerance_of(deck):
    """Of a comparison between runs whose solver of the pore flow began afresh or summed in another order."""
    return 0.0 if deck.find("Pore Flow") is None else 1e-5


def shortened(plan, work, most):
    """End time, steps and particles of so many particle-steps, but not of more steps than `most`, by the plan that `check` printed."""
    particles = max(float(re.search(r"^Particles ([\d.e+]+)", plan, re.MULTILINE).group(1)), 1.0)
    step = float(re.search(r"first steps of ([-+.\dei]+) s", plan).group(1))
    steps = int(min(most, max(6, work / particles))) + 1
    return steps * step, steps, particles


class OptionSet:
    """The set with this number of this seed, over one of the shipped decks."""

    def __init__(self, seed, number, table, folder):
        self.name = f"{seed}:{number}"
        self.rng = np.random.default_rng([seed, number])
        self.folder = pathlib.Path(folder)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        (self.folder / "jets").symlink_to(DECKS / "jets")
        decks = sorted(DECKS.glob("*.xml"))
        self.source = decks[int(self.rng.integers(len(decks)))]
        self.deck = Deck(self.source)
        shrink(self.deck, self.rng)
        self.changes, self.reference = draw_set(self.deck, table, self.rng)
        self.plain_deck = self.deck
        self.file = self.folder / "deck.xml"
        self.write()

    def write(self):
        """The deck with its changes."""
        self.deck = self.plain_deck.copy()
        for path, value in self.changes:
            self.deck.set(path, value)
        self.deck.write(self.file)

    def give_up(self, refusal):
        """Takes back the change that a refusal names, or some of them."""
        named = [change for change in self.changes if change[0] in refusal]
        # A list that was added goes as a whole.
        lists = {change[0].rpartition("/")[0] for change in named if self.plain_deck.find(change[0].rpartition("/")[0]) is None}
        longest = max((len(change[0]) for change in named), default=0)
        kept = [c for c in self.changes if len(c[0]) < longest or c not in named]
        kept = [c for c in kept if c[0].rpartition("/")[0] not in lists]
        self.changes = kept if named else [c for c in self.changes if self.rng.random() < 0.5]
        self.write()

    def drawn_paths(self):
        """Of what is still changed, the paths in the deck reference."""
        return {self.reference[path] for path, _ in self.changes}

    def shorten(self, plan, which):
        """So many particle-steps, by what `check` says of particles and the first step; output and checkpoints within them.

        @return whether that is few enough"""
        end, steps, particles = shortened(plan, WORK[which], MOST_STEPS * self.rng.uniform(0.3, 1.0))
        self.deck.set("Time/End Time", repr(end))
        for name in ("Field Interval", "History Interval", "Checkpoint Interval"):
            if name != "Checkpoint Interval" or self.deck.find("Output/Checkpoint Interval") is not None:
                self.deck.set(f"Output/{name}", repr(float(self.rng.choice([0.0, end * self.rng.uniform(0.2, 1.2)]))))
        # Mostly two or a few checkpoints: each costs as much as several steps, and kills are placed at them.
        least = 1.0 if self.rng.random() < 0.05 else max(1.0, steps / 6)
        self.deck.set("Output/Checkpoint Steps", round(least * (max(2.0, steps / 3) / least) ** self.rng.random()))
        self.deck.write(self.file)
        return particles * steps <= TOO_MUCH[which]
