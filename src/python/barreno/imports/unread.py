# SPDX-License-Identifier: BSD-3-Clause
"""What of the file no converter has read: elements, attributes and texts become remarks here, all of them."""

from barreno.imports.ups import ALL, TEXT

# Sections that only choose what is written, how work is shared, and what is measured.
NEUTRAL_SECTIONS = {"Meta", "DataArchiver", "DataAnalysis", "LoadBalancer", "Scheduler", "ProfileDriver", "Debug", "ParallelComponent",
    "VisIt", "TaskThrottle", "OnTheFlyAnalysis"}
# Ends of paths without effect on the answer of a deck.
NEUTRAL = (
    "Time/delt_min", "Time/max_delt_increase", "Time/max_initial_delt", "Time/initial_delt_range", "Time/clamp_time_to_output",
    "Time/override_restart_delt",
    "Time/clamp_timesteps_to_output", "Time/end_on_max_time_exactly", "Time/end_at_max_time_exactly", "Box@label", "Box@name",
    "Box/patches", "Box/extraCells", "Level/patches", "Level/extraCells",
    "MPM/withColor", "MPM/nodes8or27", "MPM/minimum_particle_mass", "MPM/minimum_mass_for_acc", "MPM/minimum_subcycles_for_F",
    "MPM/computeScaleFactor",
    "MPM/extra_solver_flushes", "MPM/UseMomentumForm", "MPM/use_CBDI_boundary_condition", "MPM/testForNegTemps_mpm",
    "MPM/DeleteGeometryObjects", "MPM/CanAddMPMMaterial",
    "MPM/interpolateParticleTempToGridEveryStep", "MPM/computeNodalHeatFlux", "MPM/computeColinearNormals",
    "MPM/restartOnLargeNodalVelocity", "MPM/with_gauss_solver",
    "MPM/boundary_traction_faces", "MPM/solver", "MPM/convergence_criteria_disp", "MPM/convergence_criteria_energy",
    "MPM/iters_before_timestep_restart",
    "MPM/num_iters_to_decrease_delT", "MPM/num_iters_to_increase_delT", "MPM/delT_decrease_factor", "MPM/delT_increase_factor",
    "constitutive_model/tolerance",
    "PhysicalConstants/reference_pressure", "geom_object/temperature", "geom_object/color", "geom_object/numLevelsParticleFilling",
    "geom_object/pressure", "geom_object/density",
    "material/specific_heat", "material/thermal_conductivity", "material/C_p", "material/room_temp", "material/melt_temp",
    "contact/volume_constraint", "contact/separation_factor",
    "contact/OneOrTwoStep", "pressure/res", "load_curve/id", "pressure/numberOfParticlesOnLoadSurface",
    "material@index", "material@id",
)  # fmt: skip
# Switches that are off where a file leaves them out: written with false they say nothing.
OFF = {
    "artificial_viscosity_heating", "refine_particles", "AMR", "do_contact_friction_heating", "UseGradientEnhancedVelocityProjection",
    "DoExplicitHeatConduction", "XPIC2",
    "DoPressureStabilization", "DoCapDensity", "DoDefGradAveraging", "DoThermalExpansion", "temperature_solve", "use_load_curves",
    "use_cohesive_zones", "use_volume_integral",
    "UsePrescribedDeformation", "exactDeformation", "InsertParticles", "DoImplicitHeatConduction", "do_scalar_diffusion",
    "do_auto_cycle_bc", "auto_cycle_use_minmax",
    "coupled_flow_analysis", "PorePressureFilter", "create_new_particles", "manual_new_material", "axisymmetric", "artificial_viscosity",
    "is_rigid", "do_conc_reduction",
    "usePlasticity", "useDamage", "useModifiedEOS", "useInitialStress", "useInitialDensity", "evolve_porosity", "evolve_specific_heat",
    "compute_specific_heat", "isothermal",
    "check_TEPLA_failure_criterion", "check_max_stress_failure", "outward_normal", "cylinder_end", "axisymmetric_end", "axisymmetric_side",
    "normal_only", "include_rotation",
    "use_svf", "colinear_norms", "delete_rogue_particles", "LocalizeParticles", "brittle_damage_allowRecovery",
    "brittle_damage_printDamage", "do_rotation",
}  # fmt: skip
# Switches that are on where a file leaves them out, and coefficients of nothing.
ON = {"do_melting", "DoMechanics", "dynamic", "testForNegTemps_mpm", "is_active", "do_grid_reset", "DoTransientImplicitHeatConduction"}
NOTHING = {"coeff_thermal_expansion", "char_time", "gruneisen_parameter", "failure_std", "initial_pressure", "hardening_modulus", "alpha"}


def note_unread(root, notes):
    """Every element, attribute and text that is neither in the record nor within a covered element becomes a remark."""
    walk(root.element, "", "", root.record, notes)


def walk(element, path, subject, record, notes):
    if (element, ALL) in record:
        return
    for name, value in element.attrib.items():
        if (element, "@" + name) not in record:
            note(f"{path}@{name}", value, subject, notes)
    stray = [child.tail for child in element] + ([element.text] if (element, TEXT) not in record else [])
    for text in stray:
        if text and text.strip():
            whole = path or "Uintah_specification"
            note(f'{whole}, text "{" ".join(text.split())}"', "", subject, notes, f"{whole}, text")
    number = 0
    for child in element:
        number += child.tag == "material"
        of_material = child.tag == "material" and path.endswith("MPM")
        about = subject or ((child.get("name") or f"Material {number}") if of_material else "")
        below = child.tag if of_material else f"{path}/{child.tag}".lstrip("/")
        if (child, "") in record:
            walk(child, below, about, record, notes)
        else:
            note_element(child, below, about, notes)


def note_element(element, path, subject, notes):
    """Of an element that nobody looked for, and of all that stands in it."""
    inner = [f"{one.tag}{''.join(f', {one.tag}@{name}' for name in one.attrib)}" for one in element.iter() if one is not element]
    own = [f"@{name} = {value}" for name, value in element.attrib.items()]
    text = " ".join((element.text or "").split())
    if not inner and not text and own in (["@type = none"], ["@algorithm = none"]):
        notes.add_neutral(path)
    elif inner:
        stray = [t for one in element.iter() for t in (one.text if len(one) else None, one.tail if one is not element else None) if t
            and t.strip()]
        names = ", ".join(dict.fromkeys([*own, *inner, *(" ".join(t.split()) for t in stray)]))
        note(f"{path} with all in it ({names})", "", subject, notes, path)
    else:
        name = f"{path} ({', '.join(own)})" if own else path
        note(name, text, subject, notes, path)


def is_neutral(path, value):
    tag = path.rsplit("/", 1)[-1]
    return (
        path.split("/")[0].split("@")[0].split(",")[0] in NEUTRAL_SECTIONS
        or any(path == end or path.endswith("/" + end) for end in NEUTRAL)
        or (tag in OFF and value.lower() == "false")
        or (tag in ON and value.lower() == "true")
        or (tag in NOTHING and is_zero(value))
        or (tag == "periodic" and value.replace(" ", "") == "[0,0,0]")
    )


def is_zero(text):
    try:
        return float(text) == 0.0
    except ValueError:
        return False


def note(name, value, subject, notes, path=None):
    text = " ".join(value.split())
    if is_neutral(path or name, text):
        notes.add_neutral(name)
    else:
        notes.lost(f"{name}{f' = {text}' if text else ''} is left out (it has no counterpart in a deck, or none that the import knows).",
            subject)
