#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run verification cases against their exact answers.

    verify.py BARRENO [--full] [--document] [CASE ...]

Without --full each case takes its cheap form, which the tests use. --full takes all levels; --document writes the
full tables into docs/verification.md (cases that were not run keep their last table).
Exit code 1 if a figure does not hold.
"""
import argparse
import importlib
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "tools"))
sys.path.insert(0, str(HERE))

from pages_elsewhere import sections  # noqa: E402

CASES = ["bar_wave", "shock_copper", "taylor_bar", "arenisca_benchmarks", "arenisca_against_oracle", "perforation", "shell_coasting", "shell_material", "manufactured_box", "manufactured_disk", "transfers", "thick_cylinder", "cylindrical_wave", "simple_motions", "sliding_block", "incline", "contact_disks", "pressed_blocks", "rigid_plate", "preloaded_bar", "thick_sphere", "spherical_wave", "shell_squeezed", "shell_coasting_3d", "taylor_bar_3d", "spherical_wave_3d", "contact_spheres", "manufactured_space", "extension", "integrators", "terzaghi", "two_layers", "skempton", "cryer", "mandel", "drainage_limits", "pore_sweep", "kills", "damaged_checkpoints", "full_disk", "restarts", "long_run", "fuzzed_decks"]
RESULTS = HERE / "results"
PAGE = HERE.parent / "docs" / "verification.md"


def text_of(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def section(name, data):
    lines = [f"## {data['title']}", "", f"`verification/cases/{name}.py`. {data['proves']} Exact: {data['reference']}", ""]
    lines += ["| " + " | ".join(data["columns"]) + " |", "|" + "---|" * len(data["columns"])]
    lines += ["| " + " | ".join(text_of(value) for value in row) + " |" for row in data["rows"]]
    lines += [""]
    for check in data["checks"]:
        sign = ">=" if check["at_least"] else "<="
        verdict = "holds" if check["passed"] else "DOES NOT HOLD"
        if check.get("open"):
            verdict += f" (open: {check['open']})"
        lines.append(f"- {check['what']}: {check['value']:.3g} {sign} {check['limit']:.3g}, {verdict}")
    if data["notes"]:
        lines += ["", data["notes"]]
    return "\n".join(lines) + "\n"


def write_page():
    head = "# Verification\n\nMeasured by `verification/verify.py BARRENO --full --document`; do not edit by hand.\n"
    parts = [head]
    for name in CASES:
        stored = RESULTS / f"{name}.json"
        if stored.exists():
            parts.append(section(name, json.loads(stored.read_text())))
    PAGE.write_text("\n".join(parts + list(sections(RESULTS))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--document", action="store_true")
    options = parser.parse_intermixed_args()
    unknown = set(options.cases) - set(CASES)
    if unknown:
        parser.error(f"no case {sorted(unknown)}; there are {CASES}")
    held = True
    for name in options.cases or CASES:
        result = importlib.import_module(f"cases.{name}").run(options.barreno.resolve(), options.full)
        data = {**result.__dict__}
        print(section(name, data))
        held = held and all(check["passed"] or check["open"] for check in result.checks) and bool(result.checks)
        if options.document:
            RESULTS.mkdir(exist_ok=True)
            (RESULTS / f"{name}.json").write_text(json.dumps(data, indent=1) + "\n")
    if options.document:
        write_page()
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
