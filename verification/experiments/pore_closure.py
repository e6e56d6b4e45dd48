# SPDX-License-Identifier: BSD-3-Clause
"""Sandstone under uniaxial strain, one material point: the pores that are left at 2.5 and 5 GPa of axial stress."""
import pathlib
import tempfile

import numpy as np
from barreno.runs.csv_table import arrays_of, read_csv
from tools.drive import write_path
from tools.experiment import SEEN, Experiment
from tools.plug import card_numbers
from tools.runs import call

CARDS_FOLDER = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"
CARDS = ("berea_sandstone_heat", "berea_sandstone_damage", "berea_sandstone_bounded", "berea_sandstone_shock")
STRESSES = {"2.5 GPa": (2.5e9, 0.10), "5 GPa": (5e9, 0.02)}  # axial stress, share of the pores that "closed" may leave
STRAIN, ROWS = 0.45, 450  # logarithmic
SOURCES = {
    "2.5 GPa": "Ebert et al., Meteorit. Planet. Sci. (2018), doi 10.1111/maps.12948: porous sandstone, plane shock",
    "5 GPa": "Kowitz et al., Meteorit. Planet. Sci. 48 (2013), doi 10.1111/maps.12030: Seeberger sandstone, plane shock",
}


def squeezed(barreno, card):
    """Axial stress [Pa] and share of the pore strain that is left along the path."""
    file = CARDS_FOLDER / f"{card}.xml"
    rows = [(t, np.diag([np.exp(-STRAIN * t), 1.0, 1.0])) for t in np.linspace(0.0, 1.0, ROWS + 1)]
    with tempfile.TemporaryDirectory(prefix="closure-") as scratch:
        path, out = (pathlib.Path(scratch) / name for name in ("path.csv", "answer.csv"))
        write_path(path, rows)
        ended = call(barreno, ["drive", "--material", file, "--path", path, "--out", out])
        if ended.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, ended.args))} ended with {ended.returncode}: {ended.stderr.strip()}")
        answer = arrays_of(read_csv(out))
    return -answer["stress_xx"], 1.0 + answer["plastic_volume_strain"] / card_numbers(file)["p3_crush_curve"]


def run(barreno, full):
    experiment = Experiment(
        "Closure of the pores",
        "A shock of a few GPa closes the pores of sandstone.",
        "uniaxial strain of a material point with `barreno drive`, dry, to the axial stress of the shock. \"Closed\" is what was seen; "
        "that "
        "10 and 2 % of the pores may be left at 2.5 and 5 GPa is ours",
    )  # fmt: skip
    for card in CARDS if full else CARDS[:1]:
        stress, left = squeezed(barreno, card)
        if stress[-1] < max(value for value, _ in STRESSES.values()):
            raise RuntimeError(f"{card}: the path ends at {stress[-1]:.3g} Pa, below the stresses of the experiments; lengthen STRAIN")
        for name, (value, limit) in STRESSES.items():
            at = float(np.interp(value, stress, left))
            row = experiment.compare(f"pores left at {name}, `{card}`", "closed", SEEN, SOURCES[name], [at])
            experiment.require(row, at, limit)
    return experiment
