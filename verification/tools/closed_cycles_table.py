# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/materials/arenisca.md: what cycles of each card of rock can create, from the case closed_cycles."""
import json

from tools.case_list import RESULTS
from tools.verification_pages import table

STORED = RESULTS / "closed_cycles.json"
CYCLE, SOFTER, ROUND = "most of one cycle", "most where it dilates", "most that compaction leaves of it"
HEAD = ["card", "one cycle to 1 GPa [MJ/m3]", "of what is stored there", "one cycle to 5 GPa [MJ/m3]", "of what is stored there",
    "where it dilates [MJ/m3]", "left after compaction [MJ/m3]"]  # fmt: skip


def cards():
    """{card: {(state, pressure): (created [MJ/m3], share of the stored energy)}}"""
    found = {}
    for name, state, pressure, _, _, created, _, share in json.loads(STORED.read_text())["rows"]:
        if state in (CYCLE, SOFTER, ROUND):
            found.setdefault(name, {})[state, pressure if state == CYCLE else ""] = (created / 1e3, share)
    return found


def lines():
    rows, cycles = [], {"0 to 1000": [], "0 to 5000": []}
    for name, of in cards().items():
        row = [f"`{name}`"]
        for pressure, all_cards in cycles.items():
            created, share = of[CYCLE, pressure]
            all_cards.append((created, share))
            row += [f"{created:.2f}", f"{100.0 * share:.1f} %"]
        rows.append([*row, f"{of[SOFTER, ''][0]:.2f}", f"{of[ROUND, ''][0]:.2f}"])
    most = {pressure: (max(c for c, _ in found), max(s for _, s in found)) for pressure, found in cycles.items()}
    low, high = most["0 to 1000"], most["0 to 5000"]
    softer = max(of[SOFTER, ""][0] for of in cards().values())
    return [
        *table(HEAD, rows),
        "",
        f"One cycle of shear and pressure to 1 GPa creates at most {low[0]:.1f} MJ/m3, one to 5 GPa at most {high[0]:.1f} MJ/m3: "
        f"{100.0 * low[1]:.0f} and {100.0 * high[1]:.1f} % of what the rock stores there. Rock that begins to dilate under load gives back "
        f"up to {softer:.1f} MJ/m3 that it never took up.",
    ]
