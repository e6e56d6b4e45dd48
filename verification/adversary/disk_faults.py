# SPDX-License-Identifier: BSD-3-Clause
"""Runs whose disk fails at the n-th call, once or from then on (tools/full_disk.c), and their resumes on a sound disk."""
import errno

from adversary.one_set import FILE, FINISHED, Finding
from tools.resumed import program
from adversary.same_runs import different

ERRORS = {"ENOSPC": errno.ENOSPC, "EIO": errno.EIO, "EDQUOT": errno.EDQUOT, "short": 0}
# Kinds of calls: the last call that may fail, and the share of the trials.
CALLS = {"write": (1000, 0.7), "sync": (12, 0.1), "rename": (12, 0.1), "open": (12, 0.1)}


def drawn_fault(rng, library, folder):
    """What fails, as words for a finding and as variables of the environment."""
    kind = str(rng.choice(list(CALLS), p=[share for _, share in CALLS.values()]))
    name = str(rng.choice(list(ERRORS) if kind == "write" else ["ENOSPC", "EIO"]))
    call, once = int(rng.integers(1, CALLS[kind][0])), bool(rng.random() < 0.4)
    variables = {"LD_PRELOAD": str(library), "BARRENO_FULL_FOLDER": str(folder.resolve()), "BARRENO_FULL_CALL": str(call)}
    variables.update({"BARRENO_FULL_KIND": kind, "BARRENO_FULL_ERROR": str(ERRORS[name])})
    if once:
        variables["BARRENO_FULL_ONCE"] = "1"
    return [kind, name, call, "once" if once else "from then on"], variables


def judge_fault(ended):
    """A run whose disk failed ends in order: finished, or with exit code 2 and one sentence."""
    errors = [line for line in ended.stderr.splitlines() if line.strip() and not line.startswith("warning: ")]
    said = ended.stderr.strip()[-600:]
    if ended.returncode not in (FINISHED, FILE) or "Traceback" in ended.stderr:
        raise Finding(f"exit {ended.returncode}: {said}")
    if ended.returncode == FILE and (len(errors) != 1 or not errors[0].startswith("barreno: ") or "internal error" in said):
        raise Finding(f"exit 2 without one sentence: {said}")
    if ended.returncode == FILE and "Finished" in ended.stdout:
        raise Finding("it says Finished, with exit code 2")
    if ended.returncode == FINISHED and errors:
        raise Finding(f"exit 0 after an error: {said}")


def resume_fault(barreno, folder, tally):
    """With room on the disk the run goes on. @return whether it has now all of its files"""
    if not any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5")):
        tally.add("disk faults: before the first checkpoint")
        return False
    again = program(barreno, 1, "resume", folder)
    # All but the last words was written before the disk failed.
    ended = again.returncode != FINISHED and "has reached its end time" in again.stderr
    if again.returncode != FINISHED and not ended:
        raise Finding(f"its own checkpoint is refused: exit {again.returncode}: {again.stderr.strip()[-600:]}")
    tally.add("disk faults: at the end time already" if ended else "disk faults: resumed and the same")
    return not ended


def try_fault(barreno, straight, command, folder, library, rng, tally):
    """@param command  words of the run, without its folder"""
    told, variables = drawn_fault(rng, library, folder)
    tally.add("disk faults")
    ended = program(barreno, 1, *command, "--out", folder, environment=variables)
    try:
        judge_fault(ended)
        if ended.returncode == FILE:
            tally.add("disk faults: ended with a sentence")
        whole = ended.returncode == FINISHED or resume_fault(barreno, folder, tally)
        wrong = different(straight, folder) if whole else []
        if wrong:
            raise Finding(f"it differs from a run on a sound disk: {'; '.join(wrong[:8])}")
    except Finding as finding:
        raise Finding(f"a failing disk ({' '.join(map(str, told))}): {finding}") from finding
