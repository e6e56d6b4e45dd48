# SPDX-License-Identifier: BSD-3-Clause
"""A sweep as a frame."""

import contextlib
import io
import pathlib
import signal
import threading

from barreno.interface.deck import OF_A_DECK, file_of
from barreno.interface.frames import read_frame
from barreno.runs.faults import Fault, needed
from barreno.runs.program import as_set, setting_words
from barreno.sweeps.command import run as run_sweep


def text_of(values):
    """Of the values of a parameter: a text as --vary has it, a sequence, or one number."""
    return ",".join(map(str, values)) if hasattr(values, "__iter__") and not isinstance(values, str) else str(values)


def words_of(file, vary, settings, options):
    words = [str(file)]
    for path, values in vary.items():
        words += ["--vary", f"{path}={text_of(values)}"]
    return words + as_set(setting_words(settings, OF_A_DECK)) + option_words(options)


def option_words(options):
    """Of a command.  @param options  {name: value}; None leaves it out"""
    return [word for name, value in options.items() if value is not None for word in (f"--{name}", str(value))]


@contextlib.contextmanager
def signals_kept():
    """A sweep takes the signals that end it, if it may (Program.watch_signals); behind it they belong to the caller again."""
    first = threading.current_thread() is threading.main_thread()
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP) if first else ()
    kept = {number: signal.getsignal(number) for number in numbers}
    try:
        yield
    finally:
        for number, handler in kept.items():
            signal.signal(number, handler)


def sweep(deck, vary, set=None, fidelity=None, sample="grid", samples=None, seed=None, ranks=1, jobs=None, out=None, flow=None,
        progress=True):
    """Computes a deck for several values of its parameters; finished runs of the same values are taken as they are.

    Parameters
    ----------
    deck : path or dict
        A deck file, a `Deck` or nested dictionaries.
    vary : dict
        {"List/Parameter": values}; values are a sequence, or a text as --vary has it: "0,34,69 MPa", of a Latin hypercube "0..69 MPa".
    set : dict, optional
        {"List/Parameter": value} of all runs.
    fidelity : {"fast", "balanced", "reference"}, optional
    sample : {"grid", "list", "latin"}
    samples, seed : int, optional
        Of a Latin hypercube.
    ranks, jobs : int, optional
        Processes of every run, and runs at a time.
    out : path, optional
        Folder of the runs; runs/DECK-sweep if it is not given.
    flow : {"radial", "axial", "both"}, optional
        Also the steady flow into the hole of every run: columns flow.core_flow_efficiency, flow.skin and so on (docs/flow.md).
    progress : bool
        Whether to print a line for every run that ends.

    Returns
    -------
    pandas.DataFrame
        A row for each run: its folder, what was varied, its state, and the numbers of its summary in SI (docs/sweep.md).
        `attrs["units"]` has the unit of each column that was varied, and "SI" of the others.

    Raises
    ------
    Fault
        With the sentence of `barreno sweep`. A run that fails leaves a row whose state says so; if all fail, the sweep does.
    """
    needed("pandas")
    if not isinstance(vary, dict):
        raise Fault('vary is not a dictionary; write for example vary={"Confinement/Pressure": "0,34,69 MPa"}.')
    with file_of(deck) as file, signals_kept():
        folder = pathlib.Path(out) if out is not None else pathlib.Path("runs") / f"{file.stem}-sweep"
        options = {"fidelity": fidelity, "sample": sample, "samples": samples, "seed": seed, "ranks": ranks, "jobs": jobs, "out": folder,
            "flow": flow}
        with contextlib.nullcontext() if progress else contextlib.redirect_stdout(io.StringIO()):
            code = run_sweep(words_of(file, vary, set, options))
    frame = read_frame(folder / "table.csv", texts=True) if (folder / "table.csv").is_file() else None
    if frame is None or code and not (frame["state"] == "finished").any():
        raise Fault(f"no run of the sweep in {folder} has finished; the lines above say why.", code or 1)
    # What was varied is in the unit of its values, numbers of the summary in SI.
    frame.attrs["units"] = {**dict.fromkeys(frame.select_dtypes("number").columns, "SI"), **frame.attrs["units"]}
    return frame
