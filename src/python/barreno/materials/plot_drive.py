#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a driven point: stress-strain curves, meridional and octahedral path, yield surface.

    plot_drive.py PICTURE < TEXT

`barreno drive --plot` writes the text (src/drive/plot_text.hpp) and runs this; the yield surface in it comes from the
material's own functions. Exit code 3 where a package is missing, 2 where the picture cannot be drawn, with the reason.
"""
import csv  # not pandas: the program starts this file alone, with whatever Python has Matplotlib
import os
import pathlib
import sys

NO_MODULE, NO_PICTURE = 3, 2
MEGA, PERCENT = 1e6, 0.01
ROUND_OFF = 1e-6  # of the largest value
COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "zx")
PATH_COLOUR, TOTAL_COLOUR, INITIAL_COLOUR, CURRENT_COLOUR = "C0", "C9", "0.55", "black"

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.lines import Line2D
except ImportError as error:
    print(f"it needs Python 3 with Matplotlib: {error}", file=sys.stderr)
    sys.exit(NO_MODULE)


class Path:
    """The path in the axes of the material; tensors as rows of xx yy zz xy yz zx, tension positive."""

    def __init__(self, lines):
        table = {name: np.array(column, float) for name, column in columns_of(lines).items()}
        self.tensors = {
            tensor: np.array([table[f"{tensor}_{c}"] for c in COMPONENTS]).T for tensor in ("strain", "stress", "bounded")
        }
        self.pore_pressure = table.get("pore_pressure")
        stress, bounded = self.tensors["stress"], self.tensors["bounded"]
        size = ROUND_OFF * np.abs(stress).max(initial=0.0)
        self.sheared = bool(np.any(np.abs(bounded[:, 3:]) > size))
        self.two_stresses = bool(np.any(np.abs(bounded - stress) > size))  # the surface bounds another one than the total


def columns_of(lines):
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return {} if not rows else {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def read(text):
    """Words of the head, the path, and curves of the yield surface {(state, section): {column: values}}."""
    path_lines, _, surface_lines = (part.splitlines() for part in text.partition("# yield surface\n"))
    words = dict(line[2:].split(": ", 1) for line in path_lines if line.startswith("# "))
    curves = {}
    table = columns_of(surface_lines)
    for i, key in enumerate(zip(table.get("state", []), table.get("section", []))):
        for name in ("lode_angle", "I1", "sqrt_J2"):
            curves.setdefault(key, {}).setdefault(name, []).append(float(table[name][i]))
    return words, Path(path_lines), {key: {n: np.array(v) for n, v in curve.items()} for key, curve in curves.items()}


def trace(tensors):
    return tensors[:, :3].sum(axis=1)


def root_J2(tensors):
    deviator = tensors.copy()
    deviator[:, :3] -= trace(tensors)[:, None] / 3.0
    return np.sqrt(0.5 * (deviator[:, :3] ** 2).sum(axis=1) + (deviator[:, 3:] ** 2).sum(axis=1))


def principal(tensors):
    """Principal values, compression positive and the largest first."""
    full = np.array([[[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]] for xx, yy, zz, xy, yz, zx in tensors])
    return -np.linalg.eigvalsh(full)


def octahedral(a, b, c):
    """Place in the octahedral plane of three normal stresses, a upwards; the distance from the centre is sqrt(J2)."""
    return (b - c) / 2.0, (2.0 * a - b - c) / (2.0 * np.sqrt(3.0))


def ends(axes, x, y, colour):
    """An open circle where the path begins, a full one where it ends."""
    axes.plot(x[0], y[0], "o", mfc="white", mec=colour, zorder=5)
    axes.plot(x[-1], y[-1], "o", color=colour, zorder=5)


def pairs(strain, stress):
    """Components that are equal in strain and stress, as one curve."""
    both = strain / (np.abs(strain).max(initial=0.0) or 1.0), stress / (np.abs(stress).max(initial=0.0) or 1.0)
    found = []
    for i in range(6):
        if i >= 3 and max(np.abs(part[:, i]).max() for part in both) <= ROUND_OFF:
            continue
        for group in found:
            first = group[0]
            if (first < 3) == (i < 3) and all(np.abs(part[:, first] - part[:, i]).max() <= ROUND_OFF for part in both):
                group.append(i)
                break
        else:
            found.append([i])
    return [(group[0], ", ".join(COMPONENTS[i] for i in group)) for group in found]


def draw_components(axes, path):
    strain, stress = path.tensors["strain"], path.tensors["stress"]
    for n, (i, label) in enumerate(pairs(strain, stress)):
        sign = -1.0 if i < 3 else 1.0
        axes.plot(sign * strain[:, i] / PERCENT, sign * stress[:, i] / MEGA, color=f"C{n}", label=label)
    axes.set_xlabel("logarithmic strain [%]")
    axes.set_ylabel("stress [MPa]")
    axes.set_title("components, each against its strain")
    axes.legend(fontsize=8)


def show_no_round_off(axes, shear, path):
    """A hydrostatic path has shear stresses of round-off, which would fill the picture."""
    if shear.max(initial=0.0) <= ROUND_OFF * np.abs(path.tensors["stress"]).max(initial=0.0) / MEGA:
        axes.set_ylim(-0.05, 1.0)


def draw_difference(axes, path):
    strain, difference = path.tensors["strain"], np.sqrt(3.0) * root_J2(path.tensors["stress"]) / MEGA
    for n, (i, label) in enumerate(pairs(strain, path.tensors["stress"])):
        axes.plot((-1.0 if i < 3 else 1.0) * strain[:, i] / PERCENT, difference, color=f"C{n}", label=label)
    axes.plot(-trace(strain) / PERCENT, difference, "k--", lw=1, label="volume")
    show_no_round_off(axes, difference, path)
    axes.set_xlabel("logarithmic strain [%]")
    axes.set_ylabel(r"stress difference $\sqrt{3 J_2}$ [MPa]")
    axes.set_title("stress difference against each strain")
    axes.legend(fontsize=8)


def draw_volume(axes, path):
    volume = -trace(path.tensors["strain"]) / PERCENT
    axes.plot(volume, -trace(path.tensors["stress"]) / 3.0 / MEGA, color="C0", label="mean stress")
    if path.pore_pressure is not None:
        axes.plot(volume, (-trace(path.tensors["stress"]) / 3.0 - path.pore_pressure) / MEGA, color="C2", label="mean effective stress")
        axes.plot(volume, path.pore_pressure / MEGA, color="C3", ls="--", label="pore pressure")
    if np.abs(volume).max(initial=0.0) <= ROUND_OFF * np.abs(path.tensors["strain"]).max(initial=0.0) / PERCENT:
        axes.set_xlim(-1.0, 1.0)  # shear keeps the volume up to round-off
    axes.set_xlabel("volume strain [%]")
    axes.set_ylabel("stress [MPa]")
    axes.set_title("mean stress against volume strain")
    axes.legend(fontsize=8)


def surface_styles(curves):
    """(state, section): colour and line."""
    colours = {"initial": INITIAL_COLOUR, "current": CURRENT_COLOUR}
    return {key: (colours[key[0]], ":" if key[1] == "extension" else "-") for key in curves}


def draw_meridian(axes, words, path, curves):
    bounded, stress = path.tensors["bounded"], path.tensors["stress"]
    pressure = lambda tensors: -trace(tensors) / 3.0 / MEGA
    for (state, section), (colour, line) in surface_styles(curves).items():
        if section == "octahedral":
            continue
        curve = curves[state, section]
        axes.plot(-curve["I1"] / 3.0 / MEGA, curve["sqrt_J2"] / MEGA, color=colour, ls=line, lw=2 if state == "initial" else 1.2)
    if path.two_stresses:
        axes.plot(pressure(stress), root_J2(stress) / MEGA, color=TOTAL_COLOUR, ls="--", lw=1)
    x, y = pressure(bounded), root_J2(bounded) / MEGA
    axes.plot(x, y, color=PATH_COLOUR, lw=1.8)
    ends(axes, x, y, PATH_COLOUR)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(f"$-I_1/3$ of the {words['bounded']} [MPa]")
    axes.set_ylabel(r"$\sqrt{J_2}$ [MPa]")
    axes.set_title("meridional path")


def whole_section(curve):
    """All six parts of a section that is known from triaxial extension to compression."""
    angle = np.radians(60.0 - curve["lode_angle"])[::-1]  # from the axis of compression
    radius = curve["sqrt_J2"][::-1]
    half_angle, half_radius = np.concatenate([angle, 2.0 * np.radians(60.0) - angle[::-1]]), np.concatenate([radius, radius[::-1]])
    turns = [half_angle + n * np.radians(120.0) for n in range(3)]
    angle, radius = np.concatenate(turns), np.tile(half_radius, 3)
    return radius * np.sin(angle), radius * np.cos(angle)


def draw_octahedral(axes, path, curves):
    bounded = path.tensors["bounded"]
    names = ("1", "2", "3") if path.sheared else COMPONENTS[:3]
    normal = principal(bounded).T if path.sheared else -bounded[:, :3].T
    x, y = octahedral(*(normal / MEGA))
    size = np.hypot(x, y).max(initial=0.0)
    for (state, section), (colour, _) in surface_styles(curves).items():
        if section != "octahedral":
            continue
        sx, sy = whole_section(curves[state, section])
        axes.plot(sx / MEGA, sy / MEGA, color=colour, lw=2 if state == "initial" else 1.2)
        size = max(size, np.hypot(sx, sy).max() / MEGA)
    size = 1.15 * size or 1.0
    for n, name in enumerate(names):
        angle = n * np.radians(120.0)
        end = size * np.array([np.sin(angle), np.cos(angle)])
        axes.plot([0.0, end[0]], [0.0, end[1]], color="0.8", lw=0.8, zorder=0)
        axes.annotate(rf"$-\sigma_{{{name}}}$", 1.1 * end, ha="center", va="center", fontsize=9)
    axes.plot(x, y, color=PATH_COLOUR, lw=1.8)
    ends(axes, x, y, PATH_COLOUR)
    axes.set_aspect("equal")
    axes.set_xlim(-1.25 * size, 1.25 * size)
    axes.set_ylim(-1.0 * size, 1.3 * size)
    axes.set_xlabel(r"distance from the centre: $\sqrt{J_2}$ [MPa]")
    axes.set_title("octahedral path")
    at = [curve["I1"][0] for (_, section), curve in curves.items() if section == "octahedral"]
    if at:
        axes.set_title(f"octahedral path\nsurface at $-I_1/3$ = {-at[0] / 3.0 / MEGA:.4g} MPa", fontsize=10)


def legend_lines(words, path, curves):
    lines = [(Line2D([], [], color=PATH_COLOUR, lw=1.8, marker="o"), f"path of the {words['bounded']}")]
    if path.two_stresses:
        lines.append((Line2D([], [], color=TOTAL_COLOUR, ls="--", lw=1), "path of the stress"))
    for state, width, where in (("initial", 2, "first row"), ("current", 1.2, r"last row; octahedral at the largest $\sqrt{J_2}$")):
        colour = {"initial": INITIAL_COLOUR, "current": CURRENT_COLOUR}[state]
        if (state, "compression") in curves:
            lines.append((Line2D([], [], color=colour, lw=width), f"{state} yield surface ({where})"))
    if ("initial", "extension") in curves:
        lines.append((Line2D([], [], color=CURRENT_COLOUR, ls=":"), "dotted: in triaxial extension"))
    return lines


def draw(words, path, curves):
    figure = plt.figure(figsize=(13, 8.6), layout="constrained")
    grid = figure.add_gridspec(3, 6, height_ratios=(1.0, 1.25, 0.12))
    top = [figure.add_subplot(grid[0, 2 * i : 2 * i + 2]) for i in range(3)]
    meridian, plane = figure.add_subplot(grid[1, :4]), figure.add_subplot(grid[1, 4:])
    draw_components(top[0], path)
    draw_difference(top[1], path)
    draw_volume(top[2], path)
    draw_meridian(meridian, words, path, curves)
    draw_octahedral(plane, path, curves)
    for axes in (*top, meridian):
        axes.grid(alpha=0.3)
    lines = legend_lines(words, path, curves)
    words_row = figure.add_subplot(grid[2, :])
    words_row.axis("off")
    words_row.legend(*zip(*lines), loc="center", ncols=2, fontsize=9, frameon=False)
    figure.suptitle(f"{words['title']} (compression positive)", parse_math=False)  # names of the user's: a dollar sign is no formula
    return figure


def save(figure, picture):
    """Written aside and renamed: whole or not at all."""
    aside = picture.with_name(f".{picture.name}.tmp{picture.suffix}")
    try:
        figure.savefig(aside, dpi=120)
        os.replace(aside, picture)
    finally:
        aside.unlink(missing_ok=True)


def main():
    picture = pathlib.Path(sys.argv[1])
    try:
        save(draw(*read(sys.stdin.read())), picture)
    except OSError as error:
        print(error.strerror or error, file=sys.stderr)
        return NO_PICTURE
    return 0


if __name__ == "__main__":
    sys.exit(main())
