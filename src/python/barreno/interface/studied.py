# SPDX-License-Identifier: BSD-3-Clause
"""How sure the answers of a deck are, as frames."""

import contextlib
import io
import json
import pathlib

from barreno.interface.deck import OF_A_DECK, file_of
from barreno.interface.frames import read_frame
from barreno.interface.swept import option_words, signals_kept
from barreno.runs.faults import Fault, needed
from barreno.runs.program import as_set, setting_words
from barreno.runs.regular_file import read_text
from barreno.uncertainties.answers import kind_of
from barreno.uncertainties.command import RECORD, TABLE, run as run_study

SI = {"mm": "m", "cm3": "m3", "": "-"}  # of the units of the screen
REST = "interaction and scatter"
EXAMPLE = 'vary={"Jet/Velocity": (0.98, 1.02)}'


def unit_of(answer):
    """In SI, of a name of summary.json."""
    kind = kind_of(answer)
    return SI[kind[1]] if kind else "SI"


def ends_of(path, values):
    """Of a range: a text as --vary has it, or two ends."""
    if isinstance(values, str):
        return values
    try:
        low, high = values
    except (TypeError, ValueError):
        raise Fault(f"vary of {path} is {values!r}, which is no range (two ends, or a text such as '3..15 GPa'); write for example "
            f"{EXAMPLE}.") from None
    return f"{low}..{high}"


def words_of(file, vary, settings, hold, quantities, options):
    words = [str(file)]
    for path, values in (vary or {}).items():
        words += ["--vary", f"{path}={ends_of(path, values)}"]
    words += as_set(setting_words(settings, OF_A_DECK))
    for name, values in (("hold", hold), ("quantity", quantities)):
        for value in [values] if isinstance(values, str) else values:
            words += [f"--{name}", str(value)]
    return words + option_words(options)


class Uncertainty:
    """A study of the command `barreno uncertainty`, in SI (docs/uncertainty.md has the equations). `barreno.uncertainty` makes it.

    Parameters
    ----------
    folder : path
        Of the study.
    record : dict
        Its uncertainty.json.
    """

    def __init__(self, folder, record):
        self.folder, self.record = pathlib.Path(folder), record

    def __repr__(self):
        return f"<barreno.Uncertainty {self.folder}: {', '.join(self.answers)}>"

    @property
    def answers(self):
        """Names of the answers, as in summary.json."""
        return list(self.record["answers"])

    @property
    def sentence(self):
        """The first answer with its interval, and what dominates it."""
        return self.record["answers"][self.answers[0]]["sentence"]

    @property
    def intervals(self):
        """A frame with a row for each answer.

        "5 %", "median" and "95 %" are of the runs alone; "5 % with cells" and so on count the error of their cells, nan where that is
        unknown; "least" and "largest" are of the runs; "foretold" is the share of the variance that the shares explain, nan of
        one-at-a-time. `attrs["units"]` has the unit of each row.
        """
        ends = {"5 %": "low", "median": "median", "95 %": "high"}
        rows = {}
        for name, answer in self.record["answers"].items():
            cells = answer["with_cells"] or {}
            rows[name] = {**{head: answer["ranges"][end] for head, end in ends.items()},
                **{f"{head} with cells": cells.get(end) for head, end in ends.items()},
                "least": answer["least"], "largest": answer["largest"], "foretold": answer["ranges"]["foretold"]}
        frame = needed("pandas").DataFrame.from_dict(rows, orient="index", dtype=float)
        frame.index.name = "answer"
        frame.attrs["units"] = {name: unit_of(name) for name in rows}
        return frame

    @property
    def shares(self):
        """A frame of the shares of the variance: a row for each range, a column for each answer; of a Latin hypercube the last row is
        that of interaction and scatter."""
        columns = {}
        for name, answer in self.record["answers"].items():
            spread = answer["ranges"]
            columns[name] = {path: effect["share"] for path, effect in spread["effects"].items()}
            columns[name] |= {} if spread["rest"] is None else {REST: spread["rest"]}
        frame = needed("pandas").DataFrame(columns)
        frame.index.name = "range"
        frame.attrs["units"] = dict.fromkeys(columns, "-")
        return frame

    def effects(self, answer):
        """What each range does to an answer.

        Parameters
        ----------
        answer : str
            One of `answers`.

        Returns
        -------
        pandas.DataFrame
            A row for each range, the largest share first: "share" of the variance, changes of the answer "at_low" and "at_high" of the
            range, and whether they are "told_from_scatter".

        Raises
        ------
        Fault
            If the study has no such answer.
        """
        if answer not in self.record["answers"]:
            raise Fault(f'"{answer}" is not an answer of {self.folder}; it has {", ".join(self.answers)}.')
        effects = self.record["answers"][answer]["ranges"]["effects"]
        frame = needed("pandas").DataFrame.from_dict(effects, orient="index").sort_values("share", ascending=False, kind="stable")
        frame.index.name = "range"
        frame.attrs["units"] = {"share": "-", "at_low": unit_of(answer), "at_high": unit_of(answer)}
        return frame

    @property
    def ranges(self):
        """A frame with a row for each range: its ends, the deck's value, how it is known and from where. Ends are in SI, those of
        Jet/Velocity and Jet/Radius factors."""
        frame = needed("pandas").DataFrame(self.record["ranges"]).set_index("path")
        frame.index.name = "range"
        frame.attrs["units"] = dict.fromkeys(("low", "high", "deck"), "SI")
        return frame

    @property
    def runs(self):
        """A frame with a row for each run: its folder, its values of the ranges, its state, and the numbers of its summary in SI."""
        frame = read_frame(self.folder / TABLE, texts=True)
        frame.attrs["units"] = dict.fromkeys(frame.select_dtypes("number").columns, "SI")
        return frame


def uncertainty(deck, vary=None, set=None, fidelity=None, ranges=None, hold=(), design="latin", runs=24, seed=1, quantities=(), ranks=1,
        jobs=None, out=None, flow=None, progress=True):
    """Computes a deck within ranges of its inputs: intervals of its answers, and how much each range contributes. Finished runs of the same
    values are taken as they are.

    Parameters
    ----------
    deck : path or dict
        A deck file, a `Deck` or nested dictionaries.
    vary : dict, optional
        {"List/Parameter": range}; a range is two ends, or a text as --vary has it: "3..15 GPa". Jet/Velocity and Jet/Radius are factors of
        all slugs. Without vary and ranges: those of the cards, of the jet and of pressures.
    set : dict, optional
        {"List/Parameter": value} of all runs.
    fidelity : {"fast", "balanced", "reference"}, optional
    ranges : path, optional
        A table of ranges; vary goes before it.
    hold : str or sequence of str
        Parameters or lists that stay as the deck has them.
    design : {"latin", "one-at-a-time"}
    runs : int
        At most so many.
    seed : int
        Of the Latin hypercube.
    quantities : str or sequence of str
        Numbers of summary.json as further answers.
    ranks, jobs : int, optional
        Processes of every run, and runs at a time.
    out : path, optional
        Folder of the study; runs/DECK-uncertainty if it is not given.
    flow : {"radial", "axial", "both"}, optional
        Also the steady flow into the hole of every run; the core flow efficiency is an answer (docs/flow.md).
    progress : bool
        Whether to print what the command prints.

    Returns
    -------
    Uncertainty
        With `intervals`, `shares`, `effects(answer)`, `ranges` and `runs` as frames.

    Raises
    ------
    Fault
        With the sentence of `barreno uncertainty`. A run that fails leaves a row whose state says so; where too few are left, or none of
        their answers can be looked at, the study fails.
    """
    needed("pandas")
    needed("scipy")
    if vary is not None and not isinstance(vary, dict):
        raise Fault(f"vary is not a dictionary; write for example {EXAMPLE}.")
    with file_of(deck) as file, signals_kept():
        folder = pathlib.Path(out) if out is not None else pathlib.Path("runs") / f"{file.stem}-uncertainty"
        options = {"fidelity": fidelity, "ranges": ranges, "design": design, "runs": runs, "seed": seed, "ranks": ranks, "jobs": jobs,
            "out": folder, "flow": flow}
        with contextlib.nullcontext() if progress else contextlib.redirect_stdout(io.StringIO()):
            code = run_study(words_of(file, vary, set, hold, quantities, options))
    record = json.loads(read_text(folder / RECORD))
    if "answers" not in record:
        raise Fault(f"too few runs of the study in {folder} have finished; the lines above say why.", code or 1)
    if not record["answers"]:
        raise Fault(f"no answer of the study in {folder} can be looked at: {' '.join(record['left_out'])}")
    return Uncertainty(folder, record)
