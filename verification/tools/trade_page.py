# SPDX-License-Identifier: BSD-3-Clause
"""docs/trade.md, its pictures and verification/results/trade_runs.md, from verification/results/trade.json."""
import json
import pathlib
import statistics

from tools import depth_cost
from tools.depth_aims import section as aims_of_depth
from tools.depth_at_rest_table import section as depth_at_rest
from tools.error_seconds_table import section as error_seconds
from tools.trade_checks import verdict_lines
from tools.trade_problems import PROBLEMS
from tools.uniform_cells import depth_table, doubt, steady_table

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
KNOBS = ("shape function", "fidelity", "particles per cell", "Courant Fraction", "transfer", "order of the step",
         "artificial viscosity", "Arenisca tolerance", "particles per cell of the jet")  # fmt: skip
FIDELITIES = ("fast", "balanced", "reference")
WORDS = ("Shape Function", "Transfer", "Order", "Courant Fraction", "Tolerance", "Jet")

HEAD = """# Error against cost

Measured by `verification/trade.py build/release/src/barreno --document`; do not edit by hand.

One option at a time is varied from the defaults: GIMP, FLIP, stress last, Courant Fraction 0.8, 2 particles per cell and direction, Tolerance
0.01. Every run: [trade_runs](../verification/results/trade_runs.md).

Cost is the user time of one core: particle-steps times the ns per particle-step of the largest run of a choice. Start-up is not counted. Runs
shorter than 1.5 s are timed three times, and the minimum counts. Particle-steps are exact. Two figures show the accuracy of the seconds: """
RUNS_HEAD = """# Runs of the trade-offs

Every run behind [trade.md](../../docs/trade.md), which explains error and cost. Measured by
`verification/trade.py build/release/src/barreno --document`; do not edit by hand.
"""


def trust(data):
    """Two signs of other work on the machine: waiting, and unequal times of equal runs."""
    at = {(p["knob"], p["name"], p["problem"], p["level"]): p for p in data["points"] if "cpu" in p}
    waits = statistics.median(p["wall"] / p["seconds"] for p in data["points"] if p.get("seconds", 0.0) > 1.0)
    same = [at["fidelity", "balanced", *key[2:]]["cpu"] / p["cpu"] for key, p in at.items() if key[1] == "default"
        and ("fidelity", "balanced", *key[2:]) in at]
    return (f"wall seconds\nare {waits:.2f} times CPU seconds in the median, and the rows *default* and *balanced*, which are identical "
        "runs, "
            f"differ by\nfactors of {min(same):.2f} to {max(same):.2f}.\n")  # fmt: skip


def fidelity_section(data):
    at = {(p["problem"], p["name"], p["level"]): p for p in data["points"] if "error" in p}
    lines = ["## Fidelities", "", "`--fidelity NAME` sets what the deck leaves open (`none`: nothing, whatever Fidelity the deck has):", "",
             "| fidelity | " + " | ".join(WORDS[:-1]) + " | particles per cell | in the jet |", "|---|" + "---|" * 7]  # fmt: skip
    for name in FIDELITIES:
        said, per_cell = data["chosen"][name]
        lines.append(f"| {name} | " + " | ".join(said[word] for word in WORDS[:-1]) + f" | {per_cell} | {said['Jet']} |")
    lines += ["", "In decks with a jet it also refines the cells along the jet's path, puts fewer particles into the bodies' cells, and "
        "lets slow tiles take",
              "longer steps. A deck that can have neither gets a note, and both are left out. Where the deck gives Grid/Cell Size, *fast* "
              "leaves the path",
              "as it is and *balanced* refines it to 2 cells per radius. [fidelities](verification/fidelities.md) has the effect on the "
              "depth and on the cost",
              "of the shot to 120 us.", "",
              "| fidelity | " + " | ".join(data["with_jet"]["balanced"]) + " |",
              "|---|" + "---|" * len(data["with_jet"]["balanced"])]  # fmt: skip
    lines += [f"| {name} | " + " | ".join(data["with_jet"][name].values()) + " |" for name in FIDELITIES]
    breaking = data["breaking"]
    cells = ", ".join(f"{breaking[name]['cells']} ({name})" for name in FIDELITIES)
    (splits,) = {breaking[name]["splits"] for name in FIDELITIES}
    lines += ["", f"Late slugs of metal that breaks pile up at the bottom. For such a jet there are {cells} cells per radius, and a "
        f"particle is divided up to {splits} times ([Depth at rest](#depth-at-rest)). In two dimensions *balanced* and *reference* also "
        "give the losses of each step back as heat (`Step/Return Losses`): to metals, and to rock with a `Specific heat`, as that of the "
        "main job."]
    lines += ["", "Error (and cost relative to balanced) at equal cells, one step for all:", "",
              "| fidelity | " + " | ".join(f"{p.title}: {p.error}, {unit_text(p, p.levels[-1])}" for p in PROBLEMS) + " |",
              "|---|" + "---|" * len(PROBLEMS)]  # fmt: skip
    for name in FIDELITIES:
        cells = []
        for p in PROBLEMS:
            one, base = at.get((p.name, name, p.levels[-1])), at.get((p.name, "balanced", p.levels[-1]))
            cells.append(f"{100 * one['error']:.2g} % ({one['cpu'] / base['cpu']:.2f})" if one and base else "failed")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines + former_settings(data)) + "\n"


def in_words(chosen):
    said, per_cell = chosen
    return {**{word: said[word] for word in WORDS[:-1]}, "particles per cell": per_cell, "in the jet": said["Jet"]}


def former_settings(data):
    """Lines: with which settings rows of the fidelities were measured that have others today."""
    lines = []
    for name in FIDELITIES:
        now = in_words(data["chosen"][name])
        for text in dict.fromkeys(json.dumps(p["chosen"]) for p in data["points"] if p["knob"] == "fidelity" and p["name"] == name):
            then = in_words(json.loads(text))
            changed = [f"{word} {then[word]} (now {now[word]})" for word in now if str(then[word]) != str(now[word])]
            lines += [f"- *{name}*: " + ", ".join(changed)] if changed else []
    return ["", "Rows of these fidelities were measured with former settings (`trade.py BARRENO --only fidelity --document` repeats them):",
        "", *lines] if lines else []


def unit_text(problem, level):
    return f"{level:g} {problem.unit}"


def depth_lines(depth):
    return [
        "The depth has no exact answer. Depth of `input_xml/perforation_120us.xml` with uniform cells [mm], and in brackets the relative "
        "difference from",
        f"cells of {depth['cells']:g} mm:", "", *depth_table(), "",
        f"Halving the cells of {depth['cells']:g} mm changes the depth by {100 * doubt():.1f} % at most, to 30 us. At 5, 20 and 30 us the "
        "smallest cells lie along the",
        "jet's path alone. The error grows with the depth. The depths with cells of 2, 1 and 0.5 mm do not tend to a limit with an order: "
        "cells of 2 mm",
        "are wider than the jet, and at two cells per radius errors of both signs may cancel. So no depth is extrapolated here "
        "(docs/converge.md).", "",
        "Cost with equal cells, and with small cells along the jet's path alone ([levels](verification/levels.md),",
        "[slug_length](verification/slug_length.md)). The times were not measured side by side: they are good to a fifth or so. Rock at "
        "rest costs",
        "nothing on any grid, and early in a run most of the equal cells hold such rock.", "",
        f"![depth against cost](pictures/{depth_cost.FILE})", "",
        "Error of the rate at which a long rod penetrates steadily. The reference for metals without strength is compressible Bernoulli, "
        "for sandstone",
        "(3 to 7 km/s) a run with four cells per radius.", "", *steady_table(), "",
        "In rock the channel is two jet radii wide. Jet, spent jet and wall then share nodes, which slows the jet. `barreno check` and "
        "every run with",
        "a jet say which of these errors belongs to their cells.", "",
        f"Errors of the runs are relative to {depth['reference']:.1f} mm, the depth at {depth['time']} us with cells of {depth['cells']:g} "
        "mm.", "",
    ]  # fmt: skip


def problem_section(problem, data):
    lines = [f"## {problem.title}", "", f"![error against cost](pictures/trade_{problem.name}.png)", ""]
    return "\n".join(lines + (depth_lines(data["depth"]) if problem.name == "depth" else []))


def table(problem, data):
    lines = [f"## {problem.title}", "",
        f"| option | choice | {problem.unit} | {problem.error} | {problem.second} | particle-steps | ns | CPU s | wall s |",
              "|---|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for p in data["points"]:
        if p["problem"] != problem.name:
            continue
        start = f"| {p['knob']} | {p['name']} | {p['level']:g} |"
        if "failed" in p:
            lines.append(f"{start} {p['failed']} | | | | | |")
        else:
            lines.append(f"{start} {p['error']:.4g} | {p['second']:.3g} | {p['work']:.3g} | {p['ns']:.0f} | {p['cpu']:.3g} | "
                f"{p['wall']:.3g} |")
    return "\n".join(lines) + "\n"


def reading(data):
    """What the numbers say, worked out from them: cost and error of each choice over those of the default at the same level."""
    lines = ["## Effect of each option", "",
        "Error of a choice at its cost, both relative to the default at the same, finest common level:", "",
             "| option | choice | " + " | ".join(p.title.split(" (")[0] for p in PROBLEMS) + " |",
             "|---|---|" + "---|" * len(PROBLEMS)]  # fmt: skip
    at = {(p["problem"], p["knob"], p["name"], p["level"]): p for p in data["points"] if "error" in p}
    names = list(dict.fromkeys((p["knob"], p["name"]) for p in data["points"] if p["knob"] != "default"))
    names.sort(key=lambda name: KNOBS.index(name[0]))
    for knob, name in names:
        cells = []
        for p in PROBLEMS:
            one, base = at.get((p.name, knob, name, p.levels[-1])), at[p.name, "default", "default", p.levels[-1]]
            cells.append(f"{one['error'] / base['error']:.2f} at {one['cpu'] / base['cpu']:.2f}" if one else "")
        lines.append(f"| {knob} | {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def check_lines(data):
    return "\n".join(["## Requirements", "", *(f"- {line}" for line in verdict_lines(data["checks"]))]) + "\n"


def page_of(data):
    text = (pathlib.Path(__file__).resolve().parents[1] / "trade_notes.md").read_text()
    parts = [HEAD + trust(data), fidelity_section(data), text, aims_of_depth(), error_seconds(), depth_at_rest(), reading(data),
        *(problem_section(problem, data) for problem in PROBLEMS), check_lines(data)]
    return "\n".join(parts)


def runs_page(data):
    """verification/results/trade_runs.md"""
    return "\n".join([RUNS_HEAD, *(table(problem, data) for problem in PROBLEMS)])


def curve(axes, points, style, label, colour):
    found = sorted((p["cpu"], p["error"]) for p in points if "error" in p)
    if found:
        axes.loglog(*zip(*found), style, color=colour, ms=4, lw=1, label=label)


def draw_knob(axes, mine, knob):
    """The default, and every choice of an option."""
    curve(axes, [p for p in mine if p["knob"] == "default"], "o-", "default", "k")
    for i, name in enumerate(dict.fromkeys(p["name"] for p in mine if p["knob"] == knob)):
        curve(axes, [p for p in mine if p["knob"] == knob and p["name"] == name], "o-", name, f"C{i}")
    axes.set_title(knob, fontsize=10)
    axes.grid(alpha=0.3)
    axes.tick_params(labelbottom=True)  # below every panel: the last row is not full
    axes.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2, frameon=False, columnspacing=1.0, handlelength=1.5)


def draw(data):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from tools.case_pictures import number_errors

    for problem in PROBLEMS:
        mine = [p for p in data["points"] if p["problem"] == problem.name]
        knobs = [knob for knob in KNOBS if any(p["knob"] == knob for p in mine)]
        columns = 3
        rows = -(-len(knobs) // columns)
        figure, grid = plt.subplots(rows, columns, figsize=(3.8 * columns, 3.9 * rows), sharex=True, sharey=True, layout="constrained",
            squeeze=False)
        for axes, knob in zip(grid.flat, knobs):
            draw_knob(axes, mine, knob)
        for axes in list(grid.flat)[len(knobs) :]:
            axes.axis("off")
        number_errors(grid[0, 0].yaxis, *grid[0, 0].get_ylim())
        figure.supxlabel("processor time [s]", fontsize=11)
        figure.supylabel(problem.error, fontsize=11)
        figure.suptitle(problem.title, fontsize=11)
        figure.savefig(DOCS / "pictures" / f"trade_{problem.name}.png", dpi=90)
        plt.close(figure)
