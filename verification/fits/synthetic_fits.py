#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits of noisy tests of known rocks: is the minimum found, do the ranges hold the truth, what does a fit cost.

    synthetic_fits.py LIBRARY [--sets N] [--first K] [--jobs N] [--document]

Sets of data: one hydrostatic and three triaxial tests of 8 cards, with 0.5 to 3 % of noise in stresses and in volume strains, each in one
of five file formats. --document writes verification/results/synthetic_fits.json after every set, and keeps the sets there that are not
fitted now. Ends with exit code 1 and a sentence for each set or parameter that misses what synthetic_results.py asks for.
"""

import argparse
import concurrent.futures
import contextlib
import dataclasses
import io
import json
import os
import pathlib
import sys
import tempfile
import time

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy

from fits.synthetic_results import SETS, STORED, faults_of, held, is_open
from fits.synthetic_rocks import CARDS, FORMATS, SHORT_CARD, START, cards, laboratory_of, noises_of, truth_of, write_test

from barreno.fit import command
from barreno.fit.answers import Laboratory
from barreno.fit.data import read_test
from barreno.fit.faults import Rejected
from barreno.fit.parameters import PARAMETERS
from barreno.fit.ranges import Spread, end_of
from barreno.fit.search import Problem, Search, residuals_of
from barreno.fit.specimens import opened
from barreno.materials import load

NORMAL = 1.96  # half width of 95 % over the standard deviation


def squares_of(library, tests, card):
    """Of the residuals of a card in the tests."""
    problem = Problem(library, card, {}, {}, print)
    return float(sum((part**2).sum() for part in residuals_of(tests, problem.answers(Laboratory(tests), {}))))


def without_noise(library, tests, truth):
    """The tests with what the true card answers."""
    answers = Problem(library, truth, {}, {}, print).answers(Laboratory(tests), {})
    return [
        dataclasses.replace(
            test,
            columns={**test.columns, **{name: answer[name] for name in test.channels}},
            scales={name: test.scales[name] * abs(test.columns[name]).max() / abs(answer[name]).max() for name in test.channels},
        )
        for test, answer in zip(tests, answers)
    ]


def widths_at(library, tests, truth, names):
    """{name: half width of the 95 % range at the truth, with the true noise, over that of an open parameter}. The wider one of the slopes'
    and of a profile on data without noise: slopes do not see where valleys bend, and profiles may stop at a ridge."""
    search = Search(Problem(library, truth, {}, {}, print), without_noise(library, tests, truth), names, truth)
    z = search.seen_start(truth)
    J = search.jacobian(z, central=True)
    covariance = numpy.linalg.inv(J.T @ J + 1e-6 * numpy.eye(len(names)))
    deviation = numpy.sqrt(numpy.diag(covariance))
    spread = Spread(NORMAL * deviation, NORMAL * deviation, covariance / deviation**2, J, 0.0, NORMAL**2, 0.0)
    ends = [[end_of(search, z, spread, i, sign) for sign in (-1.0, 1.0)] for i in range(len(names))]
    halves = numpy.maximum(spread.half, [0.5 * (high - low) for low, high in ends])
    return {name: float(half / PARAMETERS[name].wide) for name, half in zip(names, halves)}


def fitted(files, folder):
    """Exit code, last words and processor seconds of the command."""
    out, err, begin = io.StringIO(), io.StringIO(), time.process_time()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = command.main([*files, "--out", str(folder / "card.xml"), "--start", START])
    return code, err.getvalue().strip().splitlines()[-1].replace(f"{folder}/", ""), time.process_time() - begin


def one_set(library, number):
    """A line of the results."""
    truth, noises, form = truth_of(number % CARDS), noises_of(number), FORMATS[number % len(FORMATS)]
    shapes, random = laboratory_of(truth, number % CARDS == SHORT_CARD), numpy.random.default_rng(number)
    with opened(cards.in_a_test(truth, Tolerance=cards.TOLERANCE), library) as rock:
        answers = Laboratory(shapes).answers(rock)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        files = [write_test(folder, test, answer, truth, noises, form, random) for test, answer in zip(shapes, answers)]
        code, said, seconds = fitted(files, folder)
        row = {"set": number, "card": number % CARDS, "format": number % len(FORMATS), "noise": noises, "seconds": round(seconds, 1),
            "code": code}
        if code != 0:
            return {**row, "said": said, "ratio": None, "parameters": []}
        tests, fit = list(map(read_test, files)), json.loads((folder / "card.json").read_text())
        for test in tests:  # the true weights, for both cards
            test.scales = {name: noises[name] / test.uncertainty[0] for name in test.channels}
        ratio = (squares_of(library, tests, cards.read(str(folder / "card.xml"))) / squares_of(library, tests, truth)) ** 0.5
        widths = widths_at(library, tests, truth, [p["name"] for p in fit["parameters"]])
    parameters = [
        {"name": p["name"], "truth": truth[p["name"]], "value": p["value"], "low": p["low"], "high": p["high"],
            "width": round(widths[p["name"]], 3)}
        for p in fit["parameters"]
    ]
    return {**row, "cards_tried": fit["cards_tried"], "ratio": round(ratio, 4), "parameters": parameters}


def set_of(number):
    """In a process of its own."""
    try:
        return one_set(load(), number)
    except Rejected as refused:
        raise SystemExit(f"set {number}: the true rock cannot be tested: {refused}") from None


def tell(row):
    missed = [p["name"] for p in row["parameters"] if not is_open(p) and not held(p)]
    open_ones = [p["name"] for p in row["parameters"] if is_open(p)]
    print(f"set {row['set']}: {row['seconds']} s, misfit/truth {row['ratio']}, outside {missed}, not determined {open_ones} "
        f"{row.get('said', '')}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("library")
    parser.add_argument("--sets", type=int, default=SETS)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--document", action="store_true")
    options = parser.parse_args()
    os.environ["BARRENO_LIBRARY"] = str(pathlib.Path(options.library).resolve())
    rows, numbers = [], range(options.first, options.first + options.sets)
    others = [row for row in json.loads(STORED.read_text())["sets"]
        if row["set"] not in numbers] if options.document and STORED.exists() else []
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for row in pool.map(set_of, numbers):
            tell(row)
            rows.append(row)
            if options.document:
                STORED.write_text(json.dumps({"sets": sorted(others + rows, key=lambda row: row["set"])}, indent=1) + "\n")
    faults = faults_of(rows)
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
