# SPDX-License-Identifier: BSD-3-Clause
"""Matplotlib, as every picture of the commands has it. A text is drawn letter by letter: names of materials, bodies, decks and folders come
from the user, and Matplotlib would read what stands between two dollar signs in them as a formula. No other file imports pyplot
(tests/layout/check_pictures.py)."""

import warnings

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.usetex"] = False
matplotlib.rcParams["text.parse_math"] = False
warnings.filterwarnings("ignore", module="matplotlib")  # a letter that the font lacks is drawn as a box

import matplotlib.pyplot as plt  # noqa: E402, F401
from matplotlib.ticker import LogFormatter  # noqa: E402


class PlainLog(LogFormatter):
    """Numbers at a logarithmic axis; the usual ones are formulas."""

    def _num_to_string(self, x, vmin, vmax):
        return f"{x:g}"


def plain_log(*axes_of):
    """Numbers of logarithmic axes, or of a bar of colours, as plain text."""
    for axis in axes_of:
        axis.set_major_formatter(PlainLog(10.0, labelOnlyBase=False))
        axis.set_minor_formatter(PlainLog(10.0, labelOnlyBase=False))
