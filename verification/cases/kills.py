# SPDX-License-Identifier: BSD-3-Clause
"""SIGKILL at random moments of a short perforation on two ranks, each resumed."""
import json
import pathlib
import shutil
import time

import numpy as np
from tools.case import Result
from tools.resumed import different_fields, must_work, program, stopped_run
from tools.runs import DECKS, scratch_folder

DECK = DECKS / "perforation_quick.xml"
SHORT = ("--set", "Time/End Time=6 us", "--set", "Output/Field Interval=3 us", "--set", "Output/Checkpoint Steps=10")
MOST = 5  # kills of one run, so that one that is killed before its first checkpoint is started again


def is_finished(folder):
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["finished"]


def killed_and_resumed(barreno, folder, seconds):
    """Kills after so many seconds of running, again and again, until the run has ended. @return kills, resumes, starts"""
    kills = resumes = starts = 0
    while True:
        if is_finished(folder):  # the kill came too late
            return kills, resumes, starts
        kept = any((folder / name).exists() for name in ("checkpoint.h5", "checkpoint_previous.h5"))
        words = ("resume", folder) if kept else ("run", DECK, "--out", folder, "--overwrite", *SHORT)
        resumes, starts = resumes + kept, starts + (not kept)
        if kills == MOST:
            must_work(program(barreno, 2, *words))
            return kills, resumes, starts
        due = time.time() + seconds[kills]
        if stopped_run(barreno, 2, words, 9, lambda due=due: time.time() > due) == 0:
            return kills, resumes, starts
        kills += 1


def run(barreno, full):
    result = Result(
        "SIGKILL at random moments",
        "A run on two ranks that is killed at any moment and resumed ends exactly like the undisturbed run.",
        "the fields of that run, bit for bit.",
        ["killed runs", "kills", "resumed from a checkpoint", "started again", "ended with different fields"],
        [],
    )
    scratch = pathlib.Path(scratch_folder())
    plain = scratch / "plain"
    begun = time.time()
    must_work(program(barreno, 2, "run", DECK, "--out", plain, *SHORT))
    whole = time.time() - begun
    rng = np.random.default_rng(7)
    wanted = 100 if full else 2
    sums, other, runs = np.zeros(3, dtype=int), 0, 0
    while sums[0] < wanted:
        folder = scratch / "killed"
        shutil.rmtree(folder, ignore_errors=True)
        sums += killed_and_resumed(barreno, folder, rng.uniform(0.1, 1.0, MOST) * whole)
        runs += 1
        other += bool(different_fields(plain, folder))
    result.rows.append([runs, *map(int, sums), other])
    result.demand("kills", int(sums[0]), wanted, at_least=True)
    result.demand("resumed from a checkpoint", int(sums[1]), 1, at_least=True)
    result.demand("runs that ended with different fields", other, 0)
    return result
