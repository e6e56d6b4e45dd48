# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and numbers of a run, as a page and as a film (docs/report.md)."""
