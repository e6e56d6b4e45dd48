#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What every form of Arenisca costs against its error: measures, draws, and writes docs/materials/arenisca_forms_cost.md.

    feature_cost.py BUILD_FOLDER [--stored]

runs barreno_feature_cost of that build over the points in verification/performance (rock_points.csv, dry, and its wet and angled kin, each
shape of the third invariant its own); --stored takes the last measurement instead (verification/results/feature_cost.csv) and asks for no
build. The table of forms in docs/materials/arenisca.md comes from the same file (verification/pages.py --write).
"""
import argparse
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
CARD = "materials/cards/berea_sandstone.xml"
KINDS = ("", "wet_", "angled_", "angled_wet_", "gudehus_", "gudehus_wet_", "mohr_coulomb_", "mohr_coulomb_wet_", "damaged_", "cracked_",
    "heated_", "heated_wet_")  # fmt: skip
POINTS = [HERE / f"{kind}rock_points.csv" for kind in KINDS]
TABLE = ROOT / "verification" / "results" / "feature_cost.csv"
PICTURE = ROOT / "docs" / "pictures" / "arenisca_forms_cost.png"
PAGE = ROOT / "docs" / "materials" / "arenisca_forms_cost.md"
DEFAULT = 1e-2  # tolerance of a card
MOST_WET, MOST_WET_ELASTIC, MOST_RATIO, MOST_HEATED, MOST_SINGLE = 1000.0, 60.0, 1.5, 1.15, 20000.0  # bars; ns
MOST_DRY, MOST_DRY_ELASTIC, WISHED_DRY = 361.0, 18.8, 250.0  # what dry points took before the law was written once; ns
COMPARISON = ("bisection", "elastic centre", "plastic", "plastic, arenisca3")
ANGLES = ("Gudehus", "Willam-Warnke", "Mohr-Coulomb")
HEATED = ("dry, damage", "dry, heat", "dry, heat and tension cutoff", "wet, heat")

WHY_ANGLE = (
    "The closest point is searched in pressure and Lode angle together. One evaluation of both conditions with their derivatives costs "
    "more than "
    "one of the condition in pressure. Flow leaves the plane of stress and strain increment, so six components of shear stress are carried "
    "instead of two. The angle with its direction is needed at the prediction, where flow begins, and in the second pass, which is never "
    "left out."
)
WHY_DRY = (
    "A point that flows takes 15 evaluations of the law on average at the default tolerance (docs/materials/arenisca_cost.md). The two "
    "predictions and the return need most of them; fewer need a looser tolerance."
)
WHY_HEATED = (
    "Each evaluation has damage, dilation that falls with pressure, moduli of grains that stiffen and a temperature besides. With a "
    "tension cutoff it has principal stresses too, and takes more substeps. In wet rock the pressure of the pores is found again for "
    "grains and water whose stiffness follows pressure and temperature."
)
WHY_SLOWEST = (
    "The substeps take the time, one after the other, however many lanes are free. The tolerance asks for so many where the increment is "
    "of "
    "the order of 1e-2 and the direction of flow turns. Up to as many again are tried and found too long."
)
WHY_SLOWEST_ANGLE = (
    "As above, at twice the time of each substep. Where closed pores open, Newton's method does not find some returns; these are searched "
    "by one "
    "Lode angle after the other, each with a return of its own."
)


def read_table():
    table, words = read_csv(TABLE, cells=WORDS, separator=";"), ("form", "model", "card")
    numbers = {name: float for name in table.columns if name not in words}
    return [line[2:] for line in table.attrs["comments"]], table.astype(numbers).to_dict("records")


def at_default(rows):
    """{form: row} at a card's own tolerance."""
    return {row["form"]: row for row in rows if row["tolerance"] == DEFAULT}


def feature_of(form):
    return form.split(", ", 1)[1]


def base_of(form):
    """The plain form that a feature is compared with."""
    return form.split(", ", 1)[0] + ", plain"


def is_comparison(form):
    return feature_of(form) in COMPARISON


def bars(rows):
    """[((demand, condition), measured, most, unit, why it is missed)]"""
    found = at_default(rows)
    dry, wet = found["dry, plain"], found["wet, plain"]
    out = [
        (("dry point that flows, in lanes", "no slower than before"), dry["ns_lanes"], MOST_DRY, "ns", WHY_DRY),
        (("dry point that flows, in lanes", "half of a run's time"), dry["ns_lanes"], WISHED_DRY, "ns", WHY_DRY),
        (("dry elastic point, in lanes", "no slower than before"), dry["ns_elastic"], MOST_DRY_ELASTIC, "ns", ""),
        (("wet point that flows, in lanes", ""), wet["ns_lanes"], MOST_WET, "ns",
            "The pores are filled again in every prediction, return and second pass."),
        (("wet elastic point, in lanes", ""), wet["ns_elastic"], MOST_WET_ELASTIC, "ns",
            "The fluid's pressure is a root of its own for every point."),
    ]
    for base in ("dry", "wet"):
        for feature in ("scatter", "rate", *ANGLES):
            ratio = found[f"{base}, {feature}"]["ns_lanes"] / found[f"{base}, plain"]["ns_lanes"]
            why = WHY_ANGLE if feature in ANGLES else ""
            out.append(((f"{base}, {feature}", f"time over {base}, plain, in lanes"), ratio, MOST_RATIO, "times", why))
    for form in HEATED:
        ratio = found[form]["ns_lanes"] / found[base_of(form)]["ns_lanes"]
        out.append(((form, f"time over {base_of(form)}, in lanes"), ratio, MOST_HEATED, "times", WHY_HEATED))
    for form, row in found.items():
        if not is_comparison(form):
            what = (form, f"dearest single update, {row['substeps_of_slowest']:.0f} substeps")
            why = WHY_SLOWEST_ANGLE if feature_of(form) in (*ANGLES, "all") else WHY_SLOWEST
            out.append((what, row["ns_slowest"], MOST_SINGLE, "ns", why))
    return out


def bar_lines(rows):
    lines = ["| demand | condition | measured | at most | verdict |", "|---|---|---|---|---|"]
    reasons = {}
    for what, measured, most, unit, why in bars(rows):
        missed = measured > most
        digits = f"{measured:.2f}" if unit == "times" else f"{measured:.0f} {unit}"
        bar = f"{most:g}" if unit == "times" else f"{most:.0f} {unit}"
        lines.append(f"| {what[0]} | {what[1]} | {digits} | {bar} | {f'missed, by a factor of {measured / most:.2f}' if missed else 'met'} "
            "|")
        if missed and why:
            reasons.setdefault(why, []).append(what[0])
    if reasons:
        lines += ["", "Why demands are missed:", ""]
        lines += [f"- {'; '.join(forms)}: {why}" for why, forms in reasons.items()]
    return lines


def summary_lines(rows):
    """A line for each form at the default tolerance."""
    found = at_default(rows)
    lines = [
        "| form | added to the card | model | flows, ns in lanes | to plain | one at a time, ns | elastic, ns | dearest update, us |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for form, row in found.items():
        lanes = "" if is_comparison(form) else f"{row['ns_lanes']:.0f}"
        lines.append(
            f"| {form} | {row['card']} | {row['model']} | {lanes} | {row['ns_lanes'] / found[base_of(form)]['ns_lanes']:.2f} | "
            f"{row['ns_single']:.0f} | "
            f"{row['ns_elastic']:.1f} | {1e-3 * row['ns_slowest']:.1f} |"
        )
    return lines


def error_lines(rows):
    lines = [
        "| form | tolerance | mean error | 99 % below | largest | substeps | failed | ns | ns in lanes | dearest, us |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for r in rows:
        lanes = "" if is_comparison(r["form"]) else f"{r['ns_lanes']:.0f}"
        lines.append(
            f"| {r['form']} | {r['tolerance']:g} | {r['mean_error']:.1e} | {r['error_of_99_percent']:.1e} | {r['largest_error']:.1e} | "
            f"{r['substeps']:.2f} | {r['failed']:.0f} | {r['ns_single']:.0f} | {lanes} | {1e-3 * r['ns_slowest']:.1f} |"
        )
    return lines


def draw(rows):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(14, 4.8), layout="constrained", sharey=True)
    for one, base in zip(axes, ("dry", "wet")):
        forms = [form for form in dict.fromkeys(row["form"] for row in rows) if form.startswith(base)]
        for i, form in enumerate(forms):
            own = [row for row in rows if row["form"] == form and row["mean_error"] > 0.0]
            line = "x:" if is_comparison(form) else "o-"
            one.loglog([r["mean_error"] for r in own], [r["ns_lanes"] for r in own], line, ms=4, color=f"C{i % 10}", label=feature_of(form))
        one.set_title(f"{base} rock")
        one.set_xlabel("mean error, relative to the effective stress (smaller to the right)")
        one.invert_xaxis()
        one.grid(alpha=0.3)
        one.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    axes[0].set_ylabel("time per point that flows [ns]")
    figure.savefig(PICTURE, dpi=120)
    plt.close(figure)


def command_of(file):
    """How a file of points was recorded: in its first line."""
    with file.open(encoding="utf-8") as lines:
        return lines.readline().split("sampled by ")[1].strip()


def stored_page():
    return page_text(*read_table())


def page_text(notes, rows):
    recorded = [f"    build/release/verification/{command_of(file)}" for file in POINTS]
    lines = [
        "# Arenisca's forms: error against cost",
        "",
        "Written by `verification/performance/feature_cost.py build/release`; do not edit by hand. Every form of Arenisca, each feature "
        "alone and",
        "all together, cards with damage and heat, and the forms for comparison, updates rock points of `input_xml/perforation_quick.xml`. "
        "Dry forms",
        "update points of the dry deck, wet forms points of the deck with water in the pores, and forms with a third invariant, damage or "
        "heat points of",
        "decks whose rock has the same. The points are random samples of all steps, and the updates that flow with the most substeps, "
        "recorded by",
        "",
        *recorded,
        "",
        *(f"- {note}" for note in notes),
        "- Errors are errors of the stress after one update. They are relative to the largest of three: the effective stresses before and "
        "after, and",
        "  the strength at zero pressure. The reference is the same update with the smallest tolerance of 1e-8, 1e-7, 1e-6, 1e-5 that "
        "needs at most",
        "  2000 substeps. Points whose reference tolerance is above a fifth of the tolerance have no error.",
        "- Internal variables that were not recorded are those of virgin rock. Each shape of the third invariant updates points of its own "
        "run. States",
        "  of another shape lie off the surface, which costs crossings, substeps and accuracy that no run has.",
        "- Times are for one core, the minimum of several runs: in lanes as in a run, or one point at a time as for a host with a single "
        "point. Forms",
        "  for comparison go one at a time. The dearest update is the largest of the minima of each point that flows.",
        "- failed: updates that would need more than 2000 substeps; they have no error.",
        "",
        "## At the default tolerance",
        "",
        *summary_lines(rows),
        "",
        *bar_lines(rows),
        "",
        "## Over the tolerance",
        "",
        "![error against cost of every form](../pictures/arenisca_forms_cost.png)",
        "",
        *error_lines(rows),
    ]
    return "\n".join(lines) + "\n"


def span(values, digits):
    """The values' range in words."""
    low, high = f"{min(values):.{digits}f}", f"{max(values):.{digits}f}"
    return low if low == high else f"{low} to {high}"


def stored_part():
    """The table of forms in docs/materials/arenisca.md."""
    found = at_default(read_table()[1])

    def line(card, form, names):
        flows = span([found[name]["ns_lanes"] / found["dry, plain"]["ns_lanes"] for name in names], 1)
        return f"| {card} | {form} | {flows} | {span([found[name]['ns_elastic'] for name in names], 0)} |"

    return [
        "| card | form | point that flows, to the drained form | elastic point, ns |",
        "|---|---|---|---|",
        line("none of the following", "drained", ["dry, plain"]),
        line("`Weibull modulus`", "scattered", ["dry, scatter"]),
        line("`T1_rate_dependence`", "rated", ["dry, rate"]),
        line("`J3_type`", "angled; with rate dependence and scatter too", [f"dry, {one}" for one in (*ANGLES, "all")]),
        line("`Fracture strain`, `Dilatancy limit`, `Broken dilatancy`: `berea_sandstone_damage`", "damaged", ["dry, damage"]),
        line("heat and a limit of strength besides: `berea_sandstone_heat`", "heated", ["dry, heat"]),
        line("`Tension cutoff` besides: `berea_sandstone_cracks`", "heated", ["dry, heat and tension cutoff"]),
        line("`fluid_B0`", "wet", ["wet, plain"]),
        line("with `Weibull modulus` or `T1_rate_dependence`", "rated wet", ["wet, scatter", "wet, rate"]),
        line("with `J3_type`", "angled wet; with rate dependence and scatter too", [f"wet, {one}" for one in (*ANGLES, "all")]),
        line("damage, heat and a limit of strength: `berea_sandstone_heat_wet`", "heated wet", ["wet, heat"]),
        line("`Return solver = bisection`", "general", ["dry, bisection"]),
        line("`fluid_B0`, `Backstress strain = elastic centre` or `plastic`", "general: published",
            [f"wet, {one}" for one in COMPARISON[1:]]),
        "",
        "Measured by `verification/performance/feature_cost.py build/release`, which has the errors and other tolerances too: "
        "[arenisca_forms_cost.md](arenisca_forms_cost.md).",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--stored", action="store_true")
    options = parser.parse_args()
    if not options.stored:
        if options.build is None:
            parser.error("give the build folder, or --stored")
        program = options.build.resolve() / "verification" / "barreno_feature_cost"
        if not program.exists():
            print(f"there is no '{program}'; build the target barreno_feature_cost.", file=sys.stderr)
            return 2
        subprocess.run([program, CARD, *POINTS, TABLE], check=True, cwd=ROOT)
    notes, rows = read_table()
    draw(rows)
    PAGE.write_text(page_text(notes, rows), encoding="utf-8")
    print(PAGE)
    return 0


if __name__ == "__main__":
    sys.exit(main())
