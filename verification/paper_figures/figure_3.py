# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3: hydrostatic load and unload with the data of the card's fit, and the yield surface in principal stress space."""
import matplotlib.pyplot as plt
import numpy as np
from barreno.report.strength import Strength
from barreno.runs.csv_table import WORDS, arrays_of, read_csv
from paper_figures.lab import GIGA, MEGA, PAPER, ROOT, Table, least, most
from paper_figures.surface import card_numbers, draw_surface

TABLES = ("paper_3", "paper_3_curve")
CARD = ROOT / "materials" / "cards" / "berea_sandstone.xml"
DATA = ROOT / "verification" / "fits" / "berea"
PATH = PAPER / "hydrostat.csv"
STEPS = 60  # per row of the path


def driven(lab):
    """The material's answer along the path: pressure and volume strain, both positive in compression."""
    out = lab.folder / "hydrostat.csv"
    lab.program("drive", "--material", CARD, "--path", PATH, "--out", out, "--steps-per-row", STEPS, "--every-step")
    table = arrays_of(read_csv(out))
    pressure = -(table["stress_xx"] + table["stress_yy"] + table["stress_zz"]) / 3.0
    strain = -(table["strain_xx"] + table["strain_yy"] + table["strain_zz"])
    return {"time": table["time"], "pressure": pressure, "strain": strain, "plastic": -table["plastic_volume_strain"]}


def data_rows(name):
    """Rows of a file of the fit, (value, value, ...), and which are read in a source, recalled or assumed."""
    rows = read_csv(DATA / name, cells=WORDS).to_numpy().tolist()
    return [[float(row[0]), float(row[1]), float(row[2]), row[-1].split(";")[-1].strip() if ";" in row[-1] else ""] for row in rows]


def legs(answer):
    """Where the load ends and the unload begins."""
    return int(np.argmax(answer["pressure"]))


def tangent(answer, pressure):
    """Bulk modulus of the loading at a pressure [Pa], from the answer's own steps."""
    top = legs(answer)
    p, e = answer["pressure"][: top + 1], answer["strain"][: top + 1]
    return float(np.interp(pressure, 0.5 * (p[1:] + p[:-1]), np.diff(p) / np.diff(e)))


def crushing(answer):
    """Pressure at which the first plastic volume strain appears [Pa]."""
    first = int(np.argmax(answer["plastic"] > 1e-9))
    return float(answer["pressure"][max(first - 1, 0)])


def measure(lab):
    answer = driven(lab)
    top = legs(answer)
    porosity = 1.0 - np.exp(-card_numbers(CARD)["p3_crush_curve"])
    rows = []
    for pressure, modulus, uncertainty, source in data_rows("bulk_modulus.csv"):
        elastic = pressure * MEGA < crushing(answer)
        rows.append(["bulk modulus [GPa]", pressure, modulus, tangent(answer, pressure * MEGA) / GIGA if elastic else float("nan"),
            uncertainty, source])
    for pressure, left, uncertainty, source in data_rows("open_pores.csv"):
        total = card_numbers(CARD)["p3_crush_curve"]
        found = 100.0 * (1.0 - np.interp(pressure * MEGA, answer["pressure"][: top + 1], answer["plastic"][: top + 1]) / total)
        reached = pressure * MEGA <= answer["pressure"][top]
        rows.append(["pore strain left [%]", pressure, left, float(found) if reached else float("nan"), uncertainty, source])
    rows.append(["crushing pressure [MPa]", float("nan"), 408.1, crushing(answer) / MEGA, 5.0,
        "both blocks brought to the card's porosity"])
    cut = np.unique(np.append(np.linspace(0, len(answer["pressure"]) - 1, 100).astype(int), top))
    curve = [["load" if i <= top else "unload", answer["pressure"][i] / MEGA, 100.0 * answer["strain"][i], 100.0 * answer["plastic"][i]]
        for i in cut]
    draw(lab.picture("paper_3"), answer, rows, porosity)
    columns = ["quantity", "pressure [MPa]", "datum", "card", "uncertainty [%]", "known"]
    remark = "Figure 3: data of the fit (verification/fits/berea) and the card's answer along input_xml/paper/hydrostat.csv"
    of_curve = ["leg", "pressure [MPa]", "volume strain [%]", "plastic volume strain [%]"]
    return {
        "paper_3": Table(remark, columns, rows),
        "paper_3_curve": Table("Figure 3: the card along input_xml/paper/hydrostat.csv, compression positive", of_curve, curve),
    }


def draw(file, answer, rows, porosity):
    figure = plt.figure(figsize=(12.5, 5.4), layout="constrained")
    left = figure.add_subplot(1, 2, 1)
    draw_curve(left, answer, rows)
    right = figure.add_subplot(1, 2, 2, projection="3d")
    numbers = card_numbers(CARD)
    strength = Strength(lambda name: numbers.get(name, float("nan")))
    surface = draw_surface(right, strength, 0.0, 1.0)
    figure.colorbar(surface, ax=right, label=r"$\sqrt{J_2}$ [MPa]", shrink=0.6, pad=0.1)
    right.set_title(f"yield surface of virgin rock (porosity {100.0 * porosity:.0f} %)\nin principal stresses, compression positive",
        fontsize=11)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def draw_curve(axes, answer, rows):
    top = legs(answer)
    for part, colour, label in ((slice(0, top + 1), "C3", "card, load"), (slice(top, None), "C0", "card, unload")):
        axes.plot(100.0 * answer["strain"][part], answer["pressure"][part] / MEGA, color=colour, lw=1.8, label=label)
    total = card_numbers(CARD)["p3_crush_curve"]
    loading = (answer["pressure"][: top + 1], answer["strain"][: top + 1], answer["plastic"][: top + 1])
    for quantity, pressure, datum, _, uncertainty, _ in rows:
        if quantity.startswith("pore strain") and pressure * MEGA <= loading[0][-1]:
            # Pore strain left fixes the plastic strain; the elastic one is the card's.
            strain, plastic = (np.interp(pressure * MEGA, loading[0], values) for values in loading[1:])
            at = 100.0 * (strain - plastic + (1.0 - 0.01 * datum) * total)
            axes.errorbar(at, pressure, xerr=0.01 * uncertainty * 0.01 * datum * total * 100.0, fmt="go", capsize=3,
                label="data: pore strain left" if pressure < 1000 else None)
        if quantity.startswith("crushing"):
            at = 100.0 * np.interp(datum * MEGA, loading[0], loading[1])
            axes.errorbar(at, datum, yerr=0.01 * uncertainty * datum, fmt="g^", capsize=3, label="data: onset of crushing")
        if quantity.startswith("bulk") and np.isfinite(rows[0][3]) and pressure <= 60:
            at, half = np.interp(pressure * MEGA, loading[0], loading[1]), 0.006
            # Not into tension, where nobody has measured.
            ends, label = np.array([-min(half, 1e-3 * pressure / datum),
                half]), "data: slopes, bulk moduli to 60 MPa" if pressure == 10 else None
            axes.plot(100.0 * (at + ends), pressure + datum * 1e3 * ends, "g-", lw=2.5, alpha=0.7, label=label)
    axes.set(xlabel="volume strain [%], compression positive", ylabel="pressure [MPa]", xlim=(-0.5, None), ylim=(-50.0, None))
    axes.set_title("hydrostatic load and unload of the Berea card", fontsize=11)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9, loc="upper left")
    near = axes.inset_axes([0.36, 0.07, 0.36, 0.32])
    for line in list(axes.get_lines()):
        near.plot(*line.get_data(), color=line.get_color(), lw=line.get_linewidth(), alpha=line.get_alpha() or 1.0,
            marker=line.get_marker(), ls=line.get_linestyle())
    near.set(xlim=(0.0, 3.0), ylim=(0.0, 450.0))
    near.tick_params(labelsize=7)
    near.set_title("the start of the load", fontsize=8)
    near.grid(alpha=0.3)


def trends(tables):
    curve, data = tables["paper_3_curve"], tables["paper_3"]
    pressure, strain, plastic = (curve.column(name) for name in ("pressure [MPa]", "volume strain [%]", "plastic volume strain [%]"))
    left = float(strain[-1] - strain[0])
    unload = curve.column("leg") == "unload"
    rows = [row for row in data.rows if np.isfinite(row[3])]
    worst = max(abs(row[3] / row[2] - 1.0) / (0.01 * row[4]) for row in rows if row[0] != "bulk modulus [GPa]")
    return [
        least("3: after unloading (crushed pores stay closed): volume strain left [%]", left, 5.0),
        most("3: unload: change of plastic volume strain, relative", np.ptp(plastic[unload]) / plastic.max(), 1e-3),
        most("3: unload: largest increment of strain (falls with pressure)", np.diff(strain[unload]).max(), 0.0),
        least("3: load: least increment of strain (grows with pressure)", np.diff(strain[~unload]).min(), 0.0),
        most("3: pore strain and crushing pressure: misfit to the data over its uncertainty", worst, 1.0),
        least("3: end of the load: pressure [MPa]", pressure.max(), 1000.0),
    ]
