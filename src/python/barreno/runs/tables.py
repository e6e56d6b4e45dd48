# SPDX-License-Identifier: BSD-3-Clause
"""Files that are complete or absent, and tables of the screen."""

import contextlib
import os

from barreno.runs.faults import FILE, Fault


def make_folder(folder):
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Fault(f"--out {folder} cannot be made ({error.strerror}); name another folder.", FILE) from None


def place(file, content):
    """Written aside and renamed: complete or absent.  @param content  text, or what writes the file of a name"""
    aside = file.with_name(f".{file.name}.tmp")
    try:
        with contextlib.suppress(FileNotFoundError):
            aside.unlink()
        if callable(content):
            content(aside)
        else:
            aside.write_text(content, encoding="utf-8", errors="backslashreplace")
        os.replace(aside, file)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise Fault(f"{file} cannot be written ({error.strerror}).", FILE) from None


def number(value, digits=6):
    return "-" if value is None else f"{value:.{digits}g}"


def aligned(rows):
    """Lines of a table, its columns to the right."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return ["  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]
