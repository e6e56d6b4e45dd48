# SPDX-License-Identifier: BSD-3-Clause
"""Fields of particles by their names: values, units, colours and their range."""

import dataclasses
import difflib

import numpy as np

from matplotlib.colors import LogNorm, Normalize, TwoSlopeNorm

from barreno.report.porosity import permanent_porosity, virgin_porosity
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
    "speed": "plasma", "temperature": "magma",
    "plastic_strain": "YlGnBu", "equivalent_plastic_strain": "YlGnBu"}  # of sound rock: light, unlike the red of a jet


@dataclasses.dataclass
class Look:
    """How a field is drawn."""

    label: str
    scale: float  # of the picture's unit, in SI
    colours: str
    signed: bool  # zero is the middle of the colours
    both: bool  # neither sign may drown the other
    doubling: bool = False  # a few positive values, each twice another: colours follow their logarithm
    centre: float = None  # value with the neutral colour, in the picture's unit, where that is not zero


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


def virgin_of(file, deck):
    """Virgin porosity of the rock with the most particles; nan without such rock."""
    found = [(size, virgin_porosity(deck, name)) for name, size in zip(file.block_names, file.sizes)]
    return max(((size, virgin) for size, virgin in found if np.isfinite(virgin)), default=(0, float("nan")))[1]


def look_in(file, deck, name):
    """The look of a field in a run: porosity has a neutral colour at the virgin value, less is crushed and more is dilated, as in the
    plastic volume strain."""
    look, virgin = look_of(name), virgin_of(file, deck) if name == "porosity" else float("nan")
    if not np.isfinite(virgin):
        return look
    return dataclasses.replace(look, label=f"porosity: crushed < {virgin:.3g} < dilated", colours="RdBu", centre=virgin)


def norm_of(look, limits):
    """Of Matplotlib: from values in the picture's unit to colours."""
    if look.doubling:
        return LogNorm(*limits)
    if look.centre is not None:
        return TwoSlopeNorm(look.centre, *limits)
    return Normalize(*limits)


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


def range_around(centre, lower, upper):
    """A range of positive values on both sides of a centre; neither side is wider than three times the other but for zero."""
    below, above = max(centre - lower, 0.0), max(upper - centre, 0.0)
    least = max(below, above, 0.05 * centre) / 3.0
    return centre - min(max(below, least), centre), centre + max(above, least)


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
    if look.centre is not None:
        return range_around(look.centre, at(1.0 - 0.01 * percent), at(0.01 * percent))
    lower, upper = min(0.0, at(1.0 - 0.01 * percent)), at(0.01 * percent)
    if look.signed:
        most, least = max(-lower, upper), min(-lower, upper)
        most = min(most, 3.0 * least) if look.both and least > 0.01 * most else most
        lower, upper = (-most, most) if most > 0.0 else (-1.0, 1.0)
    return lower, upper if upper > lower else lower + 1.0
