# SPDX-License-Identifier: BSD-3-Clause
"""The command: the order of its work."""

import hashlib
import json
import pathlib
import shutil
import sys
import tempfile

from barreno.compare.results import FINISHED, as_csv, draw_into
from barreno.runs.effective_deck import value_in
from barreno.runs.faults import FILE, Fault, exit_code
from barreno.runs.program import as_set, found_program, named
from barreno.runs.regular_file import read_text
from barreno.runs.tables import make_folder, place
from barreno.sweeps import array_job, flows, plan
from barreno.sweeps.compute import compute_all, refuse_interrupted, say_failures
from barreno.sweeps.slurm import Study
from barreno.sweeps.variation import refuse_twice
from barreno.sweeps.words import jobs_of
from barreno.sweeps.write import row_of
from barreno.uncertainties import decks, report
from barreno.uncertainties.answers import analyse_all, answers_of
from barreno.uncertainties.design import least_runs, shares_of
from barreno.uncertainties.known import drop_changed, known_ranges
from barreno.uncertainties.ranges import as_csv as ranges_as_csv, read_file, read_word, settle
from barreno.uncertainties.words import LATIN, check_words, out_folder, parse

STUDY = Study("uncertainty", "barreno.uncertainties")
RECORD = "uncertainty.json"
MOST_NAMES = 5  # of parameters in a sentence
INPUTS = "inputs"  # folder of decks with other jets
TABLE, RANGES, PICTURE = "uncertainty.csv", "ranges.csv", "tornado.png"


def is_held(path, held):
    return any(path == one or path.startswith(f"{one}/") for one in held)


def given_ranges(options):
    """Of the user: --vary goes before --ranges."""
    words = [read_word(word) for word in options.vary]
    refuse_twice(words, "range", "one --vary")
    file = read_file(pathlib.Path(options.ranges)) if options.ranges else []
    again = next((one for i, one in enumerate(file) if any(one.path == other.path for other in file[:i])), None)
    if again:
        raise Fault(f"{again.where()} stands twice (a parameter has one range); leave one out.", FILE)
    return words + [one for one in file if all(one.path != other.path for other in words)]


def check_held(held, paths):
    for one in held:
        if not any(is_held(path, [one]) for path in paths):
            varied = f"{', '.join(paths[:MOST_NAMES])}{', ...' if len(paths) > MOST_NAMES else ''}"
            raise Fault(f"--hold {one} names nothing that is varied ({varied}); leave it out.")


def find_ranges(options, program, base, say):
    """Ranges with their ends in SI."""
    ranges = given_ranges(options)
    given, held = bool(ranges), [path.strip("/ ") for path in options.hold]
    ranges = ranges or known_ranges(options, base, say)
    check_held(held, [one.path for one in ranges])
    ranges = [one for one in ranges if not is_held(one.path, held)]
    if given:
        plan.check_settings([*options.settings, "Fidelity"], ranges)
        plan.check_lists(base, [one for one in ranges if one.path not in decks.FACTORS])
    words = [options.deck, *as_set(options.settings)]
    decks.check_jet(base, ranges)
    for one in ranges:
        settle(one, base, lambda settings: program.effective_deck([*words, *as_set(settings)]))
    ranges = ranges if given else drop_changed(ranges, options, say)
    if not ranges:
        raise Fault('nothing has a range, so nothing is uncertain; give one, for example --vary "Jet/Velocity=0.98..1.02".')
    return ranges


def rounded(value):
    """Six digits, which make the same deck wherever they are drawn."""
    return float(f"{value:.6g}")


def values_of(ranges, shares):
    return {one.path: rounded(one.value_at(share)) for one, share in zip(ranges, shares)}


def label_of(options, ranges, number, shares, first):
    """Of a run on the screen."""
    if options.design == LATIN:
        return f"run {number}"
    changed = [(one, share) for one, share, middle in zip(ranges, shares, first) if share != middle]
    if number == 1 or not changed:
        return "the middle"
    return f"{changed[0][0].name()} at its {'low' if changed[0][1] == 0.0 else 'high'} end"


def digest_of(values):
    return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()[:8]


def least_radius(ranges):
    return min([1.0, *(one.low for one in ranges if one.path == decks.RADIUS)])


def fit_cells(program, base, ranges, say):
    """The base of decks with other jets, whose thinnest the cells must resolve as the deck wants it."""
    least = least_radius(ranges)

    def effective(text):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(text)
            file.flush()
            return program.effective_deck([file.name])

    size = decks.cells_for_all(base, least, effective)
    if size != decks.cells_of(base):
        say(f"Cells of {1e3 * size:.4g} mm in all runs, for the thinnest jet (the deck alone: {1e3 * decks.cells_of(base):.4g} mm).")
    return decks.with_cells(base, size), (least if size != decks.cells_of(base) else 1.0)


def words_of_run(options, base, jet_base, ranges, values, number, out):
    """Words of the deck; a deck with another jet is written first.  @param jet_base  deck, and the factor of radius of its cells"""
    settings = decks.settings_of(base, values)
    settings += decks.seed_settings(base, number) if options.design == LATIN else []
    if not any(one.path in decks.FACTORS for one in ranges):
        return [options.deck, *as_set([*options.settings, *settings])]
    make_folder(out / INPUTS)
    file = out / INPUTS / f"jet-{digest_of(decks.factors_of(values))}.xml"
    deck = decks.with_jet(jet_base[0], *decks.factors_of(values), jet_base[1])
    if not file.is_file() or read_text(file) != deck:  # tasks of an array job, which plan anew at the same time, leave it
        place(file, deck)
    return [str(file), *as_set(settings)]


def make_points(options, program, base, ranges, shares, out, say):
    points, jet_base = [], fit_cells(program, base, ranges, say)
    for number, row in enumerate(shares, 1):
        values = values_of(ranges, row)
        run_words = words_of_run(options, base, jet_base, ranges, values, number, out)
        label = label_of(options, ranges, number, row, shares[0])
        points.append(plan.Point(run_words, "", out / f"run-{number:02d}-{digest_of(values)}", values=tuple(values.values()), label=label))
    plan.set_decks(points, lambda point: deck_of(program, ranges, point))
    return points


def deck_of(program, ranges, point):
    try:
        return program.effective_deck(point.words)
    except Fault as fault:
        values = ", ".join(f"{name} = {value:g}" for name, value in zip((one.name() for one in ranges), point.values))
        raise Fault(f"the ranges allow a deck that is refused ({str(fault).rstrip('.')}; {point.label}: {values}); narrow them, or hold "
            "one of these parameters with --hold.", fault.code) from None


def make_plan(options, program, base, ranges, out, say):
    """Shares and points; of a plan that is refused nothing is left."""
    shares = shares_of(options, ranges)
    if options.only is not None:
        array_job.chosen(shares, options.only)
    new = not out.exists()
    try:
        return shares, make_points(options, program, base, ranges, shares, out, say)
    except Fault:
        if new:
            shutil.rmtree(out, ignore_errors=True)
        raise


def record_of(options, base, ranges, points):
    return {
        "deck": str(options.deck), "base": plan.digest_of(base), "settings": options.settings, "design": options.design,
        "seed": options.seed,
        "ranges": [{"path": one.path, "low": one.low, "high": one.high, "drawn_in_logarithm": one.is_wide(), "deck": one.own,
            "known": one.known, "source": one.source} for one in ranges],
        "runs": [{"values": list(point.values), "folder": str(point.folder), "how": point.how} for point in points],
    }  # fmt: skip


def write_record(out, record):
    place(out / RECORD, json.dumps(record, indent=1, ensure_ascii=False) + "\n")


def rows_of(points):
    return [row_of(point, [f"{value:.9g}" for value in point.values]) for point in points]


def enough(options, ranges, rows):
    """Finished runs bear an answer."""
    finished = sum(row.state == FINISHED for row in rows)
    least = least_runs(options.design, len(ranges))
    if finished >= least:
        return True
    print(f"barreno: {finished} of {len(rows)} runs have finished, and {least} are needed for {len(ranges)} ranges; no interval is given.",
        file=sys.stderr)
    return False


def write_results(options, base, ranges, shares, points, out):
    rows = rows_of(points)
    record = record_of(options, base, ranges, points)
    place(out / TABLE, as_csv([one.path for one in ranges], rows))
    files, lines = [TABLE, RANGES], []
    if enough(options, ranges, rows):
        kept = [(share, row) for share, row in zip(shares, rows) if row.state == FINISHED]
        shares, rows = [share for share, _ in kept], [row for _, row in kept]
        answers, remarks = answers_of(rows, options.quantity)
        analyse_all(answers, options.design, shares, rows, options.flow)
        record["answers"], record["left_out"] = report.as_numbers(answers, ranges), list(remarks)
        files += draw_tornado(out, answers, ranges, remarks)
        lines = [*remarks, *report.lines_of(answers, ranges, options.design, len(rows))]
    write_record(out, record)
    for line in lines:
        print(line)
    print(f"Written to {out}: {', '.join([*files, RECORD])}")


def draw_tornado(out, answers, ranges, remarks):
    if not answers:
        return []

    def draw(aside):
        from barreno.uncertainties.picture import draw  # slow to load

        draw(aside, answers, ranges)

    return draw_into(out / PICTURE, draw, "python3-matplotlib", remarks)


def check_base(options, base):
    if not options.quantity and all(value_in(base, path) is None for path in ("Jet/Material", "Jet Monitor/Position")):
        raise Fault("the deck has no jet, so there is no depth to look at; name numbers of summary.json, for example "
            "--quantity balances.energy.plastic.")


def say_aside(line):
    """Where what is printed is a script."""
    print(line, file=sys.stderr)


def carry_out(options, words, program, points, out, write):
    """The runs, or what the words of an array job ask for.  @param write  results of all that has finished"""
    places = [out, out.parent]
    if options.submit:
        return array_job.submit(STUDY, options, words, program, points, places, out)
    if options.collect:
        return array_job.collect(program, points, places, write)
    if options.only is not None:
        points = array_job.chosen(points, options.only)
    jobs = jobs_of(options, len(points))
    program.watch_signals()
    compute_all(program, points, places, jobs)
    refuse_interrupted(program, points)
    if options.only is None:
        write()
    elif options.flow:
        flows.add_flows(program, points, options.flow, print)
    return say_failures(points)


def run(words):
    options = parse(words)
    check_words(options)
    program, out = found_program("uncertainty", options.ranks), out_folder(options)
    options.settings += [f"Fidelity={options.fidelity}"] if options.fidelity else []
    base = program.effective_deck([options.deck, *as_set(options.settings)])
    check_base(options, base)
    flows.check_deck(options, base)
    say = say_aside if options.submit else print
    ranges = find_ranges(options, program, base, say)
    plan.check_out(out, base, RECORD, "a study")
    if options.collect and not (out / RECORD).exists():
        raise Fault(f"{out} holds no study (no {RECORD}), so there is nothing to collect; the command without --collect computes it.", FILE)
    with named(pathlib.Path(options.deck).name):
        shares, points = make_plan(options, program, base, ranges, out, say)
        if not options.collect and (options.only is None or not (out / RECORD).exists()):
            make_folder(out)
            place(out / RANGES, ranges_as_csv(ranges))
            write_record(out, record_of(options, base, ranges, points))

        def write():
            if options.flow:
                flows.add_flows(program, points, options.flow, print)
            write_results(options, base, ranges, shares, points, out)

        return carry_out(options, words, program, points, out, write)


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
