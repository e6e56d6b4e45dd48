# SPDX-License-Identifier: BSD-3-Clause
"""The picture: the quantity over time for every level, and over the cell size at the end."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def label_of(name):
    """The quantity with its unit."""
    length = name.split(".")[-1] in ("depth", "channel_depth", "channel_radius_mid") or name.endswith("_radius")
    return f"{name} [m]" if length else f"{name} [SI]"


def draw_over_time(axes, name, levels, series, rows):
    for level, (time, values) in reversed(list(zip(levels, series))):
        axes.plot(1e6 * time, values, lw=1.2, label=f"cells of {1e3 * level.cells:.4g} mm")
    for i, (time, _, verdict) in enumerate(rows):
        label = {} if i else {"label": "interval"}
        axes.errorbar(1e6 * time, verdict.value, [[verdict.value - verdict.low], [verdict.high - verdict.value]], fmt="none", ecolor="k", capsize=4, **label)
    axes.set_xlabel("time [µs]")
    axes.set_ylabel(label_of(name))
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)


def draw_over_cells(axes, name, levels, row):
    time, values, verdict = row
    cells = [1e3 * level.cells for level in levels]
    axes.plot(cells, values, "ko-", label="computed")
    label = "interval" if verdict.limit is not None else "spread of the levels"
    axes.axhspan(verdict.low, verdict.high, color="C0", alpha=0.15, label=label)
    if verdict.limit is not None:
        words = f"extrapolated, order {verdict.order_used:.2f}" if verdict.order_used else "extrapolated"
        axes.plot([0.0], [verdict.limit], "C3D", label=words)
    axes.set_xlim(left=-0.05 * max(cells))
    axes.set_xlabel("cell size [mm]")
    axes.set_title(f"at {1e6 * time:.4g} µs", fontsize=10)
    axes.set_ylabel(label_of(name))
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)


def draw(file, name, levels, series, rows):
    """@param series  (times, values) of every level, or None of a number that has no history"""
    both = all(one is not None for one in series)
    figure, axes = plt.subplots(1, 2 if both else 1, figsize=(11 if both else 5.5, 4.2), layout="constrained", squeeze=False)
    if both:
        draw_over_time(axes[0, 0], name, levels, series, rows)
    draw_over_cells(axes[0, -1], name, levels, rows[-1])
    figure.savefig(file, dpi=130, format="png")
    plt.close(figure)
