# SPDX-License-Identifier: BSD-3-Clause
"""Constitutive models of Uintah as models of a deck."""

import math

from barreno.runs.faults import Fault

# Defaults of Uintah, which its files may leave out.
ROOM, MELT = 298.0, 1793.0  # K, of the Johnson-Cook flow rule
NEVER_MELTS = 1e9  # K
CHANGED = 0.01  # of a bulk modulus, from which a difference is said

ARENISCA = ("PEAKI1", "FSLOPE", "STREN", "YSLOPE", "BETA_nonassociativity", "B0", "B1", "B2", "B3", "B4", "G0", "G1", "G2", "G3", "G4",
    "p0_crush_curve",
            "p1_crush_curve", "p3_crush_curve", "CR", "fluid_B0", "fluid_pressure_initial", "T1_rate_dependence",
            "T2_rate_dependence")  # fmt: skip
ARENISCA_LEFT = {  # name: what it would be
    "p2_crush_curve": "Barreno's crush curve has no such term, nor does the published one use it",
    "gruneisen_parameter": "Arenisca has no heat here",
    "subcycling_characteristic_number": "substeps follow from Tolerance",
}


class Unknown(Exception):
    """A model that no model of a deck is."""


def linear_elastic(model, material, name, notes):
    """<G>, <K> of hypo_elastic, small strains alike."""
    notes.add("hypo_elastic becomes Linear Elastic, in logarithmic strain instead of the integrated rate; the same at small strains.", name)
    return {"Model": "Linear Elastic", "Bulk Modulus": model.number("K", "bulk_modulus"),
        "Shear Modulus": model.number("G", "shear_modulus")}


PLASTIC = ("comp_neo_hook_plastic", "cnhp_damage")  # plastic without a flag


def neo_hookean(model, material, name, notes):
    if model.flag("useInitialStress"):
        pressure = model.number("initial_pressure", default=0.0)
        notes.lost(f"the initial stress, initial_pressure = {pressure:g}, is left out (Confinement starts bodies in equilibrium under a "
            "pressure that stays on their surfaces); add it in the deck.", name)
    plastic = model.flag("usePlasticity", default=model.attribute("type") in PLASTIC)
    if plastic and model.number("yield_stress") > model.number("shear_modulus"):
        notes.add(f"yield_stress = {model.number('yield_stress'):g} is above the shear modulus, so that it does not yield below strains of "
            "1/3; it becomes elastic.", name)
        plastic = False
    if plastic and material.has("specific_heat"):
        return plastic_neo_hookean(model, material, name, notes)
    for tag in ("yield_stress", "hardening_modulus", "alpha") if not plastic else ():  # which Uintah does not read then
        model.find(tag).own_text()
    if plastic:
        notes.lost("plasticity is left out (a metal of a deck needs the specific_heat, which the file lacks); the material is elastic.",
            name)
        for tag in ("yield_stress", "hardening_modulus", "K", "alpha"):
            model.find(tag).cover()
    notes.add(f"{model.attribute('type')} becomes Neo-Hookean, whose volumetric part is lambda ln J instead of K (J^2 - 1)/2; the same at "
        "small strains.", name)
    return {"Model": "Neo-Hookean", "Bulk Modulus": model.number("bulk_modulus"), "Shear Modulus": model.number("shear_modulus")}


def plastic_neo_hookean(model, material, name, notes):
    """Isotropic hardening as the special case of the flow rule of Johnson and Cook."""
    density, bulk = material.positive("density"), model.positive("bulk_modulus")
    notes.add(f"{model.attribute('type')}{'' if model.attribute('type') in PLASTIC else ' with usePlasticity'} becomes Johnson-Cook with "
        "linear hardening alone, and a pressure of a constant bulk modulus; the same at small elastic strains.", name)
    return {"Model": "Johnson-Cook", "Shear Modulus": model.number("shear_modulus"), "Specific Heat": material.number("specific_heat"),
            "Sound Speed": math.sqrt(bulk / density), "Hugoniot Slope": 0.0, "Gruneisen": 0.0, "A": model.number("yield_stress"),
            "B": model.number("hardening_modulus", default=0.0), "C": 0.0, "n": 1.0, "m": 1.0, "Melt Temperature": NEVER_MELTS}  # fmt: skip


def arenisca(model, material, name, notes):
    out = {"Model": "Arenisca", **{key: model.number(key) for key in ARENISCA if model.has(key)}}
    for key, reason in ARENISCA_LEFT.items():
        if model.number(key, default=0.0) != 0.0:
            notes.add(f"{key} is left out ({reason}).", name)
    if out.get("BETA_nonassociativity", 1.0) > 1.0:
        notes.add(f"BETA_nonassociativity = {out['BETA_nonassociativity']:g} is above 1 (plastic work could be negative); it becomes 1.",
            name)
        out["BETA_nonassociativity"] = 1.0
    if out.get("fluid_B0", 0.0) > 0.0:
        out |= {"Backstress strain": "plastic", "Undrained moduli": "arenisca3"}
        notes.add("the pore fluid keeps the published form (Backstress strain = plastic, Undrained moduli = arenisca3), for which its "
            "parameters were made; it is ten times as expensive as the default, poroplastic.", name)
    if any(key.startswith(("PEAKI1IDIST", "peakI1")) for key in (child.tag for child in model.children())):
        for child in model.children():
            if child.tag.startswith(("PEAKI1IDIST", "peakI1")):
                child.cover()
        notes.lost("the distribution of PEAKI1 is left out (Uintah's random numbers cannot be drawn again); set Weibull modulus.", name)
    return out


def flow_of(model, material, name, notes):
    """Strength: johnson_cook, or isotropic linear hardening as its special case."""
    flow = model.find("flow_model", "plasticity_model")
    kind = flow.attribute("type")
    if kind == "johnson_cook":
        melt = flow.number("T_m", default=MELT)  # that of the flow rule, whatever melt_temp is
        if material.has("melt_temp") and material.number("melt_temp") != melt:
            notes.add(f"melt_temp = {material.number('melt_temp'):g} K is left out (strength ends at T_m of the flow rule, {melt:g} K).",
                name)
        material.find("room_temp").own_text()
        return {**{key: flow.number(key) for key in ("A", "B", "C", "n", "m")},
            "Reference Strain Rate": flow.number("epdot_0", default=1.0),
                "Room Temperature": flow.number("T_r", default=ROOM), "Melt Temperature": melt}  # fmt: skip
    if kind in ("isotropic_hardening", "isotropic"):
        return {"A": flow.number("sigma_Y", "sigma_0"), "B": flow.number("K"), "C": 0.0, "n": 1.0, "m": 1.0,
                "Room Temperature": material.number("room_temp", default=294.0), "Melt Temperature": NEVER_MELTS}  # fmt: skip
    raise Unknown(f"its flow rule {kind or 'is missing and'} is neither johnson_cook nor isotropic_hardening")


def pressure_of(model, density, name, notes):
    """Pressure: Mie-Grueneisen as it is, a constant bulk modulus as its special case."""
    law, bulk = model.find("equation_of_state"), model.positive("bulk_modulus")
    kind = law.attribute("type")
    if kind == "mie_gruneisen":
        speed = law.positive("C_0")
        modulus = density * speed**2
        if abs(modulus / bulk - 1.0) > CHANGED:
            notes.add(f"bulk_modulus = {bulk:g} is left out (Barreno takes rho C_0^2 = {modulus:g} from the pressure law, for elastic "
                "waves too).", name)
        return {"Sound Speed": speed, "Hugoniot Slope": law.number("S_alpha"), "Gruneisen": law.number("Gamma_0")}
    if kind not in ("", "default_hypo", "default_hyper"):
        law.cover()
        notes.lost(f"the pressure law {kind} is left out (Barreno has Mie-Grueneisen); bulk_modulus alone gives the pressure.", name)
    else:
        notes.add("the pressure of a constant bulk modulus becomes Mie-Grueneisen with Hugoniot Slope = Gruneisen = 0; the same at small "
            "volume changes.", name)
    return {"Sound Speed": math.sqrt(bulk / density), "Hugoniot Slope": 0.0, "Gruneisen": 0.0}


def damage_of(model, material, name, notes):
    """A child of the material in newer inputs, of the model in older ones."""
    place = material if material.has("damage_model") else model
    damage, kind = place.find("damage_model"), place.find("damage_model").attribute("type")
    if kind == "johnson_cook":
        if damage.number("D0", default=0.0) or damage.number("Dc", default=0.7) != 1.0:
            notes.add("D0 and Dc of the damage are left out (here damage begins at 0, and a point is broken at 1; Uintah's default is Dc = "
                "0.7).", name)
        return {key: damage.number(key) for key in ("D1", "D2", "D3", "D4", "D5")}
    if kind not in ("", "none"):
        damage.cover()
        notes.lost(f"the damage model {kind} is left out (Barreno has that of Johnson and Cook).", name)
    return {}


MODEL_PARTS = {  # child of an elastic-plastic model: kinds that need no word
    "yield_condition": ("", "vonMises", "von_mises"), "stability_check": ("", "none"), "shear_modulus_model": ("", "constant_shear"),
    "melting_temp_model": ("", "constant_Tm"), "specific_heat_model": ("", "constant_Cp"),
}  # fmt: skip
POROSITY = ("initial_mean_porosity", "initial_std_porosity", "critical_porosity", "frac_nucleation", "meanstrain_nucleation",
    "stddevstrain_nucleation", "initial_porosity_distrib",
            "initial_mean_scalar_damage", "initial_std_scalar_damage", "critical_scalar_damage",
            "initial_scalar_damage_distrib")  # fmt: skip


def heat_of(model, name, notes):
    """The share of plastic work that becomes heat."""
    if model.flag("isothermal"):
        notes.lost("isothermal = true is left out (a metal of a deck is heated by what it dissipates).", name)
    return {"Taylor Quinney": model.number("taylor_quinney_coeff")} if model.has("taylor_quinney_coeff") else {}


def elastic_plastic(model, material, name, notes):
    density = material.positive("density")
    flow = flow_of(model, material, name, notes)  # first, as it may end in a material that is left out
    out = {"Model": "Johnson-Cook", "Shear Modulus": model.number("shear_modulus"), "Specific Heat": material.number("specific_heat"),
           **pressure_of(model, density, name, notes), **flow, **damage_of(model, material, name, notes),
           **heat_of(model, name, notes)}  # fmt: skip
    for tag, plain in MODEL_PARTS.items():
        part = model.find(tag)
        kind = part.attribute("type")
        if kind in plain:
            continue
        part.cover()
        notes.lost(f"{tag} {kind} is left out (Barreno's metal has von Mises' condition, constant shear modulus, melting point and heat "
            "capacity).", name)
    if porous := model.children(*POROSITY):
        for child in porous:
            child.cover()
        notes.lost("porosity and scattered damage are left out (Barreno's metal is dense and the same everywhere).", name)
    return out


METALS = ("elastic_plastic", "elastic_plastic_hp")
MODELS = {"hypo_elastic": linear_elastic, "comp_neo_hook": neo_hookean, "CompNeoHook": neo_hookean, "UCNH": neo_hookean,
    "cnh_damage": neo_hookean,
          **dict.fromkeys(PLASTIC, neo_hookean), "Arenisca3": arenisca, "elastic_plastic": elastic_plastic,
          "elastic_plastic_hp": elastic_plastic}  # fmt: skip


def rigid_material(model, material, name, notes):
    """Of a body with Motion, whose stress moves nothing."""
    rest = [child for child in model.children() if child.tag not in ("bulk_modulus", "K", "shear_modulus", "G")]
    for child in rest:
        child.cover()
    without = f" without {', '.join(child.tag for child in rest)}" if rest else ""
    notes.add(f"{model.attribute('type')} becomes Linear Elastic{without} (its bodies have a Motion of their own, whatever the stress).",
        name)
    bulk = model.number("bulk_modulus", "K", default=1.0)
    return {"Model": "Linear Elastic", "Bulk Modulus": bulk, "Shear Modulus": model.number("shear_modulus", "G", default=bulk)}


def look_at_rest(material, model, is_rigid, name, notes):
    """Parts of a material that every model has."""
    erosion = material.find("erosion")
    if erosion.attribute("algorithm") not in ("", "none"):
        erosion.cover()
        notes.lost(f"erosion {erosion.attribute('algorithm')} is left out (a metal that is broken bears no tension and no shear; particles "
            "that fail are treated as Bad Particles says).", name)
    if material.flag("is_rigid") and not is_rigid:
        notes.lost("is_rigid = true is left out (no contact moves the material); give its bodies a Motion in the deck.", name)
    if not material.flag("is_active", default=True):
        notes.lost("is_active = false is left out (bodies of a deck are there from the start).", name)
        material.find("activation_time").own_text()
    damage = material.find("damage_model")
    if damage.attribute("type") not in ("", "none") and model.attribute("type") not in METALS:
        damage.cover()
        notes.lost(f"the damage model {damage.attribute('type')} is left out (Barreno has that of Johnson and Cook, for metals).", name)


def read_material(material, name, is_rigid, cards, notes):
    """Parameters of a list of Materials. @param is_rigid  a contact moves it  @param cards  name to card, of the user's words  @raises
    Unknown"""
    if name in cards:
        for child in material.children():
            if child.tag != "geom_object":
                child.cover()
        return {"Card": cards[name]}
    model = material.find("constitutive_model")
    kind = model.attribute("type")
    if is_rigid and kind not in METALS:
        parameters = rigid_material(model, material, name, notes)
        look_at_rest(material, model, is_rigid, name, notes)
        return {"Model": parameters.pop("Model"), "Density": material.number("density"), **parameters}
    if kind not in MODELS:
        raise Unknown(f'its model "{kind}" is none of {", ".join(MODELS)}')
    parameters = MODELS[kind](model, material, name, notes)
    look_at_rest(material, model, is_rigid, name, notes)
    return {"Model": parameters.pop("Model"), "Density": material.number("density"), **parameters}


def check_cards(cards, names):
    for name in cards:
        if name not in names:
            raise Fault(f'--card names "{name}", which is no material of the file; it has {", ".join(names) or "none"}.')
