# SPDX-License-Identifier: BSD-3-Clause
"""What the fits of synthetic sets must show, and the part of docs/fit.md that says what they show."""

import json
import math
import pathlib

STORED = pathlib.Path(__file__).resolve().parents[1] / "results" / "synthetic_fits.json"
SETS = 40
LARGEST_MISFIT = 1.02  # of the truth's
LARGEST_SECONDS = 60.0  # of the processor
COVERED = (0.90, 0.99)  # of the sets
CHANCE = 0.005  # of a count as far off or further, below which a parameter's count is no accident of few sets
WIDE, NARROW = 2.0, 0.5  # of a range at the truth over the width from which on a parameter is open: beyond these a wrong word is a fault


def held(p):
    return p["low"] <= p["truth"] <= p["high"]


def is_open(p):
    return p["low"] is None


def coverage(rows):
    """{name: sets, determined, held}: of those that are determined, in how many the range holds the truth; "all" of all parameters."""
    out = {}
    for p in (p for row in rows for p in row["parameters"]):
        for name in (p["name"], "all"):
            entry = out.setdefault(name, {"sets": 0, "determined": 0, "held": 0})
            entry["sets"] += 1
            entry["determined"] += not is_open(p)
            entry["held"] += not is_open(p) and held(p)
    return out


def at_most(k, n, part):
    """Chance of k hits or fewer in n."""
    return sum(math.comb(n, j) * part**j * (1.0 - part) ** (n - j) for j in range(k + 1))


def is_accident(entry):
    """Whether the count is one that a coverage between the two limits gives."""
    n, k = entry["determined"], entry["held"]
    return at_most(k, n, COVERED[0]) >= CHANCE and 1.0 - at_most(k - 1, n, COVERED[1]) >= CHANCE


def wrong_words(rows):
    """(set, parameter) that is called determined though the true range is wide, or open though it is narrow."""
    return [
        (row["set"], p["name"]) for row in rows for p in row["parameters"]
        if (p["width"] > WIDE and not is_open(p)) or (p["width"] < NARROW and is_open(p))
    ]  # fmt: skip


def faults_of(rows):
    """A sentence for everything that is missed."""
    out = [f"set {row['set']} gives no card: {row['said']}" for row in rows if row["ratio"] is None]
    done = [row for row in rows if row["ratio"] is not None]
    out += [f"the misfit of set {row['set']} is {row['ratio']} of the truth's, above {LARGEST_MISFIT}"
        for row in done if row["ratio"] > LARGEST_MISFIT]
    out += [f"set {row['set']} takes {row['seconds']} s of the processor, above {LARGEST_SECONDS:g} s"
        for row in rows if row["seconds"] > LARGEST_SECONDS]
    for name, entry in coverage(done).items():
        whole = name == "all" and len(rows) >= SETS
        part = entry["held"] / max(entry["determined"], 1)
        if not (COVERED[0] <= part <= COVERED[1] if whole else is_accident(entry)):
            out.append(f"the ranges of {name} hold the truth in {entry['held']} of {entry['determined']} sets, which is not "
                f"{100 * COVERED[0]:g} to {100 * COVERED[1]:g} %")
    return out + [f"{name} of set {number} is called determined or not determined, and is the opposite"
        for number, name in wrong_words(done)]


def words_line(rows):
    """How often "not determined" is right."""
    entries = [p for row in rows for p in row["parameters"]]
    wide, narrow = [p for p in entries if p["width"] > WIDE], [p for p in entries if p["width"] < NARROW]
    return (
        "How often a fit calls a parameter what its range at the true card, with the true noise, makes it. A parameter is *not determined* "
        "if that range "
        f"is at least {WIDE:g} times as wide as the limit from which on parameters are open: {len(wide)}, called so "
        f"{sum(map(is_open, wide))}. A parameter is "
        f"*determined* at {NARROW:g} times that limit or less: {len(narrow)}, called so {len(narrow) - sum(map(is_open, narrow))}."
    )


def stored_part():
    """The part of docs/fit.md."""
    rows = json.loads(STORED.read_text())["sets"]
    done = [row for row in rows if row["ratio"] is not None]
    ratios, seconds = [row["ratio"] for row in done], [row["seconds"] for row in rows]
    lines = [
        f"Sets fitted: {len(rows)} of {SETS}, of which {len(done)} gave a card. Misfit over the misfit of the true card: "
        f"{min(ratios):.3f} to {max(ratios):.3f}; at most {LARGEST_MISFIT} in {sum(ratio <= LARGEST_MISFIT for ratio in ratios)} of "
        f"{len(done)}. "
        f"Processor time of a fit: {min(seconds):.0f} to {max(seconds):.0f} s.",
        "", words_line(done), "", "| parameter | sets | determined | range holds the truth |", "|---|---|---|---|",
    ]  # fmt: skip
    for name, entry in sorted(coverage(done).items(), key=lambda item: item[0] == "all"):
        part = f" ({100 * entry['held'] / entry['determined']:.0f} %)" if entry["determined"] else ""
        lines.append(f"| {name if name == 'all' else f'`{name}`'} | {entry['sets']} | {entry['determined']} | {entry['held']}{part} |")
    return lines + ["", *(f"- Missed: {fault}." for fault in faults_of(rows))]
