#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run verification cases against their exact answers.

    verify.py BARRENO [--full] [--document] [CASE ...]

Without --full each case takes its cheap form, which the tests use. --full takes all levels; --document writes the
results into verification/results, the pages that show them and their pictures (cases that were not run keep their last results).
Exit code 1 if a figure does not hold that is not open (open_demands.toml), or an open one is worse than known, or holds.
"""
import argparse
import dataclasses
import importlib
import json
import pathlib
import sys

from tools import foreign_python  # noqa: F401

from tools.case_list import RESULTS, cases
from tools.demands import FAILS, judge_all, open_demands
from tools.write_pages import write_pages

CASES = list(cases())


def text_of(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def report(name, data, full):
    """What a run of a case prints."""
    lines = [f"## {data['title']}", "", f"`verification/cases/{name}.py`. {data['proves']} Exact: {data['reference']}", ""]
    lines += ["| " + " | ".join(data["columns"]) + " |", "|" + "---|" * len(data["columns"])]
    lines += ["| " + " | ".join(text_of(value) for value in row) + " |" for row in data["rows"]]
    lines += [""]
    judged, wrong = judge_all(data["checks"], open_demands(name, full))
    for check, verdict, words in judged:
        sign = ">=" if check["at_least"] else "<="
        lines.append(f"- {check['what']}: {check['value']:.3g} {sign} {check['limit']:.3g}, {verdict}" + (f" ({words})" if words else ""))
    lines += [f"- {FAILS}: {words}" for words in wrong]
    if data["notes"]:
        lines += ["", data["notes"]]
    return "\n".join(lines) + "\n"


def failures(name, checks, full):
    """What fails of a case in a form, a line each; a case that demands nothing fails."""
    judged, wrong = judge_all(checks, open_demands(name, full))
    lines = [f"{check['what']}: {check['value']:.6g} against {check['limit']:.6g}: {words}"
        for check, verdict, words in judged if verdict == FAILS]
    return lines + wrong + ([] if checks else ["nothing was demanded"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--document", action="store_true")
    options = parser.parse_intermixed_args()
    unknown = set(options.cases) - set(CASES)
    if unknown:
        parser.error(f"no case {sorted(unknown)}; there are {CASES}")
    held = True
    for name in options.cases or CASES:
        result = importlib.import_module(f"cases.{name}").run(options.barreno.resolve(), options.full)
        data = dataclasses.asdict(result)
        if not data["curves"]:
            del data["curves"]
        print(report(name, data, options.full))
        failed = failures(name, result.checks, options.full)
        for line in failed:
            print(f"{name}: {line}", file=sys.stderr)
        held = held and not failed
        if options.document:
            RESULTS.mkdir(exist_ok=True)
            (RESULTS / f"{name}.json").write_text(json.dumps(data, indent=1) + "\n")
    if options.document:
        write_pages()
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
