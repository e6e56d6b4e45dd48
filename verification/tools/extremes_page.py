# SPDX-License-Identifier: BSD-3-Clause
"""The page of the extremes, from their results file."""
import json

from tools.case_list import RESULTS
from tools.extreme import HOLDS, RED, STOPS, Row

STORED = RESULTS / "extremes.json"
HEAD = """# Extremes

Measured by `verification/extremes.py BARRENO --full --document`; do not edit by hand.

| verdict | meaning |
|---|---|
| holds | the row meets its criterion |
| stops | the run ends with a sentence that names fault and reason |
| RED | neither; `verification/open_demands.toml` lists the row as open, with the reason |

Every test run takes the cheap forms (`ctest -R verification.extremes`).
"""


def stored_rows():
    return [Row(**row) for row in json.loads(STORED.read_text())]


def stored_page():
    return page_of(stored_rows())


def one_line(text):
    return " ".join(str(text).split()).replace("|", "/")


def page_of(rows):
    counts = {verdict: sum(row.verdict == verdict for row in rows) for verdict in (HOLDS, STOPS, RED)}
    lines = [HEAD, f"{len(rows)} rows: {counts[HOLDS]} hold, {counts[STOPS]} stop with their sentence, {counts[RED]} are red.", ""]
    extreme = None
    for row in rows:
        if row.extreme != extreme:
            extreme = row.extreme
            lines += ["", f"## {extreme}", "", "| set-up | criterion | found | verdict | sentence or reason |", "|---|---|---|---|---|"]
        lines.append("| " + " | ".join(one_line(v) for v in (row.setup, row.criterion, row.found, row.verdict, row.note)) + " |")
    return "\n".join(lines) + "\n"
