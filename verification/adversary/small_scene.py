# SPDX-License-Identifier: BSD-3-Clause
"""A deck with so few cells that a run of it takes a tenth of a second."""
import functools
import math

from deck_tree import metres

# Cells of the box, at most and at least.
MOST = {2: 2500, 3: 2500}
LEAST = 24


def cell_sizes(deck):
    """Edges of cells, in metres, that divide the box and give it not too many and not too few of them."""
    lower, upper = metres(deck.value("Grid/Lower")), metres(deck.value("Grid/Upper"))
    (size,) = metres(deck.value("Grid/Cell Size"))
    edges = [b - a for a, b in zip(lower, upper)]
    cells = [round(edge / size) for edge in edges]
    coarsest = functools.reduce(math.gcd, cells)
    sizes = []
    for times in range(1, 200):
        count = math.prod(times * n // coarsest for n in cells)
        if LEAST <= count <= MOST[len(edges)]:
            sizes.append(edges[0] / (times * cells[0] // coarsest))
    return sizes


def shrink(deck, rng):
    """Another cell size, if the box allows one; else a box that ends at whole cells of twice, three times ... the size."""
    sizes = cell_sizes(deck)
    if sizes:
        # Coarse ones are cheap and no less likely to go wrong.
        weights = [1.0 / (1.0 + i) for i in range(len(sizes))]
        deck.set("Grid/Cell Size", repr(float(rng.choice(sizes, p=[w / sum(weights) for w in weights]))) + " m")
