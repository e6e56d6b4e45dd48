# SPDX-License-Identifier: BSD-3-Clause
"""Depth of perforation_120us.xml at 10 us against its cost, with equal cells and with small ones along the jet's path: curves of a picture
of docs/trade.md, from results/levels.json and results/slug_length.json."""
from tools.case_list import stored

FILE = "depth_against_cost.png"
TITLE = "Depth at 10 µs against cost, equal and refined cells"
PICTURE = {"x": "processor time [s]", "y": ["depth at 10 µs [mm]"]}
TIP = 1.0  # mm, radius of the jet's tip
OF_LEVELS = {"1 mm": (1.0, True), "refined to 0.25 mm": (0.25, False), "0.25 mm": (0.25, True)}  # name -> smallest cells [mm], everywhere


def rows(case):
    data = stored(case)
    return [dict(zip(data["columns"], row)) for row in data["rows"]]


def points():
    """(kind, smallest cells [mm], processor time [s], depth [mm])"""
    out = []
    for row in rows("levels"):
        if row["cells"] not in OF_LEVELS:  # with fewer particles
            continue
        cells, everywhere = OF_LEVELS[row["cells"]]
        kind = "equal cells" if everywhere else "small cells along the path"
        out.append((kind, cells, row["processor time [s]"], row["at 10 us [mm]"]))
    for row in rows("slug_length"):
        if row["slugs"] == "as in the table":
            out.append(("small along the path, steps of several lengths", TIP / row["cells per radius"], row["processor time [s]"],
                row["depth [mm]"]))
    return out


def curves():
    """{kind with its cells: [(time, depth)]}"""
    found = points()
    sizes = {kind: ", ".join(f"{cells:g}" for cells in sorted({cells for of, cells, *_ in found if of == kind}, reverse=True))
        for kind, *_ in found}
    out = {}
    for kind, _, seconds, depth in found:
        out.setdefault(f"{kind}: {sizes[kind]} mm", []).append((seconds, depth))
    return {label: sorted(values) for label, values in out.items()}
