# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of tests, as tables: their columns, and the parameters that they say something about."""

from typing import NamedTuple

ELASTIC = ("B0", "B1", "B2")
SHEAR = ("G0", "G1", "G2")
CRUSH = ("p0_crush_curve", "p1_crush_curve", "p3_crush_curve")
STRENGTH = ("PEAKI1", "FSLOPE", "STREN", "YSLOPE")


class Kind(NamedTuple):
    """A curve follows a specimen row by row; a table has a specimen in each row.

    control   column that the specimen is driven by (curve), or that says which specimen a row is (table; may be absent)
    channels  columns that the rock is compared in; of alternatives one is needed
    """

    curve: bool
    control: str
    channels: tuple  # of tuples of alternatives, the first group is needed
    fits: tuple
    meaning: str


KINDS = {
    "hydrostatic": Kind(True, "volume_strain", (("pressure",),), (*ELASTIC, *CRUSH), "pressure on all sides"),
    "triaxial": Kind(
        True, "axial_strain", (("axial_stress", "differential_stress"), ("volume_strain", "radial_strain")),
        (*ELASTIC, *SHEAR, *CRUSH, *STRENGTH, "CR"), "compression along the axis at constant confinement",
    ),
    "uniaxial strain": Kind(
        True, "axial_strain", (("axial_stress",), ("radial_stress",)),
        (*ELASTIC, *SHEAR, *CRUSH, *STRENGTH, "CR"), "compression along the axis without radial strain",
    ),
    "bulk modulus": Kind(False, "pressure", (("bulk_modulus",),), ELASTIC, "tangent (unloading) bulk modulus"),
    "poisson's ratio": Kind(False, "pressure", (("poissons_ratio",),), ("G1", "G2"), "of unloading"),
    "crush pressure": Kind(False, "", (("crush_pressure",),), ("p0_crush_curve",), "hydrostatic pressure at which pores begin to crush"),
    "open pores": Kind(False, "pressure", (("open_pores",),), CRUSH, "pore strain that is left at a pressure, over that of virgin rock"),
    "triaxial strength": Kind(
        False, "confinement", (("differential_stress",),), (*STRENGTH, "CR", *CRUSH), "largest differential stress at a confinement"
    ),
    "tensile strength": Kind(False, "", (("tensile_strength",),), STRENGTH, "in uniaxial tension"),
    "compaction onset": Kind(
        False, "mean_stress", (("differential_stress",),), (*STRENGTH, "CR", "p0_crush_curve"),
        "differential stress at which rock under a mean stress yields first",
    ),
}  # fmt: skip

DIMENSIONS = {
    "pressure": "stress", "axial_stress": "stress", "differential_stress": "stress", "radial_stress": "stress",
    "bulk_modulus": "stress", "crush_pressure": "stress", "confinement": "stress", "tensile_strength": "stress",
    "mean_stress": "stress", "volume_strain": "strain", "axial_strain": "strain", "radial_strain": "strain",
    "poissons_ratio": "ratio", "open_pores": "ratio", "uncertainty": "ratio",
}  # fmt: skip


def columns_of(kind):
    """All columns that a file of this kind may have, besides source."""
    channels = [name for group in kind.channels for name in group]
    return [*([kind.control] if kind.control else []), *channels, *([] if kind.curve else ["uncertainty"])]
