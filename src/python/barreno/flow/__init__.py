# SPDX-License-Identifier: BSD-3-Clause
"""How much flows through the rock into the hole of a run (docs/flow.md)."""
