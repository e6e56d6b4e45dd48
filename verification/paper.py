#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every picture and table of docs/paper.md, and whether the trend of each figure holds.

    paper.py BARRENO                    all figures: docs/pictures/paper_*.png, verification/results/paper_*.csv and the tables of docs/paper.md
    paper.py BARRENO --only 7           one figure, as often as needed
    paper.py BARRENO --fine             the same with two cells per jet radius along the whole path, or cells half as wide
    paper.py BARRENO --quick --only 9   coarse and short: only whether the trend holds; nothing is kept
    paper.py BARRENO --again            all runs and pictures as for the page, but nothing is kept
    paper.py --check                    the trends of the results that are there

--runs FOLDER keeps the runs and takes those that are already there, --jobs N has N at a time (default: one for each core). Exit code 1 if a trend does not hold.
"""
import argparse
import pathlib
import sys
import time

import matplotlib

matplotlib.use("Agg")

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "tools"), str(HERE / "oracles"), str(HERE / "cases"), str(HERE), str(HERE.parent / "src" / "python")]
from paper_figures import FIGURES, figure  # noqa: E402
from paper_figures.lab import RESULTS, Lab, cost_of, read_table, write_cost, write_table  # noqa: E402


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
    tables = module.measure(lab)
    if lab.keep:
        for name, table in tables.items():
            write_table(RESULTS / f"{name}.csv", table)
        write_cost(number, cost_of(lab.used))
    good = judge(module.trends(tables))
    print(f"  {time.monotonic() - began:.0f} s", flush=True)
    return good


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", nargs="?", type=pathlib.Path)
    parser.add_argument("--only", metavar="FIGURE", type=int, action="append", choices=FIGURES)
    form = parser.add_mutually_exclusive_group()
    for name in ("quick", "again", "fine", "check"):
        form.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--runs", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("--jobs", metavar="N", type=int)
    options = parser.parse_args()
    if options.barreno is None and not options.check:
        parser.error("name the program, for example build/release/src/barreno")
    return options


def main():
    options = arguments()
    numbers = options.only or FIGURES
    if options.check:
        return 0 if all([judge(figure(number).trends(stored(number))) for number in numbers]) else 1
    lab = Lab(options.barreno, "quick" if options.quick else "fine" if options.fine else "default", options.runs, not (options.quick or options.again), options.jobs)
    good = all([make(lab, number) for number in numbers])
    if lab.keep:
        from pages import write_pages

        write_pages()
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
