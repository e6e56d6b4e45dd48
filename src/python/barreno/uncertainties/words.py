# SPDX-License-Identifier: BSD-3-Clause
"""The words of the command."""

import pathlib

from barreno.runs.faults import FILE, Fault
from barreno.runs.ranks import check_ranks
from barreno.runs.words import Words
from barreno.sweeps import flows
from barreno.sweeps.sample import MOST_RUNS
from barreno.sweeps.words import add_modes, check_modes

EXAMPLE = "write for example barreno uncertainty input_xml/perforation.xml --fidelity fast"
LATIN, ONE_AT_A_TIME = "latin", "one-at-a-time"
DESIGNS = (LATIN, ONE_AT_A_TIME)


def parse(words):
    parser = Words(
        "uncertainty",
        EXAMPLE,
        "uncertainty.md",
        description="How sure the answers of a deck are: runs within ranges of its inputs, intervals, shares (docs/uncertainty.md).",
        epilog="Examples:\n  barreno uncertainty input_xml/perforation.xml --fidelity fast\n"
        "  barreno uncertainty input_xml/perforation.xml \\\n"
        '      --vary "Materials/Sandstone/FSLOPE=0.5..0.6" --vary "Jet/Velocity=0.98..1.02"\n\n'
        "Exit codes: 0 finished, 1 bad deck or arguments, 2 file, or runs that --collect does not find; of a run that failed, its own;\n"
        "128 + the number of the signal that ended the command.",
    )
    add = parser.add_argument
    add("deck", metavar="DECK", help="deck file (docs/deck.md)")
    add("--vary", action="append", default=[], metavar='"LIST/NAME=LOW..HIGH UNIT"',
        help="range of a parameter of the deck, as often as needed; Jet/Velocity and Jet/Radius are factors of all slugs")
    add("--ranges", metavar="FILE.csv",
        help="ranges: parameter,low,high,known,source (without --vary and --ranges: those of the cards, of the jet and of pressures)")
    add("--hold", action="append", default=[], metavar="LIST/NAME", help="leave a parameter, or all of a list, as the deck has it")
    add("--runs", type=int, default=24, metavar="N", help="at most so many runs (default 24)")
    add("--design", default=LATIN, metavar="WORD", help="latin: Latin hypercube (default); one-at-a-time: both ends of each range")
    add("--seed", type=int, default=1, metavar="N", help="of the Latin hypercube (default 1)")
    add("--quantity", action="append", default=[], metavar="NAME",
        help="a number of summary.json beside the depth and the measures of the hole, as often as needed (docs/output.md)")
    add("--jobs", type=int, metavar="N", help="runs at a time (default: the cores, divided by --ranks)")
    add("--ranks", type=int, default=1, metavar="N", help="processes of every run (default 1)")
    add("--out", metavar="FOLDER", help="folder of the runs and of the results (default runs/DECK-uncertainty)")
    add("--set", action="append", default=[], dest="settings", metavar='"LIST/NAME=VALUE"',
        help="changes a value of the deck in all runs, as often as needed")
    add("--fidelity", metavar="WORD", help="fast, balanced, reference or none, as for run")
    flows.add_word(add)
    add_modes(add)
    return parser.parse_args(words)


def check_words(options):
    for name, what, least, example in (("jobs", "runs at a time", 1, 2), ("ranks", "ranks", 1, 2), ("runs", "runs", 3, 24)):
        count = getattr(options, name)
        if count is not None and count < least:
            raise Fault(f"--{name} {count} is not a number of {what} ({least} or more); write for example --{name} {example}.")
    if options.runs > MOST_RUNS:
        raise Fault(f"--runs {options.runs} is more than {MOST_RUNS}; give fewer.")
    if options.seed < 0:
        raise Fault(f"--seed {options.seed} is below 0 (a seed is a whole number from 0); write for example --seed 2.")
    if options.design not in DESIGNS:
        raise Fault(f"--design {options.design} is no way to choose runs; it is one of {LATIN} and {ONE_AT_A_TIME}.")
    check_modes(options)
    flows.check_word(options)
    if options.submit is None:  # a batch system puts them on other machines
        check_ranks(options.ranks)
    for name, what in ((options.deck, "the deck"), (options.ranges, "--ranges")):
        if name is not None and not pathlib.Path(name).is_file():
            raise Fault(f"{name} does not exist (needed as {what}); check the path.", FILE)


def out_folder(options):
    return pathlib.Path(options.out) if options.out else pathlib.Path("runs") / f"{pathlib.Path(options.deck).stem}-uncertainty"
