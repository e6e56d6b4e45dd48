#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and numbers of a run: report.py RUN_DIR writes RUN_DIR/report/index.md and its PNG files.

The field picture shows the last state as deformed particles, pressure at the left and plastic strain at the
right; in axisymmetry the left half is the mirror image.
"""
import argparse
import contextlib
import json
import os
import pathlib
import sys
import warnings

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from join_exodus import as_one_file, files_of
from matplotlib.collections import PolyCollection
from netCDF4 import Dataset, chartostring
from uniform_cells import error_text

PLASTIC_STRAIN = ("equivalent_plastic_strain", "plastic_strain")
MILLI, MICRO, MEGA = 1e-3, 1e-6, 1e6


class Fault(Exception):
    """What keeps a report from being made, as the part of a sentence in brackets."""


def on_one_line(text):
    return " ".join(str(text).split())


@contextlib.contextmanager
def reading(file):
    """Whatever goes wrong with what a file holds is said of the file: a run that was killed, or a copy that was cut off,
    leaves anything."""
    try:
        yield
    except OSError as error:
        raise Fault(f"{file.name} cannot be read: {on_one_line(error.strerror or error)}") from error
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError, ValueError) as error:
        raise Fault(f"{file.name} is truncated or was changed: {on_one_line(error)[:200]}") from error


@contextlib.contextmanager
def written(file):
    """A name to write under, which becomes the file when all is there; a link that somebody laid there is not followed."""
    aside = file.with_name(f".{file.name}.tmp{file.suffix}")
    try:
        aside.unlink(missing_ok=True)
        os.close(os.open(aside, os.O_CREAT | os.O_EXCL | os.O_WRONLY | os.O_NOFOLLOW, 0o666))
        yield aside
        aside.replace(file)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise Fault(f"{file.name} cannot be written: {on_one_line(error.strerror or error)}") from error


def save(figure, file):
    with written(file) as aside:
        figure.savefig(aside, dpi=130, bbox_inches="tight")
    plt.close(figure)


class Fields:
    """The last step of particles.e: corners of the particles that exist, and their variables."""

    def __init__(self, file):
        data = Dataset(file)
        data.set_auto_mask(False)
        self.time = float(data.variables["time_whole"][-1])
        elements = len(data.dimensions["num_elem"])
        x = data.variables["coordx"][:] + data.variables["vals_nod_var1"][-1]
        y = data.variables["coordy"][:] + data.variables["vals_nod_var2"][-1]
        corners = np.stack([x, y], axis=1).reshape(elements, -1, 2)
        self.names = [
            str(t).split("\0")[0].strip()
            for t in np.atleast_1d(chartostring(data.variables["name_elem_var"][:]))
        ]
        self.sizes = [
            len(data.dimensions[f"num_el_in_blk{b + 1}"])
            if f"num_el_in_blk{b + 1}" in data.dimensions
            else 0
            for b in range(len(data.dimensions["num_el_blk"]))
        ]
        self.data = data
        self.alive = self.variable("status") > 0.5
        self.corners = corners[self.alive]

    def variable(self, name):
        """Values of all elements; nan in blocks that do not carry it."""
        parts = []
        for b, size in enumerate(self.sizes):
            key = f"vals_elem_var{self.names.index(name) + 1}eb{b + 1}" if name in self.names else ""
            has = size > 0 and key in self.data.variables
            parts.append(self.data.variables[key][-1] if has else np.full(size, np.nan))
        return np.concatenate(parts)

    def of_alive(self, names):
        """The first of the names that each block has."""
        values = np.full(len(self.alive), np.nan)
        for name in names:
            found = self.variable(name)
            values = np.where(np.isnan(values), found, values)
        return values[self.alive]


class Table(dict):
    """Columns by their names; one that a file lacks is said of the file."""

    def __init__(self, file, columns):
        super().__init__(columns)
        self.file = file

    def __missing__(self, name):
        raise Fault(f"{self.file.name} lacks the column '{name}'")

    def last_row(self):
        return Table(self.file, {name: values[-1] for name, values in self.items()})


def read_csv(file):
    """A table of numbers under a header, comments left out. A run that was killed may have left half a line at the end, which
    is left out too; line ends of other systems are line ends."""
    file = pathlib.Path(file)
    with reading(file):
        lines = file.read_bytes().decode("utf-8").replace("\r\n", "\n").split("\n")
    rows = [(number, line.strip().split(",")) for number, line in enumerate(lines[:-1], 1) if line.strip() and not line.startswith("#")]
    if len(rows) < 2:
        raise Fault(f"{file.name} contains no row of numbers")
    header = rows[0][1]
    values = []
    for number, cells in rows[1:]:
        if len(cells) != len(header):
            raise Fault(f"line {number} of {file.name} has {len(cells)} columns instead of {len(header)}")
        try:
            values.append([float(cell) for cell in cells])
        except ValueError as error:
            raise Fault(f"line {number} of {file.name} contains something that is not a number: {on_one_line(error)[:100]}") from error
    table = np.array(values, float)
    return Table(file, {name: table[:, i] for i, name in enumerate(header)})


def draw_half(axes, corners, values, colours, limits):
    if corners.shape[1] == 1:
        return axes.scatter(
            corners[:, 0, 0], corners[:, 0, 1], c=values, s=1, cmap=colours,
            vmin=limits[0], vmax=limits[1],
        )
    shapes = PolyCollection(corners, array=values, cmap=colours, edgecolors="none", linewidths=0)
    shapes.set_clim(*limits)
    # Lines between neighbours would show through the gaps of antialiasing.
    shapes.set_antialiased(False)
    axes.add_collection(shapes)
    return shapes


def areas_of(corners):
    if corners.shape[1] < 4:
        return np.ones(len(corners))
    first, second = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    return 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


def limits_of(values, areas, percent):
    """Colour range that leaves out 100 - percent of the picture at each end: a jet in pieces has single particles
    under thousands of times the pressure of the rock."""
    finite = np.isfinite(values)
    if not finite.any():
        return 0.0, 1.0
    order = np.argsort(values[finite])
    share = np.cumsum(areas[finite][order]) / areas[finite].sum()
    at = lambda part: values[finite][order][min(np.searchsorted(share, part), len(order) - 1)]
    lower, upper = min(0.0, at(1.0 - 0.01 * percent)), at(0.01 * percent)
    return lower, upper if upper > lower else lower + 1.0


def draw_fields(run, summary, folder):
    with as_one_file(run / "particles.e") as file:
        fields = Fields(file)
    if len(fields.corners) == 0:
        raise ValueError("its last step has no particle")
    mirrored = summary.get("mode", "axisymmetric") == "axisymmetric"
    corners = fields.corners / MILLI
    pressure = fields.of_alive(["pressure"]) / MEGA
    plastic = fields.of_alive(PLASTIC_STRAIN)
    width = np.ptp(corners[:, :, 0]) * (2.0 if mirrored else 1.0)
    height = max(np.ptp(corners[:, :, 1]), 1e-12)
    tall = 9.0
    panels = 1 if mirrored else 2
    size = (panels * min(14.0, max(3.5, tall * width / height)) + 3.0, tall)
    figure, axes = plt.subplots(1, panels, figsize=size, squeeze=False, layout="constrained")
    left, right = axes[0, 0], axes[0, -1]
    for one in {left, right}:
        one.set_facecolor("0.85")
        one.set_aspect("equal")
        one.set_xlabel("r [mm]" if mirrored else "x [mm]")
        one.set_ylabel("y [mm]")
    mirror = np.array([-1.0, 1.0]) if mirrored else np.ones(2)
    a = draw_half(left, corners * mirror, pressure, "viridis", limits_of(pressure, areas_of(corners), 99.0))
    # A block without plastic strain (elastic material) is drawn as zero.
    b = draw_half(right, corners, np.nan_to_num(plastic), "inferno", limits_of(plastic, areas_of(corners), 98.0))
    for one in {left, right}:
        one.autoscale_view()
        if summary.get("jet", {}).get("direction", -1.0) > 0.0:
            one.invert_yaxis()  # a jet is drawn going down
    for bar, one, side, label in (
        (a, left, "left", "pressure [MPa]"),
        (b, right, "right", "plastic strain [-]"),
    ):
        scale = figure.colorbar(bar, ax=one, location=side, label=label, shrink=0.5, pad=0.1, extend="both")
        scale.solids.set_edgecolor("face")
    left.set_title(f"t = {fields.time / MICRO:.4g} µs")
    save(figure, folder / "fields.png")


def draw_depth(run, folder):
    """Returns the last row of depth.csv, or nothing for a run without a jet."""
    if not (run / "depth.csv").exists():
        return {}
    table = read_csv(run / "depth.csv")
    time = table["time"] / MICRO
    figure, axes = plt.subplots(1, 2, figsize=(11, 4))
    axes[0].plot(time, table["depth"] / MILLI, label="deepest jet material")
    axes[0].plot(time, table["channel_depth"] / MILLI, label="open channel")
    axes[0].set_ylabel("depth [mm]")
    axes[0].legend()
    axes[1].plot(time, table["tip_velocity"], label="velocity of the deepest jet material")
    axes[1].set_ylabel("velocity [m/s]")
    axes[1].legend()
    for one in axes:
        one.set_xlabel("time [µs]")
        one.grid(alpha=0.3)
    save(figure, folder / "depth.png")
    return table.last_row()


def draw_energy(run, summary, folder):
    """What was put in went into these; the rest is the error of the balance."""
    table = read_csv(run / "history.csv")
    time = table["time"] / MICRO
    energy = summary.get("balances", {}).get("energy", {})
    kept = ("kinetic", "elastic", "plastic", "viscous", "removed_kinetic")
    # Lost between particles and grid, and by stress integration: drawn as the loss that it is.
    numerical = -(table["transfer"] + table["stress_integration"])
    parts = [table[name] for name in kept] + [numerical]
    labels = [name.replace("_", " ") for name in kept] + ["numerical loss"]
    start = energy.get("initial_kinetic", table["kinetic"][0]) + energy.get("prestress", 0.0)
    put_in = start + table["launched_kinetic"] + table["boundary_work"]
    figure, axes = plt.subplots(2, 1, figsize=(8, 7), sharex=True, height_ratios=(3, 1))
    axes[0].stackplot(time, np.clip(parts, 0.0, None), labels=labels, alpha=0.85)
    axes[0].plot(time, put_in, "k--", label="put in")
    axes[0].set_ylabel("energy [J]")
    axes[0].legend(loc="upper left", fontsize=8)
    axes[1].plot(time, 100.0 * table["energy_error"], "k")
    axes[1].set_ylabel("energy error [%]")
    axes[1].set_xlabel("time [µs]")
    axes[1].grid(alpha=0.3)
    save(figure, folder / "energy.png")
    return table.last_row()


def table_lines(rows):
    lines = ["| | |", "|---|---|"]
    cell = lambda text: on_one_line(text).replace("|", "\\|")
    lines += [f"| {cell(name)} | {cell(value)} |" for name, value in rows]
    return lines + [""]


def count_text(cells):
    text = f"{cells:.2g}"
    return f"{text} cell" if text == "1" else f"{text} cells"


def depth_text(depth, penetration):
    """The depth with its interval: of a convergence study of the deck, or else the error that was measured with cells of that size."""
    if depth["depth"] <= 0.0:
        return "none: the jet has hit no target"
    text = f"{depth['depth'] / MILLI:.2f} mm"
    study, error = penetration.get("convergence"), penetration.get("depth_error", {})
    if study:
        cells = ", ".join(f"{size / MILLI:.3g}" for size in sorted(study["cells"], reverse=True))
        what = "grid convergence index" if study["extrapolated"] is not None else "spread, without an order"
        text += f"; {study['low'] / MILLI:.1f} to {study['high'] / MILLI:.1f} mm by cells of {cells} mm ({what})"
    if "value" in error:
        text += f"; error from the cells {error_text(error)}, at {count_text(error['cells_per_radius'])} per jet radius as {error['source']}"
    elif "unknown" in error:
        text += f"; error from the cells unknown: {error['unknown']}"
    return text


def resolution_rows(penetration):
    cells = penetration.get("cells_per_radius")
    if not cells:
        return []
    return [("cells per radius of the jet at impact", f"{cells['least']:.3g} to {cells['most']:.3g} (tip {cells['tip']:.3g}, tail {cells['tail']:.3g})")]


def index_text(run, summary, history, depth):
    title = on_one_line(summary.get("title") or run.name)
    state = "finished" if summary.get("finished") else summary.get("reason", "not finished")
    rows = [("deck", summary.get("deck", "")), ("result", state)]
    rows += [("time", f"{history['time'] / MICRO:.4g} µs"), ("steps", f"{history['step']:.0f}")]
    rows += [("particles", f"{history['particles']:.0f}")]
    if depth:
        rows += [
            ("depth", depth_text(depth, summary.get("penetration", {}))),
            *resolution_rows(summary.get("penetration", {})),
            ("open channel", f"{depth['channel_depth'] / MILLI:.2f} mm"),
            ("channel radius at half depth", f"{depth['channel_radius_mid'] / MILLI:.2f} mm"),
            ("jet mass inside", f"{depth['jet_mass_inside'] * 1e3:.3f} g"),
        ]
    energy = summary.get("balances", {}).get("energy", {})
    if "transfer_share" in energy:
        integration, transfer = (100.0 * energy[name] for name in ("stress_integration_share", "transfer_share"))
        rows.append(
            (
                "numerical energy error of the method, added (+) or lost (-)",
                f"{integration + transfer:+.2g} % of the energy put in (stress integration {integration:+.2g} %, "
                f"transfer between particles and grid {transfer:+.2g} %)",
            )
        )
    errors = (history[f"{name}_error"] for name in ("energy", "mass", "momentum"))
    rows.append(("balances, including these errors, close to", "energy {:+.2e}, mass {:+.1e}, axial momentum {:+.1e}".format(*errors)))
    removed = sum(value for name, value in history.items() if name.startswith("removed_"))
    removed -= history["removed_kinetic"]
    rows += [("particles removed", f"{removed:.0f}"), ("held", f"{history['held']:.0f}")]
    if "wall_seconds" in summary:
        ranks = "1 rank" if summary["ranks"] == 1 else f"{summary['ranks']} ranks"
        rows.append(("wall time", f"{summary['wall_seconds']:.1f} s on {ranks}"))
        rows.append(("per particle-step", f"{summary['ns_per_particle_step']:.0f} ns"))
        rows.append(("state per particle", f"{summary['bytes_per_particle']:.0f} bytes"))
    lines = [f"# {title}", ""] + table_lines(rows) + ["![fields](fields.png)", ""]
    if depth:
        lines += ["![depth](depth.png)", ""]
    lines += ["![energy](energy.png)", ""]
    if summary.get("phases"):
        lines += ["## Phases", ""]
        lines += table_lines((n, f"{p['seconds']:.2f} s") for n, p in summary["phases"].items())
    return "\n".join(lines)


def read_summary(file):
    """What a run said of itself; nothing while it runs, or if it was killed."""
    if not file.exists():
        return {}
    with reading(file):
        summary = json.loads(file.read_text(encoding="utf-8"))
        if not isinstance(summary, dict):
            raise ValueError("it is not a JSON object")
        return summary


def make_report(run):
    """Writes the page and its pictures. @return the page  @raises Fault"""
    summary = read_summary(run / "summary.json")
    if not (run / "history.csv").exists():
        raise Fault("it contains no history.csv; give the folder of a run")
    try:
        files_of(run / "particles.e")
    except OSError as error:
        raise Fault(on_one_line(error)) from error
    folder = run / "report"
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise Fault(f"{folder.name} cannot be made there: {error.strerror}") from error
    with reading(run / "particles.e"):
        draw_fields(run, summary, folder)
    with reading(run / "depth.csv"):
        depth = draw_depth(run, folder)
    with reading(run / "history.csv"):
        history = draw_energy(run, summary, folder)
    with reading(run / "summary.json"):
        text = index_text(run, summary, history, depth)
    with written(folder / "index.md") as aside:
        aside.write_text(text, encoding="utf-8")
    return folder / "index.md"


def main():
    parser = argparse.ArgumentParser(description="Pictures and numbers of a run.")
    parser.add_argument("run", type=pathlib.Path, help="run folder")
    run = parser.parse_args().run
    warnings.simplefilter("ignore")  # of what is drawn: numbers that are none leave gaps
    try:
        page = make_report(run)
    except Fault as fault:
        print(f"barreno: cannot report on '{on_one_line(run)}' ({fault}).", file=sys.stderr)
        return 2
    print(f"{page} and its pictures")
    return 0


if __name__ == "__main__":
    sys.exit(main())
