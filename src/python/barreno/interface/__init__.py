# SPDX-License-Identifier: BSD-3-Clause
"""What `import barreno` offers: runs, decks, sweeps (docs/python.md). It calls the other parts of the package."""
