# SPDX-License-Identifier: BSD-3-Clause
"""Data and model of every test in one picture."""

import pathlib

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.usetex"] = False
matplotlib.rcParams["text.parse_math"] = False  # names of files are drawn letter by letter
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402
from matplotlib.ticker import FormatStrFormatter, NullFormatter  # noqa: E402

from barreno.fit.kinds import DIMENSIONS, KINDS  # noqa: E402

MODEL, SECOND = "tab:red", "tab:blue"


def scaled(name, values):
    dimension = DIMENSIONS[name]
    if name == "bulk_modulus":
        return values / 1e9, "bulk modulus [GPa]"
    unit = {"stress": (1e6, "MPa"), "strain": (0.01, "%"), "ratio": (1.0, "-")}[dimension]
    return values / unit[0], f"{name.replace('_', ' ').replace('poissons', 'Poisson')} [{unit[1]}]"


def title_of(test):
    side = f", {test.confinement / 1e6:.4g} MPa" if test.kind == "triaxial" else ""
    return f"{test.kind.replace('poisson', 'Poisson')}{side}\n{pathlib.Path(test.file).name}"


def draw_curve(axes, test, answer):
    """Stress over the strain that drives the test; a second channel on the axis at the right."""
    x, label = scaled(KINDS[test.kind].control, test.columns[KINDS[test.kind].control])
    axes.set_xlabel(label)
    for i, name in enumerate(test.channels):
        panel, colour = (axes, MODEL) if i == 0 else (axes.twinx(), SECOND)
        data, label = scaled(name, test.columns[name])
        panel.plot(x, data, "o", ms=3, mfc="none", mec="0.35" if i == 0 else SECOND, mew=0.7, alpha=1.0 if i == 0 else 0.6, label="data")
        panel.plot(x, scaled(name, answer[name])[0], "-", color=colour, lw=1.4, label="model")
        panel.set_ylabel(label, color="black" if i == 0 else colour)


def draw_table(axes, test, answer):
    name = test.channels[0]
    data, label = scaled(name, test.columns[name])
    model = scaled(name, answer[name])[0]
    control = KINDS[test.kind].control
    x, x_label = scaled(control, test.columns[control]) if control else (numpy.arange(1, test.rows + 1.0), "row of the file")
    if x.min() > 0.0 and x.max() > 30.0 * x.min():
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(FormatStrFormatter("%g"))
        axes.xaxis.set_minor_formatter(NullFormatter())
    order = numpy.argsort(x)
    axes.errorbar(x, data, yerr=test.uncertainty * data, fmt="o", ms=4, color="0.35", mfc="none", elinewidth=0.8, capsize=2, label="data")
    axes.plot(x[order], model[order], "s:" if control else "s", ms=4, lw=1.0, color=MODEL, label="model")
    axes.set_xlabel(x_label)
    axes.set_ylabel(label)
    axes.set_ylim(0.0, 1.12 * max((data * (1.0 + test.uncertainty)).max(), model.max()))
    if not control:
        axes.set_xticks(x)
        axes.set_xlim(0.5, test.rows + 0.5)


def columns(count):
    """Panels in a row: few rows, few empty places."""
    return min((3, 4), key=lambda across: -count % across) if count > 4 else {4: 2}.get(count, count)


def draw(file, tests, answers):
    across = columns(len(tests))
    down = -(-len(tests) // across)
    figure, panels = pyplot.subplots(down, across, figsize=(4.2 * across, 3.4 * down), squeeze=False, layout="constrained")
    for axes, test, answer in zip(panels.flat, tests, answers):
        (draw_curve if KINDS[test.kind].curve else draw_table)(axes, test, answer)
        axes.set_title(title_of(test), fontsize=9)
        axes.grid(True, lw=0.3, color="0.85")
    for axes in panels.flat[len(tests):]:  # fmt: skip
        axes.set_visible(False)
    panels.flat[0].legend(fontsize=8, frameon=False)
    figure.savefig(file, format="png", dpi=130)
    pyplot.close(figure)
