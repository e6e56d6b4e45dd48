# SPDX-License-Identifier: BSD-3-Clause
"""The command: its words, and what it writes."""

import argparse
import contextlib
import math
import os
import pathlib
import sys

from barreno.fit import card, data, report, solve
from barreno.fit.answers import Laboratory
from barreno.fit.faults import Rejected
from barreno.fit.kinds import DIMENSIONS, KINDS, STRENGTH
from barreno.fit.laboratory import RAW, Said
from barreno.fit.parameters import fixed_values, given_bounds
from barreno.fit.specimens import opened
from barreno.fit.table import name_of
from barreno.materials import load
from barreno.runs.faults import FILE, NUMERICAL, Fault, exit_code

DEFAULT_START = "berea_sandstone"


class Words(argparse.ArgumentParser):
    def error(self, message):
        raise Fault(f"{message}; write for example barreno fit hydrostatic.csv triaxial_40MPa.csv --out card.xml (docs/fit.md).")


def parse(words):
    parser = Words(prog="barreno fit", description="A card of Arenisca from laboratory tests (docs/fit.md).")
    parser.add_argument("data", nargs="+", metavar="DATA", help="a CSV file for each test")
    parser.add_argument("--out", required=True, metavar="CARD.xml",
        help="the card; a picture (.png) and all numbers (.json) are written beside it")
    parser.add_argument("--start", metavar="CARD.xml",
        help=f"start, and what the data do not determine (a path or a name; default {DEFAULT_START})")
    parser.add_argument("--fix", action="append", default=[], metavar="NAME=value", help='holds a parameter, "PEAKI1=12 MPa"')
    parser.add_argument("--bounds", action="append", default=[], metavar="NAME=low,high", help="holds a parameter between two values")
    parser.add_argument("--column", action="append", default=[], metavar="NAME=column",
        help='what a column of the files is, "Force=axial_force"')
    parser.add_argument("--sign", action="append", default=[], metavar="column=negative",
        help="sign of compression in a column, positive or negative")
    parser.add_argument("--say", action="append", default=[], metavar="[FILE:]key=value",
        help='a line of the header, "tri40.csv:confinement=40 MPa"')
    parser.add_argument("--name", metavar="NAME", help="name of the rock in the card (default: from the name of the file)")
    return parser.parse_args(words)


def said_of(options):
    """What the words say of the files."""
    said = Said()
    for word in options.column:
        name, equal, column = word.rpartition("=")
        if not equal or not name.strip() or not column.strip():
            raise Fault(f"--column {word} is no assignment; write for example --column \"Force=axial_force\".")
        said.columns[name_of(name)] = column.strip().lower()
    for word in options.sign:
        column, _, sign = word.partition("=")
        if sign not in ("positive", "negative") or not (column in DIMENSIONS or column in RAW):
            raise Fault(f"--sign {word} is no column with positive or negative; write for example --sign volume_strain=negative.")
        said.signs[column] = sign == "negative"
    for word in options.say:
        left, equal, value = word.partition("=")
        file, _, key = left.rpartition(":")
        if not equal or key.strip() not in (*data.KEYS, "decimal"):
            raise Fault(f"--say {word} is no line of a header; write for example --say \"tri40.csv:confinement=40 MPa\" (keys: "
                f"{', '.join((*data.KEYS, 'decimal'))}).")
        if file and file not in {pathlib.Path(name).name for name in options.data}:
            raise Fault(f"--say {word} names no file of the data; write its name without a folder.")
        said.keys.append((file, key.strip(), value.strip()))
    return said


def read_tests(files, said):
    if len(set(map(os.path.realpath, files))) < len(files):
        raise Fault("a file is given twice as data; name each test once.")
    tests = [data.read_test(file, said) for file in files]
    unused = [name for name in said.columns if name not in said.used]
    if unused:
        raise Fault(f"--column {unused[0]}={said.columns[unused[0]]} names no column of the files; write the name as it stands there, "
            "without its unit.")
    return sorted(tests, key=lambda test: (list(KINDS).index(test.kind), test.confinement))


def fix_porosity(tests, fixed):
    """p3 = -ln(1 - porosity), where the files say it."""
    said = {test.porosity: test.file for test in tests if test.porosity}
    if "p3_crush_curve" in fixed or not said:
        return
    if len(said) > 1:
        (a, first), (b, second) = list(said.items())[:2]
        raise Fault(f"{first} and {second} have porosities of {100 * a:.4g} and {100 * b:.4g} %, and a card has one; decide with --fix "
            "p3_crush_curve=value, -ln(1 - porosity).")
    fixed["p3_crush_curve"] = -math.log(1.0 - next(iter(said)))


def check_scope(tests, given_start):
    """Without a card to start from, the data have to say what is not borrowed from another rock."""
    if given_start:
        return
    kinds = {test.kind for test in tests}
    if not kinds & {"hydrostatic", "uniaxial strain", "bulk modulus"}:
        raise Fault("no hydrostatic test is among the data (nor uniaxial strain, nor bulk moduli), so nothing says how the rock is "
            "compressed and crushed; add one, or name a card with --start that this is taken from.")
    if not any(set(KINDS[kind].fits) & set(STRENGTH) for kind in kinds):
        raise Fault("no triaxial test is among the data, so nothing says how strong the rock is; add one, or name a card with --start that "
            "the strength is taken from.")


def check_out(out):
    path = pathlib.Path(out)
    if path.suffix != ".xml":
        raise Fault(f"--out {out} is not the name of a card; end it with .xml.")
    if not path.parent.is_dir():
        raise Fault(f"the folder of --out {out} does not exist; make it first.", FILE)
    if not os.access(path.parent, os.W_OK):
        raise Fault(f"--out {out} cannot be written (its folder forbids it); name another one.", FILE)
    return path


def load_library():
    try:
        return load()
    except (OSError, ImportError) as error:
        raise Fault(f"libBARRENO.so cannot be used: {' '.join(str(error).split())}", FILE) from None


def final_answers(problem, tests, result):
    """Of the card as it stands in the file."""
    try:
        with opened(card.in_a_test(result.card, Tolerance=card.TOLERANCE), problem.library) as rock:
            answers = Laboratory(tests).answers(rock)
        with opened(result.card, problem.library):
            pass
    except Rejected as refused:
        raise Fault(f"the card that fits best is refused: {refused}", NUMERICAL) from None
    return answers


def place(file, content):
    """Written aside and renamed: complete or absent."""
    aside = file.with_name(f".{file.name}.tmp")
    try:
        if callable(content):
            content(aside)
        else:
            aside.write_text(content)
        aside.replace(file)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise Fault(f"{file} cannot be written ({error.strerror}).", FILE) from None


def run(words):
    options = parse(words)
    out = check_out(options.out)
    fixed, bounds = fixed_values(options.fix), given_bounds(options.bounds)
    tests = read_tests(options.data, said_of(options))
    check_scope(tests, options.start)
    fix_porosity(tests, fixed)
    start_name = options.start or DEFAULT_START
    start = card.read(start_name)
    library = load_library()
    for test in tests:
        for note in test.notes:
            print(f"note: {note}", file=sys.stderr)
    problem = solve.Problem(library, start, fixed, bounds, say=lambda text: print(f"fitting {text}", file=sys.stderr))
    result = solve.fit(problem, tests)
    result.card = report.rounded(result)
    answers = final_answers(problem, tests, result)
    summary = report.summary(problem, result, tests, answers, start_name, library.barreno_version().decode())
    name = options.name or out.stem.replace("_", " ").title()
    place(out.with_suffix(".png"), lambda aside: report.draw(aside, tests, answers))
    place(out.with_suffix(".json"), report.as_json(summary))
    place(out, report.card_text(name, result, summary, tests))
    print(report.tables(summary, out))
    return 0


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
