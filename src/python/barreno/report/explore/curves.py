# SPDX-License-Identifier: BSD-3-Clause
"""Curves beside the explorable view: depth, speeds and energies against time."""

import numpy as np

from barreno.report.penetration import depth_and_rate

MILLI, MICRO = 1e-3, 1e-6
MOST_ROWS = 600  # of a curve


def thinned(values):
    """Rows for a small picture, the last among them; null where a number is none."""
    every = np.unique(np.rint(np.linspace(0, len(values) - 1, min(len(values), MOST_ROWS))).astype(int))
    return [float(f"{value:.6g}") if np.isfinite(value) else None for value in np.asarray(values, float)[every]]


def plot(title, time, curves):
    """@param curves  {name: values}"""
    return {"title": title, "time": thinned(np.asarray(time) / MICRO), "curves": [{"name": name, "values": thinned(values)}
        for name, values in curves.items()]}


def depth_plots(table):
    time, names = table["time"], {"depth": "depth", "channel_depth": "open channel"}
    if "probed_depth" in table:
        names["probed_depth"] = "as wide as the jet"
    found = [plot("depth [mm]", time, {name: table[column] / MILLI for column, name in names.items()})]
    hit, _, rate, _ = depth_and_rate(table)
    if len(hit):
        found.append(plot("speed [m/s]", time, {"deepest piece of the jet": table["tip_velocity"],
            "rate of the depth": np.interp(time, hit, rate, left=np.nan)}))
    return found


def energy_plot(history):
    energies = {name: history[name] for name in ("kinetic", "elastic", "plastic")}
    unit, size = ("kJ", 1e3) if max(float(np.nanmax(np.abs(values))) for values in energies.values()) >= 1e3 else ("J", 1.0)
    return plot(f"energy [{unit}]", history["time"], {name: values / size for name, values in energies.items()})
