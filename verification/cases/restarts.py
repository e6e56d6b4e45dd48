# SPDX-License-Identifier: BSD-3-Clause
"""A checkpoint of two ranks, resumed on one to four."""
import pathlib
import shutil

from tools.case import Result
from tools.resumed import at_previous, different_fields, different_files, different_sums, must_work, program
from tools.runs import DECKS, scratch_folder


def run(barreno, full):
    result = Result(
        "Restart on another number of ranks",
        "Neither fields nor tables nor balances depend on when a run was resumed or on how many ranks.",
        "the undisturbed run on two ranks: variables of particles.e, history.csv and depth.csv byte for byte, and all numbers of "
        "summary.json except times, memory and the number of skipped particle-steps.",
        ["ranks", "fields that differ in a bit", "tables that differ", "numbers of the summary that differ"],
        [],
    )
    scratch = pathlib.Path(scratch_folder())
    end = "20 us" if full else "6 us"
    plain = scratch / "plain"
    must_work(program(barreno, 2, "run", DECKS / "perforation_quick.xml", "--out", plain, "--set", f"Time/End Time={end}",
                      "--set", "Output/Field Interval=3 us", "--set", "Output/Checkpoint Steps=60"))  # fmt: skip
    for ranks in (1, 2, 3, 4) if full else (1, 3):
        folder = scratch / f"on{ranks}"
        at_previous(pathlib.Path(shutil.copytree(plain, folder)))
        must_work(program(barreno, ranks, "resume", folder))
        wrong = [different_fields(plain, folder), different_files(plain, folder), different_sums(plain, folder)]
        result.rows.append([ranks, *map(len, wrong)])
        for what, names in zip(("fields", "tables", "numbers of the summary"), wrong):
            result.demand(f"{ranks} ranks: {what} that differ", len(names), 0)
    return result
