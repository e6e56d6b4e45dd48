# SPDX-License-Identifier: BSD-3-Clause
"""A deck with cells of several sizes: order, limit and interval of a result (docs/converge.md)."""
