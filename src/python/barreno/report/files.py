# SPDX-License-Identifier: BSD-3-Clause
"""Files of a run and of its report: tables and the summary, read with a word for whatever is wrong with them; pages, written whole."""

import contextlib
import json
import os
import pathlib
import xml.etree.ElementTree

from barreno.runs.csv_table import BadTable, EmptyTable, arrays_of, read_csv
from barreno.runs.faults import BadRun, on_one_line
from barreno.runs.regular_file import read_text


@contextlib.contextmanager
def reading(file):
    """Whatever goes wrong with what a file holds is said of the file: a run that was killed, or a copy that was cut off,
    leaves anything."""
    try:
        yield
    except OSError as error:
        raise BadRun(f"{file.name} cannot be read: {on_one_line(error.strerror or error)}") from error
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError, ValueError,
            xml.etree.ElementTree.ParseError) as error:
        raise BadRun(f"{file.name} is truncated or was changed: {on_one_line(error)[:200]}") from error


@contextlib.contextmanager
def written(file):
    """A name to write under, which becomes the file when all is there; a link that somebody laid there is not followed."""
    aside = file.with_name(f".{file.name}.tmp{file.suffix}")
    try:
        aside.unlink(missing_ok=True)
        os.close(os.open(aside, os.O_CREAT | os.O_EXCL | os.O_WRONLY | os.O_NOFOLLOW, 0o666))
        yield aside
        aside.replace(file)
    except OSError as error:
        raise BadRun(f"{file.name} cannot be written: {on_one_line(error.strerror or error)}") from error
    finally:
        with contextlib.suppress(OSError):
            aside.unlink()


def write_text(file, text):
    with written(file) as aside:
        aside.write_text(text, encoding="utf-8", errors="backslashreplace")


def make_folder(folder):
    try:
        folder.mkdir(exist_ok=True, parents=True)
    except OSError as error:
        raise BadRun(f"{folder.name} cannot be made there: {error.strerror}") from error


class Table(dict):
    """Columns by their names, and the lines of comment above them; a column that a file lacks is said of the file."""

    def __init__(self, file, columns, comments=()):
        super().__init__(columns)
        self.file, self.comments = file, comments

    def __missing__(self, name):
        raise BadRun(f"{self.file.name} lacks the column '{name}'")

    def last_row(self):
        return Table(self.file, {name: values[-1] for name, values in self.items()})


def read_columns(file):
    """A table of numbers. A run that was killed may have left half a line at the end, which is left out."""
    file = pathlib.Path(file)
    with reading(file):
        try:
            frame = read_csv(file, cut=True)
        except EmptyTable as error:
            raise BadRun(f"{file.name} contains no row of numbers") from error
        except BadTable as error:
            if not error.where:
                raise
            raise BadRun(f"{error.where} of {file.name} {on_one_line(error.what)[:200]}") from error
    if frame.empty:
        raise BadRun(f"{file.name} contains no row of numbers")
    return Table(file, arrays_of(frame), frame.attrs["comments"])


def read_summary(file):
    """What a run said of itself; nothing while it runs, or if it was killed."""
    if not file.exists():
        return {}
    with reading(file):
        summary = json.loads(read_text(file))
        if not isinstance(summary, dict):
            raise ValueError("it is not a JSON object")
        return summary
