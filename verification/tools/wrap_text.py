# SPDX-License-Identifier: BSD-3-Clause
"""Paragraphs of a page in lines of at most 140 columns. Tables, headings, pictures, code and marks stay as they are."""
import re

WIDTH = 140
# A word is never divided within code or a link.
WORD = re.compile(r"(?:`[^`\n]*`|!?\[[^\]\n]*\]\([^)\s]*\)|\S)+")
KEPT = re.compile(r"\s*(?:[|#<]|!\[)")
ITEM = re.compile(r"(\s*)((?:[-*]|\d+\.) +)")
UNFIT = re.compile(r"(?:[-+*=|>#]|\d+[.)])$|[|>#]")  # words that would begin something else at the start of a line


def wrap_paragraph(lines, width=WIDTH):
    """The same words in lines that are as long as they may be."""
    item = ITEM.match(lines[0])
    first = item.group(0) if item else re.match(r" *", lines[0]).group(0)
    rest = " " * len(first)
    words = WORD.findall(" ".join([lines[0][len(first) :], *lines[1:]]))
    out, line = [], []
    for word in words:
        if line and len(rest) + len(" ".join([*line, word])) > width:
            kept = line[:-1] if UNFIT.match(word) and len(line) > 1 else line
            out.append(" ".join(kept))
            line = line[len(kept) :]
        line.append(word)
    out.append(" ".join(line))
    return [(rest if i else first) + text for i, text in enumerate(out)]


def indent_of(line):
    return len(line) - len(line.lstrip(" "))


def code_lines(lines):
    """Numbers of the lines of code: fenced, or four columns further in than the text or list item that they belong to."""
    found, fenced, inside, offset = set(), False, False, 0
    for i, line in enumerate(lines):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            found.add(i)
        elif fenced or (inside and line.strip()):
            found.add(i)
        elif not line.strip():
            inside = False
        else:
            after_blank = i == 0 or not lines[i - 1].strip()
            offset = 0 if after_blank and indent_of(line) == 0 else offset
            inside = after_blank and indent_of(line) >= offset + 4
            item = ITEM.match(line)
            if inside:
                found.add(i)
            elif item:
                offset = len(item.group(0))
    return found


def paragraphs(lines):
    """Groups of lines: (is a paragraph, its lines)."""
    group, code = [], code_lines(lines)
    for i, line in enumerate(lines):
        kept = i in code or not line.strip() or KEPT.match(line)
        if group and (kept or ITEM.match(line)):
            yield True, group
            group = []
        if kept:
            yield False, [line]
        else:
            group.append(line)
    if group:
        yield True, group


def wrapped(text, width=WIDTH):
    out = []
    for is_paragraph, lines in paragraphs(text.split("\n")):
        out += wrap_paragraph(lines, width) if is_paragraph and any(len(line) > width for line in lines) else lines
    return "\n".join(out)
