# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed at random moments and resumed, on the same and on another number of ranks."""
import signal

from one_set import FILE, FINISHED, REFUSED, Finding, must_end, tolerance_of
from same_runs import different

KINDS = [9, 9, 9, 9, int(signal.SIGTERM), int(signal.SIGINT), int(signal.SIGHUP), int(signal.SIGUSR1)]


def said_all(ended):
    """Whether a resume found a run that had said its last words before the kill came: its files are whole."""
    return ended.code == REFUSED and "has reached its end time" in ended.err


def killed(barreno, deck, folder, seconds, rng, tally):
    """A run that gets a signal, and is resumed until it has ended. @return whether there was something to resume"""
    kind = int(rng.choice(KINDS))
    words = deck if isinstance(deck, list) else [deck]
    ended = barreno.run("run", *words, "--out", folder, signal=kind, after=rng.uniform(0.0, 1.0) * seconds)
    for turn in range(3):
        tally.add("kills")
        if ended.kind == "signal" and ended.code in (9, kind):
            pass  # before the program notes signals, or by one that cannot be noted
        elif must_end(ended, FINISHED, 128 + kind) == FINISHED:
            tally.add("kills that came too late")
            return True
        if not any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5")):
            # A sealed file that had no name yet is one to go on from.
            tally.add("killed before the first checkpoint")
            return must_end(barreno.run("resume", folder), FILE, FINISHED) == FINISHED
        # The last attempt is left alone.
        kind = int(rng.choice([*KINDS, *len(KINDS) * [0]])) if turn < 2 else 0
        ended = barreno.run("resume", folder, signal=kind, after=rng.uniform(0.0, 1.0) * seconds)
        if said_all(ended):
            tally.add("kills that came too late")
            return True
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
