# SPDX-License-Identifier: BSD-3-Clause
"""Fields of particles by their names: values, units, colours and their range."""

import dataclasses
import difflib

import numpy as np

from barreno.report.porosity import permanent_porosity
from barreno.report.run_tables import UNITS
from barreno.runs.faults import Fault

# The same quantity under the names of two models.
PLASTIC_STRAIN = ("equivalent_plastic_strain", "plastic_strain")
DERIVED = ("speed", "porosity")
SIGNED = ("velocity_", "darcy_velocity_", "plastic_volume_strain", "stress_")
# Of SI units: the unit of pictures, in SI.
PICTURE_UNITS = {"Pa": ("MPa", 1e6), "kg/m3": ("kg/m³", 1.0), "J/kg": ("kJ/kg", 1e3), "m": ("mm", 1e-3), "s": ("ns", 1e-9)}
DOUBLING = ("cell_size", "step_length")
COLOURS = {"cell_size": "YlGnBu_r", "step_length": "YlOrRd_r", "pressure": "viridis", "pore_pressure": "viridis", "porosity": "cividis",
    "speed": "plasma", "temperature": "magma"}


@dataclasses.dataclass
class Look:
    """How a field is drawn."""

    label: str
    scale: float  # of the picture's unit, in SI
    colours: str
    signed: bool  # zero is the middle of the colours
    both: bool  # neither sign may drown the other
    doubling: bool = False  # a few positive values, each twice another: colours follow their logarithm


def unit_of(name):
    """(unit of the picture, in SI); a field that the table lacks, of a model from elsewhere, has none."""
    si = UNITS.get("velocity_x" if name == "speed" else name)
    return PICTURE_UNITS.get(si, (si, 1.0))


def look_of(name):
    unit, scale = unit_of(name)
    signed = name.startswith(SIGNED)
    colours = "RdBu_r" if signed else next((found for start, found in COLOURS.items() if name.startswith(start)), "inferno")
    words = "plastic strain" if name in PLASTIC_STRAIN else name.replace("_", " ")
    if name == "plastic_volume_strain":
        colours, words = "RdBu", "plastic volume strain: crushed < 0 < dilated"
    return Look(f"{words} [{unit}]" if unit else words, scale, colours, signed, name == "plastic_volume_strain", name in DOUBLING)


def known_fields(file, deck):
    """What --left, --right and --field can name."""
    found = [name for name in file.fields() if name != "status"]
    if "velocity_x" in found:
        found.append("speed")
    if "porosity" not in found and "plastic_volume_strain" in found and any("p3_crush_curve" in deck.parameters("Materials", m)
            for m in deck.entries("Materials")):
        found.append("porosity")
    return found


def check_field(option, name, known):
    if name in known:
        return
    near = difflib.get_close_matches(name.lower().replace(" ", "_"), known, 1, 0.6)
    hint = f"did you mean {near[0]}?" if near else "choose one of these."
    raise Fault(f'{option} "{name}" is not a field of this run, which has {", ".join(sorted(known))}; {hint}')


def values_of(frame, deck, name):
    """Values in SI of the particles of a frame; nan where a material does not carry the field."""
    if name == "speed":
        parts = [frame.of_alive([f"velocity_{axis}"]) for axis in "xyz"[: frame.file.dimensions]]
        return np.sqrt(np.sum(np.square(parts), axis=0))
    if name == "porosity" and name not in frame.names:
        return permanent_porosity(frame, deck)
    return frame.of_alive(PLASTIC_STRAIN if name in PLASTIC_STRAIN else [name])


def range_of_doubling(values):
    """All that is positive, however little of the picture it is; a single value in the middle."""
    positive = values[np.isfinite(values) & (values > 0.0)]
    if not len(positive):
        return 0.5, 2.0
    low, high = float(positive.min()), float(positive.max())
    return (low, high) if high > 1.01 * low else (low / 2.0, high * 2.0)


def range_of(values, areas, look, percent=98.5):
    """Colour range that leaves out 100 - percent of the picture at each end: a jet in pieces has single particles
    under thousands of times the pressure of the rock."""
    if look.doubling:
        return range_of_doubling(values)
    finite = np.isfinite(values)
    if not finite.any():
        return 0.0, 1.0
    order = np.argsort(values[finite])
    share = np.cumsum(areas[finite][order]) / max(areas[finite].sum(), 1e-300)
    at = lambda part: float(values[finite][order][min(np.searchsorted(share, part), len(order) - 1)])  # noqa: E731
    lower, upper = min(0.0, at(1.0 - 0.01 * percent)), at(0.01 * percent)
    if look.signed:
        most, least = max(-lower, upper), min(-lower, upper)
        most = min(most, 3.0 * least) if look.both and least > 0.01 * most else most
        lower, upper = -most, most
    return lower, upper if upper > lower else lower + 1.0
