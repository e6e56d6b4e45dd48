# SPDX-License-Identifier: BSD-3-Clause
"""What ends a search of a fit."""


class Rejected(Exception):
    """The library refuses a card or a step that the optimiser tries."""
