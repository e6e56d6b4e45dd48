# SPDX-License-Identifier: BSD-3-Clause
"""Pressure and shear stress as one colour, with the legend in their plane (paraview/view.py has the same inks)."""

import numpy as np
from matplotlib.colors import ListedColormap

from barreno.runs.plots import plain_log

PRESSURES, SHEARS = (30.0, 3000.0), (10.0, 600.0)  # MPa: from white to full ink, logarithmic


def ink(value, ends):
    """0 to 1 on a logarithmic scale."""
    return np.clip(np.log(np.maximum(value, 1e-9) / ends[0]) / np.log(ends[1] / ends[0]), 0.0, 1.0)


def colour_of(pressure, shear):
    """Four inks: cyan of the pressure, magenta of the shear stress, black of both, yellow of tension; MPa."""
    cyan, magenta = ink(pressure, PRESSURES), ink(shear, SHEARS)
    yellow, black = (np.asarray(pressure) < 0.0).astype(float), 0.45 * cyan * magenta
    return np.clip(np.stack([1.0 - 0.9 * cyan, 1.0 - 0.85 * magenta, 1.0 - 0.9 * yellow], axis=-1), 0.0, 1.0) * (1.0 - black)[..., None]


def draw_inks(axes):
    """The legend: colours in the plane of pressure and shear stress."""
    pressure, shear = np.geomspace(PRESSURES[0] / 3.0, PRESSURES[1], 120), np.geomspace(SHEARS[0] / 2.0, SHEARS[1], 120)
    colours = colour_of(*np.meshgrid(pressure, shear))
    number = np.arange(colours[..., 0].size).reshape(colours.shape[:2])
    axes.pcolormesh(pressure, shear, number, cmap=ListedColormap(colours.reshape(-1, 3)), vmin=-0.5, vmax=number.size - 0.5,
        rasterized=True)
    axes.set(xscale="log", yscale="log", xlim=(pressure[0], pressure[-1]), ylim=(shear[0], shear[-1]), xlabel="pressure [MPa]",
        ylabel="√J₂ [MPa]", title="colours (tension: yellow)")
    plain_log(axes.xaxis, axes.yaxis)
