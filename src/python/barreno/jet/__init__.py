# SPDX-License-Identifier: BSD-3-Clause
"""The jet of a deck: table, audit, picture, depths by theory (docs/jets.md)."""
