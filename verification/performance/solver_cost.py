#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What accuracy costs in Arenisca: measures, draws, and writes docs/materials/arenisca_cost.md.

    solver_cost.py BUILD_FOLDER [--stored]

runs barreno_solver_cost of that build over verification/performance/rock_points.csv; --stored takes the last
measurement instead (verification/results/solver_cost.csv) and asks for no build.
"""
import argparse
import math
import pathlib
import subprocess
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from barreno.runs.csv_table import WORDS, read_csv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
POINTS = HERE / "rock_points.csv"
TABLE = ROOT / "verification" / "results" / "solver_cost.csv"
PICTURE = ROOT / "docs" / "pictures" / "arenisca_cost.png"
PAGE = ROOT / "docs" / "materials" / "arenisca_cost.md"
FAST, CONTROLLED, NESTED = "fast", "bisected returns", "nested bisection"
TARGET = 1e-6


def read_table():
    table = read_csv(TABLE, cells=WORDS)
    numbers = {name: float for name in table.columns if name != "solver"}
    return [line[2:] for line in table.attrs["comments"]], table.astype(numbers).to_dict("records")


def at_error(rows, solver, column, target=TARGET):
    """Cost at a mean error, between rows on logarithmic axes; beyond them on the line of the last two."""
    points = sorted((math.log(r["mean_error"]), math.log(r[column])) for r in rows if r["solver"] == solver)
    wanted = math.log(target)
    i = min(max(sum(p[0] < wanted for p in points), 1), len(points) - 1)
    (x0, y0), (x1, y1) = points[i - 1], points[i]
    return math.exp(y0 + (y1 - y0) * (wanted - x0) / (x1 - x0))


def draw(rows):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for i, solver in enumerate(dict.fromkeys(row["solver"] for row in rows)):
        colour = f"C{i}"
        own = [row for row in rows if row["solver"] == solver]
        error = [row["mean_error"] for row in own]
        axes[0].loglog(error, [row["evaluations"] for row in own], "o-", ms=4, color=colour, label=solver)
        if solver == FAST:
            axes[1].loglog(error, [row["ns_lanes"] for row in own], "o--", ms=4, color=colour, label="fast, in vector lanes")
        axes[1].loglog(error, [row["ns_single"] for row in own], "o-", ms=4, color=colour, label=solver)
    axes[0].set_ylabel("yield-function evaluations per update")
    axes[1].set_ylabel("time per plastic update [ns]")
    for one in axes:
        one.set_xlabel("mean error, relative to the stress")
        one.invert_xaxis()
        one.grid(alpha=0.3)
        one.legend(fontsize=8)
    figure.savefig(PICTURE, dpi=130)
    plt.close(figure)


def stored_page():
    return page_text(*read_table())


def page_text(notes, rows):
    evaluations = {s: at_error(rows, s, "evaluations") for s in (FAST, NESTED)}
    times = {s: at_error(rows, s, "ns_single") for s in (FAST, NESTED)}
    default = next(r for r in rows if r["solver"] == FAST and r["knob"] == 1e-2)
    lines = [
        "# Arenisca: error against cost",
        "",
        "Written by `verification/performance/solver_cost.py build/release`; do not edit by hand. The updates come from",
        "yielding rock in `input_xml/perforation_quick.xml`, a random sample of all steps, recorded by",
        "`build/release/verification/barreno_record_rock_points input_xml/perforation_quick.xml "
        "verification/performance/rock_points.csv --flowing 2048 --elastic 512`.",
        "",
        "Errors are errors of the stress after one update, against the same update in 32768 second-order substeps. They are relative to "
        "the largest of",
        "three: the stresses before and after, and the strength at zero pressure. The table gives the mean, the error that 99 of 100 "
        "updates stay",
        "below, and the largest. Times are for one core, the minimum of several runs.",
        "",
        "- fast: the default solver; the parameter is the card's `Tolerance`.",
        "- bisected returns: the same error-controlled substeps, each returned by the published bisection, to the last bit.",
        "- nested bisection: the published scheme, equal substeps of one return each; the parameter is their number. It bisects",
        "  to 1e-9; *to last bit* is the oracle of the tests.",
        "- failed: how many of 2048 updates would need more than 2000 substeps. The outcome reports this and the state is unchanged; they "
        "have no error.",
        "",
        "| solver | parameter | mean error | 99 % below | largest | evaluations | substeps | failed | ns | ns in lanes |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for r in rows:
        lanes = f"{r['ns_lanes']:.0f}" if r["solver"] == FAST else ""
        lines.append(
            f"| {r['solver']} | {r['knob']:g} | {r['mean_error']:.1e} | {r['error_of_99_percent']:.1e} | "
            f"{r['largest_error']:.1e} | {r['evaluations']:.1f} | {r['substeps']:.2f} | {r['failed']:.0f} | {r['ns_single']:.0f} | {lanes} "
            "|"
        )
    controlled = at_error(rows, CONTROLLED, "evaluations")
    lines += [
        "",
        *(f"- {note}" for note in notes),
        f"- default tolerance: {default['ns_lanes']:.0f} ns per plastic update in lanes, mean error {default['mean_error']:.1e}",
        f"- at the mean error {TARGET:g} (between rows): {evaluations[FAST]:.0f} yield-function evaluations against "
        f"{evaluations[NESTED]:.0f} of the nested bisection, a ratio of {evaluations[NESTED] / evaluations[FAST]:.0f}; "
        f"time {times[NESTED] / times[FAST]:.0f} times less (single points)",
        f"- the return alone, on the same error-controlled substeps: {controlled / evaluations[FAST]:.0f} times fewer of these evaluations",
        "",
        "![error against cost](../pictures/arenisca_cost.png)",
    ]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--stored", action="store_true")
    options = parser.parse_args()
    if not options.stored:
        if options.build is None:
            parser.error("give the build folder, or --stored")
        program = options.build / "verification" / "barreno_solver_cost"
        if not program.exists():
            print(f"there is no '{program}'; build the target barreno_solver_cost.", file=sys.stderr)
            return 2
        subprocess.run([program, POINTS, TABLE], check=True)
    notes, rows = read_table()
    draw(rows)
    PAGE.write_text(page_text(notes, rows), encoding="utf-8")
    print(PAGE)
    return 0


if __name__ == "__main__":
    sys.exit(main())
