# SPDX-License-Identifier: BSD-3-Clause
"""Time, flags of the method and saved outputs."""

SHAPES = {"linear": "linear", "gimp": "GIMP", "3rdorderBS": "quadratic B-spline", "4thorderBS": "cubic B-spline", "cpdi": "CPDI",
    "fast_cpdi": "CPDI"}
VISCOSITY = (0.2, 2.0)  # Uintah's defaults where it is on
DEFAULT_FIELDS = 20  # instants of particles.e where Uintah counts steps
MANY_STEPS = 2e9  # about the largest integer: no limit
LONGEST = 1e29  # Uintah's way to say: no limit
# What particles.e and history.csv have without being asked.
SAVED = {"p.x", "p.velocity", "p.mass", "p.volume", "p.stress", "p.deformationMeasure", "p.deformationGradient", "p.particleID",
    "p.plasticStrain", "p.temperature", "p.damage",
         "p.evp", "p.porosity", "p.PorePressure", "TotalMass", "TotalMomentum", "KineticEnergy", "StrainEnergy", "AccStrainEnergy",
         "p.displacement"}  # fmt: skip


def time_of(root):
    return {"End Time": root.find("Time").number("maxTime", "max_Time")}


def step_of(root, notes):
    flags, time = root.find("MPM"), root.find("Time")
    kind = flags.text("interpolator", default="linear")
    out = {}
    if kind in SHAPES:
        out["Shape Function"] = SHAPES[kind]
    else:
        notes.lost(f"The interpolator {kind} has no counterpart; the default, GIMP, is taken.")
    if flags.text("time_integrator", default="explicit") != "explicit":
        notes.lost(f"The time integrator {flags.text('time_integrator')} is left out (a deck is computed explicitly; Quasi-Static is its "
            "way to slow loading).")
    viscous = flags.flag("artificial_viscosity")
    linear, quadratic = (flags.number(f"artificial_viscosity_coeff{i}", default=VISCOSITY[i - 1]) if viscous else 0.0 for i in (1, 2))
    out |= {"Linear Viscosity": linear, "Quadratic Viscosity": quadratic}
    damping = flags.number("artificial_damping_coeff", default=0.0)
    if damping:
        out["Damping"] = damping
    multiplier = time.number("timestep_multiplier", default=1.0)
    out["Courant Fraction"] = min(multiplier, 0.8)
    if multiplier > 0.8:
        notes.add(f"timestep_multiplier = {multiplier:g} becomes a Courant Fraction of 0.8, the default (the critical steps of the codes "
            "differ: docs/method.md).")
    for tag, entry in (("delt_init", "Initial Step"), ("delt_max", "Largest Step")):
        value = time.number(tag, default=0.0)
        if 0.0 < value < LONGEST:
            out[entry] = value
    steps = time.number("max_Timesteps", "max_timesteps", default=0.0)
    if 0.0 < steps < MANY_STEPS:
        notes.lost(f"The largest number of steps, {steps:g}, is left out (a run of a deck ends at its End Time).")
    if time.number("initTime", "init_Time", default=0.0):
        notes.lost("initTime is left out (a run of a deck begins at 0).")
    note_flags(flags, notes)
    return out | transfer_of(flags, out)


def transfer_of(flags, step):
    out = {"Transfer": "XPIC", "XPIC Order": 2} if flags.flag("XPIC2") else {}
    if flags.has("cpdi_lcrit"):
        largest = flags.number("cpdi_lcrit")  # of other shape functions it says nothing
        out |= {"Largest Domain": largest} if step.get("Shape Function") == "CPDI" else {}
    return out


def note_flags(flags, notes):
    """Flags that are on, mean something that a deck does not have, and deserve their own sentence; others are listed as unread."""
    erosion = flags.find("erosion")
    kind = erosion.attribute("algorithm")
    if kind not in ("", "none"):
        erosion.cover()
        notes.lost(f"erosion {kind} is left out (a metal that is broken bears no tension and no shear; particles that fail are treated as "
            "Bad Particles says).")
    if flags.flag("delete_rogue_particles"):
        notes.lost("The flag delete_rogue_particles = true has no counterpart; it is left out.")
    if flags.flag("UsePrescribedDeformation"):
        name = flags.text("PrescribedDeformationFile", default="time_defgrad_rotation")
        notes.lost(f"The deformation that {name} prescribes is left out (bodies of a deck move by their own motion); barreno drive takes a "
            "material along a path.")
    if not flags.flag("do_grid_reset", default=True):
        notes.lost("do_grid_reset = false is left out (the grid of a deck is the same in every step).")
    if flags.number("ForceBC_force_increment_factor", default=1.0) != 1.0:
        notes.lost("ForceBC_force_increment_factor is left out (forces of a deck are pressures with Times).")


def gravity_of(root, space, notes):
    found = [root.find(name).vector("gravity", default=(0.0, 0.0, 0.0)) for name in ("PhysicalConstants", "MPM")]
    gravity = space.in_plane(found[0] if any(found[0]) else found[1], "Gravity", "", notes)
    return {"Kind": "gravity", "Acceleration": gravity} if any(gravity) else {}


def output_of(root, end_time, notes):
    archive, out = root.find("DataArchiver"), {}
    if archive.number("outputInterval", default=0.0) > 0.0:
        out["Field Interval"] = archive.number("outputInterval")
    elif archive.has("outputTimestepInterval"):
        out["Field Interval"] = end_time / DEFAULT_FIELDS
        notes.add(f"Output every {archive.number('outputTimestepInterval'):g} steps becomes one every {end_time / DEFAULT_FIELDS:g} of "
            "time (a deck knows no steps).")
    checkpoint = archive.find("checkpoint")
    interval, steps = checkpoint.attribute_number("interval"), checkpoint.attribute_number("timestepInterval")
    if interval and 0.0 < interval < LONGEST:
        out["Checkpoint Interval"] = interval
    elif steps and 1.0 <= steps < MANY_STEPS:
        out["Checkpoint Steps"] = int(steps)
    saved = [save.attribute("label") for save in archive.children("save")]
    left = sorted(label for label in set(saved) - SAVED if not label.startswith("g."))
    if left:
        notes.add(f"Saved variables without a counterpart are left out: {', '.join(left)} (particles.e has what docs/output.md lists).")
    if any(label.startswith("g.") for label in saved):
        notes.add("Variables of the grid (g.*) are not saved (particles.e has particles alone).")
    return out
