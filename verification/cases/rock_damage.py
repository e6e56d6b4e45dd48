# SPDX-License-Identifier: BSD-3-Clause
"""Sandstone that breaks, one material point: the card with damage against its equations written anew (oracles/rock_damage.py)."""
import pathlib
import tempfile

import numpy as np
from barreno.materials import Material, load
from oracles.rock_damage import BreakingRock
from scipy.optimize import brentq
from tools.case import Result
from tools.plug import Plug, card_numbers, write_card

CARDS_FOLDER = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"
CARD = "berea_sandstone_damage"
MEGA = 1e6
WIDTHS = (0.25e-3, 1e-3, 4e-3)  # of a crack [m]
CONFINEMENTS = (0.0, 10.0, 50.0)  # [MPa]
SHORTENING, STEP = 0.12, 1e-4
# Tests of rock that was crushed before: pressures that crushed it and of the test [MPa], Broken dilatancy, and its critical state or none.
AFTER_CRUSHING = ((800.0, 10.0, 0.0, None), (800.0, 10.0, 1.0, "first volume"), (1500.0, 300.0, 1.0, "branch point"))
# What is left at the end of crushing, or of the distance from the branch point; and whether that is the least. Half, because that distance
# falls with the shear as in a decay.
LEFT = {None: (0.7, True), "first volume": (0.1, False), "branch point": (0.5, False)}
LONG, FINE = 0.4, 1e-4  # shortening of such a test, and its increments
BONDS = 1e9  # Damage pressure of these tests [Pa]: crushed rock breaks at once
PARTS = 800  # increments of a test in tension to full damage
NEARLY = 0.98  # damage at which such a test ends: broken rock has no stiffness, and what is left takes 4e-4 of the work
COLUMNS = ["test", "quantity", "computed", "exact", "difference, relative"]


def set_fracture_strain(plug, value):
    plug.state[0, plug.material.state_names.index("fracture_strain")] = value


def pull(plug, increment, side):
    """Axial strain under no stress at the side. From far away Newton's method comes to the vertex, where rock has no stiffness.

    @param side  strain of the side in the increment before
    @return that of this one
    """

    def answer(lateral):
        strain = np.array([[increment, lateral, lateral, 0.0, 0.0, 0.0]])
        return plug.material.update(strain, plug.stress, plug.state, plug.dt, 0)

    found = brentq(lambda lateral: answer(lateral).stress[0, 1], side - 1.5 * increment, side + 1.5 * increment, xtol=1e-12)
    taken = answer(found)
    plug.stress, plug.state = taken.stress, taken.state
    return found


def pulled(library, fracture_strain):
    """Peak [Pa] and work per volume [J/m3] of uniaxial tension to nearly full damage; largest tension over (1 - D) of the peak."""
    with Material(CARDS_FOLDER / f"{CARD}.xml", library) as material:
        plug = Plug(material, None)
        plug.strain_axially(0.0)  # fills the state of a point that is all zero
        set_fracture_strain(plug, fracture_strain)
        rows, work, side = [], 0.0, 0.0
        increment = 1.2 * fracture_strain / PARTS
        for _ in range(2 * PARTS):
            before = plug.stress[0, 0]
            side = pull(plug, increment, side)
            work += 0.5 * (before + plug.stress[0, 0]) * increment
            rows.append((plug.stress[0, 0], plug.get("damage")))
            if plug.get("damage") >= NEARLY:
                break
    stress, damage = np.array(rows).T
    peak = float(stress.max())
    return peak, float(work), float((stress - (1.0 - damage) * peak).max() / peak), float(damage[-1])


def compressed(material, confinement):
    """(equivalent plastic strain, damage, plastic volume strain, axial stress) of a triaxial test, confined first."""
    plug = Plug(material, None)
    if confinement > 0.0:
        plug.confine(confinement)
    rows = []
    for _ in range(round(SHORTENING / STEP)):
        plug.shorten(-STEP, confinement)
        rows.append([*(plug.get(name) for name in ("equivalent_plastic_strain", "damage", "plastic_volume_strain")), plug.stress[0, 0]])
    return np.array(rows).T


def sheared(result, library, exact):
    """Triaxial tests: the whole way against the equations, and the strength that is left."""
    with Material(CARDS_FOLDER / f"{CARD}.xml", library) as material:
        for confinement in CONFINEMENTS:
            shear, damage, volume, stress = compressed(material, confinement * MEGA)
            name = f"triaxial, {confinement:g} MPa"
            flows = shear > 1e-4
            ways = np.concatenate([[0.0], shear[flows]])
            D, evp, _, axial = (part[1:] for part in exact.path(-confinement * MEGA, ways, -1, exact.card["Fracture strain"]))
            whole = exact.axial_stress(-confinement * MEGA, 0.0, 0.0, -1)
            broken = exact.axial_stress(-confinement * MEGA, 1.0, 0.0, -1)
            apart = {
                "damage on the way": (float(np.abs(damage[flows] - D).max()), 1.0),
                "plastic volume strain on the way": (float(np.abs(volume[flows] - evp).max()), float(evp.max())),
                "axial stress on the way": (float(np.abs(stress[flows] - axial).max()), -whole),
            }
            for quantity, (difference, size) in apart.items():
                result.rows.append([name, quantity, "", "", difference / size])
                result.demand(f"{name}: {quantity}, relative", difference / size, 0.02)
            peak, left = -float(stress.min()) / MEGA, -float(stress[-1]) / MEGA
            result.rows.append([name, "strength [MPa]", peak, -whole / MEGA, abs(peak / (-whole / MEGA) - 1.0)])
            result.demand(f"{name}: strength, relative", abs(peak / (-whole / MEGA) - 1.0), 0.02)
            off = abs(left + broken / MEGA)
            result.rows.append([name, "strength that is left [MPa]", left, -broken / MEGA, off / max(-broken / MEGA, peak)])
            if confinement > 0.0:
                result.demand(f"{name}: residual strength off the friction line, relative", off / (-broken / MEGA), 0.05)
            else:
                result.demand(f"{name}: residual strength over the peak", left / peak, 0.01)
            result.demand(f"{name}: damage falls by", float(-np.diff(damage).min(initial=0.0)), 0.0)


def torn(result, library, exact):
    energy, mean = exact.card["Fracture energy"], exact.mean_tension()
    tension = exact.axial_stress(0.0, 0.0, 0.0, 1) / MEGA
    for width in WIDTHS:
        peak, work, above, damage = pulled(library, energy / (width * mean))
        name = f"tension, crack of {1e3 * width:g} mm"
        result.rows.append([name, "strength [MPa]", peak / MEGA, tension, abs(peak / MEGA / tension - 1.0)])
        result.rows.append([name, "work per area [J/m2]", width * work, energy, abs(width * work / energy - 1.0)])
        result.demand(f"{name}: strength, relative", abs(peak / MEGA / tension - 1.0), 0.02)
        result.demand(f"{name}: work per area off the fracture energy, relative", abs(width * work / energy - 1.0), 0.05)
        result.demand(f"{name}: tension above (1 - D) of the strength, relative", above, 0.02)
        result.demand(f"{name}: damage at the end", damage, NEARLY, at_least=True)


def crushed(result, library):
    """Hydrostatic pressure crushes without damage."""
    with Material(CARDS_FOLDER / f"{CARD}.xml", library) as material:
        plug = Plug(material, None)
        while plug.pressure() < 2000.0 * MEGA:
            plug.squeeze(-0.5 * STEP)
        result.rows.append(["hydrostatic, 2 GPa", "damage", plug.get("damage"), 0.0, plug.get("damage")])
        result.demand("hydrostatic, 2 GPa: damage", plug.get("damage"), 1e-12)
        result.demand("hydrostatic, 2 GPa: pores crushed by", -plug.get("plastic_volume_strain"), 0.1, at_least=True)


def crushed_and_sheared(material, crushing, after):
    """@return  volumetric plastic strain after crushing, and rows of the triaxial test"""
    plug = Plug(material, None)
    while plug.pressure() < crushing * MEGA:
        plug.squeeze(-STEP)
    while plug.pressure() > 1.2 * after * MEGA:
        plug.squeeze(0.1 * STEP)
    plug.confine(after * MEGA)
    start, rows = plug.get("plastic_volume_strain"), []
    for _ in range(round(LONG / FINE)):
        plug.shorten(-FINE, after * MEGA)
        rows.append([plug.get(name) for name in ("equivalent_plastic_strain", "damage", "plastic_volume_strain")])
    return start, np.array(rows).T


def sheared_after_crushing(result, library):
    """Triaxial tests of rock that was crushed before: with Broken dilatancy it dilates until it is in its critical state."""
    for crushing, after, broken, critical in AFTER_CRUSHING:
        with tempfile.TemporaryDirectory() as folder:
            file = write_card(folder, CARDS_FOLDER / f"{CARD}.xml", {"Broken dilatancy": broken, "Damage pressure": BONDS})
            exact = BreakingRock(card_numbers(file))
            with Material(file, library) as material:
                start, (shear, damage, volume) = crushed_and_sheared(material, crushing, after)
        flows = shear > 1e-4
        ways = np.concatenate([[0.0], shear[flows]])
        D, evp, _, axial = (part[1:] for part in exact.path(-after * MEGA, ways, -1, exact.card["Fracture strain"], start))
        name = f"crushed at {crushing:g} MPa, triaxial at {after:g} MPa, Broken dilatancy {broken:g}"
        for quantity, difference in {
            "damage on the way": np.abs(damage[flows] - D).max(),
            "plastic volume strain on the way, over that of crushing": np.abs(volume[flows] - evp).max() / -start,
        }.items():
            result.rows.append([name, quantity, "", "", float(difference)])
            result.demand(f"{name}: {quantity}", float(difference), 0.02)
        result.rows.append([name, "plastic volume strain, crushed and at the end", float(start), "", float(volume[-1])])
        left = float(volume[-1] / start)
        if critical == "branch point":
            before, after_all = (float(1.0 - (axial[k] - 2.0 * after * MEGA) / exact.branch_point(1.0, volume[k])[0]) for k in (0, -1))
            result.rows.append([name, "distance from the branch point over it, at the start and at the end", before, "", after_all])
            left = after_all / before
        bound, at_least = LEFT[critical]
        result.demand(f"{name}: what is left", left, bound, at_least=at_least)


def whole_rock(result, library):
    """Before it breaks rock is that of the card without damage."""
    stresses = []
    with tempfile.TemporaryDirectory() as folder:
        far = write_card(folder, CARDS_FOLDER / "berea_sandstone_bounded.xml", {"Fracture strain": 1e15, "Residual slope": 0.396})
        for file in (CARDS_FOLDER / "berea_sandstone_bounded.xml", far):
            with Material(file, library) as material:
                plug = Plug(material, None)
                plug.confine(10.0 * MEGA)
                for _ in range(200):
                    plug.shorten(-STEP, 10.0 * MEGA)
                stresses.append(plug.stress[0].copy())
    apart = float(np.abs(stresses[1] - stresses[0]).max() / np.abs(stresses[0]).max())
    result.rows.append(["damage far away, triaxial, 10 MPa", "stress, 2 % shorter", "", "without damage", apart])
    result.demand("damage far away: stress off that without damage, relative", apart, 1e-6)


def run(barreno, full):
    del full  # one form: it takes seconds
    library = load(barreno.resolve().parents[1] / "materials" / "libBARRENO.so")
    exact = BreakingRock(card_numbers(CARDS_FOLDER / f"{CARD}.xml"))
    result = Result(
        "Sandstone that breaks",
        "Rock with damage loses cohesion and tensile strength and keeps its friction, and a crack takes the same work in cells of any "
        "size.",
        "the equations of [method](../method.md) 18 written anew, integrated over the plastic strain "
        "(`verification/oracles/rock_damage.py`). One material point, no grid.",
        COLUMNS,
        [],
    )  # fmt: skip
    torn(result, library, exact)
    sheared(result, library, exact)
    crushed(result, library)
    sheared_after_crushing(result, library)
    whole_rock(result, library)
    result.notes = (
        "A way is compared at the plastic shear strains of the computed test: damage as it is, the others relative to their largest "
        "values. What broken rock bears is compared with the friction line, the limit surface without cohesion. In tension the strain of "
        "full damage is set for the width of a crack, as a run sets it for its cells."
    )
    return result
