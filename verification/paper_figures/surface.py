# SPDX-License-Identifier: BSD-3-Clause
"""Arenisca's card, and its yield surface in principal stress space. Compression is positive here."""
import xml.etree.ElementTree as xml

import matplotlib.pyplot as plt
import numpy as np
from barreno.report.principal import revolved
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

MEGA = 1e6


def card_numbers(card):
    """{parameter: value} of a card, SI."""
    found = {}
    for entry in xml.parse(card).getroot().iter("Parameter"):
        try:
            found[entry.get("name")] = float(entry.get("value"))
        except ValueError:
            continue
    for name in ("STREN", "YSLOPE", "FSLOPE", "p0_crush_curve", "p1_crush_curve"):
        found.setdefault(name, 0.0)
    found.setdefault("CR", 0.5)
    return found


def draw_surface(axes, strength, plastic, alpha, points=120, most=np.inf):
    """The surface at a plastic volume strain, in MPa, in 3D axes. @return what a colour bar needs"""
    p, q = strength.curve(plastic, most, 2000)
    # Points close to each other at the vertex and at the cap, where the meridian is steep.
    place = 0.5 * (1.0 - np.cos(np.linspace(0.0, np.pi, points)))
    at = np.interp(place, np.linspace(0.0, 1.0, len(p)), np.arange(len(p)))
    p, q = (np.interp(at, np.arange(len(p)), values) / MEGA for values in (p, q))
    x, y, z = revolved(p, q)
    norm = Normalize(0.0, q.max())
    colours = plt.get_cmap("viridis")(norm(np.repeat(q[:, None], x.shape[1], axis=1)))
    axes.plot_surface(x, y, z, facecolors=colours, rstride=1, cstride=1, linewidth=0.0, antialiased=False, alpha=alpha, shade=True)
    end = p.max()
    axes.plot([-0.1 * end, 1.15 * end], [-0.1 * end, 1.15 * end], [-0.1 * end, 1.15 * end], "k-.", lw=1.0)
    axes.set(xlabel=r"$\sigma_1$ [MPa]", ylabel=r"$\sigma_2$ [MPa]", zlabel=r"$\sigma_3$ [MPa]")
    axes.yaxis.set_major_locator(MaxNLocator(3))  # seen from its end: no room for more
    axes.set_box_aspect((1.0, 1.0, 1.0))
    axes.view_init(elev=18.0, azim=-68.0)
    return ScalarMappable(norm, "viridis")
