# SPDX-License-Identifier: BSD-3-Clause
"""Units of the columns of a run's tables, as docs/output.md lists them (a test compares both)."""

ENERGIES = ("kinetic", "elastic", "plastic", "viscous", "boundary_work", "launched_kinetic", "body_work", "damped", "stress_integration",
    "transfer", "removed_kinetic", "friction", "remembered", "explosive", "fluid_work")
UNITS = {
    **dict.fromkeys(ENERGIES, "J"), **dict.fromkeys(("time", "dt"), "s"), **dict.fromkeys(("mass", "jet_mass_inside"), "kg"),
    **dict.fromkeys(("momentum", "rigid_impulse"), "kg m/s"),
    **dict.fromkeys(("depth", "channel_depth", "probed_depth", "channel_radius_mid"), "m"),
    **dict.fromkeys(("fluid", "fluid_inflow", "fluid_removed", "probed_volume"), "m3"), "tip_velocity": "m/s",
}  # fmt: skip
ENDINGS = {"_force_x": "N", "_force_y": "N", "_force_z": "N", "_impulse_x": "kg m/s", "_impulse_y": "kg m/s", "_impulse_z": "kg m/s",
    "_inner_radius": "m", "_outer_radius": "m", "_volume": "m3", "_pressure": "Pa"}  # behind the name of a body


def unit_of_column(name):
    """Of the CSV files of a run; "-" for counts and ratios."""
    return UNITS.get(name) or next((unit for ending, unit in ENDINGS.items() if name.endswith(ending)), "-")
