# SPDX-License-Identifier: BSD-3-Clause
"""The command: the order of its work."""

import sys

from barreno.runs.faults import FILE, Fault, exit_code
from barreno.runs.program import as_set, found_program
from barreno.compare.results import list_of
from barreno.runs.run_folder import deck_in, read_summary
from barreno.sweeps import plan, slurm
from barreno.sweeps.compute import compute_all, refuse_interrupted, say_failures, take_all
from barreno.sweeps.sample import points_of
from barreno.sweeps.variation import read_variations
from barreno.sweeps.words import check_words, jobs_of, out_folder, parse
from barreno.sweeps.write import write_sweep

FAULTS = (1, 2, 3, 4)  # exit codes of a run that would fail again
MOST_NAMES = 5  # of runs in a sentence


def make_plan(options, program, out):
    """Variations and points; whatever is wrong with them is said before a folder is made."""
    variations = read_variations(options.vary, options.sample)
    points = points_of(variations, options.sample, options.samples, options.seed)
    plan.check_settings([*options.settings, *(["Fidelity"] if options.fidelity else [])], variations)
    options.settings += [f"Fidelity={options.fidelity}"] if options.fidelity else []
    base = program.effective_deck([options.deck, *as_set(options.settings)])
    plan.check_lists(base, variations)
    plan.check_out(out, base)
    points = plan.make_points(program, options.deck, options.settings, variations, points, out)
    return variations, base, points


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


def submit(options, words, program, points, places, out):
    missing = take_all(program, points, places, lambda *_: None)
    if not missing:
        raise Fault("all runs have finished, so there is nothing to submit; write --collect instead of --submit slurm.")
    print(slurm.script(options, words, points, out), end="")
    collect_words = [*slurm.without_submit(words), "--collect"]
    print(f"barreno: {len(missing)} tasks; send what was printed to sbatch, and when they have ended: {slurm.user_command(collect_words)}",
        file=sys.stderr)
    return 0


def chosen(points, number):
    if not 1 <= number <= len(points):
        raise Fault(f"--only {number} is not the number of a run (1 to {len(points)}); choose one of them.")
    return [points[number - 1]]


def run(words):
    options = parse(words)
    check_words(options)
    program, out = found_program("sweep", options.ranks), out_folder(options)
    variations, base, points = make_plan(options, program, out)
    if options.only is not None:
        chosen(points, options.only)
    if not options.collect and (options.only is None or not (out / plan.RECORD).exists()):
        plan.write_record(options, base, variations, points, out)
    places = [out, out.parent]
    write = lambda: write_sweep(out, variations, options.sample, points, print)  # noqa: E731
    if options.submit:
        return submit(options, words, program, points, places, out)
    if options.collect:
        return collect(program, points, places, write)
    if options.only is not None:
        points = chosen(points, options.only)
    jobs = jobs_of(options, len(points))
    program.watch_signals()
    compute_all(program, points, places, jobs)
    refuse_interrupted(program, points)
    if options.only is None:
        plan.write_record(options, base, variations, points, out)
        write()
    return say_failures(points)


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
