#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons with arcs, as their particles fill them: the charge and the liner that docs/explosives.md shows (Liners and cases).

    ./barreno python verification/tools/arcs.py build/release/src/barreno docs/pictures/polygon_arcs.png

The bodies are read from the page itself, so that what it shows is what a deck may hold. Corners have their numbers, which `Arcs` counts by;
crosses are the points of the arcs. The rear of the charge is not drawn."""
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from tools.runs import ROOT, run_deck, scratch_folder

PAGE = ROOT / "docs" / "explosives.md"
DECK = """<ParameterList name="Barreno">
  <Parameter name="Schema Version" type="int" value="1"/>
  <ParameterList name="Grid">
    <Parameter name="Mode" type="string" value="axisymmetric"/>
    <Parameter name="Lower" type="string" value="{0 mm, 0 mm}"/>
    <Parameter name="Upper" type="string" value="{24 mm, 60 mm}"/>
    <Parameter name="Cell Size" type="string" value="1 mm"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Comp B"><Parameter name="Card" type="string" value="comp_b"/></ParameterList>
    <ParameterList name="Copper"><Parameter name="Card" type="string" value="copper"/></ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">BODIES</ParameterList>
  <ParameterList name="Detonation">
    <Parameter name="Bodies" type="string" value="{Charge}"/>
    <ParameterList name="Detonators"><ParameterList name="Rear">
      <Parameter name="Kind" type="string" value="point"/>
      <Parameter name="Position" type="string" value="{0 mm, 0 mm}"/>
    </ParameterList></ParameterList>
  </ParameterList>
  <ParameterList name="Conditions"><ParameterList name="Axis">
    <Parameter name="Face" type="string" value="x_lower"/>
    <Parameter name="Kind" type="string" value="symmetry"/>
  </ParameterList></ParameterList>
  <ParameterList name="Time"><Parameter name="End Time" type="string" value="1 ns"/></ParameterList>
</ParameterList>
"""


def bodies_of_page():
    """The lists that the page's section shows, which is what it indents."""
    section = PAGE.read_text().split("## Liners and cases")[1].split("\n## ")[0]
    return "\n".join(line for line in section.splitlines() if line.startswith("    "))


def table_of(body, name):
    """Rows of a table of lengths in mm in a body's list; numbers without a unit stay as they are."""
    text = body.find(f"Parameter[@name='{name}']").get("value")
    rows, columns = map(int, text.split(":")[0].split("x"))
    return np.array([float(cell.split()[0]) for cell in re.search(r"\{(.*)\}", text).group(1).split(",")]).reshape(rows, columns)


def mark(axes, body, colour):
    """Corners with their numbers, points of arcs as crosses."""
    for number, (x, y) in enumerate(table_of(body, "Corners"), 1):
        axes.plot(x, y, "o", ms=4, color=colour, zorder=4)
        below = body.get("name") == "Charge"
        axes.annotate(str(number), (x, y), (7, -11 if below else 5), textcoords="offset points", color=colour, fontsize=9, zorder=5)
    for _, x, y in table_of(body, "Arcs"):
        axes.plot(x, y, "x", ms=8, mew=2, color=colour, zorder=4)


def main():
    barreno, picture = sys.argv[1:]
    text = DECK.replace("BODIES", bodies_of_page())
    deck = pathlib.Path(scratch_folder()) / "arcs.xml"
    deck.write_text(text)
    start = run_deck(pathlib.Path(barreno).resolve(), deck).particles(0)
    gas = np.isfinite(start["burn"])
    figure, axes = plt.subplots(figsize=(5.2, 5.6), layout="constrained")
    for part, colour in ((gas, "#f4d58d"), (~gas, "#c9772f")):
        axes.add_collection(PolyCollection(1e3 * start["corners"][part], facecolor=colour, edgecolor="white", linewidths=0.3))
    for body, colour in zip(xml.fromstring(text).find("ParameterList[@name='Bodies']"), ("#6b5310", "#5a1f00")):
        mark(axes, body, colour)
    axes.set(xlim=(-1.0, 23.0), ylim=(30.0, 58.0), aspect="equal", xlabel="distance from the axis [mm]", ylabel="along the axis [mm]")
    figure.savefig(picture, dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    main()
