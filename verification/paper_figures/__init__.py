# SPDX-License-Identifier: BSD-3-Clause
"""The figures of docs/paper.md, a file for each: what is run, tabulated and drawn, and the trend that must hold.

A figure has TABLES, the names of its files in verification/results, measure(lab), which runs, draws and returns {name: Table}, and
trends(tables), which judges tables alone, so that results of an earlier run can be judged too. DRAWN, where there is one, are its pictures
that need tables alone.
"""
import importlib

FIGURES = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10)


def figure(number):
    return importlib.import_module(f"paper_figures.figure_{number}")
