#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every deck of input_xml takes its first steps on one and on two ranks, with sound files that agree bit for bit; those
with a Pore Flow, whose linear solver sums in the order of ranks, to 1e-7 of the largest value of each variable.

    test_shipped_decks.py BARRENO [--ranks 2 [--coarse]]

With --ranks on these alone and without the comparison; with --coarse the decks that have most particles have larger cells.
"""
import argparse
import pathlib
import re
import tempfile

import numpy as np

import check_exodus
import exodiff_lite
from tools.runs import DECKS, run_deck

TESTS = pathlib.Path(__file__).resolve().parents[1]

# Where the solver's round-off, 1e-12, decides whether yielding rock takes a substep more, the stress moves by a share of the card's
# Tolerance: 4e-5 of the largest stress with the default of 0.01, seen on one machine of two.
SETTINGS = {"perforation_drainage.xml": {"Materials/Sandstone/Tolerance": "1e-6"}}

# Share of a deck's time; less of those that have most particles.
SHARE = {
    "perforation_refined.xml": 0.002, "perforation.xml": 0.002, "perforation_3d.xml": 0.003,
    "jet_formation_3d.xml": 0.004, "driven_cone_3d.xml": 0.004,
}

COARSE = {
    "driven_cone_3d.xml": {"Grid/Cell Size": "4 mm", "Time/End Time": "0.36 us"},
    "jet_formation_3d.xml": {"Grid/Cell Size": "4 mm", "Grid/Upper": "{42 mm, 150 mm, 44 mm}", "Time/End Time": "0.256 us"},
    "perforation_3d.xml": {"Grid/Cell Size": "4 mm"},
    "perforation.xml": {"Jet/Cells Per Radius": "1.2"},
    "perforation_refined.xml": {"Grid/Cell Size": "2 mm", "Jet/Cells Per Radius": "2"},
}


def early(deck):
    """The first hundredth of a deck's time, or less; of one that ends at rest, after some 500 us, too."""
    value, unit = re.search(r'name="End Time"[^>]*value="([\d.e+-]+|at rest) *(\w*)"', (DECKS / deck).read_text()).groups()
    value, unit = ("500", "us") if value == "at rest" else (value, unit)
    return {"Time/End Time": f"{SHARE.get(deck, 0.01) * float(value)} {unit}".strip()}


def same_to(tolerance, one, two):
    """Whether two runs end alike, variable by variable; components are measured by the largest of their vector or tensor."""
    first, second = ({name: np.nan_to_num(values) for name, values in run.particles().items()} for run in (one, two))
    sizes = {}
    for name, values in first.items():
        stem = re.sub("_[xyz]{1,2}$", "", name)
        sizes[stem] = max(sizes.get(stem, 0.0), np.max(np.abs(values)))
    for name, values in first.items():
        off = np.max(np.abs(values - second[name]))
        size = sizes[re.sub("_[xyz]{1,2}$", "", name)]
        assert off <= tolerance * size, f"{name} differs by {off:g}, its largest value is {size:g}"


def check_deck(barreno, deck, folder, all_ranks, coarse):
    settings = {**early(deck), **SETTINGS.get(deck, {}), **(COARSE.get(deck, {}) if coarse else {})}
    runs = [run_deck(barreno, deck, settings, ranks=ranks, folder=folder / f"{deck}-{ranks}") for ranks in all_ranks]
    for run in runs:
        assert run.summary["finished"], run.summary["reason"]
        assert run.summary["steps"] >= 2, f"only {run.summary['steps']} steps"
        for name, bound in (("mass", 1e-12), ("momentum", 1e-12), ("energy", 1e-2)):
            error = run.summary["balances"][name]["error"]
            assert abs(error) <= bound, f"{name} balance is off by {error:g}"
        # Row by row: the first ones, before anything has done work, too.
        for name, bound in (("mass", 1e-12), ("momentum", 1e-12), ("energy", 1e-2)):
            worst = np.max(np.abs(run.table("history.csv")[f"{name}_error"]))
            assert worst <= bound, f"{name}_error in history.csv is {worst:g}"
        for name in ("history.csv", "deck.xml", "run.log"):
            assert (run.folder / name).stat().st_size > 0, f"{name} is empty"
        check_exodus.check(run.folder / "particles.e")
    print(f"{deck}: {runs[0].summary['steps']} steps", flush=True)
    if len(runs) == 1:
        return
    if "Pore Flow" in (DECKS / deck).read_text():
        same_to(1e-7, *runs)
        return
    found = exodiff_lite.compare_files(*[run.folder / "particles.e" for run in runs], TESTS / "scripts" / "same.exodiff")
    assert not found, f"one and two ranks differ: {found[:10]}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("barreno")
    parser.add_argument("--ranks", type=int)
    parser.add_argument("--coarse", action="store_true")
    options = parser.parse_args()
    decks = sorted(path.name for path in DECKS.glob("*.xml"))
    assert decks, f"no decks in {DECKS}"
    with tempfile.TemporaryDirectory() as folder:
        for deck in decks:
            check_deck(options.barreno, deck, pathlib.Path(folder), [options.ranks] if options.ranks else (1, 2), options.coarse)


if __name__ == "__main__":
    main()
