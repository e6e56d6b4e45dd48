# SPDX-License-Identifier: BSD-3-Clause
"""Perforations with a fidelity whose disk fails at the n-th call (tools/full_disk.c), or that are killed; and their resumes."""
import errno
import pathlib
import shutil
import sys

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / "tools")]
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cases"))  # behind: it has a kills.py too
from full_disk import build as build_library  # noqa: E402
from kills import killed  # noqa: E402
from one_set import DECKS, FILE, FINISHED, Finding  # noqa: E402
from resumed import must_work, program  # noqa: E402
from same_runs import different  # noqa: E402

FIDELITIES = ((), ("--fidelity", "fast"), ("--fidelity", "balanced"))
ERRORS = {"ENOSPC": errno.ENOSPC, "EIO": errno.EIO, "EDQUOT": errno.EDQUOT, "short": 0}
CALLS = {"write": 400, "sync": 12, "rename": 12, "open": 12}


def drawn_words(rng):
    """A small perforation: its fidelity and options as words of a command line."""
    words = [*FIDELITIES[rng.integers(3)]]
    changes = {"Time/End Time": f"{rng.uniform(3.0, 6.0):.3g} us", "Output/Checkpoint Steps": str(rng.integers(5, 30)), "Output/Field Interval": "2 us"}
    if not words:
        changes["Grid/Cell Size"] = "10 mm"
    if rng.random() < 0.5:
        changes["Step/Return Losses"] = "true"
    return [*words, *(word for item in changes.items() for word in ("--set", "=".join(item)))]


def drawn_fault(rng, library, folder):
    """What fails, as words for a finding and as variables of the environment."""
    kind = str(rng.choice(list(CALLS), p=[0.7, 0.1, 0.1, 0.1]))
    name = str(rng.choice(list(ERRORS) if kind == "write" else ["ENOSPC", "EIO"]))
    call, once = int(rng.integers(1, CALLS[kind])), bool(rng.random() < 0.4)
    variables = {"LD_PRELOAD": str(library), "BARRENO_FULL_FOLDER": str(folder.resolve()), "BARRENO_FULL_CALL": str(call)}
    variables.update({"BARRENO_FULL_KIND": kind, "BARRENO_FULL_ERROR": str(ERRORS[name])})
    if once:
        variables["BARRENO_FULL_ONCE"] = "1"
    return [kind, name, call, "once" if once else "from then on"], variables


def judge_fault(ended):
    """A run whose disk failed ends in order: finished, or with exit code 2 and one sentence."""
    errors = [line for line in ended.stderr.splitlines() if line.strip() and not line.startswith("warning: ")]
    if ended.returncode not in (FINISHED, FILE):
        raise Finding(f"a failing disk: exit {ended.returncode}: {ended.stderr.strip()[-600:]}")
    if ended.returncode == FILE and (len(errors) != 1 or not errors[0].startswith("barreno: ") or "Finished" in ended.stdout):
        raise Finding(f"a failing disk: exit 2 without one sentence, or with Finished: {ended.stderr.strip()[-600:]}")


def try_fault(barreno, straight, words, folder, library, rng, tally):
    """@return what failed"""
    told, variables = drawn_fault(rng, library, folder)
    tally.add("disk faults")
    ended = program(barreno, 1, "run", DECKS / "perforation_quick.xml", *words, "--out", folder, environment=variables)
    try:
        judge_fault(ended)
        if ended.returncode == FILE:
            tally.add("disk faults: ended with a sentence")
            resumable = any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5"))
            if not resumable:
                return
            again = program(barreno, 1, "resume", folder)
            said = "has reached its end time" in again.stderr
            if again.returncode != FINISHED and not said:
                raise Finding(f"its own checkpoint is refused: exit {again.returncode}: {again.stderr.strip()[-600:]}")
            wrong = [] if said else different(straight, folder)
            tally.add("disk faults: resumed")
        else:
            wrong = different(straight, folder)
        if wrong:
            raise Finding(f"after a failing disk it differs: {'; '.join(wrong[:8])}")
    except Finding as finding:
        raise Finding(f"{' '.join(map(str, told))}: {finding}") from finding


def try_perforation(barreno, server, words, folder, library, rng, tally):
    """One run that is left alone, one whose disk fails, and one that is killed and resumed."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    straight = folder / "straight"
    ended = must_work(program(barreno, 1, "run", DECKS / "perforation_quick.xml", *words, "--out", straight))
    tally.add("perforations with fidelities")
    del ended
    try_fault(barreno, straight, words, folder / "faulty", library, rng, tally)
    deck = [DECKS / "perforation_quick.xml", *words]
    if killed(server, deck, folder / "killed", 0.3, rng, tally):
        wrong = different(straight, folder / "killed")
        if wrong:
            raise Finding(f"killed and resumed, it differs from the straight run: {'; '.join(wrong[:8])}")
        tally.add("perforations killed, resumed and the same")


__all__ = ["build_library", "drawn_words", "try_perforation"]
