# SPDX-License-Identifier: BSD-3-Clause
"""A deck with several values of its parameters: runs, a table and pictures (docs/sweep.md)."""
