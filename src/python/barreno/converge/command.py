# SPDX-License-Identifier: BSD-3-Clause
"""The command: its words, and the order of its work."""

import math
import pathlib
import re
import sys

from barreno.converge import levels as level_runs
from barreno.converge import order, report
from barreno.converge.quantity import Quantity
from barreno.runs.effective_deck import value_in
from barreno.runs.faults import FILE, Fault, exit_code
from barreno.runs.program import as_set, found_program
from barreno.runs.ranks import check_ranks
from barreno.runs.run_folder import read_summary
from barreno.runs.tables import make_folder, place
from barreno.runs.words import TIME_UNITS, Words, quantity_of

AT_REST = "at rest"
EXAMPLE = "write for example barreno converge input_xml/perforation_quick.xml --levels 3"


def parse(words):
    parser = Words("converge", EXAMPLE, "converge.md",
        description="A deck with cells of several sizes: order, limit and interval of a result (docs/converge.md).")
    parser.add_argument("deck", metavar="DECK", help="deck file (docs/deck.md)")
    parser.add_argument("--quantity", default="depth", metavar="NAME",
        help="depth (default), a column of depth.csv, history.csv or radii.csv, or a number of summary.json")
    parser.add_argument("--times", default="", metavar="LIST",
        help='when the column is compared, "10 us, 20 us" (default: four equal parts of the run)')
    parser.add_argument("--levels", type=int, default=3, metavar="N",
        help="number of cell sizes, 2 to 6 (default 3: twice, once and half the deck's)")
    parser.add_argument("--refine", type=float, default=2.0, metavar="RATIO",
        help="ratio of successive cell sizes, above 1, at most 4 (default 2)")
    parser.add_argument("--formal-order", type=float, default=2.0, metavar="P", help="order that the method can have at most (default 2)")
    parser.add_argument("--out", metavar="FOLDER", help="folder of the runs and of the result (default runs/DECK-converge)")
    parser.add_argument("--ranks", type=int, default=1, metavar="N", help="processes of every run")
    parser.add_argument("--fidelity", metavar="NAME", help="fast, balanced, reference or none, as for run")
    parser.add_argument("--set", action="append", default=[], dest="settings", metavar='"LIST/NAME=VALUE"',
        help="changes a value of the deck on all levels, as often as needed")
    return parser.parse_args(words)


def check_words(options):
    if not 2 <= options.levels <= 6:
        raise Fault(f"--levels {options.levels} is not a number of cell sizes from 2 to 6 (three show an order); {EXAMPLE}.")
    if not 1.1 <= options.refine <= 4.0:
        raise Fault(f"--refine {options.refine:g} is not a ratio from 1.1 to 4 (levels that are closer tell nothing apart); write for "
            "example --refine 2.")
    if not 0.0 < options.formal_order <= 10.0:
        raise Fault(f"--formal-order {options.formal_order:g} is not an order above 0 and at most 10; write for example --formal-order 2.")
    check_ranks(options.ranks)
    if not pathlib.Path(options.deck).is_file():
        raise Fault(f"{options.deck} does not exist (needed as the deck); check the path.", FILE)


def time_of(text):
    try:
        return quantity_of(text, TIME_UNITS)
    except ValueError:
        raise Fault(f'--times has "{text.strip()}", which is not a time; write for example --times "10 us, 20 us".') from None


def end_of(deck):
    """End of the runs of a deck [s]; infinite of one to rest: its runs say it."""
    text = value_in(deck, "Time/End Time")
    return math.inf if text == AT_REST else float(text)


def last_end(levels):
    """The latest of the ends of runs to rest [s]."""
    return max(read_summary(level.folder)["time"] for level in levels)


def times_of(text, end):
    """Times in s, in their order; in words as a deck has them."""
    if not text:
        return [end * part / 4.0 for part in (1, 2, 3, 4)]
    times = sorted({time_of(part) for part in text.split(",")})
    if times[0] <= 0.0 or times[-1] > end * (1.0 + 1e-9):
        raise Fault(f"--times has {times[0] if times[0] <= 0.0 else times[-1]:g} s, which is not in the run (0 to {end:g} s); choose times "
            "up to Time/End Time.")
    return times


def out_folder(options):
    return pathlib.Path(options.out) if options.out else pathlib.Path("runs") / f"{pathlib.Path(options.deck).stem}-converge"


def check_quantity(name, deck):
    if name == "depth" and all(value_in(deck, path) is None for path in ("Jet/Material", "Jet Monitor/Position")):
        raise Fault('--quantity depth needs a jet, and the deck has none; name a column of history.csv or a number of summary.json, for '
            'example --quantity kinetic.')


def resolving(levels, quantity):
    """How many of the three levels of the smallest cells have none wider than the jet's radius, where a depth is followed."""
    count = 0
    for level in levels[:3]:
        cells = read_summary(level.folder).get("penetration", {}).get("cells_per_radius") if quantity.table == "depth.csv" else None
        if cells and cells.get("tip", 1.0) < 1.0 - 1e-6:
            return count
        count += 1
    return 3


def refuse_no_depth(levels, quantity):
    """A depth of 0 on all levels agrees to round-off and says nothing."""
    if quantity.table == "depth.csv" and not any(read_summary(level.folder).get("penetration", {}).get("met_target") for level in levels):
        raise Fault("the jet has met no target by the end of the runs, so there is no depth; barreno check says why.")


def refuse_through(levels, quantity):
    """Behind a target there is no depth: its length, which all levels would then share, has no error."""
    if quantity.name != "depth":
        return
    through = [level for level in levels if read_summary(level.folder).get("penetration", {}).get("through")]
    if through:
        raise Fault(
            f"the jet has come out of the rear of the target in {len(through)} of the {len(levels)} runs, so depth is the length of the "
            "target there;"
            " make the target thicker, or choose an earlier Time/End Time."
        )


def compare(levels, quantity, times, formal):
    """[(time, values, verdict)]"""
    refuse_no_depth(levels, quantity)
    refuse_through(levels, quantity)
    found = [quantity.at(level.folder, times) for level in levels]
    if any(not math.isfinite(value) for values in found for value in values):
        raise Fault(f"{quantity.name} is not a finite number in a run; choose another quantity.")
    resolved, sizes = resolving(levels, quantity), [level.cells for level in levels]
    rows = []
    for i, time in enumerate(times if quantity.table else times[-1:]):
        values = [values[i] for values in found]
        rows.append((time, values, order.judge(sizes, values, formal, resolved)))
    return rows


def stem_of(name):
    """The depth, which summaries refer to, is not written over by another quantity."""
    return "converge" if name == "depth" else "converge_" + re.sub(r"\W", "_", name)


def write(options, levels, quantity, rows, out):
    stem = stem_of(quantity.name)
    place(out / f"{stem}.csv", report.as_csv(quantity.name, levels, rows))
    place(out / f"{stem}.json", report.as_json(options.deck, quantity.name, levels, rows, options.formal_order))
    series = [quantity.series(level.folder) for level in levels]

    def draw(aside):
        from barreno.converge.picture import draw  # slow to load

        draw(aside, quantity.name, levels, series, rows)

    place(out / f"{stem}.png", draw)
    if quantity.name == "depth":
        report.note_in_summaries(levels, rows[-1][2], out / f"{stem}.json")


def run(words):
    options = parse(words)
    check_words(options)
    program = found_program("converge", options.ranks)
    settings = [*options.settings, *([f"Fidelity={options.fidelity}"] if options.fidelity else [])]
    base = program.effective_deck([options.deck, *as_set(settings)])
    check_quantity(options.quantity, base)
    size, end = float(value_in(base, "Grid/Cell Size")), end_of(base)
    times = times_of(options.times, end)
    out, sizes = out_folder(options), level_runs.cells_of(size, options.levels, options.refine)
    settings += level_runs.box_setting(base, level_runs.common_length(sizes[0], options.levels, options.refine), print)
    levels = level_runs.make_levels(program, options.deck, settings, base, sizes, out)
    make_folder(out)  # nothing is left of a deck that cannot be
    program.watch_signals()
    places = [out, out.parent]
    for level in reversed(levels):  # the cheap ones first: what is wrong shows early
        level_runs.run_level(program, level, places, print)
        if level is levels[-1]:
            quantity = Quantity(options.quantity, level.folder)
    if math.isinf(end):
        # Beyond its end a hole at rest stays as it is.
        end = last_end(levels)
        times = times_of(options.times, end)
    if times[-1] < end:
        times.append(end)
    rows = compare(levels, quantity, times, options.formal_order)
    write(options, levels, quantity, rows, out)
    print(report.table(quantity.name, levels, rows))
    for line in report.remarks(rows, options.formal_order):
        print(line)
    if rows[-1][2].kind == order.UNRESOLVED:
        print(report.offer(level_runs.cell_settings(base, sizes[0])))
    if any(row[2].order_used for row in rows):
        print(f"Interval: {report.METHOD}.")
    measured = report.measured_error(quantity, levels[0])
    if measured:
        print(measured)
    stem = stem_of(quantity.name)
    print(f"Written: {out / stem}.csv, {stem}.json and {stem}.png")
    return 0


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
