# SPDX-License-Identifier: BSD-3-Clause
"""Small perforations with each fidelity and kind of jet: killed and resumed, on other ranks, on disks that fail."""
import shutil

import numpy as np
from adversary.disk_faults import try_fault
from adversary.kill_moments import built_library, drawn_moment, run_to, whole_run
from adversary.kills import killed
from adversary.one_set import DECKS, FINISHED, Finding, must_end
from adversary.same_runs import different, unsound

DECK = DECKS / "perforation_quick.xml"
# Chances that a perforation is tried so; all are run and killed.
SHARE = {"fault": 0.35, "ranks": 0.15}
KILLS = 3  # of one perforation
# Counts of kills that perforations have for themselves too.
PARTS = {
    "kills": "kills of perforations",
    "kills placed at a checkpoint": "kills of perforations placed at a checkpoint",
    "kills placed at a checkpoint that met one": "kills of perforations placed at a checkpoint that met one",
}


def drawn_words(rng):
    """A small perforation: its fidelity and options as words of a command line."""
    fidelity = str(rng.choice(["", "fast", "balanced"]))
    changes = {
        "Time/End Time": f"{rng.uniform(1.0, 3.0):.3g} us",
        "Output/Checkpoint Steps": str(rng.integers(1, 5)),
        "Output/Field Interval": str(rng.choice(["0.5 us", "1 us", "2 us"])),
        "Jet/Kind": str(rng.choice(["discrete", "thinned", "continuous"])),
    }
    if changes["Jet/Kind"] == "continuous":
        changes["Materials/Tungsten/Expansion Strain"] = "on"
    if not fidelity:
        changes["Grid/Cell Size"] = str(rng.choice(["5 mm", "10 mm"]))
        changes["Step/Subcycles"] = str(rng.choice([1, 2, 4, 8]))
    if rng.random() < 0.5:
        changes["Step/Return Losses"] = "true"
    words = ["--fidelity", fidelity] if fidelity else []
    return [*words, *(word for item in changes.items() for word in ("--set", "=".join(item)))]


def refuse_different(straight, folder, how, same_ranks=True):
    wrong = different(straight, folder, same_ranks=same_ranks)
    if wrong:
        raise Finding(f"{how}, it differs from the straight run: {'; '.join(wrong[:8])}")


def try_other_ranks(servers, straight, command, folder, seconds, rng, tally):
    """Killed on one number of ranks and resumed on another one."""
    counts = [(1, "plain"), (2, 2), (3, 3)]
    first, second = (counts[i] for i in rng.permutation(3)[:2])
    begun, moment = servers[first[1]], drawn_moment(rng, [9])
    if first[0] == 1:
        run_to(servers["killed"], [*command, "--out", folder], folder, moment, whole_run(straight, seconds))
    else:
        # A server of several ranks has no process to kill for one run: a checkpoint of the middle does it.
        must_end(begun.run(*command, "--out", folder), FINISHED)
        previous = folder / "checkpoint_previous.h5"
        if not previous.exists():
            return
        previous.replace(folder / "checkpoint.h5")
        (folder / "summary.json").unlink()
    if not (folder / "checkpoint.h5").exists() or (folder / "summary.json").exists():
        return
    must_end(servers[second[1]].run("resume", folder), FINISHED)
    refuse_different(straight, folder, f"begun on {first[0]} ranks and resumed on {second[0]}", same_ranks=False)
    tally.add("perforations resumed on other ranks and the same")


def try_perforation(servers, words, folder, library, rng, tally):
    """One run that is left alone, and what is done to others like it."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    command = ["run", DECK, *words]
    straight = folder / "straight"
    ended = servers["plain"].run(*command, "--out", straight)
    must_end(ended, FINISHED)
    tally.add("perforations with fidelities")
    wrong = unsound(straight)
    if wrong:
        raise Finding("; ".join(wrong[:8]))
    seconds = max(ended.seconds, 0.05)
    for number in range(KILLS):
        place = folder / f"killed{number}"
        before = dict(tally.counts)
        if killed(servers["killed"], command[1:], place, straight, seconds, rng, tally):
            refuse_different(straight, place, "killed and resumed")
            tally.add("perforations killed, resumed and the same")
        for of_all, of_these in PARTS.items():
            tally.add(of_these, tally.counts.get(of_all, 0) - before.get(of_all, 0))
    if rng.random() < SHARE["fault"]:
        try_fault(servers["program"], straight, command, folder / "faulty", library, rng, tally)
    if rng.random() < SHARE["ranks"]:
        try_other_ranks(servers, straight, command, folder / "ranks", seconds, rng, tally)


def try_perforations(numbers, seed, _table, servers, folder, tally):
    """Yields (number, what is tried, how it is tried)."""
    library = built_library(folder, "full_disk") if numbers else None
    for number in numbers:
        rng = np.random.default_rng([seed, number])
        words = drawn_words(rng)

        def trial(words=words, rng=rng):
            try_perforation(servers, words, folder / "perforation", library, rng, tally)

        yield number, lambda words=words: words, trial
