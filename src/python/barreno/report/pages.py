# SPDX-License-Identifier: BSD-3-Clause
"""Sections as Markdown, as one HTML page that needs no network, and as a PDF."""

import base64
import html
import textwrap

from matplotlib.backends.backend_pdf import PdfPages

from barreno.runs.faults import on_one_line
from barreno.runs.plots import plt
from barreno.runs.regular_file import read_bytes

STYLE = """body { font: 15px/1.45 sans-serif; color: #222; max-width: 62em; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.2em; margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1em 0; } td, th { padding: .2em .8em .2em 0; vertical-align: top; text-align: left; border-bottom: 1px solid #eee; }
body > table { display: block; overflow-x: auto; }
figure { margin: 1em 0; } figure img { max-width: 100%; max-height: 60em; } figcaption { color: #555; max-width: 50em; }"""
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


def html_table(heads, rows):
    head = "<tr>" + "".join(f"<th>{html.escape(one)}</th>" for one in heads) + "</tr>\n" if any(heads) else ""
    body = "".join("<tr>" + "".join(f"<td>{html.escape(on_one_line(cell))}</td>" for cell in row) + "</tr>\n" for row in rows)
    return f"<table>\n{head}{body}</table>"


def html_picture(picture, folder):
    data = base64.b64encode(read_bytes(folder / f"{picture.name}.png")).decode("ascii")
    caption = html.escape(picture.caption)
    return f'<figure><img alt="{html.escape(picture.name)}" src="data:image/png;base64,{data}"><figcaption>{caption}</figcaption></figure>'


def as_html(title, sections, folder):
    """@param folder  of the pictures, which the page takes in"""
    name = html.escape(on_one_line(title))
    parts = ['<!DOCTYPE html>\n<html lang="en"><head><meta '
        f'charset="utf-8"><title>{name}</title><style>\n{STYLE}\n</style></head><body>\n<h1>{name}</h1>']
    for section in sections:
        parts += [f"<h2>{html.escape(section.title)}</h2>"] if section.title else []
        parts += [html_table(("", ""), section.rows)] if section.rows else []
        parts += [f"<p>{html.escape(words)}</p>" for words in section.words]
        parts += [html_table(section.heads, section.table)] if section.table else []
        parts += [html_picture(picture, folder) for picture in section.pictures]
    return "\n".join([*parts, "</body></html>\n"])


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
