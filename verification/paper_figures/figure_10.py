# SPDX-License-Identifier: BSD-3-Clause
"""Figure 10: Weibull modulus with several seeds, scale effect alone and no variation; in two rocks."""
import matplotlib.pyplot as plt
import numpy as np
from paper_figures import spall
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS, DECK, draw_channels, measured, settings_of, sound

TABLES = ("paper_10", "paper_10_spall")
MODULI, SEEDS = (1.0, 2.0, 4.0), (1, 2, 3)
STRONGER = 3.0  # strength of a particle, on average, over that of the card: the scale effect, the same for every modulus
CONFINEMENT = 69.0  # MPa
ROCK = "Materials/Sandstone"
# PEAKI1 is what varies. In Berea it is the cohesion, a few MPa; here it carries the strength at all pressures, about that of Berea at 1
# GPa.
COHESIVE = {f"{ROCK}/STREN": "0", f"{ROCK}/YSLOPE": "0", f"{ROCK}/FSLOPE": "0.03", f"{ROCK}/PEAKI1": "4 GPa"}
ROCKS = {"Berea": ({}, STRONGER), "cohesive": (COHESIVE, 1.0)}
NONE, SCALE = "no variation", "scale only"


def weibull(modulus, factor, cells, seed=0, scatter="random"):
    """Settings under which particles are `factor` times as strong as the card on average, for any modulus: a particle's cube is half a cell
    wide."""
    volume = (0.5e-3 * cells) ** 3 * factor**modulus
    words = {"modulus": f"{modulus:g}", "reference volume": f"{volume:.6g} m3", "seed": str(seed), "scatter": scatter}
    return {f"{ROCK}/Weibull {name}": value for name, value in words.items()}


def cases(form):
    """[(rock, what, seed, settings)]"""
    out, cells = [], CELLS[form]
    for rock, (card, factor) in ROCKS.items():
        moduli, seeds = ((1.0,), SEEDS[:1]) if form == "quick" else (MODULI, SEEDS)
        out += [(rock, f"m = {m:g}", seed, {**card, **weibull(m, factor, cells, seed)}) for m in moduli for seed in seeds]
        if rock == "Berea" and form != "quick":
            out.append((rock, SCALE, 0, {**card, **weibull(MODULI[-1], factor, cells, 0, SCALE)}))
        out.append((rock, NONE, 0, card))
    return out


def measure(lab):
    cells, asked = CELLS[lab.form], cases(lab.form)
    names = [f"weibull-{rock}-{what.replace(' = ', '').replace(' ', '-')}-{seed}" for rock, what, seed, _ in asked]
    until = lab.of_form({"Time/End Time": "60 us"}, {})
    folders = lab.runs([(DECK, settings_of(cells, CONFINEMENT, {**more, **until}), name) for (*_, more), name in zip(asked, names)])
    rows = []
    for (rock, what, seed, _), folder in zip(asked, folders):
        shot = measured(folder)
        rows.append([rock, what, float(seed), shot.early, shot.depth, shot.volume, shot.lost])
    remark = f"Figure 10: input_xml/paper/{DECK}, cells of {cells:g} mm, {CONFINEMENT:g} MPa of confinement; depth: the greatest of 100 us"
    table = Table(remark, ["rock", "variation", "seed", "depth at 30 us [mm]", "depth [mm]", "hole [cm3]", "numerical energy"], rows)
    if lab.form != "quick":
        draw_pictures(lab, table, asked, folders)
        return {"paper_10": table, "paper_10_spall": spall.compare(lab, 10, CONFINEMENT, spall_cases(cells))}
    return {"paper_10": table}


def spall_cases(cells):
    """{rock: settings}: the cohesive one, with the largest scatter and without."""
    modulus, factor = MODULI[0], ROCKS["cohesive"][1]
    return {f"cohesive, m = {modulus:g}": {**COHESIVE, **weibull(modulus, factor, cells, SEEDS[0])}, f"cohesive, {NONE}": COHESIVE}


def draw_pictures(lab, table, asked, folders):
    first = [i for i, (rock, _, seed, _) in enumerate(asked) if rock == "cohesive" and seed <= SEEDS[0]]
    channels = [(f"{words_of(asked[i][1])}\n{table.rows[i][4]:.1f} mm deep", folders[i]) for i in first]
    fields, limits = ("pressure", "plastic_volume_strain"), ((0.0, 300.0), (-0.2, 0.2))
    draw_channels(lab.picture("paper_10"), channels, fields, limits, (24.0, -8.0, 80.0))
    draw_depths(lab.picture("paper_10_depth"), table)


def words_of(what):
    return what.replace("m =", "Weibull modulus")


def depths(table, rock, what):
    return table.column("depth [mm]", rock=rock, variation=what)


def draw_depths(file, table):
    figure, panels = plt.subplots(1, len(ROCKS), figsize=(10.0, 4.0), layout="constrained")
    for axes, rock in zip(panels, ROCKS):
        kinds = list(dict.fromkeys(table.column("variation", rock=rock)))
        for i, what in enumerate(kinds):
            found = depths(table, rock, what)
            axes.plot(np.full(len(found), i), found, "o", color="C0", ms=5, alpha=0.8, label=None if i else "one seed")
            axes.plot([i - 0.2, i + 0.2], [found.mean()] * 2, color="k", lw=1.2, label=None if i else "mean of the seeds")
        middle = 0.5 * (max(table.column("depth [mm]", rock=rock)) + min(table.column("depth [mm]", rock=rock)))
        axes.set(title=f"{rock} rock", ylim=(0.95 * middle, 1.05 * middle), xlim=(-0.5, len(kinds) - 0.5))
        axes.set_xticks(range(len(kinds)), kinds, fontsize=9)
        axes.set_xlabel("Weibull modulus m: scatter falls to the right")
        axes.grid(axis="y", alpha=0.3)
    panels[0].set_ylabel("greatest depth [mm]")
    panels[0].legend(fontsize=8)
    figure.savefig(file, dpi=110)
    plt.close(figure)


DRAWN = {"paper_10_depth": lambda file, tables: draw_depths(file, tables["paper_10"])}  # of the tables alone


def trends(tables):
    table = tables["paper_10"]
    means = lambda rock, kinds: [float(depths(table, rock, what).mean()) for what in kinds]  # noqa: E731
    most_scattered, none = means("cohesive", (f"m = {MODULI[0]:g}", NONE))
    out = [least("10: strength carried by PEAKI1: depth, largest scatter over none", most_scattered / none, 1.005)]
    if not len(table.column("seed", variation=SCALE)):
        scattered, even = means("Berea", (f"m = {MODULI[0]:g}", NONE))
        out.append(most("10: Berea (against the paper, no increase): depth, largest scatter over none, difference",
            abs(scattered / even - 1.0), 0.02))
    else:
        falling = means("cohesive", (*(f"m = {m:g}" for m in MODULI), NONE))
        spread = max(float(np.ptp(depths(table, "cohesive", f"m = {m:g}"))) for m in MODULI)
        berea = means("Berea", (*(f"m = {m:g}" for m in MODULI), SCALE))
        out += [
            least("10: cohesive rock: fall of the depth from one modulus to the next [mm]", -np.diff(falling).max(), 0.1),
            least("10: cohesive rock: whole fall over the largest difference of seeds",
                (falling[0] - falling[-1]) / max(spread, 1e-9), 2.0),
            most("10: Berea, all moduli and scale only (against the paper, no increase): largest difference of depth, relative",
                max(berea) / min(berea) - 1.0, 0.02),
        ]
    return [*out, sound(table, 10)]
