# SPDX-License-Identifier: BSD-3-Clause
"""A study as an array job: its script, the run of one task, and what is collected when the tasks have ended."""

import sys

from barreno.compare.results import list_of
from barreno.runs.faults import FILE, Fault
from barreno.runs.run_folder import deck_in, read_summary
from barreno.sweeps import slurm
from barreno.sweeps.compute import say_failures, take_all

FAULTS = (1, 2, 3, 4)  # exit codes of a run that would fail again
MOST_NAMES = 5  # of runs in a sentence


def names_of(points):
    names = [point.label for point in points[:MOST_NAMES]]
    return list_of(names) if len(points) <= MOST_NAMES else f"{', '.join(names)} and {len(points) - MOST_NAMES} more"


def note_failure(point):
    """Of a task that ended with a fault, from what its run left."""
    if deck_in(point.folder) != point.deck or not (point.folder / "summary.json").exists():
        return
    summary = read_summary(point.folder)
    if not summary.get("finished") and summary.get("exit_code") in FAULTS:
        point.code, point.said = summary["exit_code"], summary.get("reason", "")


def collect(program, points, places, write):
    missing = take_all(program, points, places, lambda *_: None)
    for point in missing:
        note_failure(point)
    if len(missing) == len(points) and not any(point.code for point in points):
        raise Fault("none of the runs has finished; the command without --collect computes them.", FILE)
    write()
    code, absent = say_failures(points), [point for point in missing if not point.code]
    if absent:
        numbers = slurm.ranges_of([i for i, point in enumerate(points, 1) if point in absent])
        raise Fault(f"{len(absent)} of {len(points)} runs have not finished ({names_of(absent)}); the command without --collect computes "
            f"them, or the tasks {numbers} of the array job.", FILE)
    return code


def submit(study, options, words, program, points, places, out):
    """@param words  of the command"""
    missing = take_all(program, points, places, lambda *_: None)
    if not missing:
        raise Fault("all runs have finished, so there is nothing to submit; write --collect instead of --submit slurm.")
    print(slurm.script(study, options, words, points, out), end="")
    collect_words = [*slurm.without_submit(words), "--collect"]
    print(f"barreno: {len(missing)} tasks; send what was printed to sbatch, and when they have ended: "
        f"{slurm.user_command(study, collect_words)}", file=sys.stderr)
    return 0


def chosen(points, number):
    if not 1 <= number <= len(points):
        raise Fault(f"--only {number} is not the number of a run (1 to {len(points)}); choose one of them.")
    return [points[number - 1]]
