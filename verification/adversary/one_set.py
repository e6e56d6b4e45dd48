# SPDX-License-Identifier: BSD-3-Clause
"""What is tried with one random option set: it is checked, run, run under sanitizers, killed and resumed, run on more ranks."""
import dataclasses
import pathlib
import re
import shutil

import numpy as np
from deck_tree import Deck
from draw import draw_set
from same_runs import different, unsound
from small_scene import shrink

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECKS = ROOT / "input_xml"
# Particle-steps of one run: a tenth of a second, and a second of it under sanitizers.
WORK = {"plain": 1.5e5, "sanitized": 3e4}
MOST_STEPS = 300
MOST_REFUSALS = 12
# Exit codes of a run: finished; refused by a sentence; a file; no numerical answer. Signals are 128 and their number.
FINISHED, REFUSED, FILE, NUMERICAL = 0, 1, 2, 3


@dataclasses.dataclass
class Tally:
    """What came of some option sets."""

    counts: dict = dataclasses.field(default_factory=dict)
    drawn: set = dataclasses.field(default_factory=set)
    decks: set = dataclasses.field(default_factory=set)
    findings: list = dataclasses.field(default_factory=list)

    def add(self, what, number=1):
        self.counts[what] = self.counts.get(what, 0) + number


class Finding(Exception):
    """Something that must not be."""


def sentence_of(ended):
    """The one line that says why a command was refused. @raises Finding  if there is not one"""
    lines = [line for line in ended.err.splitlines() if line.strip()]
    if len(lines) != 1 or not lines[0].startswith("barreno: ") or "internal error" in lines[0]:
        raise Finding(f"{ended.text()} without one sentence: {ended.err.strip()[-1500:] or 'nothing'}")
    return lines[0]


def must_end(ended, *codes):
    """One of these exit codes, and a sentence where it is a refusal."""
    if ended.kind != "exit" or ended.code not in codes:
        raise Finding(f"{ended.words[0]}: {ended.text()}: {(ended.err.strip() or ended.out.strip())[-1500:]}")
    if ended.code in (REFUSED, FILE):
        sentence_of(ended)
    return ended.code


def tolerance_of(deck):
    """Of a comparison between runs whose solver of the pore flow began afresh or summed in another order."""
    return 0.0 if deck.find("Pore Flow") is None else 1e-5


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

    def shorten(self, plan, work):
        """So many particle-steps, by what `check` says of particles and the first step; output and checkpoints within them."""
        particles = max(float(re.search(r"^Particles ([\d.e+]+)", plan, re.MULTILINE).group(1)), 1.0)
        step = float(re.search(r"first steps of ([-+.\dei]+) s", plan).group(1))
        steps = int(min(MOST_STEPS, max(6, work / particles)) * self.rng.uniform(0.3, 1.0)) + 1
        end = steps * step
        self.deck.set("Time/End Time", repr(end))
        for name in ("Field Interval", "History Interval", "Checkpoint Interval"):
            if name != "Checkpoint Interval" or self.deck.find("Output/Checkpoint Interval") is not None:
                self.deck.set(f"Output/{name}", repr(float(self.rng.choice([0.0, end * self.rng.uniform(0.05, 1.2)]))))
        self.deck.set("Output/Checkpoint Steps", int(self.rng.integers(1, max(3, steps // 2))))
        self.deck.write(self.file)
        return particles * steps


def killed(barreno, deck, folder, seconds, rng, tally):
    """A run that gets a signal, and is resumed until it has ended. @return whether there was something to resume"""
    kind = int(rng.choice([9, 9, 9, 15, 2]))
    ended = barreno.run("run", deck, "--out", folder, signal=kind, after=rng.uniform(0.0, 1.0) * seconds)
    for _ in range(3):
        tally.add("kills")
        if ended.kind == "signal" and ended.code in (9, kind):
            pass  # before the program notes signals, or by one that cannot be noted
        elif must_end(ended, FINISHED, 128 + kind) == FINISHED:
            tally.add("kills that came too late")
            return True
        if not any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5")):
            refusal = barreno.run("resume", folder)
            must_end(refusal, FILE)
            tally.add("killed before the first checkpoint")
            return False
        # The last attempt is left alone.
        kind = int(rng.choice([9, 9, 15, 2, 0, 0, 0])) if _ < 2 else 0
        ended = barreno.run("resume", folder, signal=kind, after=rng.uniform(0.0, 1.0) * seconds)
        if kind == 0:
            must_end(ended, FINISHED)
            tally.add("resumed to the end")
            return True
    return True


def try_kills(one, barreno, straight, seconds, tally):
    folder = one.folder / "killed"
    if killed(barreno, one.file, folder, seconds, one.rng, tally):
        wrong = different(straight, folder, tolerance_of(one.deck))
        if wrong:
            raise Finding(f"killed and resumed, it differs from the straight run: {'; '.join(wrong[:8])}")
        tally.add("killed, resumed and the same")


def try_ranks(one, barreno, several, straight, seconds, tally):
    """Straight on several ranks, and begun on one and resumed on several."""
    folder = one.folder / "several"
    must_end(several.run("run", one.file, "--out", folder), FINISHED)
    wrong = different(straight, folder, tolerance_of(one.deck), same_ranks=False)
    if wrong:
        raise Finding(f"on {several.ranks} ranks it differs from one: {'; '.join(wrong[:8])}")
    tally.add("the same on more ranks")
    folder = one.folder / "moved"
    barreno.run("run", one.file, "--out", folder, signal=9, after=one.rng.uniform(0.3, 1.0) * seconds)
    if (folder / "checkpoint.h5").exists():
        tally.add("kills")
        code = must_end(several.run("resume", folder), FINISHED, REFUSED)
        wrong = different(straight, folder, tolerance_of(one.deck), same_ranks=False) if code == FINISHED else []
        if wrong:
            raise Finding(f"killed on one rank and resumed on {several.ranks}, it differs: {'; '.join(wrong[:8])}")
        tally.add("killed, resumed on more ranks and the same")


def try_set(one, servers, share, tally):
    """@param share  chances of "sanitized", "kills" and "ranks"; @raises Finding"""
    plain = servers["plain"]
    tally.add("sets")
    refusals = []
    plan = plain.run("check", one.file)
    while must_end(plan, FINISHED, REFUSED) == REFUSED:
        tally.add("refused")
        refusals.append(sentence_of(plan))
        if not one.changes or len(refusals) > MOST_REFUSALS:
            return refusals
        one.give_up(refusals[-1])
        plan = plain.run("check", one.file)
    tally.add("accepted")
    tally.decks.add(one.source.name)
    tally.drawn.update(one.drawn_paths())
    one.shorten(plan.out, WORK["plain"])
    straight = one.folder / "straight"
    begun = plain.run("run", one.file, "--out", straight)
    code = must_end(begun, FINISHED, NUMERICAL)
    tally.add("finished" if code == FINISHED else "stopped with a reason")
    if code == FINISHED:
        wrong = unsound(straight)
        if wrong:
            raise Finding("; ".join(wrong[:8]))
        seconds = max(begun.seconds, 0.02)
        if one.rng.random() < share["kills"]:
            try_kills(one, plain, straight, seconds, tally)
        if one.rng.random() < share["ranks"]:
            try_ranks(one, plain, servers[int(one.rng.choice([2, 3]))], straight, seconds, tally)
    if one.rng.random() < share["sanitized"]:
        one.shorten(plan.out, WORK["sanitized"])
        must_end(servers["sanitized"].run("run", one.file, "--out", one.folder / "sanitized"), FINISHED, NUMERICAL)
        tally.add("under sanitizers")
    return refusals
