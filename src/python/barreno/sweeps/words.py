# SPDX-License-Identifier: BSD-3-Clause
"""The words of the command."""

import os
import pathlib

from barreno.runs.faults import FILE, Fault
from barreno.runs.ranks import check_ranks
from barreno.runs.words import Words
from barreno.sweeps import flows

EXAMPLE = 'write for example barreno sweep input_xml/perforation_quick.xml --vary "Confinement/Pressure=0,34,69 MPa"'
SAMPLES = ("grid", "list", "latin")


def parse(words):
    parser = Words(
        "sweep",
        EXAMPLE,
        "sweep.md",
        description="A deck with several values of its parameters, run side by side: table, curves and channels (docs/sweep.md).",
        epilog='Example:\n  barreno sweep input_xml/perforation_quick.xml --vary "Confinement/Pressure=0,34,69 MPa"\n\n'
        "Exit codes: 0 finished, 1 bad deck or arguments, 2 file, or runs that --collect does not find; of a run that failed, its own;\n"
        "128 + the number of the signal that ended the sweep.",
    )
    add = parser.add_argument
    add("deck", metavar="DECK", help="deck file (docs/deck.md)")
    add("--vary", action="append", default=[], metavar='"LIST/NAME=VALUE,VALUE..."',
        help="parameter and its values, as often as needed; a unit behind the last value is that of all; of --sample latin a range, "
            "LIST/NAME=LOW..HIGH UNIT")  # fmt: skip
    add("--sample", default="grid", metavar="WORD",
        help="grid: all values with all others (default); list: position by position; latin: Latin hypercube in ranges")
    add("--samples", type=int, metavar="N", help="number of runs of --sample latin")
    add("--seed", type=int, default=1, metavar="N", help="of --sample latin (default 1); the same seed draws the same values")
    add("--jobs", type=int, metavar="N", help="runs at a time (default: the cores, divided by --ranks)")
    add("--ranks", type=int, default=1, metavar="N", help="processes of every run (default 1)")
    add("--out", metavar="FOLDER", help="folder of the runs and of the results (default runs/DECK-sweep)")
    add("--set", action="append", default=[], dest="settings", metavar='"LIST/NAME=VALUE"',
        help="changes a value of the deck in all runs, as often as needed")
    add("--fidelity", metavar="WORD", help="fast, balanced, reference or none, as for run")
    flows.add_word(add)
    add_modes(add)
    return parser.parse_args(words)


def add_modes(add):
    """Words of the array job, also of other commands that make many runs."""
    add("--submit", nargs="?", const="", metavar="slurm", help="print the script of an array job, one task per run, instead of computing")
    add("--collect", action="store_true", help="compute nothing: table and pictures of the runs that are there")
    add("--only", type=int, metavar="N",
        help="compute the run of this number alone, from 1, without table and pictures (a task of the array job)")


def check_counts(options):
    for name, what, example in (("jobs", "runs at a time", 2), ("ranks", "ranks", 2), ("samples", "samples", 20)):
        count = getattr(options, name)
        if count is not None and count < 1:
            raise Fault(f"--{name} {count} is not a number of {what} (1 or more); write for example --{name} {example}.")


def check_sample(options):
    if options.sample not in SAMPLES:
        raise Fault(f"--sample {options.sample} is no way to choose values; it is one of grid, list and latin.")
    if options.sample == "latin" and options.samples is None:
        raise Fault("--sample latin needs the number of its samples; write for example --sample latin --samples 20.")
    if options.sample != "latin" and options.samples is not None:
        raise Fault(f"--samples {options.samples} belongs to --sample latin (a grid and a list have the values of --vary); leave it out, "
            "or add --sample latin.")


def check_modes(options):
    if options.submit is not None and options.submit != "slurm":
        named = (
            f"--submit {options.submit} is not a batch system that scripts are written for" if options.submit
            else "--submit does not say which batch system"
        )
        raise Fault(f"{named}; write --submit slurm.")
    chosen = [name for name in ("submit", "collect", "only") if getattr(options, name) not in (None, False)]
    if len(chosen) > 1:
        raise Fault(f"--{chosen[0]} and --{chosen[1]} exclude each other (one prints a script, one collects, one computes a single run); "
            "choose one.")


def check_words(options):
    check_counts(options)
    check_sample(options)
    check_modes(options)
    flows.check_word(options)
    if options.submit is None:  # a batch system puts them on other machines
        check_ranks(options.ranks)
    if not pathlib.Path(options.deck).is_file():
        raise Fault(f"{options.deck} does not exist (needed as the deck); check the path.", FILE)


def out_folder(options):
    return pathlib.Path(options.out) if options.out else pathlib.Path("runs") / f"{pathlib.Path(options.deck).stem}-sweep"


def jobs_of(options, runs):
    """Of so many runs. The launcher knows physical cores, of which each carries one rank."""
    cores = int(os.environ.get("BARRENO_CORES") or len(os.sched_getaffinity(0)))
    jobs = min(options.jobs or max(1, cores // options.ranks), runs)
    if options.jobs:
        check_ranks(jobs * options.ranks, f"--jobs {options.jobs}, which is {jobs * options.ranks} processes at a time,")
    return jobs
