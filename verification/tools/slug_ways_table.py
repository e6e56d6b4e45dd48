# SPDX-License-Identifier: BSD-3-Clause
"""What late slugs lose on their way: a part of docs/trade.md, from verification/results/slug_ways.json."""
import json

from tools.case_list import DOCS, RESULTS

TIMES = (120, 160, 200)  # us
BINS = (0, 50, 100, 150, 200, 250, 300)  # mm
PICTURE = DOCS / "pictures" / "slug_ways.png"


def table():
    found = json.loads((RESULTS / "slug_ways.json").read_text())
    places = [f"{low} to {high} mm" for low, high in zip(BINS, BINS[1:])]
    lines = ["| cells per radius | particles per cell | part of the slug | " + " | ".join(places) + " |", "|" + "---|" * (3 + len(places))]
    for name, times in found.items():
        cells, particles = name.split("/")
        rows = times[str(TIMES[-1])]
        for part, k in (("core, inner half", 2), ("rim, outer quarter", 3)):
            lines.append(f"| {cells} | {particles} | {part} | " + " | ".join(f"{row[k]:.2f}" for row in rows) + " |")
    return lines
