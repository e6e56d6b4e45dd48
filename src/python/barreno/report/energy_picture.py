# SPDX-License-Identifier: BSD-3-Clause
"""Where the energy that was put in went, by term; the rest is the error of the balance."""

import numpy as np

from barreno.report.legends import place_legends
from barreno.report.run_tables import energies
from barreno.runs.plots import plt

MICRO, KILO = 1e-6, 1e3
ALWAYS = ("kinetic", "elastic", "plastic")


def parts_of(table):
    """[(name, values)] of what the energy went into; terms that a deck has nothing of are left out."""
    kept = [name for name in energies("held") if name in ALWAYS or np.any(table.get(name, 0.0))]
    # Lost between particles and grid, and by stress integration: a loss, so that all parts add up to what was put in.
    loss = -sum(table[name] for name in energies("numerical"))
    return [*((name.replace("_", " "), table[name]) for name in kept), ("numerical loss", loss)]


def put_in(table, summary):
    """Energy at the start, of the jet, work of forces, and what pore fluid brought; history.csv has no columns for the start."""
    start = {"initial_kinetic": table["kinetic"][0], **summary.get("balances", {}).get("energy", {})}
    return sum(table.get(name, start.get(name, 0.0)) for name in energies("supplied", "worked", "exchanged"))


def energy_terms(table, summary):
    """Rows: every term at the end and its share of what was put in."""
    total = float(put_in(table, summary)[-1])
    share = lambda value: f", {100.0 * value / total:.3g} %" if total else ""  # noqa: E731
    return [("put in", f"{total:.5g} J"), *((name, f"{values[-1]:.5g} J{share(values[-1])}") for name, values in parts_of(table))]


def energy_figure(table, summary):
    time, parts = table["time"] / MICRO, parts_of(table)
    figure, axes = plt.subplots(2, 1, figsize=(8, 7), sharex=True, height_ratios=(3, 1), layout="constrained")
    axes[0].stackplot(time, np.clip([values / KILO for _, values in parts], 0.0, None), labels=[name for name, _ in parts], alpha=0.85)
    axes[0].plot(time, put_in(table, summary) / KILO, "k--", label="put in")
    axes[0].set_ylabel("energy [kJ]")
    axes[1].plot(time, 100.0 * table["energy_error"], "k")
    axes[1].set_ylabel("remainder of\nthe ledger [%]")
    axes[1].set_xlabel("time [µs]")
    for one in axes:
        one.grid(alpha=0.3)
        one.set_xlim(time[0], time[-1] if time[-1] > time[0] else time[0] + 1.0)
    place_legends(axes[0], fontsize=8)
    return figure
