# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are stopped and resumed, and whether they end as the run that was left alone."""
import json
import os
import pathlib
import subprocess
import time

import numpy as np
from tools.runs import mpi_environment


def command(barreno, ranks, *words):
    return (["mpirun", "--quiet", "-n", str(ranks)] if ranks > 1 else []) + [str(barreno), *map(str, words)]


def program(barreno, ranks, *words, environment=None):
    return subprocess.run(
        command(barreno, ranks, *words), capture_output=True, text=True, env={**mpi_environment(ranks), **(environment or {})}, check=False
    )


def must_work(result):
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(result.args)} ended with {result.returncode}: {result.stderr.strip()}")
    return result


def lines_of(file):
    return file.read_text().count("\n") if file.exists() else 0


def children(pid):
    """The processes that this one has started, at any depth."""
    found = []
    for task in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        for child in task.read_text().split():
            found += [int(child), *children(child)]
    return found


def stopped_run(barreno, ranks, words, kind, when):
    """Start, send a signal once `when()` holds (to every process for one that cannot be passed on), and wait. @return exit code"""
    run = subprocess.Popen(
        command(barreno, ranks, *words), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=mpi_environment(ranks)
    )
    while run.poll() is None and not when():
        time.sleep(0.005)
    if kind == 9:
        for pid in children(run.pid):
            try:
                os.kill(pid, kind)
            except ProcessLookupError:
                pass
    if run.poll() is None:
        run.send_signal(kind)
    return run.wait()


def at_previous(folder):
    """A finished run as if it had been killed in the middle: its last checkpoint is the one before, its files are longer."""
    (folder / "checkpoint_previous.h5").replace(folder / "checkpoint.h5")
    (folder / "summary.json").unlink()
    return folder


def different_fields(one, other):
    """Names of variables of particles.e that are not the same to the bit."""
    from netCDF4 import Dataset

    with Dataset(one / "particles.e") as a, Dataset(other / "particles.e") as b:
        names = [n for n in a.variables if n not in ("qa_records", "info_records")]
        return [n for n in names if a[n].shape != b[n].shape or not np.array_equal(np.ma.filled(a[n][:], 0), np.ma.filled(b[n][:], 0))]


# Of summary.json: where and how long a run ran, what it was called, and what was said since it was resumed.
OF_THE_MACHINE = (
    "ranks wall_seconds cpu_seconds ns_per_particle_step peak_resident_bytes largest_rank_peak_bytes phases prediction particle_steps "
    "skipped_particle_steps deck warnings set_up"
).split()


def different_sums(one, other):
    """What a summary says of mass, momentum, energy and particles, by name, where it is not the same to the bit."""
    a, b = (json.loads((folder / "summary.json").read_text()) for folder in (one, other))
    for summary in (a, b):
        summary.get("jet", {}).pop("table_file", None)
    return [name for name in sorted({*a, *b} - {*OF_THE_MACHINE}) if a.get(name) != b.get(name)]


def different_files(one, other, names=("history.csv", "depth.csv")):
    return [name for name in names if (one / name).read_bytes() != (other / name).read_bytes()]
