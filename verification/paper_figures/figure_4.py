# SPDX-License-Identifier: BSD-3-Clause
"""Figure 4: a thick spherical shell with fluid in its pore, closed form and Arenisca, and Arenisca's surface before and after."""
import math

import matplotlib.pyplot as plt
import numpy as np
from oracles import shell_statics as statics
from barreno.report.strength import Strength
from tools.drive import drive
from paper_figures.lab import MEGA, Table, least, most
from cases.shell_material import DEEPEST, FLUID, VARIANTS, parameters

TABLES = ("paper_4",)
CURVE = "2Y ln phi0"  # crush curve from the shell's porosity, nothing fitted (verification/cases/shell_material.py)
BACK = -0.02  # volume strain to which it is unloaded; closer to 0 pores reopen
DRAINED, UNDRAINED = VARIANTS[0], VARIANTS[1]


def strains():
    down, back = np.linspace(0.0, DEEPEST, 121), np.linspace(DEEPEST, BACK, 101)[1:]
    return np.append(down, back), len(down)


def driven(lab, variant, at):
    """Arenisca with the shell's parameters along these volume strains: pressure, pore pressure, plastic volume strain."""
    rows = [(float(i), np.eye(3) * math.exp(strain / 3.0)) for i, strain in enumerate(at)]
    answer = drive(lab.barreno, "Arenisca", parameters(CURVE, variant), rows, steps=2)
    pressure = -(answer["stress_xx"] + answer["stress_yy"] + answer["stress_zz"]) / 3.0
    return pressure, answer.get("pore_pressure", np.zeros_like(pressure)), answer["plastic_volume_strain"]


def closed_form(variant, at):
    """The shell's pressure, and that of its fluid."""
    rows = statics.curve(statics.Shell(fluid_modulus=variant.fluid), list(at), DEEPEST)
    fluid = np.array([row[4] for row in rows])
    return np.array([row[3] for row in rows]) + fluid, fluid


def measure(lab):
    at, turn = strains()
    rows, curves = [], {}
    for name, variant in (("drained", DRAINED), ("undrained", UNDRAINED)):
        curves[name] = (*closed_form(variant, at), *driven(lab, variant, at))
        shell, fluid, pressure, pore, plastic = curves[name]
        for i in range(0, len(at), 5):
            rows.append([name, "load" if i < turn else "unload", -100.0 * at[i],
                *(float(x) / MEGA for x in (shell[i], fluid[i], pressure[i], pore[i])), -100.0 * plastic[i]])
    draw(lab.picture("paper_4"), at, turn, curves)
    columns = ["rock", "leg", "volume strain [%]", "shell [MPa]", "fluid of the shell [MPa]", "Arenisca [MPa]",
        "pore pressure of Arenisca [MPa]", "plastic volume strain [%]"]
    return {"paper_4": Table("Figure 4: shell of an incompressible matrix (closed form) and Arenisca with its parameters; compression "
        "positive", columns, rows)}


def draw(file, at, turn, curves):
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.0, 4.8), layout="constrained")
    x = -100.0 * at
    for name, colour in (("drained", "0.45"), ("undrained", "C3")):
        shell, fluid, pressure, pore, _ = curves[name]
        left.plot(x, shell / MEGA, color=colour, lw=1.8, label=f"shell, {name}: closed form")
        left.plot(x, pressure / MEGA, color=colour, ls="--", lw=1.8, label=f"Arenisca, {name}")
        if name == "undrained":
            left.plot(x, fluid / MEGA, color="C0", lw=1.4, label="fluid in the shell's pore")
            left.plot(x, pore / MEGA, color="C0", ls="--", lw=1.4, label="Arenisca, pore pressure")
    left.axhline(0.0, color="k", lw=0.5)
    left.set(xlabel="volume strain [%], compression positive", ylabel="pressure [MPa]", title="Hydrostatic load and unload")
    left.grid(alpha=0.3)
    left.legend(fontsize=8.5, loc="upper left")
    _, _, _, pore, plastic = curves["undrained"]
    draw_surfaces(right, plastic[turn - 1], pore[turn - 1])
    figure.savefig(file, dpi=110)
    plt.close(figure)


def draw_surfaces(axes, plastic, pore):
    """Meridians in total stress: of the virgin rock, hardened by the crushing alone, and moved by the pore pressure."""
    card = {name: float(value) for name, value in parameters(CURVE, UNDRAINED).items()}
    strength = Strength(lambda name: card.get(name, 0.5 if name == "CR" else 0.0))
    states = (
        (0.0, 0.0, {"color": "0.45"}, "before"),
        (plastic, 0.0, {"color": "C3", "ls": ":"}, "crushed, without the pore pressure"),
        (plastic, pore, {"color": "C3"}, f"after loading to {-100.0 * DEEPEST:.0f} %"),
    )
    for e, shift, style, name in states:
        p, q = strength.curve(e, np.inf)
        axes.plot((p + shift) / MEGA, q / MEGA, lw=1.8, label=name, **style)
    low = axes.get_ylim()[1]
    axes.annotate("", (pore / MEGA, 0.03 * low), (0.0, 0.03 * low), arrowprops={"arrowstyle": "->", "color": "C0", "lw": 1.6})
    axes.annotate(f"pore pressure {pore / MEGA:.0f} MPa", (0.5 * pore / MEGA, 0.045 * low), ha="center", color="C0", fontsize=9)
    axes.set(xlabel="pressure (total) [MPa]", ylabel=r"$\sqrt{J_2}$ [MPa]", title="Arenisca's yield surface, meridian",
        ylim=(0.0, 1.3 * low))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9, loc="upper left")


def trends(tables):
    table = tables["paper_4"]
    out = []
    # At the knee, which is round for a shell that yields from its inner wall outwards and sharp for a crush curve.
    for name, limit in (("drained", 0.1), ("undrained", 0.03)):
        shell, rock = (table.column(column, rock=name, leg="load") for column in ("shell [MPa]", "Arenisca [MPa]"))
        out.append(most(f"4: {name}, load: Arenisca less closed form, over the largest pressure",
            np.abs(rock - shell).max() / shell.max(), limit))
    wet, dry = (table.column("Arenisca [MPa]", rock=name, leg="load").max() for name in ("undrained", "drained"))
    pore = table.column("pore pressure of Arenisca [MPa]", rock="undrained", leg="load")
    out += [
        least("4: deepest strain: pressure, with fluid over without", wet / dry, 1.5),
        least("4: load: least increment of pore pressure (grows)", np.diff(pore).min(), 0.0),
        least("4: deepest strain: pore pressure over total pressure", pore[-1] / wet, 0.2),
    ]
    fluid = [table.column(column, rock="undrained") for column in ("fluid of the shell [MPa]", "pore pressure of Arenisca [MPa]")]
    out.append(most("4: load and unload: pore pressure less that of the shell's fluid, over the largest",
        np.abs(fluid[1] - fluid[0]).max() / pore.max(), 0.01))
    return out
