# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of docs/paper.md share: runs that are made once, tables in verification/results, pictures, trends."""
import concurrent.futures
import csv
import dataclasses
import json
import math
import os
import pathlib
import subprocess
import tempfile
import time

import matplotlib
import numpy as np
from barreno.runs.csv_table import WORDS, read_csv
from tools.demands import met
from paper_figures.progress import Progress
from tools.runs import DECKS, ROOT, mpi_environment

PAPER = DECKS / "paper"
RESULTS = ROOT / "verification" / "results"
COSTS = RESULTS / "paper_time.csv"
PICTURES = ROOT / "docs" / "pictures"
FORMS = ("quick", "default", "fine")
MILLI, MICRO, MEGA, GIGA = 1e-3, 1e-6, 1e6, 1e9


@dataclasses.dataclass
class Trend:
    """What must hold of a figure: a value and its limit."""

    what: str
    value: float
    limit: float
    at_least: bool

    @property
    def holds(self):
        return math.isfinite(self.value) and met(self.value, self.limit, self.at_least)

    def __str__(self):
        return (
            f"{'holds' if self.holds else 'FAILS'}: {self.what}: {self.value:.4g}, {'at least' if self.at_least else 'at most'} "
            f"{self.limit:.4g}"
        )


def least(what, value, limit):
    return Trend(what, float(value), float(limit), True)


def most(what, value, limit):
    return Trend(what, float(value), float(limit), False)


@dataclasses.dataclass
class Table:
    """A results file: what was run, columns, rows of numbers and words."""

    remark: str
    columns: list
    rows: list

    def column(self, name, **where):
        """Values of a column in the rows in which other columns have these values; words stay words."""
        at = self.columns.index(name)
        return np.array([row[at] for row in self.rows if all(row[self.columns.index(key)] == value for key, value in where.items())])

    def value(self, name, **where):
        found = self.column(name, **where)
        if len(found) != 1:
            raise LookupError(f"{len(found)} rows instead of one have {where}")
        return found[0]


def text_of(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def number_or_word(text):
    try:
        return float(text)
    except ValueError:
        return text


def write_table(file, table):
    with open(file, "w", newline="") as out:
        out.writelines(f"# {line}\n" for line in table.remark.splitlines())
        writer = csv.writer(out, lineterminator="\n")
        writer.writerows([table.columns, *([text_of(value) for value in row] for row in table.rows)])


def read_table(file):
    found = read_csv(file, cells=WORDS)
    remark = "\n".join(line[2:] for line in found.attrs["comments"])
    return Table(remark, list(found.columns), [[number_or_word(text) for text in row] for row in found.to_numpy().tolist()])


class Lab:
    """The program and where results go.

    @param form    one of FORMS: cells and times of the runs
    @param folder  of the runs; a temporary one without it
    @param keep    whether pictures and results become those of docs/paper.md
    @param jobs    runs at a time
    @param numbers figures that will be made, for the time left
    """

    def __init__(self, barreno, form="default", folder=None, keep=True, jobs=None, numbers=()):
        matplotlib.rcParams["text.parse_math"] = True  # the pictures of the commands, which some figures import, have no formulas
        self.barreno, self.form, self.keep = pathlib.Path(barreno).resolve(), form, keep
        self.scratch = tempfile.TemporaryDirectory(prefix="paper-")
        self.folder = pathlib.Path(folder).resolve() if folder else pathlib.Path(self.scratch.name)
        self.library = self.barreno.parents[1] / "materials" / "libBARRENO.so"
        self.done, self.used, self.jobs = {}, [], jobs or len(os.sched_getaffinity(0))
        self.progress = Progress(stored_costs() if form == "default" else {}, numbers, self.jobs)

    def of_form(self, quick, default, fine=None):
        return {"quick": quick, "default": default, "fine": default if fine is None else fine}[self.form]

    def picture(self, name):
        return (PICTURES if self.keep else self.folder) / f"{name}.png"

    def program(self, *words):
        """What the program prints; its error is an error here."""
        result = subprocess.run([str(self.barreno), *map(str, words)], env=mpi_environment(), capture_output=True, text=True, check=False)
        if result.returncode:
            raise RuntimeError(f"barreno {' '.join(map(str, words))} ended with {result.returncode}: {result.stderr.strip()}")
        return result.stdout

    def run(self, deck, settings, name):
        """Folder of a run of a deck of input_xml/paper, made once."""
        key = (deck, tuple(settings.items()))
        if key not in self.done:
            folder = self.folder / (name if self.form == "default" else f"{self.form}-{name}")
            began = time.monotonic()
            words = [word for path, value in settings.items() for word in ("--set", f"{path}={value}")]
            reused = self.is_there(folder, key)
            if not reused:
                (folder / "asked.json").unlink(missing_ok=True)  # until all of the run is there
                self.program("run", PAPER / deck, *words, "--out", folder, "--overwrite")
                (folder / "asked.json").write_text(json.dumps(key))
            self.done[key] = folder
            self.progress.run_ended(name, time.monotonic() - began, reused)
        self.used.append(self.done[key])
        return self.done[key]

    def runs(self, asked):
        """Folders of several runs, `jobs` at a time.  @param asked  [(deck, settings, name)]"""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(lambda one: self.run(*one), asked))

    def is_there(self, folder, key):
        """Whether an earlier call with the same --runs has made this run, with this program and these decks."""
        file = folder / "asked.json"
        made_from = [self.barreno, PAPER / key[0], *PAPER.glob("*.csv"), *(ROOT / "materials" / "cards").iterdir(),
            *(DECKS / "jets").iterdir()]
        changed = max(one.stat().st_mtime for one in made_from)
        return file.exists() and json.loads(file.read_text()) == json.loads(json.dumps(key)) and file.stat().st_mtime > changed


def cost_of(folders):
    """[runs, their processor time in s]"""
    return [float(len(set(folders))), sum(summary_of(folder)["cpu_seconds"] for folder in set(folders))]


def stored_costs():
    """{figure: [runs, their processor time in s]} when each was made last."""
    return {int(row[0]): row[1:] for row in read_table(COSTS).rows} if COSTS.exists() else {}


def write_cost(number, cost):
    """A figure's row of paper_time.csv."""
    rows = [[float(other), *found] for other, found in stored_costs().items() if other != number]
    table = Table("Processor time of the runs of each figure of docs/paper.md, a core each; pictures take seconds more",
        ["figure", "runs", "processor time [s]"], sorted([*rows, [float(number), *cost]]))
    write_table(COSTS, table)


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())
