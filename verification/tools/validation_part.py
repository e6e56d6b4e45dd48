# SPDX-License-Identifier: BSD-3-Clause
"""Parts of docs/validation.md from validation.json: all comparisons in one table, and a section for each experiment."""
import math

from tools.case_list import stored
from tools.demands import FAILS, HOLDS, OPEN, judge_all, open_demands
from tools.experiment import EXPERIMENTS, judged, spread
from tools.validation_results import PICTURE_FILE, stored_experiments
from tools.verification_pages import sign, table, verdict_of

LABORATORY = "laboratory_tests"  # a case of verification that compares with measurements


def ours(values):
    """'10.3 +- 0.2': of the smallest cells, with their interval."""
    half = spread(values)
    return f"{values[-1]:.3g}" if math.isnan(half) else f"{values[-1]:.3g} +- {half:.2g}"


def verdicts_of(name, data):
    """{quantity: verdict in words}; what is not required has none."""
    words = {HOLDS: "holds", OPEN: "**fails**", FAILS: "**FAILS**"}
    found, _ = judged(name, data, True)
    return {check["what"]: f"{words[verdict]}{f': {reason}' if reason else ''}" for check, verdict, reason in found}


def requirement(check):
    return "" if check is None else f"{check['value']:.3g} {sign(check)} {check['limit']:.3g}"


def laboratory():
    """(its results, each requirement with verdict and reason)."""
    data = stored(LABORATORY)
    return data, judge_all(data["checks"], open_demands(LABORATORY, True))[0]


def overview():
    """One row for each quantity, and one for the laboratory tests, which have a page of verification."""
    rows = []
    for name, data in stored_experiments().items():
        verdicts = verdicts_of(name, data)
        link = f"[{data['title']}](#{data['title'].lower().replace(' ', '-')})"
        for row in data["rows"]:
            verdict = verdicts.get(row["what"], "shown")
            rows.append([link, row["what"], row["measured"], row["mark"], ours(row["ours"]), verdict.partition(":")[0]])
            link = ""
    data, found = laboratory()
    link = f"[{data['title']}](verification/{LABORATORY}.md)"
    rows.append([link, f"{len(data['rows'])} quantities, below", "", "", "", verdict_of(found)])
    return table(["experiment", "quantity", "measured", "mark", "ours", "verdict"], rows)


def section(name, data):
    cells = [f"{h:g} mm" for h in data["cells"]]
    words = data["set_up"] + (f" of {' and '.join(cells)}." if cells else ".")
    verdicts = verdicts_of(name, data)
    several = len(cells) > 1
    lines = [f"### {data['title']}", "", f"{data['claim']} `verification/experiments/{name}.py`: {words}", ""]
    if data["profiles"]:
        lines += [f"![{data['title']}](pictures/{PICTURE_FILE})", ""]
    columns = ["quantity", "measured", "mark", "source", *(cells[:-1] if several else []), "ours", "required", "verdict"]
    rows = []
    for row in data["rows"]:
        coarse = ([f"{row['ours'][0]:.3g}"] if len(row["ours"]) > 1 else [""]) if several else []
        rows.append([row["what"], row["measured"], row["mark"], row["source"], *coarse, ours(row["ours"]), requirement(row["check"]),
            verdicts.get(row["what"], "shown")])
    return [*lines, *table(columns, rows), "", *([data["notes"], ""] if data["notes"] else [])]


def sections():
    found = stored_experiments()
    return [line for name in EXPERIMENTS if name in found for line in section(name, found[name])]


def fails():
    """What does not hold, with its reason."""
    rows = []
    everything = [(data["title"], judged(name, data, True)[0]) for name, data in stored_experiments().items()]
    data, found = laboratory()
    for title, verdicts in [*everything, (data["title"], found)]:
        rows += [[title, check["what"], f"{check['value']:.3g}", f"{sign(check)} {check['limit']:.3g}", words]
            for check, verdict, words in verdicts if verdict != HOLDS]
    return table(["experiment", "requirement", "ours", "limit", "likely reason"], rows)


def failing():
    """Stored requirements that fail and are not open."""
    out = []
    for name, data in stored_experiments().items():
        found, wrong = judged(name, data, True)
        out += [f"results/validation.json: {name}: {check['what']}: {words}" for check, verdict, words in found if verdict == FAILS]
        out += [f"results/validation.json: {name}: {words}" for words in wrong]
    return out
