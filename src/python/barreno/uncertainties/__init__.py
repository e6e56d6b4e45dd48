# SPDX-License-Identifier: BSD-3-Clause
"""How sure an answer is: runs within the ranges of what is known of a deck, intervals, and who contributes what (docs/uncertainty.md)."""
