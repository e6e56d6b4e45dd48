# SPDX-License-Identifier: BSD-3-Clause
"""Runs at hand side by side, with differences against the first (docs/sweep.md)."""
