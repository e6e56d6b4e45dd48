# SPDX-License-Identifier: BSD-3-Clause
"""Barreno from Python: the commands that work on runs and decks, and the materials."""
