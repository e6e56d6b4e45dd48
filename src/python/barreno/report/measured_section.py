# SPDX-License-Identifier: BSD-3-Clause
"""The section on a measured hole: both walls in the same axes, and their difference in numbers (measured.json)."""

import json

import numpy as np

from barreno.report.files import write_text
from barreno.report.legends import place_legends
from barreno.report.section import Picture, Section
from barreno.report.wall import MEASURED
from barreno.runs.faults import Fault
from barreno.runs.plots import plt

MILLI = 1e-3


def rows_below(hole, start):
    """Depth over which each open row of the run counts below a start [m]: half a cell, and more for the first one."""
    middle, half = hole.depth[: hole.open_rows], 0.25 * hole.cell
    low = np.concatenate([[0.0], middle[1:] - half])
    return np.clip(middle + half - np.maximum(low, start), 0.0, None)


def volume_below(hole, start):
    """Of the run's hole below a depth [m3], of a slot per thickness [m2]; of the whole hole it is Hole.volume."""
    radius = np.where(np.isfinite(hole.radius), hole.radius, 0.0)[: hole.open_rows]
    return float(np.sum((2.0 * radius if hole.plane else np.pi * radius**2) * rows_below(hole, start)))


def common_rows(hole, measured):
    """Rows of the run that both holes have."""
    depth, radius = hole.depth[: hole.open_rows], hole.radius[: hole.open_rows]
    keep = np.isfinite(radius) & (np.arange(len(depth)) >= hole.first_row) & (depth >= measured.start) & (depth <= measured.end)
    return depth[keep], radius[keep]


def differences(hole, measured):
    """Numbers in SI; a difference is the run less the measurement, None where the two share no depth."""
    depth, radius = common_rows(hole, measured)
    apart = radius - measured.radius_at(depth)
    largest = int(np.abs(apart).argmax()) if len(apart) else None
    volumes = volume_below(hole, measured.start), (measured.area_below if hole.plane else measured.volume_below)(measured.start)
    return {
        "file": measured.name, "run_depth": hole.length, "measured_depth": measured.end, "depth_difference": hole.length - measured.end,
        "compared_from": float(depth[0]) if len(depth) else None, "compared_to": float(depth[-1]) if len(depth) else None,
        "compared_rows": len(depth), "radius_mean_difference": float(apart.mean()) if len(apart) else None,
        "radius_rms_difference": float(np.sqrt(np.mean(apart**2))) if len(apart) else None,
        "radius_largest_difference": float(apart[largest]) if len(apart) else None,
        "radius_largest_difference_at": float(depth[largest]) if len(apart) else None, "volume_from": measured.start,
        "run_volume": volumes[0], "measured_volume": volumes[1], "volume_difference": volumes[0] - volumes[1],
    }  # fmt: skip


def share_text(part, whole):
    return f" ({100.0 * part / whole:+.1f} %)" if whole else ""


def rows_of(found, plane):
    unit, scale = ("mm2 per thickness", MILLI**2) if plane else ("cm3", 1e-6)
    rows = [
        ("measured hole", found["file"]),
        ("depth", f"{found['run_depth'] / MILLI:.2f} mm in the run, {found['measured_depth'] / MILLI:.2f} mm measured: "
            f"{found['depth_difference'] / MILLI:+.2f} mm{share_text(found['depth_difference'], found['measured_depth'])}"),
        (f"volume below {found['volume_from'] / MILLI:.2f} mm", f"{found['run_volume'] / scale:.4g} {unit} in the run, "
            f"{found['measured_volume'] / scale:.4g} {unit} measured: {found['volume_difference'] / scale:+.3g} {unit}"
            f"{share_text(found['volume_difference'], found['measured_volume'])}"),
    ]
    if found["compared_rows"]:
        rows += [
            ("radius, rms difference", f"{found['radius_rms_difference'] / MILLI:.3f} mm over depths from "
                f"{found['compared_from'] / MILLI:.2f} to {found['compared_to'] / MILLI:.2f} mm (mean "
                f"{found['radius_mean_difference'] / MILLI:+.3f} mm)"),
            ("radius, largest difference", f"{found['radius_largest_difference'] / MILLI:+.3f} mm at a depth of "
                f"{found['radius_largest_difference_at'] / MILLI:.2f} mm"),
        ]
    return rows


WORDS = (
    "Differences are the run less the measurement. Radii are compared in the rows of profile.csv that both holes have; a measured hole is "
    "a cone between two of its rows. Volumes count from the first measured depth to the end of each hole. measured.json has the same "
    "numbers in SI units."
)


def measured_figure(hole, measured):
    figure, (wall, apart) = plt.subplots(2, 1, figsize=(11.0, 5.6), height_ratios=(3, 1.4), sharex=True, layout="constrained")
    rows = hole.open_rows
    radius = np.where(np.isfinite(hole.radius[:rows]), hole.radius[:rows], np.nan)
    wall.plot(np.append(hole.depth[:rows], hole.length) / MILLI, np.append(radius, 0.0) / MILLI, "k-", lw=1.0, label="run")
    depth, radius = np.append(measured.depth, measured.end), np.append(measured.radius, measured.radius[-1])
    wall.plot(depth / MILLI, radius / MILLI, "--", color=MEASURED, lw=1.6, label=f"measured ({measured.name})")
    wall.set(ylabel="half width [mm]" if hole.plane else "radius [mm]", ylim=(0.0, None), xlim=(0.0, None))
    depth, radius = common_rows(hole, measured)
    apart.axhline(0.0, color="k", lw=0.8)
    apart.plot(depth / MILLI, (radius - measured.radius_at(depth)) / MILLI, color=MEASURED, lw=1.0)
    apart.set(xlabel="depth below the outer face [mm]", ylabel="run - measured\n[mm]")
    for axes in (wall, apart):
        axes.grid(alpha=0.3)
    place_legends(wall, fontsize=9)
    return figure


def measured_section(hole, measured, folder):
    """@param folder  where measured.json is written  @raises Fault  for a run without a hole"""
    if hole is None or hole.open_rows == 0:
        raise Fault("--measured: the run has no hole in its target at that time; choose a later --time, or leave --measured out.")
    found = differences(hole, measured)
    write_text(folder / "measured.json", json.dumps(found, indent=1) + "\n")
    picture = Picture("measured", measured_figure(hole, measured), "The run's hole and the measured one, and their difference.")
    return Section("Measured hole", rows_of(found, hole.plane), [WORDS], [picture])
