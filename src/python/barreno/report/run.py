# SPDX-License-Identifier: BSD-3-Clause
"""A run folder, open: its particles, deck, tables and summary."""

import contextlib
import pathlib

import numpy as np

from barreno.report.deck import read_deck
from barreno.runs.exodus_sets import files_of
from barreno.report.files import read_columns, read_summary, reading
from barreno.report.particles import ParticleFile
from barreno.runs.faults import BadRun, Fault, on_one_line
from barreno.runs.lock import is_running
from barreno.runs.run_folder import other_version

MICRO = 1e-6


class Run:
    """@raises BadRun  where the folder is none of a run, or a file that a report needs cannot be read"""

    def __init__(self, folder, stack):
        self.folder = pathlib.Path(folder)
        self.summary = read_summary(self.folder / "summary.json")
        if not (self.folder / "history.csv").exists():
            raise BadRun("it contains no history.csv; give the folder of a run")
        try:
            files_of(self.particle_path)
        except OSError as error:
            raise BadRun(on_one_line(error)) from error
        self.deck = read_deck(self.folder / "deck.xml")
        with self.particles_read():
            self.file = ParticleFile(self.particle_path)
            stack.callback(self.file.close)
            if len(self.file.times) == 0:
                raise ValueError("it has no time step")

    @property
    def particle_path(self):
        return self.folder / "particles.e"

    def particles_read(self):
        return reading(self.particle_path)

    def depth_table(self):
        """Nothing for a run without a jet."""
        return read_columns(self.folder / "depth.csv") if (self.folder / "depth.csv").exists() else None

    def history_table(self):
        return read_columns(self.folder / "history.csv")

    def remarks(self):
        """Sentences on a run that is not over, or of another version."""
        if is_running(self.folder):
            return [f"{self.folder} is still running; the page has what the run had written."]
        if not self.summary:
            return [f"{self.folder} has no summary.json, because the run was killed; the page has what the run had written."]
        said = other_version(self.folder, self.summary.get("version", ""))
        return [said] if said else []

    def step_at(self, time):
        """The step of particles.e that is nearest to a time; the last one for None."""
        times = self.file.times
        if time is None:
            return len(times) - 1
        slack = 0.5 * float(np.diff(times).max(initial=0.0)) + 1e-12 * abs(float(times[-1]))
        if not times[0] - slack <= time <= times[-1] + slack:
            raise Fault(f"--time {time / MICRO:g} us is not in the run's particles.e ({times[0] / MICRO:g} to {times[-1] / MICRO:g} us); "
                "choose a time in between.")
        return int(np.abs(times - time).argmin())

    def frame(self, time=None):
        frame = self.file.frame(self.step_at(time))
        if not frame.alive.any():
            raise ValueError("its last step has no particle" if time is None else "it has no particle at that time")
        return frame


@contextlib.contextmanager
def opened(folder):
    with contextlib.ExitStack() as stack:
        yield Run(folder, stack)
