# SPDX-License-Identifier: BSD-3-Clause
"""Constitutive models of Uintah as models of a deck."""

import math

from barreno_runs.faults import Fault

# Defaults of Uintah, which its files may leave out.
ROOM, MELT = 298.0, 1793.0  # K, of the Johnson-Cook flow rule
NEVER_MELTS = 1e9  # K
CHANGED = 0.01  # of a bulk modulus, from which a difference is said

ARENISCA = ("PEAKI1", "FSLOPE", "STREN", "YSLOPE", "BETA_nonassociativity", "B0", "B1", "B2", "B3", "B4", "G0", "G1", "G2", "G3", "G4", "p0_crush_curve",
            "p1_crush_curve", "p3_crush_curve", "CR", "fluid_B0", "fluid_pressure_initial", "T1_rate_dependence", "T2_rate_dependence")  # fmt: skip
ARENISCA_LEFT = {  # name: what it would be
    "p2_crush_curve": "Barreno's crush curve has no such term, nor does the published one use it",
    "gruneisen_parameter": "Arenisca has no heat here",
    "subcycling_characteristic_number": "substeps follow from Tolerance",
}


class Unknown(Exception):
    """A model that no model of a deck is."""


def linear_elastic(model, material, name, notes):
    """<G>, <K> of hypo_elastic, small strains alike."""
    notes.add(f"{name}: hypo_elastic becomes Linear Elastic, in logarithmic strain instead of the integrated rate; the same at small strains.")
    return {"Model": "Linear Elastic", "Bulk Modulus": model.number("K", "bulk_modulus"), "Shear Modulus": model.number("G", "shear_modulus")}


def neo_hookean(model, material, name, notes):
    notes.add(f"{name}: comp_neo_hook becomes Neo-Hookean, whose volumetric part is lambda ln J instead of K (J^2 - 1)/2; the same at small strains.")
    return {"Model": "Neo-Hookean", "Bulk Modulus": model.number("bulk_modulus"), "Shear Modulus": model.number("shear_modulus")}


def arenisca(model, material, name, notes):
    out = {"Model": "Arenisca", **{key: model.number(key) for key in ARENISCA if model.has(key)}}
    for key, reason in ARENISCA_LEFT.items():
        if model.number(key, default=0.0) != 0.0:
            notes.add(f"{name}: {key} is left out ({reason}).")
    if out.get("BETA_nonassociativity", 1.0) > 1.0:
        notes.add(f"{name}: BETA_nonassociativity = {out['BETA_nonassociativity']:g} is above 1 (plastic work could be negative); it becomes 1.")
        out["BETA_nonassociativity"] = 1.0
    if out.get("fluid_B0", 0.0) > 0.0:
        out |= {"Backstress strain": "plastic", "Undrained moduli": "arenisca3"}
        notes.add(f"{name}: the pore fluid keeps the published form (Backstress strain = plastic, Undrained moduli = arenisca3), for which its parameters were made; it is ten times as expensive as the default, poroplastic.")
    if any(key.startswith(("PEAKI1IDIST", "peakI1")) for key in (child.tag for child in model.children())):
        notes.add(f"{name}: the distribution of PEAKI1 is left out (Uintah's random numbers cannot be drawn again); set Weibull modulus.")
    return out


def flow_of(model, material, name, notes):
    """Strength: johnson_cook, or isotropic linear hardening as its special case."""
    flow = model.find("flow_model", "plasticity_model")
    kind = flow.attribute("type")
    melt = material.number("melt_temp", default=MELT)
    if kind == "johnson_cook":
        return {**{key: flow.number(key) for key in ("A", "B", "C", "n", "m")}, "Reference Strain Rate": flow.number("epdot_0", default=1.0),
                "Room Temperature": flow.number("T_r", default=ROOM), "Melt Temperature": flow.number("T_m", default=melt)}  # fmt: skip
    if kind in ("isotropic_hardening", "isotropic"):
        return {"A": flow.number("sigma_Y", "sigma_0"), "B": flow.number("K"), "C": 0.0, "n": 1.0, "m": 1.0,
                "Room Temperature": material.number("room_temp", default=294.0), "Melt Temperature": NEVER_MELTS}  # fmt: skip
    raise Unknown(f"its flow rule {kind or 'is missing and'} is neither johnson_cook nor isotropic_hardening")


def pressure_of(model, density, name, notes):
    """Pressure: Mie-Grueneisen as it is, a constant bulk modulus as its special case."""
    law, bulk = model.find("equation_of_state"), model.number("bulk_modulus")
    kind = law.attribute("type")
    if kind == "mie_gruneisen":
        speed = law.number("C_0")
        modulus = density * speed**2
        if abs(modulus / bulk - 1.0) > CHANGED:
            notes.add(f"{name}: bulk_modulus = {bulk:g} is left out (Barreno takes rho C_0^2 = {modulus:g} from the pressure law, for elastic waves too).")
        return {"Sound Speed": speed, "Hugoniot Slope": law.number("S_alpha"), "Gruneisen": law.number("Gamma_0")}
    if kind not in ("", "default_hypo", "default_hyper"):
        notes.add(f"{name}: the pressure law {kind} is left out (Barreno has Mie-Grueneisen); bulk_modulus alone gives the pressure.")
    else:
        notes.add(f"{name}: the pressure of a constant bulk modulus becomes Mie-Grueneisen with Hugoniot Slope = Gruneisen = 0; the same at small volume changes.")
    return {"Sound Speed": math.sqrt(bulk / density), "Hugoniot Slope": 0.0, "Gruneisen": 0.0}


def damage_of(model, name, notes):
    damage = model.find("damage_model")
    kind = damage.attribute("type")
    if kind == "johnson_cook":
        if damage.number("D0", default=0.0) or damage.number("Dc", default=0.7) != 1.0:
            notes.add(f"{name}: D0 and Dc of the damage are left out (here damage begins at 0, and a point is broken at 1; Uintah's default is Dc = 0.7).")
        return {key: damage.number(key) for key in ("D1", "D2", "D3", "D4", "D5")}
    if kind not in ("", "none"):
        notes.add(f"{name}: the damage model {kind} is left out (Barreno has that of Johnson and Cook).")
    return {}


MODEL_PARTS = {  # child of an elastic-plastic model: kinds that need no word
    "yield_condition": ("", "vonMises", "von_mises"), "stability_check": ("", "none"), "shear_modulus_model": ("", "constant_shear"),
    "melting_temp_model": ("", "constant_Tm"), "specific_heat_model": ("", "constant_Cp"),
}  # fmt: skip
POROSITY = ("initial_mean_porosity", "initial_mean_scalar_damage", "evolve_porosity")


def elastic_plastic(model, material, name, notes):
    density = material.number("density")
    out = {"Model": "Johnson-Cook", "Shear Modulus": model.number("shear_modulus"), "Specific Heat": material.number("specific_heat"),
           **pressure_of(model, density, name, notes), **flow_of(model, material, name, notes), **damage_of(model, name, notes)}  # fmt: skip
    for tag, plain in MODEL_PARTS.items():
        kind = model.find(tag).attribute("type")
        if kind not in plain:
            notes.add(f"{name}: {tag} {kind} is left out (Barreno's metal has von Mises' condition, constant shear modulus, melting point and heat capacity).")
    if any(model.has(tag) for tag in POROSITY):
        notes.add(f"{name}: porosity and scattered damage are left out (Barreno's metal is dense and the same everywhere).")
    return out


MODELS = {"hypo_elastic": linear_elastic, "comp_neo_hook": neo_hookean, "CompNeoHook": neo_hookean, "Arenisca3": arenisca, "elastic_plastic": elastic_plastic,
          "elastic_plastic_hp": elastic_plastic}  # fmt: skip


def read_material(material, name, cards, notes):
    """Parameters of a list of Materials. @param cards  name to card, of the user's words  @raises Unknown"""
    if name in cards:
        return {"Card": cards[name]}
    model = material.find("constitutive_model")
    kind = model.attribute("type")
    if kind not in MODELS:
        raise Unknown(f'its model "{kind}" is none of {", ".join(MODELS)}')
    parameters = MODELS[kind](model, material, name, notes)
    return {"Model": parameters.pop("Model"), "Density": material.number("density"), **parameters}


def check_cards(cards, names):
    for name in cards:
        if name not in names:
            raise Fault(f'--card names "{name}", which is no material of the file; it has {", ".join(names) or "none"}.')
