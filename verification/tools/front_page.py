# SPDX-License-Identifier: BSD-3-Clause
"""The figures of accuracy and cost in README.md."""
import json

from case_list import RESULTS, stored
from solver_cost import FAST, read_table
from trade_page import FIDELITIES
from uniform_cells import REFERENCE, depth_of, interval


def results(name):
    return json.loads((RESULTS / f"{name}.json").read_text())


def rows_of(case):
    """{first column: {column: value}}"""
    data = stored(case)
    return {row[0]: dict(zip(data["columns"], row)) for row in data["rows"]}


def exponent(value):
    return f"{abs(value):.0e}".replace("e-0", "e-")


def with_interval(depth, cells):
    """180 (176 to 187): what was computed, and where the depth lies by the errors that were measured with so many cells per radius."""
    low, high = interval(depth, cells)
    return f"{depth:.0f} ({low:.0f} to {high:.0f})"


def fidelity_row(name, cells, job):
    depths = [with_interval(job[f"depth at {time} us [mm]"], cells) for time in (50, 90)]
    return (
        f"| with `--fidelity {name}`, {cells:g} cells per radius along the jet's path ([docs/verification/fidelities.md](docs/verification/fidelities.md)): depth at 50 and 90 us with its "
        f"interval, greatest difference to cells of {REFERENCE:g} mm everywhere until then, processor time | {depths[0]} and {depths[1]} mm; "
        f"{100 * job['greatest error of the depth']:.1f} %; {job['processor time [s]']:.0f} s |"
    )


def figures():
    job, runs = results("decks")["perforation.xml"], rows_of("perforation")
    jobs = rows_of("fidelities")
    whole, cells = runs["perforation.xml, 1 ranks"], [runs[f"{h} mm"] for h in ("2.0", "1.0", "0.5")]
    depths = [run["depth at 50 us [mm]"] for run in cells]
    errors = [100.0 * (depth / depth_of(REFERENCE, 50) - 1.0) for depth in depths]
    strong = next(one for one in results("scaling")["strong"] if one["name"].startswith("perforation"))
    notes, rock = read_table()
    point = next(row for row in rock if row["solver"] == FAST and row["knob"] == 1e-2)
    elastic = next(note for note in notes if note.startswith("elastic")).split(": ")[1]
    skipped = job["skipped_particle_steps"] / (job["skipped_particle_steps"] + job["particle_steps"])
    return [
        "| quantity | figure |", "|---|---|",
        f"| perforation.xml to 120 us on one core, including the yielding of Arenisca | {job['seconds']:.0f} s of processor time, {1e-6 * job['bytes']:.0f} MB in total; "
        f"{100 * skipped:.0f} % of the particle-steps are skipped, in dormant tiles |",
        f"| two ranks compared with one, {strong['name']} ([docs/performance.md](docs/performance.md)) | {strong['speedup']:.1f} times as fast |",
        f"| balances of perforation.xml ([docs/verification/perforation.md](docs/verification/perforation.md)) | mass {exponent(whole['mass'])}, axial momentum "
        f"{exponent(whole['axial momentum'])}, energy ledger remainder {exponent(whole['energy ledger'])} |",
        f"| its depth at 50, 90 and 120 us with one cell in the jet's radius, and in brackets the interval that the error measured with such cells to 90 us gives ([docs/trade.md](docs/trade.md#perforation-depth-at-20-us-axisymmetric-small-target)) | "
        f"{with_interval(whole['depth at 50 us [mm]'], 1.0)}, {with_interval(whole['depth at 90 us [mm]'], 1.0)} and {whole['final depth [mm]']:.0f} mm |",
        f"| its depth at 50 us with cells of 2, 1 and 0.5 mm, and the error against cells of {REFERENCE:g} mm ([docs/trade.md](docs/trade.md#perforation-depth-at-20-us-axisymmetric-small-target)) | "
        f"{depths[0]:.0f}, {depths[1]:.0f} and {depths[2]:.0f} mm; {errors[0]:.0f}, {errors[1]:.0f} and {errors[2] + 0.0:.1f} % |",
        *(fidelity_row(name, jobs[name]["cells per radius"], jobs[name]) for name in ("fast", "balanced")),
        f"| stress update of one rock point: yielding; elastic ([docs/materials/arenisca_cost.md](docs/materials/arenisca_cost.md)) | {1e-3 * point['ns_lanes']:.2g} us; {elastic} |",
    ]  # fmt: skip


# Problems of the trade, and the level that the front page shows.
SHOWN = (("box", 32, "manufactured motion, 32 cells"), ("shell", 16, "coasting shell, 16 cells in the wall"),
         ("shock", 0.5, "shock, pressures, 0.5 mm cells"), ("depth", 1.0, "depth of a perforation after 20 us, 1 mm cells"))  # fmt: skip


def fidelities():
    data = results("trade")
    at = {(p["problem"], p["name"], p["level"]): p for p in data["points"] if "error" in p}
    lines = ["| fidelity | " + " | ".join(words for _, _, words in SHOWN) + " |", "|---|" + "---|" * len(SHOWN)]
    for name in FIDELITIES:
        errors = [f"{100 * at[problem, name, level]['error']:.2g} %" for problem, level, _ in SHOWN]
        lines.append(f"| {name} ({data['chosen'][name][0]['Shape Function']}) | " + " | ".join(errors) + " |")
    steps = [at[problem, "fast", level]["work"] / at[problem, "balanced", level]["work"] for problem, level, _ in SHOWN]
    return [*lines, "", f"*fast* takes {min(steps):.2f} to {max(steps):.2f} of the particle-steps of *balanced*."]
