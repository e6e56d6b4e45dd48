#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every picture and table of docs/paper.md, and whether the trend of each figure holds.

    paper.py BARRENO                    all figures: docs/pictures/paper_*.png, verification/results/paper_*.csv and the tables of
    docs/paper.md paper.py BARRENO --only 7           one figure, as often as needed
    paper.py BARRENO --fine             the same with two cells per jet radius along the whole path, or cells half as wide
    paper.py BARRENO --quick --only 9   coarse and short: only whether the trend holds; nothing is kept
    paper.py BARRENO --again            all runs and pictures as for the page, but nothing is kept
    paper.py --check                    the trends of the results that are there
    paper.py --draw                     the pictures that need no particles, from the results that are there

What is kept takes runs of the same settings that are in --runs FOLDER (default runs/paper) already and newer than the program and its
decks, so that a call that was stopped goes on. --jobs N has N runs at a time (default: one for each core). Exit code 1 if a trend does not
hold or a figure cannot be made; the others are.
"""
import argparse
import pathlib
import sys
import time

from tools import foreign_python  # noqa: F401

import matplotlib

matplotlib.use("Agg")
from barreno.sweeps.compute import duration
from paper_figures import FIGURES, figure
from paper_figures.lab import PICTURES, RESULTS, ROOT, Lab, cost_of, read_table, write_cost, write_table
from tools.write_pages import write_pages


def stored(number):
    """Tables of a figure in verification/results."""
    files = [RESULTS / f"{name}.csv" for name in figure(number).TABLES]
    return {file.stem: read_table(file) for file in files}


def judge(trends):
    for trend in trends:
        print(f"  {trend}", flush=True)
    return all(trend.holds for trend in trends)


def make(lab, number):
    """Runs, draws and writes a figure. @return whether its trends hold"""
    print(f"figure {number}", flush=True)
    began = time.monotonic()
    module, lab.used = figure(number), []
    lab.progress.begin(number)
    tables = module.measure(lab)
    if lab.keep:
        for name, table in tables.items():
            write_table(RESULTS / f"{name}.csv", table)
        write_cost(number, cost_of(lab.used))
    lab.progress.figure_ended()
    good = judge(module.trends(tables))
    print(f"  figure {number} took {duration(time.monotonic() - began)}", flush=True)
    return good


def made(lab, number):
    """The same; what keeps one figure from being made does not keep the others."""
    try:
        return make(lab, number)
    except (RuntimeError, OSError) as error:
        lab.progress.figure_ended()
        print(f"  figure {number} is not made: {error}", file=sys.stderr, flush=True)
        return False


def draw(numbers):
    """Pictures of results alone."""
    for number in numbers:
        for name, does in getattr(figure(number), "DRAWN", {}).items():
            does(PICTURES / f"{name}.png", stored(number))
            print(f"docs/pictures/{name}.png", flush=True)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", nargs="?", type=pathlib.Path)
    parser.add_argument("--only", metavar="FIGURE", type=int, action="append", choices=FIGURES)
    form = parser.add_mutually_exclusive_group()
    for name in ("quick", "again", "fine", "check", "draw"):
        form.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--runs", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("--jobs", metavar="N", type=int)
    options = parser.parse_args()
    if not (options.check or options.draw) and (options.barreno is None or not options.barreno.is_file()):
        parser.error("name the program, for example build/release/src/barreno")
    return options


def lab_of(options, numbers):
    keep = not (options.quick or options.again)
    folder = options.runs or (ROOT / "runs" / "paper" if keep else None)
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
    return Lab(options.barreno, "quick" if options.quick else "fine" if options.fine else "default", folder, keep, options.jobs, numbers)


def main():
    options = arguments()
    numbers = options.only or FIGURES
    if options.check:
        return 0 if all([judge(figure(number).trends(stored(number))) for number in numbers]) else 1
    if options.draw:
        draw(numbers)
        return 0
    lab = lab_of(options, numbers)
    print(lab.progress.first_line(), flush=True)
    good = all([made(lab, number) for number in numbers])
    if lab.keep:
        write_pages()
    print(f"{len(numbers)} figures took {lab.progress.whole()}{f'; their runs are in {lab.folder}' if lab.keep else ''}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("interrupted; the same command takes the runs that have finished", file=sys.stderr)
        sys.exit(130)
