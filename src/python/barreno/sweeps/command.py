# SPDX-License-Identifier: BSD-3-Clause
"""The command: the order of its work."""

import sys

from barreno.runs.faults import exit_code
from barreno.runs.program import as_set, found_program
from barreno.sweeps import flows, plan
from barreno.sweeps.array_job import chosen, collect, submit
from barreno.sweeps.compute import compute_all, refuse_interrupted, say_failures
from barreno.sweeps.sample import points_of
from barreno.sweeps.slurm import SWEEP
from barreno.sweeps.variation import read_variations
from barreno.sweeps.words import check_words, jobs_of, out_folder, parse
from barreno.sweeps.write import write_sweep


def make_plan(options, program, out):
    """Variations and points; whatever is wrong with them is said before a folder is made."""
    variations = read_variations(options.vary, options.sample)
    points = points_of(variations, options.sample, options.samples, options.seed)
    plan.check_settings([*options.settings, *(["Fidelity"] if options.fidelity else [])], variations)
    options.settings += [f"Fidelity={options.fidelity}"] if options.fidelity else []
    base = program.effective_deck([options.deck, *as_set(options.settings)])
    flows.check_deck(options, base)
    plan.check_lists(base, variations)
    plan.check_out(out, base)
    points = plan.make_points(program, options.deck, options.settings, variations, points, out)
    return variations, base, points


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

    def write():
        if options.flow:
            flows.add_flows(program, points, options.flow, print)
        write_sweep(out, variations, options.sample, points, print)

    if options.submit:
        return submit(SWEEP, options, words, program, points, places, out)
    if options.collect:
        return collect(program, points, places, write)
    chosen_points = points if options.only is None else chosen(points, options.only)
    jobs = jobs_of(options, len(chosen_points))
    program.watch_signals()
    compute_all(program, chosen_points, places, jobs)
    refuse_interrupted(program, chosen_points)
    if options.only is None:
        plan.write_record(options, base, variations, points, out)
        write()
    elif options.flow:
        flows.add_flows(program, chosen_points, options.flow, print)
    return say_failures(chosen_points)


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
