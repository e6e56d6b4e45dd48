# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a sweep: their decks, their folders, and the folder of the sweep."""

import concurrent.futures
import dataclasses
import difflib
import hashlib
import json
import re

from barreno.runs.effective_deck import lists_in, value_in
from barreno.runs.faults import FILE, Fault
from barreno.runs.make_runs import Run
from barreno.runs.program import as_set
from barreno.runs.regular_file import read_text
from barreno.runs.tables import make_folder, place

# Lists whose entries have names of the user's own: --set would make a new one of a name that is misspelled.
NAMED_LISTS = ("Materials", "Shapes", "Bodies", "Conditions", "Loads", "Refinement", "Contact", "Pore Flow/Rocks", "Pore Flow/Conditions")
LONGEST_NAME = 100
RECORD = "sweep.json"
CHECKS_AT_ONCE = 4


@dataclasses.dataclass(eq=False)
class Point(Run):
    """One run: its values, in the order of the variations."""

    values: tuple = ()
    label: str = ""
    more: dict = dataclasses.field(default_factory=dict)  # numbers beside those of its summary


def check_lists(base, variations):
    for variation in variations:
        owner = next((name for name in NAMED_LISTS if variation.path.startswith(f"{name}/")), None)
        name = variation.path.removeprefix(f"{owner}/").split("/")[0]
        known = lists_in(base, owner) if owner else []
        if not owner or name in known or f"{owner}/{name}" == variation.path:
            continue
        near = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean '{near[0]}'?" if near else f"choose one of {', '.join(map(repr, known))}." if known else "add it to the deck."
        raise Fault(f'{variation.where()}: the deck has no list {name} in {owner}; {hint}')


def check_settings(settings, variations):
    """A value that is set and varied is a mistake in one of them."""
    paths = {setting.partition("=")[0] for setting in settings}
    for variation in variations:
        if variation.path in paths:
            raise Fault(f'{variation.where()} varies what --set or --fidelity fixes; leave one of them out.')


def short_names(variations):
    """Last words of the paths; whole paths where these are not different."""
    names = [variation.name() for variation in variations]
    return names if len(set(names)) == len(names) else [variation.path for variation in variations]


def label_of(names, values):
    return ", ".join(f"{name} = {value.text}" for name, value in zip(names, values))


def folder_name(names, values):
    parts = [f"{name}-{value.text.replace(' ', '')}" for name, value in zip(names, values)]
    name = "_".join(re.sub(r"[^\w.+-]+", "_", part).strip("_") for part in parts)
    digest = hashlib.sha256(label_of(names, values).encode()).hexdigest()[:8]
    return name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]}-{digest}"


def folder_names(names, points):
    """One for each point, also if two of them become the same text."""
    found = [folder_name(names, values) for values in points]
    digest = lambda values: hashlib.sha256(label_of(names, values).encode()).hexdigest()[:8]  # noqa: E731
    return [name if found.count(name) == 1 else f"{name}-{digest(values)}" for name, values in zip(found, points)]


def make_points(program, deck, settings, variations, points, out):
    names = short_names(variations)
    words = [[deck, *as_set([*settings, *(f"{variation.path}={value.text}" for variation, value in zip(variations, values))])]
        for values in points]
    made = [Point(word, "", out / name, values=values, label=label_of(names, values))
        for word, name, values in zip(words, folder_names(names, points), points)]
    set_decks(made, lambda point: program.effective_deck(point.words))
    return made


def set_decks(points, deck_of):
    """Every run's effective deck: what is wrong with one is said before anything is computed.  @param deck_of  a point"""
    with concurrent.futures.ThreadPoolExecutor(CHECKS_AT_ONCE) as checks:
        decks = list(checks.map(deck_of, points))
    seen = {}
    for point, deck in zip(points, decks):
        point.deck = deck
        other = seen.setdefault(deck, point)
        if other is not point:
            raise Fault(f"{other.label} and {point.label} make the same run (the values that take effect are equal); leave one out.")


def digest_of(deck):
    return hashlib.sha256(deck.encode()).hexdigest()


def recorded_base(file):
    try:
        return json.loads(read_text(file))["base"]
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return None


def check_out(out, base, record=RECORD, study="a sweep"):
    """A folder that holds anything but a sweep of this deck, or another study of it that keeps such a record, is left alone."""
    if not out.exists():
        return
    if not out.is_dir():
        raise Fault(f"--out {out} is a file (the runs of {study} need a folder); name another one.", FILE)
    held = sorted(file.name for file in out.iterdir() if not file.name.startswith("."))
    if held and not (out / record).exists():
        raise Fault(f"--out {out} holds something else ({', '.join(held[:3])}{', ...' if len(held) > 3 else ''}, and no {record}); name "
            "another folder.", FILE)
    if held and recorded_base(out / record) != digest_of(base):
        raise Fault(f"--out {out} holds {study} of another deck, or of this one with other values of what is not varied; name another "
            "folder, or remove that one.", FILE)


def write_record(options, base, variations, points, out):
    runs = [{"values": {v.path: value.text for v, value in zip(variations, point.values)}, "folder": str(point.folder), "how": point.how}
        for point in points]
    record = {"deck": str(options.deck), "base": digest_of(base), "settings": options.settings, "sample": options.sample, "runs": runs}
    make_folder(out)
    place(out / RECORD, json.dumps(record, indent=1, ensure_ascii=False) + "\n")


def si_values(variation_path, points):
    """Of a parameter in the runs, as numbers; None if they are none."""
    try:
        return [float(value_in(point.deck, variation_path)) for point in points]
    except (TypeError, ValueError):
        return None
