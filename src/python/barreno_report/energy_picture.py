# SPDX-License-Identifier: BSD-3-Clause
"""Where the energy that was put in went, by term; the rest is the error of the balance."""

import matplotlib.pyplot as plt
import numpy as np

MICRO = 1e-6
KEPT = ("kinetic", "elastic", "plastic", "viscous", "friction", "removed_kinetic", "damped")


def energy_figure(table, summary):
    time = table["time"] / MICRO
    energy = summary.get("balances", {}).get("energy", {})
    # Terms that a deck has nothing of are left out of the legend.
    kept = [name for name in KEPT if name in ("kinetic", "elastic", "plastic") or np.any(table.get(name, 0.0))]
    # Lost between particles and grid, and by stress integration: drawn as the loss that it is.
    numerical = -(table["transfer"] + table["stress_integration"])
    parts = [table[name] for name in kept] + [numerical]
    start = energy.get("initial_kinetic", table["kinetic"][0]) + energy.get("prestress", 0.0)
    put_in = start + table["launched_kinetic"] + table["boundary_work"] + table.get("body_work", 0.0)
    figure, axes = plt.subplots(2, 1, figsize=(8, 7), sharex=True, height_ratios=(3, 1), layout="constrained")
    axes[0].stackplot(time, np.clip(parts, 0.0, None), labels=[name.replace("_", " ") for name in kept] + ["numerical loss"], alpha=0.85)
    axes[0].plot(time, put_in, "k--", label="put in")
    axes[0].set_ylabel("energy [J]")
    axes[0].legend(loc="upper left", fontsize=8)
    axes[1].plot(time, 100.0 * table["energy_error"], "k")
    axes[1].set_ylabel("remainder of\nthe ledger [%]")
    axes[1].set_xlabel("time [µs]")
    for one in axes:
        one.grid(alpha=0.3)
        one.set_xlim(time[0], time[-1] if time[-1] > time[0] else time[0] + 1.0)
    return figure
