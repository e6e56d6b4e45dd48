# SPDX-License-Identifier: BSD-3-Clause
"""The reader of CSV files, by pandas. Tables of a laboratory, which any program may have written, are read by fit/table.py."""

import io
import re

from barreno.runs.regular_file import read_bytes

NUMBERS, MIXED, WORDS = "numbers", "mixed", "words"
NAN = ("nan", "NaN", "-nan")
UNIT = re.compile(r".*\S\s*\[([^\[\]]*)\]")  # "depth [mm]"


class BadTable(ValueError):
    """A clause: where, and what is wrong there.

    Attributes
    ----------
    where : str
        The line; "" for the whole file.
    column : str
        The column of a cell that is not a number; else "".
    """

    def __init__(self, where, what, column=""):
        super().__init__(f"{where} {what}" if where else what)
        self.where, self.what, self.column = where, what, column


class EmptyTable(BadTable):
    """The file has no line of names."""

    def __init__(self):
        super().__init__("", "it has no line of names")


def read_csv(file, cells=NUMBERS, separator=",", cut=False):
    """A table under a line of names, behind lines of comment that begin with #.

    Parameters
    ----------
    file : path
    cells : str
        NUMBERS; MIXED: a column of something else has texts, an empty cell is nan; WORDS: all are texts, as they stand in the file.
    separator : str
    cut : bool
        Whether a last line without its end is left out: who writes the file may be at it, or was killed.

    Returns
    -------
    pandas.DataFrame
        `attrs["units"]` has the unit of each column whose name says it, as "depth [mm]"; `attrs["comments"]` the lines of comment.

    Raises
    ------
    BadTable
        If the file is no such table.
    OSError
        If it cannot be read.
    """
    import pandas  # slow to load

    lines = text_of(read_bytes(file)).replace("\r\n", "\n").split("\n")
    if cut:
        lines = lines[:-1]
    rows = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith("#")]
    check_widths(rows, separator)
    nan = {NUMBERS: NAN, MIXED: ("", *NAN), WORDS: ()}[cells]
    try:
        frame = pandas.read_csv(io.StringIO("\n".join(line for _, line in rows)), sep=separator, index_col=False, skipinitialspace=True,
            lineterminator="\n", float_precision="round_trip", keep_default_na=False, na_values=nan, dtype=str if cells == WORDS else None)
    except ValueError as error:  # pandas' own faults are of this kind
        raise BadTable("", str(error)) from None
    if cells == NUMBERS:
        frame = only_numbers(frame, [number for number, _ in rows[1:]])
    frame.attrs["units"] = {name: found.group(1).strip() for name in frame.columns if (found := UNIT.fullmatch(name))}
    frame.attrs["comments"] = [line for line in lines if line.lstrip().startswith("#")]
    return frame


def text_of(raw):
    try:
        text = raw.decode("utf-8")
    except UnicodeDecodeError as error:
        raise BadTable("", str(error)) from None
    if "\0" in text:  # pandas would end the cell there
        raise BadTable("", "it is no text: it has bytes of value 0")
    return text


def check_widths(rows, separator):
    """pandas fills up a short row, and cuts off a long one."""
    if not rows:
        raise EmptyTable
    widths = [re.sub(r'"[^"]*"', "", line).count(separator) + 1 for _, line in rows]
    for (number, _), width in zip(rows, widths):
        if width != widths[0]:
            raise BadTable(f"line {number}", f"has {width} columns instead of {widths[0]}")


def only_numbers(frame, numbers):
    """The frame, whole numbers as such.  @param numbers  of the lines of its rows"""
    from pandas.api.types import is_bool_dtype, is_numeric_dtype

    if frame.empty:
        return frame.astype(float)
    faults = []
    for name in frame.columns:
        if is_bool_dtype(frame[name]) or not is_numeric_dtype(frame[name]):
            values, fault = floats_of(frame[name])
            faults += [(*fault, name)] if fault else []
            frame[name] = values
    if faults:
        row, what, name = min(faults)
        raise BadTable(f"line {numbers[row]}", f"contains something that is not a number: {what}", name)
    return frame


def floats_of(column):
    """Of texts that pandas leaves as they are: a number beyond a double, or none.  @return values, and (row, what is wrong) or None"""
    values = []
    for row, cell in enumerate(column):
        try:
            values.append(float(str(cell)))
        except ValueError as error:
            return float("nan"), (row, str(error)[:100])
    return values, None


def arrays_of(frame):
    """{name: array} of a frame of numbers."""
    return {name: frame[name].to_numpy(float) for name in frame.columns}
