# SPDX-License-Identifier: BSD-3-Clause
"""Metal that is compressed, sheared until it is hot, and expanded to its first volume, one material point: the work that its heat does,
which the ledger counts as elastic (docs/method.md 21)."""
import pathlib

import numpy as np
from barreno.materials import Material, load
from tools.case import Result
from tools.plug import card_numbers
from tools.works import works_along

CARDS_FOLDER = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"
CARDS = ("tungsten_alloy", "steel_4340_fracture", "copper_ofhc", "aluminium_6061_fracture")
COMPRESSIONS = (0.05, 0.15)  # 1 - V/V0 while it is sheared
SHEAR = 0.3  # strain
STEPS, DT = 2000, 1e-9  # of each of the three parts; of a step [s]
MEGA = 1e6
COLUMNS = ["card", "compression", "temperature [K]", "heat made [MJ/m3]", "elastic work of the ledger [MJ/m3]", "closed form [MJ/m3]",
    "difference over the heat"]  # fmt: skip


def squeezed(begin, end):
    """Steps between two volume ratios, equal in the ratio."""
    ratios = np.linspace(begin, end, STEPS + 1)
    steps = np.zeros((STEPS, 1, 6))
    steps[..., :3] = (np.diff(np.log(ratios)) / 3.0)[:, None, None]
    return steps


def sheared():
    steps = np.zeros((STEPS, 1, 6))
    steps[..., 3] = SHEAR / STEPS
    return steps


def squares(stresses):
    """s : s of the deviators."""
    deviators = stresses.copy()
    deviators[..., :3] -= stresses[..., :3].mean(axis=-1, keepdims=True)
    return (deviators[..., :3] ** 2).sum(axis=-1) + 2.0 * (deviators[..., 3:] ** 2).sum(axis=-1)


def way(material, compression):
    """Works of every step (steps, 2) [J/m3], V/V0 and s : s from the start on (steps + 1), the state at the end, highest temperature."""
    stress, state = material.virgin(1)
    works, sheared_by, volumes, hottest = [], [np.zeros(1)], [np.ones(1)], 0.0
    for part in (squeezed(1.0, 1.0 - compression), sheared(), squeezed(1.0 - compression, 1.0)):
        stresses, state, work = works_along(material, part, stress, state, DT)
        stress = stresses[-1].copy()
        works.append(work[:, 0])
        sheared_by.append(squares(stresses[:, 0]))
        volumes.append(volumes[-1][-1] * np.exp(np.cumsum(part[:, 0, :3].sum(axis=1))))
        hottest = max(hottest, float(state[0, material.state_index("temperature")]))
    return np.concatenate(works), np.concatenate(volumes), np.concatenate(sheared_by), state[0], hottest


def add(result, name, library, compression):
    with Material(CARDS_FOLDER / f"{name}.xml", library) as material:
        card = card_numbers(CARDS_FOLDER / f"{name}.xml")
        works, volumes, sheared_by, state, hottest = way(material, compression)
        inside = float(state[material.state_index("internal_energy")]) * card["Density"]
        broken = float(state[material.state_index("damage")])
    elastic, heat = works[:, 0].sum(), works[:, 1].sum()
    stored = sheared_by / (4.0 * card["Shear Modulus"])  # of the deviator, per volume
    # Heat is what is dissipated, and what V s : s/4G loses where V falls under the same s; on the way back to V0 it falls by
    # exp(-Gamma0 (1 - V/V0)) from where it was made. The cold energy comes back whole.
    made = works[:, 1] - 0.5 * (stored[1:] + stored[:-1]) * np.diff(volumes)
    left = float((made * np.exp(-card["Gruneisen"] * (1.0 - 0.5 * (volumes[1:] + volumes[:-1])))).sum())
    exact = stored[-1] + left - heat
    apart, worked = abs(elastic - exact) / heat, 1.0 - left / heat
    result.rows.append([name, f"{compression:g}", f"{hottest:.0f}", heat / MEGA, elastic / MEGA, exact / MEGA, apart])
    where = f"{name}, {compression:g}"
    result.demand(f"{where}: elastic work against the closed form, over the heat", apart, 1e-5)
    result.demand(f"{where}: elastic and plastic work less the internal energy, over the heat", abs(elastic + heat - inside) / heat, 1e-5)
    result.demand(f"{where}: heat turned into work over the heat", worked, 0.05, at_least=True)
    result.demand(f"{where}: damage", broken, 0.99)


def run(barreno, full):
    del full  # one form: it takes a second
    library = load(barreno.resolve().parents[1] / "materials" / "libBARRENO.so")
    result = Result(
        "Work of heat in metals",
        "Hot metal that expands does work out of its heat. The ledger counts that work as elastic, so the elastic energy falls below what "
        "is stored. The internal energy closes.",
        "1 - exp(-Gamma0 (1 - V/V0)) of the heat that is made at a volume V, with a constant Gamma rho, and the elastic energy of the "
        f"deviator that is left. One material point: compressed, sheared by {SHEAR:g} at constant volume, expanded to its first volume",
        COLUMNS,
        [],
    )  # fmt: skip
    for name in CARDS:
        for compression in COMPRESSIONS:
            add(result, name, library, compression)
    return result
