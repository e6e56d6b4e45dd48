# SPDX-License-Identifier: BSD-3-Clause
"""Inputs of other codes as decks: barreno import-ups."""
