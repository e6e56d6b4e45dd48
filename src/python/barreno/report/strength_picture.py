# SPDX-License-Identifier: BSD-3-Clause
"""Pressure-shear map: where the rock at the tip of the hole stands in its strength."""

import numpy as np

from barreno.report.hole import jet_particles
from barreno.report.legends import place_legends
from barreno.report.particles import offsets
from barreno.report.strength import strength_of, surface_of
from barreno.runs.plots import plt

MILLI, MEGA = 1e-3, 1e6
NEAR = 8.0  # cells: distance from the tip within which rock is shown


def rock_near(frame, deck, tip, distance):
    """{material: (p, q, distance, e)} of particles with pores near a point (x, y); p less the pore pressure, where there is one."""
    away = np.hypot(*offsets(frame.centres, tip))
    e = frame.of_alive(["plastic_volume_strain"])
    p, q = frame.of_alive(["pressure"]) - np.nan_to_num(frame.of_alive(["pore_pressure"])), frame.of_alive(["shear_stress"])
    found = {}
    for block in np.unique(frame.block):
        keep = (frame.block == block) & (away <= distance) & np.isfinite(e) & ~jet_particles(frame, deck)
        if keep.any():
            found[frame.file.block_names[block]] = (p[keep], q[keep], away[keep], e[keep])
    return found


def draw_surface(axes, strength, most):
    p, q = strength.curve(0.0, most)
    axes.plot(p / MEGA, q / MEGA, "k-", lw=1.3, label="yield surface of virgin rock")
    if strength.angled:
        axes.plot(p / MEGA, strength.shape(60.0) * q / MEGA, "k:", lw=1.3, label="the same in triaxial extension")
    if np.isfinite(strength.hydrostatic_strength(0.0)):
        p, q = strength.curve(-np.inf, most)
        axes.plot(p / MEGA, q / MEGA, "k--", lw=1.0, label="pores closed: no cap")


def draw_points(axes, found, deck, most):
    """Particles and their surfaces up to a pressure. @return what a colour bar needs"""
    lowest, highest, points = 0.0, MEGA, None
    for name, (p, q, _, e) in found.items():
        span = max(float(np.percentile(np.abs(e), 90.0)), 1e-6)
        points = axes.scatter(p / MEGA, q / MEGA, c=e, s=10, cmap="RdBu", vmin=-span, vmax=span, edgecolors="0.4", linewidths=0.3,
            rasterized=True)
        # The legend's point has no colour, which would be that of the first particle.
        without = "" if strength_of(deck, name) else "; its surface is not drawn"
        axes.scatter([], [], c="w", s=10, edgecolors="0.4", linewidths=0.8, label=f"{name} ({len(p)} particles{without})")
        lowest, highest = min(lowest, float(p.min())), max(highest, float(q[p <= most].max(initial=0.0)))
        strength = strength_of(deck, name)
        if strength:
            draw_surface(axes, strength, 1.2 * most)
    axes.set(xlim=(max(lowest, -0.1 * most) / MEGA - 0.03 * most / MEGA, 1.05 * most / MEGA), ylim=(0.0, 1.15 * highest / MEGA))
    axes.grid(alpha=0.3)
    return points


def low_pressure(found, deck):
    """Twice the pressure that crushes virgin rock, for a closer look; 0 where no card says it."""
    strengths = [strength_of(deck, name) for name in found]
    crush = [-one.hydrostatic_strength(0.0) / 3.0 for one in strengths if one]
    return 2.0 * max((p for p in crush if np.isfinite(p)), default=0.0)


def surface_words(found, deck):
    """What the picture leaves out: a sentence for each rock without a surface."""
    reasons = {name: surface_of(deck, name)[1] for name in found}
    return [f"{name}: {why}, so its surface is not drawn." for name, why in reasons.items() if why]


def strength_figure(deck, found, wet, tip, distance):
    """@param found  of rock_near  @param wet  whether there are pore pressures"""
    most, low = max(float(p.max()) for p, *_ in found.values()), low_pressure(found, deck)
    parts = [low, most] if 0.0 < low < 0.7 * most else [max(most, low)]
    figure, panels = plt.subplots(1, len(parts), figsize=(1.5 + 5.0 * len(parts), 4.6), layout="constrained", squeeze=False)
    for axes, part in zip(panels[0], parts):
        points = draw_points(axes, found, deck, max(part, MEGA))
        axes.set(xlabel="effective pressure p - pore pressure [MPa]" if wet else "pressure p [MPa]", ylabel="√J₂ [MPa]")
    if len(parts) > 1:
        panels[0, 0].set_title("up to twice the crushing pressure of virgin rock", fontsize=10)
        panels[0, 1].set_title("all", fontsize=10)
    figure.colorbar(points, ax=panels[0, -1], label="plastic volume strain: crushed < 0 < dilated", extend="both")
    figure.suptitle(f"rock within {distance / MILLI:.3g} mm of the tip at y = {tip[1] / MILLI:.4g} mm", fontsize=11)
    place_legends(panels[0, -1], fontsize=8)
    return figure
