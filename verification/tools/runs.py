# SPDX-License-Identifier: BSD-3-Clause
"""Run a deck and read what it left: the one way in which verification cases use the code."""
import atexit
import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from barreno.runs.csv_table import arrays_of, read_csv

from tools.mpi_environment import mpi_environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECKS = ROOT / "input_xml"
NO_END = 100000  # [s], longer than any run


class Run:
    """A finished run: its tables, its summary and its particles."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def table(self, name):
        """Columns of a CSV file as arrays."""
        return arrays_of(read_csv(self.folder / name))

    def times(self):
        """Times that particles.e holds, the start included [s]."""
        from netCDF4 import Dataset

        with Dataset(self.folder / "particles.e") as data:
            return np.array(data.variables["time_whole"][:])

    def instants(self):
        """How many times particles.e holds, the start included."""
        return len(self.times())

    def count_of_block(self, block):
        """How many particles the block of a material has, those included that are not there yet."""
        from netCDF4 import Dataset

        with Dataset(self.folder / "particles.e") as data:
            return len(data.dimensions[f"num_el_in_blk{block}"])

    def particles(self, step=-1, only=None):
        """Element variables of all blocks at a time step, or only those of these names, and corners as (particle, corner, xy or xyz)."""
        from netCDF4 import Dataset, chartostring

        with Dataset(self.folder / "particles.e") as data:
            data.set_auto_mask(False)
            names = [str(name).split("\0")[0] for name in chartostring(data.variables["name_elem_var"][:])]
            # A material without particles has a block without elements.
            blocks = [b for b in range(1, len(data.dimensions["num_el_blk"]) + 1) if f"num_el_in_blk{b}" in data.dimensions]
            out = {"time": float(data.variables["time_whole"][step])}
            for i, name in enumerate(names, 1):
                if only is not None and name not in only:
                    continue
                parts = []
                for block in blocks:
                    variable = data.variables.get(f"vals_elem_var{i}eb{block}")
                    count = len(data.dimensions[f"num_el_in_blk{block}"])
                    parts.append(np.asarray(variable[step]) if variable is not None else np.full(count, np.nan))
                out[name] = np.concatenate(parts)
            nodal = [str(name).split("\0")[0] for name in chartostring(data.variables["name_nod_var"][:])]
            places = []
            for axis in (name for name in "xyz" if f"coord{name}" in data.variables):
                moved = data.variables[f"vals_nod_var{nodal.index(f'displacement_{axis}') + 1}"][step]
                places.append(np.asarray(data.variables[f"coord{axis}"][:]) + np.asarray(moved))
            connect = np.concatenate([np.asarray(data.variables[f"connect{b}"][:]) for b in blocks]) - 1
        out["corners"] = np.stack([place[connect] for place in places], axis=-1)
        for axis, centre in zip("xyz", out["corners"].mean(axis=1).T):
            out[axis] = centre
        return out


def scratch_folder():
    """A folder that goes when the script ends."""
    folder = tempfile.TemporaryDirectory(prefix="verification-")
    atexit.register(folder.cleanup)
    return folder.name


@functools.lru_cache(None)
def server(ranks):
    """serve_runs, if the environment names it: a run begins in a fifth of the time; None: every call is a start of the program."""
    program = os.environ.get("BARRENO_SERVER")
    if not program:
        return None
    from adversary.run_server import RunServer

    one = RunServer(program, scratch_folder(), ranks)
    atexit.register(one.end)
    return one


def call(barreno, words, ranks=1, longest=None):
    """A call of the program that has ended, as subprocess tells of it. @param longest  [s], if any; beyond, TimeoutExpired"""
    if server(ranks):
        return served(words, ranks, longest)
    command = [str(barreno), *map(str, words)]
    if ranks > 1:
        command = ["mpirun", "--quiet", "-n", str(ranks)] + command
    return subprocess.run(command, env=mpi_environment(ranks), capture_output=True, text=True, timeout=longest)


def served(words, ranks, longest):
    ended = server(ranks).run(*words, limit=round(longest or NO_END))
    if ended.kind == "hang":
        raise subprocess.TimeoutExpired(ended.words, longest or NO_END)
    if ended.kind == "lost":
        raise RuntimeError(f"serve_runs ended with barreno {' '.join(ended.words)}")
    code = -ended.code if ended.kind == "signal" else ended.code
    return subprocess.CompletedProcess(["barreno", *ended.words], code, ended.out, ended.err)


def run_deck(barreno, deck, settings=None, ranks=1, folder=None):
    """Run input_xml/DECK with --set overrides; an error of the code is an error here."""
    folder = folder or os.path.join(scratch_folder(), "run")
    words = ["run", str(DECKS / deck), "--out", str(folder)]
    for path, value in (settings or {}).items():
        words += ["--set", f"{path}={value}"]
    result = call(barreno, words, ranks)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(result.args)} ended with {result.returncode}: {result.stderr.strip()}")
    return Run(folder)


def order(errors, ratio=2.0):
    """Observed orders of successive errors."""
    return [float(np.log(a / b) / np.log(ratio)) for a, b in zip(errors, errors[1:])]


def missing_fluid(run):
    """Share of a run's first pore fluid that is neither in the rock nor has flowed out of it: what solves lose, and what particles
    took along that were removed. 0 without pore flow."""
    table = run.table("history.csv")
    if "fluid_error" not in table:
        return 0.0
    first = table["fluid"][-1] + table["fluid_removed"][-1] - table["fluid_inflow"][-1]
    gone = table["fluid_removed"][-1] / first if first > 0.0 else 0.0
    return float(abs(table["fluid_error"][-1]) + gone)
