# SPDX-License-Identifier: BSD-3-Clause
"""The picture: the quantity over time for every level, and over the cell size at the end."""

from barreno.runs.plots import plt

LENGTHS = ("depth", "channel_depth", "probed_depth", "channel_radius_mid", "inner_radius", "outer_radius")
ENERGIES = ("kinetic", "elastic", "plastic", "viscous", "friction", "stress_integration", "transfer", "removed_kinetic", "launched_kinetic",
    "boundary_work",
            "body_work", "fluid_work", "damped", "explosive")  # fmt: skip


def unit_of(name):
    """(unit of the picture, in SI) of a quantity; a name of summary.json has lists in front, one of radii.csv a body."""
    last = name.split(".")[-1]
    if last.endswith(LENGTHS):
        return "mm", 1e-3
    units = {**dict.fromkeys(ENERGIES, "J"), "tip_velocity": "m/s", "jet_mass_inside": "kg"}
    return units.get(last, "SI"), 1.0


def draw_over_time(axes, scale, levels, series, rows):
    for level, (time, values) in reversed(list(zip(levels, series))):
        axes.plot(1e6 * time, values / scale, lw=1.2, label=f"cells of {level.name('mm', 1e-3)}")
    for i, (time, _, verdict) in enumerate(rows):
        label = {} if i else {"label": "interval" if verdict.limit is not None else "spread of the levels"}
        value, low, high = (number / scale for number in (verdict.value, verdict.low, verdict.high))
        axes.errorbar(1e6 * time, value, [[value - low], [high - value]], fmt="none", ecolor="k", capsize=4, **label)
    axes.set_xlabel("time [µs]")
    axes.set_title("over time", fontsize=10)


def draw_over_cells(axes, scale, levels, row):
    time, values, verdict = row
    cells = [1e3 * level.cells for level in levels]
    axes.plot(cells, [value / scale for value in values], "ko-", label="computed")
    label = "interval" if verdict.limit is not None else "spread of the levels"
    axes.axhspan(verdict.low / scale, verdict.high / scale, color="C0", alpha=0.15, label=label)
    if verdict.limit is not None:
        words = f"extrapolated, order {verdict.order_used:.2f}" if verdict.order_used else "extrapolated"
        axes.plot([0.0], [verdict.limit / scale], "C3D", label=words)
    axes.set_xlim(left=-0.05 * max(cells))
    axes.set_xlabel("Grid/Cell Size [mm]")
    axes.set_title(f"over the cell size, at {1e6 * time:.4g} µs", fontsize=10)


def draw(file, name, levels, series, rows):
    """@param series  (times, values) of every level, or None of a number that has no history"""
    both = all(one is not None for one in series)
    unit, scale = unit_of(name)
    figure, axes = plt.subplots(1, 2 if both else 1, figsize=(11 if both else 5.5, 4.2), layout="constrained", squeeze=False)
    if both:
        draw_over_time(axes[0, 0], scale, levels, series, rows)
    draw_over_cells(axes[0, -1], scale, levels, rows[-1])
    for one in axes[0]:
        one.set_ylabel(f"{name} [{unit}]")
        one.legend(fontsize=8)
        one.grid(alpha=0.3)
    figure.savefig(file, dpi=130, format="png")
    plt.close(figure)
