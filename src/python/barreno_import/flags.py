# SPDX-License-Identifier: BSD-3-Clause
"""Time, flags of the method and saved outputs."""

SHAPES = {"linear": "linear", "gimp": "GIMP", "3rdorderBS": "quadratic B-spline", "4thorderBS": "cubic B-spline", "cpdi": "CPDI"}
VISCOSITY = (0.2, 2.0)  # Uintah's defaults where it is on
DEFAULT_FIELDS = 20  # instants of particles.e where Uintah counts steps
LONGEST = 1e29  # Uintah's way to say: no limit
# What particles.e and history.csv have without being asked.
SAVED = {"p.x", "p.velocity", "p.mass", "p.volume", "p.stress", "p.deformationMeasure", "p.deformationGradient", "p.particleID", "p.plasticStrain", "p.temperature", "p.damage",
         "p.evp", "p.porosity", "p.PorePressure", "TotalMass", "TotalMomentum", "KineticEnergy", "StrainEnergy", "AccStrainEnergy", "p.displacement"}  # fmt: skip
# Flags that say what Barreno does anyway, or that only choose how Uintah computes.
SILENT = {"time_integrator", "interpolator", "axisymmetric", "artificial_viscosity", "artificial_viscosity_coeff1", "artificial_viscosity_coeff2", "artificial_damping_coeff",
          "withColor", "use_load_curves", "InsertParticles", "InsertParticlesFile", "minimum_particle_mass", "minimum_mass_for_acc", "maximum_particle_velocity",
          "do_grid_reset", "ForceBC_force_increment_factor", "create_new_particles", "manual_new_material", "UseMomentumForm", "extra_solver_flushes",
          "use_CBDI_boundary_condition", "cpdi_lcrit", "artificial_viscosity_heating", "do_contact_friction_heating", "DoExplicitHeatConduction",
          "DoImplicitHeatConduction", "minimum_subcycles_for_F", "computeScaleFactor", "nodes8or27", "erosion", "gravity"}  # fmt: skip


def time_of(root):
    return {"End Time": root.find("Time").number("maxTime", "max_Time")}


def step_of(root, notes):
    flags, time = root.find("MPM"), root.find("Time")
    kind = flags.text("interpolator", default="linear")
    out = {}
    if kind in SHAPES:
        out["Shape Function"] = SHAPES[kind]
    else:
        notes.add(f"The interpolator {kind} has no counterpart; the default, GIMP, is taken.")
    if flags.text("time_integrator", default="explicit") != "explicit":
        notes.add(f"The time integrator {flags.text('time_integrator')} is left out (a deck is computed explicitly; Quasi-Static is its way to slow loading).")
    viscous = flags.flag("artificial_viscosity")
    linear, quadratic = (flags.number(f"artificial_viscosity_coeff{i}", default=VISCOSITY[i - 1]) if viscous else 0.0 for i in (1, 2))
    out |= {"Linear Viscosity": linear, "Quadratic Viscosity": quadratic}
    damping = flags.number("artificial_damping_coeff", default=0.0)
    if damping:
        out["Damping"] = damping
    multiplier = time.number("timestep_multiplier", default=1.0)
    out["Courant Fraction"] = min(multiplier, 0.8)
    if multiplier > 0.8:
        notes.add(f"timestep_multiplier = {multiplier:g} becomes a Courant Fraction of 0.8, the default (the critical steps of the codes differ: docs/method.md).")
    for tag, entry in (("delt_init", "Initial Step"), ("delt_max", "Largest Step")):
        value = time.number(tag, default=0.0)
        if 0.0 < value < LONGEST:
            out[entry] = value
    if time.has("max_timesteps", "max_Timesteps"):
        notes.add("The largest number of steps is left out (a run of a deck ends at its End Time).")
    if time.number("initTime", "init_Time", default=0.0):
        notes.add("initTime is left out (a run of a deck begins at 0).")
    note_flags(flags, notes)
    return out


def note_flags(flags, notes):
    """Flags that are on and mean something that a deck does not have."""
    for child in flags.children():
        text = (child.element.text or "").strip()
        if child.tag == "erosion":
            kind = child.attribute("algorithm")
            if kind not in ("", "none"):
                notes.add(f"erosion {kind} is left out (a metal that is broken bears no tension and no shear; particles that fail are treated as Bad Particles says).")
        elif child.tag not in SILENT and text.lower() not in ("", "false", "none", "[]", "0", "0.0"):
            notes.add(f"The flag {child.tag} = {text} has no counterpart; it is left out.")
    if flags.flag("DoExplicitHeatConduction") or flags.flag("DoImplicitHeatConduction"):
        notes.add("Conduction of heat is left out (Barreno's metals keep their heat where it arises).")


def gravity_of(root, space):
    place = root.find("PhysicalConstants") if root.has("PhysicalConstants") else root.find("MPM")
    gravity = place.vector("gravity", default=(0.0, 0.0, 0.0))
    return {"Kind": "gravity", "Acceleration": space.point(gravity)} if any(gravity) else {}


def output_of(root, end_time, notes):
    archive, out = root.find("DataArchiver"), {}
    if archive.has("outputInterval"):
        out["Field Interval"] = archive.number("outputInterval")
    elif archive.has("outputTimestepInterval"):
        out["Field Interval"] = end_time / DEFAULT_FIELDS
        notes.add(f"Output every {archive.text('outputTimestepInterval')} steps becomes one every {end_time / DEFAULT_FIELDS:g} of time (a deck knows no steps).")
    checkpoint = archive.find("checkpoint").element
    if checkpoint.get("interval"):
        out["Checkpoint Interval"] = float(checkpoint.get("interval"))
    elif checkpoint.get("timestepInterval"):
        out["Checkpoint Steps"] = int(float(checkpoint.get("timestepInterval")))
    saved = [save.attribute("label") for save in archive.children("save")]
    left = sorted(label for label in set(saved) - SAVED if not label.startswith("g."))
    if left:
        notes.add(f"Saved variables without a counterpart are left out: {', '.join(left)} (particles.e has what docs/output.md lists).")
    if any(label.startswith("g.") for label in saved):
        notes.add("Variables of the grid (g.*) are not saved (particles.e has particles alone).")
    return out
