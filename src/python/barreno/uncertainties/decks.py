# SPDX-License-Identifier: BSD-3-Clause
"""The deck of a run: what its values change, and what must change with them."""

import xml.etree.ElementTree as xml

from barreno.fit.parameters import tie
from barreno.runs.effective_deck import lists_in, value_in
from barreno.runs.faults import Fault

VELOCITY, RADIUS = "Jet/Velocity", "Jet/Radius"  # factors of all slugs, which no parameter of a deck is
FACTORS = (VELOCITY, RADIUS)
ROUNDED = 1.0 - 1e-9  # of cells per radius, so that no rounding asks for cells of half the size


def rows_in(text):
    """Numbers of a table, "154x5:{...}", and the text before them."""
    head, _, body = text.partition("{")
    return head, [float(word) for word in body.rstrip("} ").split(",")]


def cells_of(deck):
    return float(value_in(deck, "Grid/Cell Size"))


def with_cells(deck, size):
    """The effective deck with cells of another size; None leaves them open."""
    root = xml.fromstring(deck)
    grid = next(one for one in root if one.get("name") == "Grid")
    entry = next(one for one in grid if one.get("name") == "Cell Size")
    if size is None:
        grid.remove(entry)
    else:
        entry.set("value", repr(size))
    return xml.tostring(root, encoding="unicode") + "\n"


def cells_for_all(base, least, effective):
    """Size of cells that the thinnest jet needs, where the deck leaves it open; else the deck's. All runs then have the same cells.

    Parameters
    ----------
    least : float
        Smallest factor of radius.
    effective : callable
        Effective deck of the text of a deck.
    """
    if least >= 1.0 or cells_of(effective(with_cells(base, None))) != cells_of(base):
        return cells_of(base)
    return cells_of(effective(with_cells(with_jet(base, 1.0, least, least), None)))


def with_jet(base, velocity, radius, least=1.0):
    """The effective deck with a jet of other velocities and radii from the same origin: slugs keep their length and follow in times that
    are shorter by the factor of velocity. Cells along the path are those of the jet with the least radius: their number per
    radius grows."""
    root = xml.fromstring(base)
    jet = next(one for one in root if one.get("name") == "Jet")
    entries = {entry.get("name"): entry for entry in jet if entry.tag == "Parameter"}
    head, numbers = rows_in(entries["Slugs"].get("value"))
    factors = (1.0 / velocity, velocity, radius, 1.0, 1.0)
    scaled = ", ".join(repr(number * factors[i % 5]) for i, number in enumerate(numbers))
    entries["Slugs"].set("value", f"{head}{{{scaled}}}")
    for name, factor in (("Pieces Below", velocity), ("Cells Per Radius", radius / least * ROUNDED)):
        if name in entries and float(entries[name].get("value")) > 0.0:
            entries[name].set("value", repr(float(entries[name].get("value")) * factor))
    return xml.tostring(root, encoding="unicode") + "\n"


def check_jet(base, ranges):
    """Whether the jet can be varied."""
    varied = next((one for one in ranges if one.path in FACTORS), None)
    if varied is None:
        return
    if value_in(base, "Jet/Slugs") is None:
        raise Fault(f"{varied.where()}: the deck has no Jet; leave the range out, or write --hold Jet.")
    surfaces = [f"{owner}/{name}" for owner in ("Shapes", "Bodies") for name in lists_in(base, owner)
        if value_in(base, f"{owner}/{name}/File") is not None]
    if surfaces:
        raise Fault(f"{varied.where()}: the deck has a surface from a file ({surfaces[0]}), and decks with other jets are written "
            "elsewhere, where that file is not found; write --hold Jet.")


def factors_of(values):
    """@param values  {path: number}"""
    return values.get(VELOCITY, 1.0), values.get(RADIUS, 1.0)


def tied_settings(base, values):
    """The shear modulus of unstressed rock follows its bulk modulus and Poisson's ratio, as the program demands: moduli must not jump at
    zero pressure.  @param values  {path: number}, SI"""
    settings = []
    for material in lists_in(base, "Materials"):
        path = f"Materials/{material}/"
        own = {name: value_in(base, path + name) for name in ("G0", "G1", "B0")}
        if None in own.values() or value_in(base, path + "Model") != "Arenisca" or path + "G0" in values:
            continue
        new = {name: values.get(path + name, float(text)) for name, text in own.items()}
        if any(path + name in values for name in own) and new["G1"] != 0.0:
            settings.append(f"{path}G0={tie(new, ())['G0']:.9g}")
    return settings


def seed_settings(base, run):
    """Rock of scattered strength is drawn anew in each run, so that its scatter is among the answers'."""
    settings = []
    for material in lists_in(base, "Materials"):
        path = f"Materials/{material}/Weibull "
        if float(value_in(base, path + "modulus") or 0.0) > 0.0 and value_in(base, path + "scatter") == "random":
            settings.append(f"{path}seed={int(float(value_in(base, path + 'seed') or 0)) + run}")
    return settings


def settings_of(base, values):
    return [f"{path}={number:.9g}" for path, number in values.items() if path not in FACTORS] + tied_settings(base, values)
