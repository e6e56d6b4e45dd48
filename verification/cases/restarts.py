# SPDX-License-Identifier: BSD-3-Clause
"""A checkpoint of two ranks, resumed on one to four."""
import pathlib
import shutil

from case import Result
from resumed import at_previous, different_fields, must_work, program
from runs import DECKS, Run, scratch_folder


def largest_difference(one, other):
    """Of the columns of the history, over the largest value of each."""
    a, b = Run(one).table("history.csv"), Run(other).table("history.csv")
    return max(float(abs(a[n] - b[n]).max() / max(abs(a[n]).max(), 1e-300)) for n in a if not n.endswith("_error"))


def run(barreno, full):
    result = Result(
        "Restart on another number of ranks",
        "Fields do not depend on where a run was resumed, nor on how many ranks.",
        "the run on two ranks that was left alone. Sums over ranks (energies) are added in another order: difference of a column over its "
        "largest value, but for the columns that are errors themselves.",
        ["ranks", "fields that differ in a bit", "columns of the history differ by"],
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
        result.rows.append([ranks, len(different_fields(plain, folder)), largest_difference(plain, folder)])
        result.demand(f"{ranks} ranks: fields that differ", result.rows[-1][1], 0)
        result.demand(f"{ranks} ranks: columns of the history", result.rows[-1][2], 1e-11)
    return result
