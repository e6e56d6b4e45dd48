# SPDX-License-Identifier: BSD-3-Clause
"""A table as text, whatever program wrote it. The rules are those of src/deck/files/table_text.cpp and decimal_marks.cpp, which read the
tables of decks and of `drive`: tests/decks/test_table_variants.py gives both the same files. So no pandas here: its guesses at separators,
decimal marks and lines of titles are others."""

import csv
import re
from dataclasses import dataclass, field
from barreno.fit.units import is_unit
from barreno.runs.faults import Fault

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
DIGITS = re.compile(r"[-+]?([\d.,]*\d[\d.,]*)")  # that a cell begins with
PLAIN_NUMBER = re.compile(r"[-+]?[\d.,]*\d(\.|[eE][-+]?\d+)?")  # whatever its marks mean
SEPARATORS = {";": "semicolons", "\t": "tabs", " ": "blanks"}


@dataclass
class Table:
    """Cells of a file; its numbers have a decimal point."""

    header_line: int = 0  # 0: no header
    titles: list = field(default_factory=list)  # (line, cells) above the header
    heads: list = field(default_factory=list)  # names of the columns as they stand, without units
    names: list = field(default_factory=list)  # in small letters, "axial_strain"
    units: list = field(default_factory=list)  # "" where none is given
    rows: list = field(default_factory=list)  # (line, cells)
    comments: list = field(default_factory=list)  # (line, key, value) of "# key: value"
    notes: list = field(default_factory=list)  # what was guessed


def decoded(raw):
    """The text of bytes in UTF-8, in UTF-16 with a byte-order mark, or in Latin-1; None where it is no text."""
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        try:
            text = raw.decode("utf-16")
        except UnicodeDecodeError:
            return None
    else:
        try:
            text = raw.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = raw.decode("latin-1")
    return None if "\0" in text else text


def name_of(cell):
    return re.sub(r"[ -]", "_", cell.strip().lower())


def head_and_unit(cell):
    """ "Stress [MPa]" or "Stress (MPa)"; "Stress, MPa" and "Stress / MPa" where that is a unit."""
    found = re.fullmatch(r"(.+?)\s*(?:\[([^\]]*)\]|\(([^)]*)\))", cell)
    if found:
        return found.group(1).strip(), (found.group(2) or found.group(3) or "").strip()
    found = re.fullmatch(r"(.+?)\s*(?:,|\s/\s)\s*(\S+)", cell)
    if found and is_unit(found.group(2)):
        return found.group(1).strip(), found.group(2)
    return cell.strip(), ""


def separator_of(lines):
    """The sign that more than half of the lines of the second half, where titles are not, have outside of quotes."""
    lines = lines[len(lines) // 2 :]
    for sign in (";", "\t"):
        if 2 * sum(sign in re.sub(r'"[^"]*"', "", line) for _, line in lines) > len(lines):
            return sign
    return " " if all(len(line.split()) > 1 and all(map(PLAIN_NUMBER.fullmatch, line.split())) for _, line in lines) else ","


def cells_of(line, separator):
    if separator == " ":
        return re.sub(r"\s+(?=[\[(])", "", line).split()  # "Stress [MPa]" is one cell
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]


def is_number(cell):
    return NUMBER.fullmatch(cell) is not None


def is_text_row(cells):
    return any(cells) and not any(DIGITS.match(cell) for cell in cells)


def header_at(lines, known):
    """Index of the first line with a known name; else of the last line of text before the first row of numbers, or 0."""
    for i, (_, cells) in enumerate(lines):
        if any(name_of(head_and_unit(cell)[0]) in known for cell in cells):
            return i
    first = next((i for i, (_, cells) in enumerate(lines) if len(cells) > 1 and sum(bool(DIGITS.match(c)) for c in cells) > len(cells) / 2),
        0)
    while first > 1 and is_text_row(lines[first - 1][1]) and all(is_unit(c.strip("[]() ")) for c in lines[first - 1][1] if c):
        first -= 1
    return max(first - 1, 0)


def take_header(table, line):
    table.header_line, cells = line
    while cells and not cells[-1]:
        cells.pop()
    for cell in cells:
        head, unit = head_and_unit(cell)
        table.heads.append(head)
        table.names.append(name_of(head))
        table.units.append(unit)


def take_unit_row(table):
    """Of the rows of text below the names the one that holds units; further ones, channels for instance, are not read."""
    texts = next((i for i, (_, cells) in enumerate(table.rows) if not is_text_row(cells)), len(table.rows))
    stripped = [[cell.strip("[]() ") for cell in cells] for _, cells in table.rows[:texts]]
    found = next((i for i, cells in enumerate(stripped) if all(not cell or is_unit(cell) for cell in cells)), None)
    if any(table.units) or not texts:
        return
    table.units = (stripped[found or 0] + [""] * len(table.names))[: len(table.names)]
    skipped = [number for i, (number, _) in enumerate(table.rows[: texts if found is not None else 0]) if i != found]
    if skipped:
        table.notes.append(f"text below the column names is not read: line {skipped[0]}.")
    table.rows = table.rows[texts if found is not None else 1 :]


def split_table(file, text, known, decimal=""):
    """The table of a text; a Fault where the marks in its numbers leave open what they mean.

    @param decimal  "comma" or "point", where it is said
    """
    table, lines = Table(), []
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1):
        if not line.strip():
            continue
        if line.lstrip().startswith("#"):
            key, colon, value = line.strip()[1:].partition(":")
            if colon:
                table.comments.append((number, key.strip().lower(), value.strip()))
        else:
            lines.append((number, line))
    if not lines:
        return table
    separator = separator_of(lines)
    if separator in SEPARATORS:
        table.notes.append(f"cells are separated by {SEPARATORS[separator]}.")
    try:
        lines = [(number, cells_of(line, separator)) for number, line in lines]
    except csv.Error as error:
        raise Fault(f"{file} is no table ({error}); is it the right file?") from None
    at = header_at(lines, known)
    table.titles = lines[:at]
    if at:
        first, last = lines[0][0], lines[at - 1][0]
        table.notes.append(f"line {first} stands above the column names." if at == 1
            else f"lines {first} to {last} stand above the column names.")
    take_header(table, lines[at])
    table.rows = [line for line in lines[at + 1 :] if any(line[1])]
    take_unit_row(table)
    for _, cells in table.rows:
        while len(cells) > len(table.names) and not cells[-1]:
            cells.pop()
    put_decimal_points(file, table, decimal)
    return table


def in_thousands(digits, mark):
    return re.fullmatch(rf"[1-9]\d{{0,2}}(\{mark}\d{{3}})+", digits) is not None


@dataclass
class Mark:
    """What the numbers of a table show of a comma, or of a point."""

    first: tuple = ()  # line and digits
    thousands: bool = True  # each number that has it could have it between thousands
    repeated: bool = False
    last: bool = False  # of both in a number


def marks_of(table):
    marks = {",": Mark(), ".": Mark()}
    for number, cells in table.rows:
        for found in filter(None, map(DIGITS.match, cells)):
            digits = found.group(1)
            for mark, other in ((",", "."), (".", ",")):
                if mark not in digits:
                    continue
                seen = marks[mark]
                seen.first = seen.first or (number, digits)
                seen.repeated |= digits.count(mark) > 1
                if other in digits and digits.rfind(mark) > digits.find(other):
                    seen.last = True
                elif not in_thousands(digits.split(other)[0], mark):
                    seen.thousands = False
    return marks


def decimal_of(marks):
    """The decimal mark; "" where it is open, None where the numbers contradict each other."""
    comma, point = marks[","], marks["."]
    not_comma, not_point = comma.repeated or point.last, point.repeated or comma.last
    if not_comma or not_point:
        other = comma if not_comma else point
        return (not_comma != not_point and other.thousands and ("." if not_comma else ",")) or None
    if comma.first and point.first:
        return None if comma.thousands == point.thousands else "." if comma.thousands else ","
    if not comma.first:
        return "."
    return "" if comma.thousands else ","


def said_decimal(file, table, decimal):
    said = decimal or next((value for _, key, value in table.comments if key == "decimal"), "")
    if said.lower() not in ("", "comma", "point"):
        raise Fault(f"{file} has the decimal '{said}', which is neither comma nor point; write one of the two.")
    return {"": "", "comma": ",", "point": "."}[said.lower()]


def put_decimal_points(file, table, decimal):
    marks = marks_of(table)
    comma, point = marks[","], marks["."]
    said = said_decimal(file, table, decimal)
    found = said or decimal_of(marks)
    if said and not (point if said == "," else comma).thousands:
        found = None
    if found is None and not (comma.first and point.first):
        return  # the cell is named where numbers are read
    if found == "":
        raise Fault(f'{file}, line {comma.first[0]} has "{comma.first[1]}" (a decimal comma, or a comma between thousands); say which with '
            'a line "# decimal: comma" or "# decimal: point", or with --say decimal=comma.')
    if found is None:
        raise Fault(f'{file}, line {comma.first[0]} has "{comma.first[1]}" and line {point.first[0]} has "{point.first[1]}" (a table has '
            'one decimal mark); write its numbers with one.')
    if found == "." and not comma.first:
        return
    for _, cells in table.rows:
        for i, cell in enumerate(cells):
            digits = DIGITS.match(cell)
            if digits:
                begin, end = digits.span(1)
                written = digits.group(1).replace("." if found == "," else ",", "").replace(",", ".")
                cells[i] = cell[:begin] + written + cell[end:]
    if not said and found == ",":
        table.notes.append("the decimal mark is the comma.")
    if not said and (point if found == "," else comma).first:
        table.notes.append(f"{'points' if found == ',' else 'commas'} stand between thousands.")
