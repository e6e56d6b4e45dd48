# SPDX-License-Identifier: BSD-3-Clause
"""One table in the forms of spreadsheets and laboratories: encodings, separators, decimal marks, units, line ends, titles."""

import itertools

ENCODINGS = ("utf-8", "utf-8-sig", "latin-1", "utf-16-le", "utf-16-be")
MARKS = {"utf-16-le": b"\xff\xfe", "utf-16-be": b"\xfe\xff"}
CELLS = ((",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","), ('","', ","))  # separator, decimal mark; the last is quoted
UNITS = ("brackets", "parentheses", "row", "row in brackets")
ENDS = ("\n", "\r\n", "\r")
TITLES = ("", "Universität A, cell 3\nProbe 7\n")


def head_lines(names, units, style):
    if style == "brackets":
        return [[f"{name} [{unit}]" for name, unit in zip(names, units)]]
    if style == "parentheses":
        return [[f"{name.replace('_', ' ').capitalize()} ({unit})" for name, unit in zip(names, units)]]
    return [[name.upper() for name in names], [f"[{unit}]" if "brackets" in style else unit for unit in units]]


def form_of(table, encoding="utf-8", cells=(",", "."), style="brackets", end="\n", title=""):
    """Bytes of a table: (comments, names, units, rows of texts with a point)."""
    comments, names, units, rows = table
    separator, decimal = cells
    quote = '"' if '"' in separator else ""
    lines = head_lines(names, units, style) + [[cell.replace(".", decimal) for cell in row] for row in rows]
    text = "".join(f"# {c}\n" for c in comments) + title + "".join(quote + separator.join(line) + quote + "\n" for line in lines)
    return MARKS.get(encoding, b"") + text.replace("\n", end).encode(encoding)


def filled(table, separator=";"):
    """As a spreadsheet fills rows up with empty cells."""
    text = form_of(table, cells=(separator, ",")).decode()
    return "".join(line + (2 * separator if not line.startswith("#") else "") + "\n"
        for line in text.splitlines()).encode() + 5 * separator.encode() + b"\n"


def with_channels(table, below):
    """One more row of text beside that of the units."""
    lines = form_of(table, cells=(";", ","), style="row").decode().splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith(table[2][0])) + (1 if below else 0)
    return "\n".join(lines[:at] + [";".join(f"Kanal {chr(65 + i)}" for i in range(len(table[1])))] + lines[at:]).encode() + b"\n"


def forms(table):
    """Name and bytes of each form."""
    for encoding, cells in itertools.product(ENCODINGS, CELLS):
        yield f"{encoding} {cells}", form_of((("Müller",) + tuple(table[0]), *table[1:]), encoding, cells)
    for style, end, title in itertools.product(UNITS, ENDS, TITLES):
        yield f"{style} {end!r} {title[:5]}", form_of(table, "latin-1", (";", ","), style, end, title)
    for mark, gap, style in ((".", " ", "brackets"), (",", "   ", "brackets"), (".", " ", "row"), (",", "\t ", "row in brackets")):
        yield f"blanks {mark}", form_of(table, cells=(gap, mark), style=style)
    yield "names of channels above units", with_channels(table, below=False)
    yield "names of channels below units", with_channels(table, below=True)
    yield "filled", filled(table)
    yield "filled with tabs", filled(table, "\t")


def _in_thousands(cell, mark, decimal):
    whole, _, part = cell.partition(".")
    return f"{int(whole):,}".replace(",", mark) + (decimal + part if part else "")


def forms_in_thousands(table):
    """A column beyond 999 with marks between thousands."""
    comments, names, units, rows = table
    for separator, mark, decimal in ((";", ".", ","), (";", ",", "."), ("\t", ".", ",")):
        lines = head_lines(names, units, "brackets") + [[_in_thousands(cell, mark, decimal) for cell in row] for row in rows]
        yield f"thousands {mark!r}", ("".join(f"# {c}\n" for c in comments)
            + "".join(separator.join(line) + "\n" for line in lines)).encode()
