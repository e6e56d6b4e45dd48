# SPDX-License-Identifier: BSD-3-Clause
"""Flipped bits and cuts at random places of a checkpoint."""
import pathlib
import shutil

import numpy as np
from tools.case import Result
from tools.resumed import different_fields, different_files, must_work, program
from tools.runs import DECKS, scratch_folder

SHORT = ("--set", "Time/End Time=6 us", "--set", "Output/Field Interval=3 us", "--set", "Output/Checkpoint Steps=60")


def damage(data, turn, rng):
    """@return what was done"""
    place = int(rng.integers(len(data)))
    if turn % 2 == 0:
        data[place] ^= 1 << int(rng.integers(8))
        return "flipped bit"
    del data[place:]
    return "cut"


def run(barreno, full):
    result = Result(
        "Damaged checkpoints",
        "A single wrong bit or a truncated file is detected; the previous checkpoint is used, and the run ends as if nothing had happened.",
        "the undisturbed run, its tables byte for byte and its fields bit for bit.",
        ["damage", "files", "found", "previous one used", "ended differently"],
        [],
    )
    scratch = pathlib.Path(scratch_folder())
    plain = scratch / "plain"
    must_work(program(barreno, 1, "run", DECKS / "perforation_quick.xml", *SHORT, "--out", plain))
    rng = np.random.default_rng(3)
    counts = {"flipped bit": [0, 0, 0, 0], "cut": [0, 0, 0, 0]}
    for turn in range(50 if full else 4):
        folder = scratch / "damaged"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(plain, folder)
        data = bytearray((folder / "checkpoint.h5").read_bytes())
        count = counts[damage(data, turn, rng)]
        (folder / "checkpoint.h5").write_bytes(data)
        ended = program(barreno, 1, "resume", folder)
        count[0] += 1
        count[1] += "checkpoint.h5 is skipped" in ended.stdout
        count[2] += ended.returncode == 0 and "resumed from checkpoint_previous.h5" in ended.stdout
        count[3] += bool(different_fields(plain, folder) or different_files(plain, folder))
    for kind, count in counts.items():
        result.rows.append([kind, *count])
        result.demand(f"{kind}: not found", count[0] - count[1], 0)
        result.demand(f"{kind}: previous one not used", count[0] - count[2], 0)
        result.demand(f"{kind}: ended differently", count[3], 0)
    return result
