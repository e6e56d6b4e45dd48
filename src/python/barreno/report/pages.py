# SPDX-License-Identifier: BSD-3-Clause
"""Sections as Markdown, as one HTML page that needs no network, and as a PDF."""

import base64
import functools
import pathlib
import textwrap

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup
from matplotlib.backends.backend_pdf import PdfPages

from barreno.runs.faults import on_one_line
from barreno.runs.plots import plt
from barreno.runs.regular_file import read_bytes, read_text

HERE = pathlib.Path(__file__).parent
LINE, PAGE = 92, 69  # letters and lines of a page of the PDF
PAPER = (8.27, 11.69)
LETTERS_PER_INCH, GAP = 13, 0.12  # of a caption; inches between it and the picture


def markdown_cell(text):
    return on_one_line(text).replace("|", "\\|")


def markdown_table(heads, rows):
    line = lambda cells: "| " + " | ".join(map(markdown_cell, cells)) + " |"  # noqa: E731
    return [line(heads) if any(heads) else "| " * len(heads) + "|", "|---" * len(heads) + "|", *map(line, rows), ""]


def as_markdown(title, sections):
    lines = [f"# {on_one_line(title)}", ""]
    for section in sections:
        lines += [f"## {section.title}", ""] if section.title else []
        lines += markdown_table(("", ""), section.rows) if section.rows else []
        lines += [paragraph for words in section.words for paragraph in (words, "")]
        lines += markdown_table(section.heads, section.table) if section.table else []
        lines += [line for picture in section.pictures for line in (f"![{picture.caption or picture.name}]({picture.name}.png)", "")]
    return "\n".join(lines)


def encoded(picture, folder):
    return base64.b64encode(read_bytes(folder / f"{picture.name}.png")).decode("ascii")


def own_text(name):
    """A file of this package, which is no text of a run's: it goes into a page as it is."""
    return Markup(read_text(HERE / name).rstrip())


def as_html(title, sections, folder, view=None, sentence=""):
    """
    @param folder    of the pictures, which the page takes in
    @param view      {"outputs": sentence, "data": JSON, "scripts": texts} of the view to explore
    @param sentence  below the title
    """
    pages = Environment(loader=FileSystemLoader(HERE), autoescape=True, undefined=StrictUndefined, keep_trailing_newline=True)
    pages.filters.update(on_one_line=on_one_line, encoded=functools.partial(encoded, folder=folder))
    return pages.get_template("page/page.html").render(title=title, sections=sections, view=view, sentence=sentence, own=own_text)


def table_text(heads, rows):
    """Lines of a table, its heads one word under the other so that it fits the page."""
    words = [head.split() for head in heads]
    high = max(map(len, words))
    above = [["" if line < high - len(one) else one[line - high + len(one)] for one in words] for line in range(high)]
    widths = [max(len(str(row[i])) for row in [*above, *rows]) for i in range(len(heads))]
    return ["  ".join(str(cell).rjust(width) for cell, width in zip(row, widths)) for row in [*above, *rows]]


def text_lines(title, sections):
    """Lines of the PDF's pages of text."""
    lines = [*textwrap.wrap(on_one_line(title), LINE)]
    for section in sections:
        if section.rows or section.words or section.table:
            lines += ["", "", section.title, "-" * len(section.title)] if section.title else [""]
        for name, value in section.rows:
            lines += textwrap.wrap(f"{name}: {on_one_line(value)}", LINE, subsequent_indent="    ")
        for words in section.words:
            lines += ["", *textwrap.wrap(words, LINE)]
        if section.table:
            lines += ["", *table_text(section.heads, section.table)]
    return lines


def captioned(picture, title):
    """Heading above and caption below the picture, as wide as it is; taken off again, since its figure may be drawn elsewhere."""
    figure = picture.figure
    letters = max(40, int(figure.get_figwidth() * LETTERS_PER_INCH))
    return [
        figure.text(0.0, 1.0 + GAP / figure.get_figheight(), title, ha="left", va="bottom", fontsize=13, weight="bold"),
        figure.text(0.0, -GAP / figure.get_figheight(), textwrap.fill(picture.caption, letters), ha="left", va="top", fontsize=10),
    ]


def write_pdf(file, title, sections):
    """Pages of text, then a page for every picture with its caption, in its own size."""
    lines = text_lines(title, sections)
    with PdfPages(file, metadata={"Title": on_one_line(title), "CreationDate": None}) as pdf:
        for begin in range(0, len(lines), PAGE):
            page = plt.figure(figsize=PAPER)
            page.text(0.08, 0.95, "\n".join(lines[begin : begin + PAGE]), va="top", family="monospace", fontsize=8.5, linespacing=1.35)
            pdf.savefig(page)
            plt.close(page)
        for section in sections:
            for picture in section.pictures:
                words = captioned(picture, section.title)
                pdf.savefig(picture.figure, bbox_inches="tight", pad_inches=0.3, dpi=200)
                for one in words:
                    one.remove()
