# SPDX-License-Identifier: BSD-3-Clause
"""The commands report and film: their words, and what they print."""

import pathlib
import sys
import warnings

from barreno.report.build import Wishes, make_report
from barreno.report.fields import check_field, known_fields
from barreno.report.files import make_folder
from barreno.report.film import check_out, write_film
from barreno.report.measured_file import read_measured
from barreno.report.progress import Progress
from barreno.report.run import opened
from barreno.report.words import check_folder, depths_of, film_parser, report_parser, time_of
from barreno.runs.faults import FILE, BadRun, Fault, exit_code, on_one_line


def report(words):
    options = report_parser().parse_args(words)
    folder = check_folder(options.run)
    wishes = Wishes(options.left, options.right, time_of("--time", options.time), depths_of("--depths", options.depths), options.particles,
        options.pdf, read_measured(options.measured) if options.measured else None)
    page = make_report(folder, wishes)
    beside = (
        ["report.pdf"] * options.pdf + ["profile.csv"] * (page.parent / "profile.csv").exists()
        + ["measured.json"] * bool(options.measured) + ["paths.csv"] * (options.particles is not None)
    )
    print(f"{page} (one file with its pictures); beside it index.md, the pictures, {', '.join([*beside, 'paraview/view.py'])}")


def film(words):
    options = film_parser().parse_args(words)
    folder = check_folder(options.run)
    if not 0.1 <= options.per_second <= 60.0:
        raise Fault(f"--per-second {options.per_second:g} is not a number of pictures from 0.1 to 60; write for example --per-second 6.")
    out = pathlib.Path(options.out) if options.out else folder / "report" / f"{options.field}.gif"
    with opened(folder) as run:
        with run.particles_read():
            known = known_fields(run.file, run.deck)
        for option, name in (("--field", options.field), ("--right", options.right or options.field)):
            check_field(option, name, known)
        if not options.out:
            make_folder(out.parent)
        check_out(out)
        write_film(out, run, options.field, options.right or options.field, options.per_second, Progress("pictures"))
    print(f"{out}")


COMMANDS = {"report": report, "film": film}


def run_of(words):
    """The folder among the words, for a sentence."""
    return next((on_one_line(word) for word in words if pathlib.Path(word).is_dir()), "the run")


def run(words):
    if not words or words[0] not in COMMANDS:
        raise Fault("the first word is report or film; write for example python3 -m barreno.report report runs/perforation-1.")
    try:
        COMMANDS[words[0]](words[1:])
    except BadRun as bad:
        raise Fault(f"cannot report on '{run_of(words[1:])}' ({bad}).", FILE) from None
    return 0


def main(words=None):
    warnings.simplefilter("ignore")  # of what is drawn: numbers that are none leave gaps
    return exit_code(run, sys.argv[1:] if words is None else list(words))
