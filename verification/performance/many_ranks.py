#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each of many ranks does, counted and not timed: many_ranks.py BARRENO [--quick] [--document].

A ball, a drilled block and a box in three dimensions, on 1, 2, 4, 8 and 16 ranks, which may be more than there are cores: answers
must be those of one rank to the bit (tables and the last checkpoint, which holds every field; files of particles are one per rank, so
that none gathers them). Counted are the places that a rank looks at to fill bodies, the particles that it makes and
its largest memory (summary.json), its messages, bytes and reductions (a preloaded library, tools/message_costs.c), and the bytes of
a checkpoint that it reads on a resume. --quick is a smaller scene on 1, 8 and 16 ranks. --document writes docs/cluster.md and
verification/results/many_ranks.json.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.resumed import at_previous, must_work, program
from tools.runs import ROOT, Run, scratch_folder
from tools.small_decks import write_deck
from tools.write_pages import write_pages

STORED = ROOT / "verification" / "results" / "many_ranks.json"
LIBRARY_SOURCE = ROOT / "verification" / "tools" / "message_costs.c"
CELL = 1.0  # mm
STEPS = 8


def write_scene(file, n):
    """n cells along each side of a box, three quarters of which are filled from below: two bodies of the lattice beside each other on a
    slab."""
    size = n * CELL
    elastic = {"Model": "Linear Elastic", "Density": "1000 kg/m3", "Bulk Modulus": "6 MPa", "Shear Modulus": "3 MPa"}
    low, high, middle = 0.25 * size, 0.72 * size, 0.5 * size

    def point(*x):
        return [f"{value:g} mm" for value in x]

    write_deck(file, {
        "Title": "Two bodies on a slab",
        "Grid": {"Mode": "3D", "Lower": point(0, 0, 0), "Upper": point(size, size, size), "Cell Size": f"{CELL:g} mm"},
        "Materials": {"Elastic": elastic},
        "Bodies": {
            "Slab": {"Material": "Elastic", "Lower": point(0, 0, 0), "Upper": point(size, low, size)},
            "Ball": {"Material": "Elastic", "Shape": "ball", "Centre": point(middle, low + 0.22 * size, 0.25 * size),
                "Radius": f"{0.215 * size:g} mm",
                     "Velocity": "{0 m/s, -2 m/s, 0 m/s}"},
            "Drilled": {"Material": "Elastic", "Shape": "difference", "Parts": "{Block, Bore}", "Velocity": "{0 m/s, -2 m/s, 0 m/s}"},
        },
        "Shapes": {
            "Block": {"Shape": "box", "Lower": point(0.05 * size, low, 0.51 * size), "Upper": point(0.95 * size, high, 0.95 * size)},
            "Bore": {"Shape": "cylinder", "Start": point(middle, 0, 0.73 * size), "End": point(middle, size, 0.73 * size),
                "Radius": f"{0.1 * size:g} mm"},
        },
        "Time": {"End Time": f"{STEPS * 2.4:g} us"},
    })  # fmt: skip
    return pathlib.Path(file)


def build_library(scratch):
    library = scratch / "message_costs.so"
    subprocess.run(["mpicc", "-O1", "-shared", "-fPIC", "-o", library, LIBRARY_SOURCE], check=True)
    return library


def counts(folder, ranks):
    """By rank: {kind: (calls, bytes)}."""
    tables = []
    for rank in range(ranks):
        lines = [line.split() for line in (folder / f"messages.{rank}").read_text().splitlines() if line]
        tables.append({words[0]: (float(words[1]), float(words[2])) for words in lines})
    return tables


def resumed(barreno, ranks, folder):
    """A copy of a run as if it had been killed in the middle, resumed. @return its folder"""
    again = folder.with_name(f"{folder.name}_resumed")
    shutil.copytree(folder, again)
    at_previous(again)
    must_work(program(barreno, ranks, "resume", again))
    return again


def run_on(barreno, library, deck, ranks, scratch):
    """One run with a checkpoint halfway. @return its folder and its counts"""
    folder, told = scratch / f"run_{ranks}", scratch / f"told_{ranks}"
    told.mkdir()
    words = ("run", deck, "--out", folder, "--set", f"Output/Checkpoint Steps={STEPS // 2}", "--set", "Output/Particle Files=one per rank")
    must_work(program(barreno, ranks, *words, environment={"LD_PRELOAD": str(library), "MESSAGES_FILE": str(told / "messages")}))
    run = Run(folder)
    tables = counts(told, ranks)
    return folder, {
        "ranks": ranks, "steps": run.summary["steps"], "particles": run.summary["particles"],
        **{name: run.summary["set_up"][name] for name in ("candidate_points", "largest_rank_candidate_points",
            "largest_rank_undivided_points", "particles_made", "largest_rank_particles_made")},
        "largest_rank_peak_bytes": run.summary["largest_rank_peak_bytes"],
        **{f"largest_rank_{name}": max(table[kind][column] for table in tables)
           for name, kind, column in (("messages", "sends", 0), ("sent_bytes", "sends", 1), ("reductions", "reductions", 0))},
        "checkpoint_bytes": (folder / "checkpoint.h5").stat().st_size,
    }  # fmt: skip


def measure(barreno, cells, all_ranks, resumed_on=None):
    """Counts by ranks, and what differs from the run on the first of them.

    @param resumed_on  some of the ranks; None: all
    """
    from adversary.same_runs import different  # needs h5py, which pages do not

    scratch = pathlib.Path(scratch_folder())
    library, deck = build_library(scratch), write_scene(scratch / "scene.xml", cells)
    rows, wrong, first = [], [], None
    for ranks in all_ranks:
        folder, row = run_on(barreno, library, deck, ranks, scratch)
        first = first or folder
        wrong += [f"{ranks} ranks: {what}" for what in different(first, folder, same_ranks=False)]
        if resumed_on is None or ranks in resumed_on:
            again = resumed(barreno, ranks, folder)
            row["largest_rank_checkpoint_bytes"] = Run(again).summary["set_up"]["largest_rank_checkpoint_bytes"]
            wrong += [f"{ranks} ranks, resumed: {what}" for what in different(first, again, same_ranks=False)]
        rows.append(row)
    return rows, wrong


def page(rows):
    lines = [f"{rows[0]['particles']:,.0f} particles, {rows[0]['steps']} steps, one checkpoint of {1e-6 * rows[0]['checkpoint_bytes']:.0f} "
        "MB halfway and one at the end.", "",
             "| ranks | places looked at | of these on every rank | particles made | peak memory, MB | messages | MB sent | reductions | "
             "MB read on resume |",
             "|---|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for row in rows:
        of = {"checkpoint_bytes": float("nan")} | {name.removeprefix("largest_rank_"): value
            for name, value in row.items() if name.startswith("largest_rank_")}
        lines.append(f"| {row['ranks']} | {of['candidate_points']:,.0f} | {of['undivided_points']:,.0f} | {of['particles_made']:,.0f} | "
            f"{1e-6 * of['peak_bytes']:.0f} | {of['messages']:,.0f} "
                     f"| {1e-6 * of['sent_bytes']:.1f} | {of['reductions']:,.0f} | {1e-6 * of['checkpoint_bytes']:.1f} |")  # fmt: skip
    return lines


def stored_part():
    return page(json.loads(STORED.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno")
    parser.add_argument("--quick", action="store_true", help="a smaller scene on 1, 8 and 16 ranks")
    parser.add_argument("--document", action="store_true")
    arguments = parser.parse_args()
    barreno = pathlib.Path(arguments.barreno).resolve()
    rows, wrong = measure(barreno, 24, (1, 8, 16)) if arguments.quick else measure(barreno, 48, (1, 2, 4, 8, 16))
    print("\n".join(page(rows)))
    if arguments.document and not wrong:
        STORED.write_text(json.dumps(rows, indent=1) + "\n")
        write_pages()
    sys.exit("; ".join(wrong) if wrong else 0)


if __name__ == "__main__":
    main()
