# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are taken if they are there, continued if they are half there, and made otherwise."""

import dataclasses
import pathlib

from barreno.runs.faults import NUMERICAL
from barreno.runs.run_folder import deck_in, state_of


@dataclasses.dataclass(eq=False)
class Run:
    words: list  # of the deck
    deck: str  # as it takes effect
    folder: pathlib.Path
    how: str = ""  # "reused", "resumed" or "computed"; empty while it is not there
    code: int = 0  # it ended with
    said: str = ""  # of a failure

    def failure_code(self):
        """Of the whole command, which a signal to one of its runs does not end."""
        return self.code if 0 < self.code < 128 else NUMERICAL

    def failure(self):
        return f"ended with exit code {self.code}: {self.said or 'see its run.log in ' + str(self.folder)}"


def finished_in(places, version):
    """{effective deck: folder} of the finished runs of a version, the first of every deck."""
    found = {}
    for place in places:
        for folder in sorted(place.iterdir()) if place.is_dir() else ():
            if (folder / "deck.xml").is_file() and state_of(folder) == (True, version):
                found.setdefault(deck_in(folder), folder)
    return found


def take_finished(run, version, finished):
    """Takes a finished run of the same program and the same effective deck: its own folder, or one of finished_in. @return whether there is
    one"""
    own = deck_in(run.folder) == run.deck and state_of(run.folder) == (True, version)
    folder = run.folder if own else finished.get(run.deck)
    if folder:
        run.folder, run.how = folder, "reused"
    return folder is not None


def can_go_on(run, version):
    """Whether its folder has an unfinished run of this deck, by this version as far as it says."""
    finished, made_by = state_of(run.folder)
    return not finished and made_by in ("", version) and deck_in(run.folder) == run.deck and (run.folder / "checkpoint.h5").exists()


class Making:
    """A run under way: continued from its checkpoint if it has one, and from the start if it cannot be continued."""

    def __init__(self, program, run, version):
        self.program, self.run = program, run
        self.resumes = can_go_on(run, version)
        self.start()

    def start(self):
        folder = str(self.run.folder)
        words = ["resume", folder] if self.resumes else ["run", *self.run.words, "--out", folder, "--overwrite"]
        self.child = self.program.start(words)

    def ended(self):
        """Whether it has; the run then knows how and with what."""
        code = self.child.code()
        if code is None:
            return False
        if self.resumes and code and not self.program.asked:
            self.resumes = False
            self.start()
            return False
        self.run.how = "resumed" if self.resumes else "computed"
        self.run.code, self.run.said = code, self.child.said() if code else ""
        return True

    def wait(self):
        while not self.ended():
            self.child.process.wait()
