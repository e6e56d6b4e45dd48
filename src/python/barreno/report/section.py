# SPDX-License-Identifier: BSD-3-Clause
"""What a report consists of, whatever it is printed on."""

import dataclasses


@dataclasses.dataclass
class Picture:
    name: str  # of its file, without .png
    figure: object  # of Matplotlib
    caption: str = ""


@dataclasses.dataclass
class Section:
    title: str
    rows: list = dataclasses.field(default_factory=list)  # (name, value)
    words: list = dataclasses.field(default_factory=list)  # paragraphs
    pictures: list = dataclasses.field(default_factory=list)
    heads: tuple = ()  # of a table with several columns
    table: list = dataclasses.field(default_factory=list)
