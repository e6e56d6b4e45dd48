# SPDX-License-Identifier: BSD-3-Clause
"""What commands need that make several runs of a deck or read several run folders: converge, sweep, compare."""
