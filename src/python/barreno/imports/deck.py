# SPDX-License-Identifier: BSD-3-Clause
"""The deck that comes of it: nested lists of named values, in their order."""

import re
from xml.sax.saxutils import quoteattr

ROOT = "Barreno"


def name_of(text, taken, fallback):
    """A name for a list: without signs that paths and arrays use, and not yet taken."""
    plain = " ".join(re.sub(r"[/,{}\"'<>&=]", " ", text).split()) or fallback
    name, count = plain, 1
    while name in taken:
        count += 1
        name = f"{plain} {count}"
    return name


def number(value):
    """The shortest text that reads back as the same double."""
    return repr(float(value))


def array(values):
    return "{" + ", ".join(value if isinstance(value, str) else number(value) for value in values) + "}"


def table(rows):
    """Of equal rows: 2x3:{a, b, c, d, e, f}."""
    return f"{len(rows)}x{len(rows[0])}:{array([value for row in rows for value in row])}"


def parameter(name, value):
    if isinstance(value, bool):
        kind, text = "bool", str(value).lower()
    elif isinstance(value, int):
        kind, text = "int", str(value)
    elif isinstance(value, float):
        kind, text = "double", number(value)
    else:
        kind, text = "string", value if isinstance(value, str) else array(value)
    return f"<Parameter name={quoteattr(name)} type={quoteattr(kind)} value={quoteattr(text)}/>"


def lines_of(name, entries, indent):
    yield f"{indent}<ParameterList name={quoteattr(name)}>"
    for key, value in entries.items():
        if key == "Points":  # of a polygon, which Corners has as text
            continue
        if isinstance(value, dict):
            yield from lines_of(key, value, indent + "  ")
        else:
            yield f"{indent}  {parameter(key, value)}"
    yield f"{indent}</ParameterList>"


def deck_text(entries, comments):
    """@param entries  of the root, lists as dictionaries; empty lists are left out  @param comments  lines above"""
    kept = {name: value for name, value in entries.items() if value != {}}
    head = ["<!-- " + re.sub(r"-(?=-)", "- ", comment).rstrip("-") + " -->" for comment in comments]
    return "\n".join(['<?xml version="1.0"?>', *head, *lines_of(ROOT, kept, "")]) + "\n"
