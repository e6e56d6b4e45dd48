# SPDX-License-Identifier: BSD-3-Clause
"""A card of Arenisca from laboratory tests: python3 -m barreno.fit DATA... --out CARD.xml (docs/fit.md).

Every answer of the rock comes from the library, through barreno.materials; scipy.optimize.least_squares is the optimiser. Read
next: command.py. Inside, as in a laboratory, compression is positive; units are SI and strains logarithmic.
"""
