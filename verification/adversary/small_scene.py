# SPDX-License-Identifier: BSD-3-Clause
"""A deck with so few cells that a run of it takes a tenth of a second."""
import functools
import math

from adversary.deck_tree import metres

# Cells of the box, by its dimensions.
MOST = {2: 2500, 3: 1000}
LEAST = 24
OPEN = "1 mm"  # where a deck with a jet leaves its cells open: the radius of tungsten_154.csv's thinnest slug


def box_of(deck):
    """Lower corner and edges, and the edge of a cell, in metres."""
    lower, upper = metres(deck.value("Grid/Lower")), metres(deck.value("Grid/Upper"))
    return lower, [b - a for a, b in zip(lower, upper)], metres(deck.value("Grid/Cell Size") or OPEN)[0]


def cell_sizes(deck):
    """Edges of cells that divide the box and give it not too many and not too few of them."""
    _, edges, size = box_of(deck)
    cells = [round(edge / size) for edge in edges]
    coarsest = functools.reduce(math.gcd, cells)
    sizes = []
    for times in range(1, 200):
        count = math.prod(times * n // coarsest for n in cells)
        if LEAST <= count <= MOST[len(edges)]:
            sizes.append(edges[0] / (times * cells[0] // coarsest))
    return sizes


def enlarge_box(deck, rng):
    """Cells of a size that does not divide the box, which ends at whole ones."""
    lower, edges, _ = box_of(deck)
    count = math.exp(rng.uniform(math.log(LEAST), math.log(MOST[len(edges)])))
    size = (math.prod(edges) / count) ** (1.0 / len(edges))
    upper = [a + math.ceil(edge / size) * size for a, edge in zip(lower, edges)]
    deck.set("Grid/Cell Size", f"{size!r} m")
    deck.set("Grid/Upper", "{" + ", ".join(f"{b!r} m" for b in upper) + "}")


def shrink(deck, rng):
    """Another cell size that divides the box, if there is one."""
    sizes = cell_sizes(deck)
    if not sizes or rng.random() < 0.1:
        return enlarge_box(deck, rng)
    # Coarse ones are cheap and no less likely to go wrong.
    weights = [1.0 / (1.0 + i) for i in range(len(sizes))]
    chosen = float(rng.choice(sizes, p=[w / sum(weights) for w in weights]))
    return deck.set("Grid/Cell Size", f"{chosen!r} m")
