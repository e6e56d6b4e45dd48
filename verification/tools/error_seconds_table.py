# SPDX-License-Identifier: BSD-3-Clause
"""The part "Error against seconds" of docs/trade.md."""
import json

from tools.case_list import RESULTS
from tools.uniform_cells import REFERENCE, depth_of
from tools.verification_pages import table

STORED = RESULTS / "error_seconds.json"
TIMES = (20, 50, 90)  # us


ROWS = {
    "cells of 2 mm": {"Grid/Cell Size": "2 mm"}, "cells of 1 mm": {"Grid/Cell Size": "1 mm"},
    "cells of 0.5 mm": {"Grid/Cell Size": "0.5 mm"}, "*fast*": {"Fidelity": "fast"}, "*balanced*": {"Fidelity": "balanced"},
}  # fmt: skip
# Least cost of a particle-step of Uintah's material point method, in metal, on one core of the same kind [ns]; in dry rock 4686.
UINTAH = 2357.0


def error(one):
    return max(abs(depth / depth_of(REFERENCE, time) - 1.0) for depth, time in zip(one["depths"], TIMES))


def row(name, one):
    steps = one["particle_steps"] + one["skipped"]
    other = f"{1e-9 * UINTAH * steps:.0f}" if name.startswith("cells") else "-"
    return [name, f"{100.0 * error(one):.1f} %", f"{1e-6 * steps:.0f}", f"{one['cpu_seconds']:.1f}", other]


def section():
    found = json.loads(STORED.read_text())
    head = ["cells", "greatest error of the depth", "particle-steps [10^6]", "seconds", f"at {UINTAH:,.0f} ns per particle-step [s]"]
    times = ", ".join(map(str, TIMES))
    words = (
        "What an error of the depth costs on one core: the shot of `perforation_120us.xml` to 90 us",
        f"(`verification/error_seconds.py BARRENO`). The error is the greatest at {times} us, against cells of {REFERENCE:g} mm",
        "everywhere. Cells of one size with one step for all are what a code without refinement offers. The last column is what",
        f"their particle-steps, those of dormant tiles included, cost at {UINTAH:,.0f} ns each: the least that was reported of",
        "Uintah's material point method on one core of this kind (in metal; 4,686 ns in dry rock). So it bounds that code's time",
        "from below. The machine had other work while the seconds were measured; they are good to a fifth.",
    )
    return "\n".join(["## Error against seconds", "", *words, "", *table(head, [row(name, one) for name, one in found.items()]), ""])
