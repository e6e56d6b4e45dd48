# SPDX-License-Identifier: BSD-3-Clause
"""docs/verification.md, which is one table, and a page for every case, from the stored results."""
from tools.case_list import RESULTS, cases, stored
from tools.case_pictures import file_of
from tools.demands import FAILS, HOLDS, OPEN, judge_all, open_demands
from tools.pages_elsewhere import rows_elsewhere

COLUMNS = ("claim", "exact answer", "requirement", "condition", "measured", "limit", "verdict", "picture")
LONGEST = 24  # demands that a page lists; of more the open ones and those nearest to their limits
HEAD = """# Verification

What is required of the code, and what is measured. Each claim has a page with all its figures; the figure here is one of them. An *open*
requirement is known not to hold. `verification/open_demands.toml` gives the reason and the largest value allowed. An open requirement that gets
worse fails, and so does one that begins to hold.

| to do | command |
|---|---|
| one case, its cheap form (part of every test run: `ctest -L verification`) | `./barreno python verification/verify.py build/release/src/barreno bar_wave` |
| the full form of a case, and these pages | `./barreno python verification/verify.py build/release/src/barreno --full --document bar_wave` |
| these pages from the stored results | `./barreno python verification/pages.py --write` |

"""


def number(value):
    if isinstance(value, float):
        return "" if value != value else f"{value:.4g}"
    return str(value)


def table(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return lines + ["| " + " | ".join(number(value).replace("|", "\\|") for value in row) + " |" for row in rows]


def sign(check):
    return ">=" if check["at_least"] else "<="


def verdict_of(judged):
    """Of all demands of a case, in words."""
    count = {verdict: sum(one[1] == verdict for one in judged) for verdict in (HOLDS, OPEN, FAILS)}
    if count[FAILS]:
        return f"**{count[FAILS]} of {len(judged)} fail**"
    return f"holds ({len(judged)})" if not count[OPEN] else f"{count[HOLDS]} of {len(judged)} hold, {count[OPEN]} open"


def shown(entry, judged, name):
    """(requirement, condition, measured, limit) of the one that stands for the case."""
    for check, *_ in judged:
        if check["what"] == entry["shown"]:
            return *name_and_condition(check["what"],
                entry.get("condition_last", False)), f"{check['value']:.3g}", f"{sign(check)} {check['limit']:.3g}"
    raise SystemExit(f"cases.toml: [{name}] shows '{entry['shown']}', which results/{name}.json does not have; name one of its demands")


def overview():
    lines, group, totals = [], None, {HOLDS: 0, OPEN: 0, FAILS: 0}
    for name, entry in cases().items():
        data = stored(name)
        if data is None:
            continue
        judged, _ = judge_all(data["checks"], open_demands(name, True))
        for _, verdict, _ in judged:
            totals[verdict] += 1
        if entry["group"] != group:
            group = entry["group"]
            lines.append(f"| **{group}** |" + " |" * (len(COLUMNS) - 1))
        picture = f"[picture](pictures/{file_of(name, entry)})" if file_of(name, entry) else ""
        cells = [f"[{entry['claim']}](verification/{name}.md)", entry["exact"], *shown(entry, judged, name), verdict_of(judged), picture]
        lines.append("| " + " | ".join(cells) + " |")
    lines += ["| **Elsewhere** |" + " |" * (len(COLUMNS) - 1), *rows_elsewhere(RESULTS)]
    total = sum(totals.values())
    words = f"{total} requirements of {len(cases())} cases: {totals[HOLDS]} hold, {totals[OPEN]} are open, {totals[FAILS]} fail.\n\n"
    heads = "| " + " | ".join(COLUMNS) + " |\n|" + "---|" * len(COLUMNS) + "\n"
    return HEAD + words + heads + "\n".join(lines) + "\n\n" + open_section()


def open_section():
    lines = ["## Open requirements", "", "| case | requirements | reason |", "|---|---|---|"]
    for name in cases():
        reasons = {}
        for known in open_demands(name, True).values():
            reasons[known.reason] = reasons.get(known.reason, 0) + 1
        lines += [f"| [{name}](verification/{name}.md) | {count} | {reason} |" for reason, count in reasons.items()]
    return (
        "\n".join(lines) + "\n\nOpen rows of the extremes: [extremes](../verification/results/extremes.md). Open trade-offs: "
            "[trade.md](trade.md#requirements).\n"
    )


def nearness(check):
    """1 at the limit, less the farther from it."""
    far, near = (check["value"], check["limit"]) if check["at_least"] else (check["limit"], check["value"])
    return near / far if far > 0.0 and near > 0.0 else 0.0


def name_and_condition(what, condition_last=False):
    """('order of the last halving', 'GIMP, A = 0.01') of 'GIMP, A = 0.01: order of the last halving'; of 'front speed, 0.5 mm' likewise."""
    first, colon, last = what.partition(": ")
    if colon:
        return (first, last) if condition_last else (last, first)
    name, comma, rest = what.partition(", ")
    return (name, rest) if comma and any(c.isdigit() for c in rest) and not any(c.isdigit() for c in name) else (what, "")


def demand_lines(judged, known, condition_last=False):
    listed, words = judged, ""
    if len(judged) > LONGEST:
        held = sorted((one for one in judged if one[1] == HOLDS), key=lambda one: -nearness(one[0]))[:12]
        listed = [one for one in judged if one[1] != HOLDS or one in held]
        words = (
            f"The other {len(judged) - len(listed)} of {len(judged)} requirements hold by a larger margin. All are in "
            "`verification/results`."
        )
    rows = []
    for check, verdict, reason in listed:
        if verdict == OPEN:
            verdict = f"open, at worst {known[check['what']].worst:.3g}: {reason}"
        verdict = verdict if verdict != FAILS else f"FAILS: {reason}"
        rows.append([*name_and_condition(check["what"], condition_last), f"{check['value']:.3g}",
            f"{sign(check)} {check['limit']:.3g}", verdict])
    columns = ["requirement", "condition", "measured", "limit", "verdict"]
    if not any(row[1] for row in rows):
        columns, rows = [columns[0], *columns[2:]], [[row[0], *row[2:]] for row in rows]
    return [*table(columns, rows), *(["", words] if words else [])]


def case_page(name, entry, data):
    known = open_demands(name, True)
    judged, _ = judge_all(data["checks"], known)
    lines = [f"# {data['title']}", "", f"{entry['claim']}. All claims: [verification.md](../verification.md).", "",
             f"`verification/cases/{name}.py`. {data['proves']} Exact: {data['reference']}", ""]  # fmt: skip
    if file_of(name, entry):
        lines += [f"![{data['title']}](../pictures/{file_of(name, entry)})", ""]
    lines += [*demand_lines(judged, known, entry.get("condition_last", False)), ""]
    if data["notes"]:
        lines += [data["notes"], ""]
    return "\n".join(lines + ["## Measured", "", *table(data["columns"], data["rows"])]) + "\n"


def pages():
    """{file under docs: text}."""
    out = {"verification.md": overview()}
    for name, entry in cases().items():
        data = stored(name)
        if data:
            out[f"verification/{name}.md"] = case_page(name, entry, data)
    return out
