# SPDX-License-Identifier: BSD-3-Clause
"""Parts of docs/uncertainty.md, from results/uncertainty.json (uncertainty_examples.py)."""
import json

from tools.case_list import RESULTS

UNITS = {"penetration.depth": ("mm", 1e3, 1), "penetration.probed_depth": ("mm", 1e3, 1), "penetration.channel_volume": ("cm3", 1e6, 1)}
LENGTH = ("mm", 1e3, 2)
PLAIN = ("", 1.0, 2)
LEAST = 0.005  # share of a row


def unit_of(name):
    return UNITS.get(name) or (LENGTH if "diameter" in name else PLAIN)


def interval(name, spread):
    _, factor, digits = unit_of(name)
    return f"{factor * spread['low']:.{digits}f} to {factor * spread['high']:.{digits}f}"


def answer_row(name, answer):
    unit, factor, digits = unit_of(name)
    whole = interval(name, answer["with_cells"]) if answer["with_cells"] else "unknown"
    foretold, span = answer["ranges"]["foretold"], [f"{factor * answer[end]:.{digits}f}" for end in ("least", "largest")]
    head = f"| {answer['words']}{f' [{unit}]' if unit else ''} | {factor * answer['ranges']['median']:.{digits}f} | "
    return f"{head}{interval(name, answer['ranges'])} | {whole} | {' to '.join(span)} | {100.0 * max(foretold, 0.0):.0f} % |"


def share_text(effect):
    share = f"{100.0 * effect['share']:.0f} %"
    return share if effect["told_from_scatter"] else f"({share})"


def share_rows(answers, ranges):
    """Of ranges that have a share in any answer; the others in a sentence."""
    shown, others = [], []
    for one in ranges:
        effects = [answer["ranges"]["effects"][one["path"]] for answer in answers.values()]
        name = one["path"].removeprefix("Materials/")
        if any(effect["told_from_scatter"] and effect["share"] >= LEAST for effect in effects):
            shown.append(f"| {name} | {one['known']} | {' | '.join(map(share_text, effects))} |")
        else:
            others.append(name)
    rest = " | ".join(f"{100.0 * answer['ranges']['rest']:.0f} %" for answer in answers.values())
    return [*shown, f"| interaction, scatter and other ranges | | {rest} |"], others


def example():
    data = json.loads((RESULTS / "uncertainty.json").read_text())
    answers = data["answers"]
    out = [f"`./barreno uncertainty {data['words']}`", "",
        "| answer | median | 90 % of cases | with error of cells | least and largest run | foretold |", "|---|---|---|---|---|---|"]
    out += [answer_row(name, answer) for name, answer in answers.items()]
    rows, others = share_rows(answers, data["ranges"])
    out += ["", f"| share of the variance | known | {' | '.join(answer['words'] for answer in answers.values())} |",
        "|---|---|" + "---|" * len(answers), *rows, ""]
    if others:
        out += [f"No share that stands out from the scatter: {', '.join(others)}.", ""]
    first = next(iter(answers.values()))
    minutes = data["seconds"] / 60.0
    out += [first["sentence"], "", f"Its {data['runs']} runs took {minutes:.0f} minutes of processor time. With two at a time on two "
        f"cores that is {minutes / 2.0:.0f} minutes, and more with the flow into their holes. The aim was 20 minutes in all."]
    return out
