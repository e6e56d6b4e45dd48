# SPDX-License-Identifier: BSD-3-Clause
"""Runs that Python starts."""

import itertools
import pathlib
import signal
import subprocess

from barreno.interface.deck import file_of, words_of
from barreno.interface.opened import open as open_run
from barreno.runs.faults import Fault
from barreno.runs.program import found_program
from barreno.runs.ranks import check_ranks, cores


def next_folder(file):
    """runs/DECK-N, the first that is free."""
    return next(folder for n in itertools.count(1) if not (folder := pathlib.Path("runs") / f"{pathlib.Path(file).stem}-{n}").exists())


def follow(child, progress):
    """Shows what a run prints until it ends. Ctrl-C, or the stop of a notebook, ends it behind a checkpoint."""
    try:
        for line in child.process.stdout:
            if progress:
                print(line.decode("utf-8", "replace"), end="", flush=True)
        child.process.wait()
    except KeyboardInterrupt:
        child.process.send_signal(signal.SIGUSR1)
        child.process.stdout.read()
        child.process.wait()
        raise


def run(deck, set=None, ranks=None, fidelity=None, out=None, overwrite=False, progress=True):
    """Computes a deck and opens its run.

    Parameters
    ----------
    deck : path or dict
        A deck file, a `Deck` or nested dictionaries.
    set : dict, optional
        {"List/Parameter": value}, as --set; None removes a value or a list.
    ranks : int, optional
        Processes; one per core if it is not given.
    fidelity : {"fast", "balanced", "reference"}, optional
    out : path, optional
        Folder of the run; the first free runs/DECK-N if it is not given.
    overwrite : bool
        Whether a run that is in `out` may be replaced.
    progress : bool
        Whether to print what the program prints.

    Returns
    -------
    Run

    Raises
    ------
    Fault
        With the sentence of the program, and its exit code in `code`.
    """
    check_ranks(cores() if ranks is None else ranks, "ranks" if ranks is None else f"ranks={ranks}")
    program = found_program("run", cores() if ranks is None else ranks)
    with file_of(deck) as file:
        folder = pathlib.Path(out) if out is not None else next_folder(file)
        words = ["run", *words_of(file, set, fidelity), "--out", str(folder), *(["--overwrite"] if overwrite else [])]
        child = program.start(words, subprocess.PIPE)
        with child.process.stdout:
            follow(child, progress)
    code, said = child.code(), child.said()
    if code:
        raise Fault(said or f"the run ended with exit code {code}; see run.log in {folder}.", code)
    return open_run(folder)
