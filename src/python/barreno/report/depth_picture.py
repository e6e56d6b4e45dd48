# SPDX-License-Identifier: BSD-3-Clause
"""Depth against time with its interval, the rate at which it grows, and the share of the jet that is spent."""

import numpy as np

from barreno.report.legends import place_legends
from barreno.runs.plots import plt

MILLI, MICRO, KILO = 1e-3, 1e-6, 1e3


def draw_depth(axes, table, interval):
    time = table["time"] / MICRO
    axes.plot(time, table["depth"] / MILLI, label="deepest jet material")
    axes.plot(time, table["channel_depth"] / MILLI, "--", label="open channel (whole cells)")
    if "probed_depth" in table:
        axes.plot(time, table["probed_depth"] / MILLI, ":", label="as wide as the jet's widest slug")
    if interval:
        low, high, words = interval
        axes.errorbar([time[-1]], [0.5 * (low + high) / MILLI], [[0.5 * (high - low) / MILLI]], fmt="none", ecolor="k", capsize=5,
            label=words, clip_on=False)
    axes.set_ylabel("depth [mm]")


def draw_rate(axes, time, rate, window):
    axes.plot(time / MICRO, rate / KILO, color="C2")
    axes.set_ylabel("rate of depth [km/s]")
    axes.set_ylim(bottom=min(0.0, np.nanmin(rate, initial=0.0) / KILO))
    axes.set_title(f"least squares over windows of {window / MICRO:.3g} µs", fontsize=9)


def draw_shares(axes, shares):
    time, spent, stopped = np.array(shares).T
    axes.plot(time / MICRO, 100.0 * spent, "o-", ms=3, color="C3", label="can no longer reach the bottom of the hole")
    axes.plot(time / MICRO, 100.0 * stopped, "s--", ms=3, color="0.3", label="stopped")
    axes.set_ylabel("share of the launched jet's mass [%]")
    axes.set_ylim(bottom=0.0)


def depth_figure(table, interval, time, rate, window, shares):
    """@param time, rate, window  of depth_and_rate; @param shares  of jet_shares"""
    panels = 1 + bool(len(time)) + bool(len(shares))
    figure, axes = plt.subplots(1, panels, figsize=(1.0 + 4.3 * panels, 4.0), layout="constrained", squeeze=False)
    axes = list(axes[0])
    draw_depth(axes[0], table, interval)
    if len(time):
        draw_rate(axes[1], time, rate, window)
    if len(shares):
        draw_shares(axes[-1], shares)
    for one in axes:
        one.set_xlabel("time [µs]")
        one.set_xlim(left=0.0)
        one.grid(alpha=0.3)
    place_legends(*axes, fontsize=8)
    return figure
