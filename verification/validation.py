#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compare runs with experiments: what was measured, and what the code gives with the shipped cards.

    validation.py BARRENO [--full] [--document] [EXPERIMENT ...]

EXPERIMENT: names of files in experiments; without any the cheap ones, with --full all. Without --full each takes one size of cells.
--document writes verification/results/validation.json (experiments that were not run keep their last results), docs/validation.md and its
picture. Exit code 1 if a figure does not hold that is not open (open_demands.toml), or an open one is worse than known, or holds.
"""
import argparse
import dataclasses
import importlib
import json
import pathlib
import sys
import time

from tools import foreign_python  # noqa: F401

from tools.demands import FAILS
from tools.experiment import CHEAP, EXPERIMENTS, judged, spread
from tools.validation_results import STORED, stored_experiments
from tools.write_pages import write_pages


def ours_text(values):
    return f"{values[-1]:.4g}" + (f" +- {spread(values):.2g}" if len(values) > 1 else "")


def report(data):
    lines = [f"## {data['title']}", ""]
    lines += [f"- {row['what']}: measured {row['measured']} ({row['mark']}), ours {ours_text(row['ours'])}" for row in data["rows"]]
    return "\n".join(lines)


def store(found):
    """The results of these experiments beside the last ones of the others, in the order of the page."""
    results = {**stored_experiments(), **found}
    STORED.write_text(json.dumps({name: results[name] for name in EXPERIMENTS if name in results}, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("experiments", nargs="*", metavar="EXPERIMENT")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--document", action="store_true")
    options = parser.parse_intermixed_args()
    unknown = set(options.experiments) - set(EXPERIMENTS)
    if unknown:
        parser.error(f"no experiment {sorted(unknown)}; there are {list(EXPERIMENTS)}")
    if options.document and not options.full:
        parser.error("--document needs --full: the page has the interval of two sizes of cells")
    if not options.barreno.is_file():
        parser.error(f"there is no program {options.barreno}; give the path of barreno, as build/release/src/barreno")
    found, failed = {}, []
    for name in options.experiments or (EXPERIMENTS if options.full else CHEAP):
        began = time.monotonic()
        data = dataclasses.asdict(importlib.import_module(f"experiments.{name}").run(options.barreno.resolve(), options.full))
        print(report(data))
        verdicts, wrong = judged(name, data, options.full)
        for check, verdict, words in verdicts:
            print(f"- {check['what']}: {check['value']:.3g} against {check['limit']:.3g}: {verdict}" + (f" ({words})" if words else ""))
            failed += [f"{name}: {check['what']}: {check['value']:.6g} against {check['limit']:.6g}: {words}"] if verdict == FAILS else []
        failed += [f"{name}: {words}" for words in wrong]
        print(f"  {time.monotonic() - began:.1f} s\n", flush=True)
        found[name] = data
    if options.document:
        store(found)
        write_pages()
    for line in failed:
        print(line, file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
