# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed at their checkpoints and resumed, on the same and on another number of ranks."""
from adversary.kill_moments import checkpoints_left, drawn_moment, run_to, whole_run
from adversary.one_set import FILE, FINISHED, REFUSED, Finding, must_end, tolerance_of
from adversary.same_runs import different

TURNS = 5  # of a run and its resumes; after the last the run is left alone
AGAIN = 0.8  # chance that the resumes are killed too


def said_all(ended):
    """Whether a resume found a run that had said its last words before the kill came: its files are whole."""
    return ended.code == REFUSED and "has reached its end time" in ended.err


def has_checkpoint(folder):
    return any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5"))


def count_placed(moment, tally):
    tally.add("kills")
    if moment.place != "time":
        tally.add("kills placed at a checkpoint")


def count_met(moment, tally):
    """Of a kill that ended a run which had a checkpoint and was not at its end."""
    if moment.place != "time":
        tally.add("kills placed at a checkpoint that met one")


def killed(barreno, deck, folder, straight, seconds, rng, tally):
    """A run that gets a signal, and is resumed until it has ended.

    @param straight  the folder of the same run, left alone; @return whether there was something to resume"""
    moments = [drawn_moment(rng) for _ in range(TURNS)]
    again = rng.random() < AGAIN
    words, whole = ["run", *(deck if isinstance(deck, list) else [deck]), "--out", folder], whole_run(straight, seconds)
    ended = run_to(barreno, words, folder, moments[0], whole)
    for turn, moment in enumerate(moments):
        count_placed(moment, tally)
        if ended.kind == "signal" and ended.code in (9, moment.kind):
            pass  # before the program notes signals, or by one that cannot be noted
        elif must_end(ended, FINISHED, 128 + moment.kind) == FINISHED:
            tally.add("kills that came too late")
            return True
        if not has_checkpoint(folder):
            tally.add("killed before the first checkpoint")
            # A sealed file that had no name yet is one to go on from.
            return must_end(barreno.run("resume", folder), FILE, FINISHED) == FINISHED
        # With hardly a step to come a further kill would miss.
        again = again and turn + 1 < TURNS and checkpoints_left(whole, folder) > 2
        ended = run_to(barreno, ["resume", folder], folder, moments[turn + 1] if again else None, whole)
        if said_all(ended):
            tally.add("kills that came too late")
            return True
        count_met(moment, tally)
        if not again:
            must_end(ended, FINISHED)
            tally.add("resumed to the end")
            return True
    return True


def try_kills(one, barreno, straight, seconds, tally):
    folder = one.folder / "killed"
    if killed(barreno, one.file, folder, straight, seconds, one.rng, tally):
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
    moment = drawn_moment(one.rng, [9])
    run_to(barreno, ["run", one.file, "--out", folder], folder, moment, whole_run(straight, seconds))
    if (folder / "checkpoint.h5").exists():
        count_placed(moment, tally)
        code = must_end(several.run("resume", folder), FINISHED, REFUSED)
        tally.add("kills that came too late") if code == REFUSED else count_met(moment, tally)
        wrong = different(straight, folder, tolerance_of(one.deck), same_ranks=False) if code == FINISHED else []
        if wrong:
            raise Finding(f"killed on one rank and resumed on {several.ranks}, it differs: {'; '.join(wrong[:8])}")
        tally.add("killed, resumed on more ranks and the same")
