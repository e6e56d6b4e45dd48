# SPDX-License-Identifier: BSD-3-Clause
"""What the decks and the results of several runs differ in."""

import csv
import io

from barreno.runs.effective_deck import all_values
from barreno.runs.run_folder import deck_in

LONGEST = 40  # letters of a value on the screen and in a table
ABSENT = "(absent)"


def deck_differences(runs):
    """{path: [value in the deck of each run]} of what is not the same in all of them."""
    all_of = [all_values(deck_in(run), run / "deck.xml") for run in runs]
    paths = list(dict.fromkeys(path for values in all_of for path in values))
    found = {path: [values.get(path, ABSENT) for values in all_of] for path in paths}
    return {path: values for path, values in found.items() if len(set(values)) > 1}


def shortened(values):
    """Long values (a jet's table) by their size and number, which tell them apart."""
    kinds = list(dict.fromkeys(values))
    return [value if len(value) <= LONGEST else f"({len(value)} letters, no. {kinds.index(value) + 1})" for value in values]


def number_of(value):
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else None


def against(first, value):
    """(absolute, percent) difference; None where there is none to give."""
    if first is None or value is None:
        return None, None
    return value - first, 100.0 * (value - first) / abs(first) if first else None


def quantities_of(rows):
    """[(name, numbers of all runs)] of the scalars that are numbers in any run."""
    names = list(dict.fromkeys(name for row in rows for name in row.scalars))
    found = [(name, [number_of(row.scalars.get(name)) for row in rows]) for name in names]
    return [(name, numbers) for name, numbers in found if any(number is not None for number in numbers)]


def as_csv(labels, quantities):
    out = io.StringIO()
    out.write(f"# SI units; difference: of each run from the first ({labels[0]}), also in percent of its amount; names as in summary.json "
        "(docs/output.md)\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["quantity", labels[0], *(head for label in labels[1:] for head in (label, f"{label} difference", f"{label} percent"))])
    text = lambda number: "" if number is None else repr(number)  # noqa: E731
    for name, (first, *others) in quantities:
        cells = [text(cell) for number in others for cell in (number, *against(first, number))]
        writer.writerow([name, text(first), *cells])
    return out.getvalue()


def decks_as_csv(labels, differences):
    out = io.StringIO()
    out.write("# Parameters of the effective decks that are not the same in all runs, in SI\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerows([["parameter", *labels], *([path, *values] for path, values in differences.items())])
    return out.getvalue()
