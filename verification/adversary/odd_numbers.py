# SPDX-License-Identifier: BSD-3-Clause
"""Every number of every shipped deck, one at a time, as large, small or odd as a number can be: a sentence, or a run."""
import re

from adversary.deck_tree import NUMBER, Deck
from adversary.one_set import DECKS, FILE, FINISHED, NUMERICAL, REFUSED, Finding, must_end
from adversary.same_runs import unsound

ODD = ["1e300", "-1e300", "1e-300", "-0", "5e-324", "2147483648", "9223372036854775808", "-1", "0", "nan", "inf", "-inf"]
STEPS = 20


def parameters_of(deck):
    """Paths of all parameters in which there are numbers, and how many."""
    found = []

    def visit(parameters, path):
        for child in parameters:
            at = f"{path}/{child.get('name')}".lstrip("/")
            if child.tag == "ParameterList":
                visit(child, at)
            elif child.get("name") not in ("Title", "Table", "Card", "Source"):
                found.append((at, len(NUMBER.findall(child.get("value")))))

    visit(deck.root, "")
    return [(path, count) for path, count in found if count > 0]


def all_odd_numbers():
    """(deck, path, which number, value) of all shipped decks."""
    found = []
    for file in sorted(DECKS.glob("*.xml")):
        for path, count in parameters_of(Deck(file)):
            # Of a long table the first row says as much as the others.
            found += [(file.name, path, at, value) for at in range(min(count, 6)) for value in ODD]
    return found


def with_number(text, at, value):
    count = -1

    def replaced(found):
        nonlocal count
        count += 1
        return value if count == at else found.group()

    return NUMBER.sub(replaced, text)


def try_number(odd, barreno, folder, tally):
    """@raises Finding"""
    name, path, at, value = odd
    deck = Deck(DECKS / name)
    deck.set(path, with_number(deck.value(path), at, value))
    file = folder / "deck.xml"
    deck.write(file)
    tally.add("odd numbers")
    plan = barreno.run("check", file)
    code = must_end(plan, FINISHED, REFUSED, FILE, NUMERICAL)
    if code != FINISHED:
        tally.add("odd numbers refused")
        return
    if re.search(r"\b-?(nan|inf)\b", plan.out):
        raise Finding(f"the plan says {re.search(r'.*?(nan|inf).*', plan.out).group()}")
    step = float(re.search(r"first steps of ([-+.\dei]+) s", plan.out).group(1))
    particles = float(re.search(r"^Particles ([\d.e+]+)", plan.out, re.MULTILINE).group(1))
    if particles > 2e4 or path == "Time/End Time":
        tally.add("odd numbers not run")
        return
    end = repr(max(STEPS * step, 5e-324))
    ended = barreno.run("run", file, "--out", folder / "odd", "--overwrite", "--set", f"Time/End Time={end}", "--set",
        "Output/Field Interval=0")
    code = must_end(ended, FINISHED, REFUSED, FILE, NUMERICAL)
    tally.add("odd numbers run")
    wrong = unsound(folder / "odd") if code == FINISHED else []
    if wrong:
        raise Finding("; ".join(wrong[:8]))
