#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a feature costs that a scene does not ask for: instructions in the step on lines that are there for that feature alone or ask
whether it is on, of all instructions of the step. Counted by valgrind, so that other work on the machine does not matter.

    off_costs.py BARRENO [--document]

BARRENO: a build that valgrind can read: no AVX-512, line tables, the optimisation of a release (docs/development.md).
--document writes the table into docs/performance.md. Exit code 1 if a feature costs more than 1 % where it is off.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.runs import mpi_environment, scratch_folder
from tools.small_decks import symmetry, write_deck
from tools.write_pages import write_pages

STORED = pathlib.Path(__file__).resolve().parents[1] / "results" / "off_costs.json"
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BAR = 0.01  # of the step

# Feature: its own files, and what lines of other files of the step say where they ask for it.
FEATURES = {
    "dormant tiles": (["step/dormant/", "state/dormancy"], r"skips\(|dormant\(|keeps_sums\(|chunk_part|limit_step\(good \| stays"),
    "contact": (["step/contact/", "step/nodes/node_copies"],
                r"contact|shared_tile|detect_contact"),
    "rigid bodies": (["step/boundary/move_rigid"], r"rigid"),
    "pressure loads": (["step/loads/project_loads", "step/loads/surface_pressures", "step/loads/release_torn_faces"],
        r"project_loads|tally_loads|surface_pressures|grow_cavities|torn_faces"),
    "non-reflecting faces": ([], r"impedance|resisted|absorbed"),
    "body force": (["step/loads/project_body_force", "scene/body_force"], r"body_force"),
    "jet": (["step/jet/"], r"launch_jet"),
    "pore flow": (["pore_flow/"], r"drain_pore_fluid"),
    "APIC": (["step/transfer/project_affine", "step/transfer/gather_affine", "step/transfer/start_affine"], r"affine"),
    "XPIC": (["step/transfer/filter_velocity"], r"filter"),
    "PIC share": ([], r"pic_fraction|grid_share"),
    "damping": ([], r"damping|drag"),
    "domains that deform": (["step/particles/tally_domains", "shape/cpdi", "shape/domain"], r"tally_domains|domains"),
    "bad particles held": ([], r"may_hold|held"),
    "ranks": (["step/ranks/", "grid/halo", "base/exchange", "grid/partition"], r"exchange_halo|balance_load|over_ranks"),
}  # fmt: skip


def deck(order):
    """Steel on sandstone, as bare as a deck can be."""
    return {
        "Grid": {"Mode": "axisymmetric", "Lower": (0, -0.02), "Upper": (0.04, 0.04), "Cell Size": 0.001},
        "Materials": {"Steel": {"Card": "steel_4340.xml"}, "Sandstone": {"Card": "berea_sandstone.xml"}},
        "Bodies": {
            "Hammer": {"Material": "Steel", "Lower": (0, -0.01), "Upper": (0.02, 0), "Velocity": (0, 100)},
            "Rock": {"Material": "Sandstone", "Lower": (0, 0), "Upper": (0.03, 0.03)},
        },
        "Conditions": symmetry("x_lower"),
        "Step": {"Order": order},
        "Time": {"End Time": 4e-6},
    }


def count_lines(barreno, order):
    """Instructions of the step by (file below src, line), and their sum."""
    folder = pathlib.Path(scratch_folder())
    write_deck(folder / "deck.xml", deck(order))
    out = folder / "callgrind.out"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--compress-strings=no", "--compress-pos=no",
               "--toggle-collect=barreno::advance*", str(barreno), "run", str(folder / "deck.xml"), "--out",
               str(folder / "run")]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, env=mpi_environment())
    if done.returncode != 0:
        sys.exit(f"off_costs.py: the run under valgrind ended with {done.returncode}; is BARRENO built without AVX-512? "
            f"{done.stderr[-400:]}")
    return read_counts(out)


def read_counts(out):
    """Callgrind's own cost lines: 'LINE COUNT' after fl= (of a function), fi= or fe= (of inlined text); a line after calls= is the
    callee's and not counted here."""
    counts = collections.Counter()
    total, file, is_call = 0, "", False
    for line in out.read_text().splitlines():
        if line[:3] in ("fl=", "fi=", "fe="):
            file = line[3:]
        elif line.startswith("calls="):
            is_call = True
        elif line[:1].isdigit():
            where, cost = line.split()[:2]
            if not is_call:
                total += int(cost)
                counts[(file.split("/src/", 1)[-1] if "/src/" in file else file, int(where))] += int(cost)
            is_call = False
    return counts, total


def lines_that_ask(pattern):
    """(file below src, line) of all lines that match."""
    found = set()
    for path in (ROOT / "src").rglob("*.?pp"):
        name = str(path.relative_to(ROOT / "src"))
        found |= {(name, i) for i, text in enumerate(path.read_text().splitlines(), 1) if re.search(pattern, text.split("//")[0])}
    return found


def cost_of(feature, counts):
    files, pattern = FEATURES[feature]
    asking = lines_that_ask(pattern)
    return sum(cost for (file, line), cost in counts.items() if (file, line) in asking or any(file.startswith(own) for own in files))


def stored_part():
    return table_of(json.loads(STORED.read_text()))


def table_of(rows):
    lines = ["| disabled feature | scene | share of a step's instructions |", "|---|---|---|"]
    return lines + [f"| {feature} | {order} | {100 * share:.3f} % |" for feature, order, share in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    options = parser.parse_args()
    rows = []
    # Tiles may rest where stress is last, so that this feature is off in the other order.
    for order in ("stress last", "modified stress last"):
        counts, total = count_lines(options.barreno.resolve(), order)
        print(f"{order}: {total:.4g} instructions in the steps")
        own = [f for f in FEATURES if (f == "dormant tiles") == (order == "modified stress last")]
        rows += [(feature, order, cost_of(feature, counts) / total) for feature in own]
    print("\n".join(table_of(rows)))
    if options.document:
        STORED.write_text(json.dumps(rows, indent=1) + "\n")
        write_pages()
    return 1 if any(share > BAR for _, _, share in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
