# SPDX-License-Identifier: BSD-3-Clause
"""Fields of the explorable view: which ones, their colours and range, their values at the start, and the state of particles."""

import numpy as np

from barreno.report.explore.codes import codes_of, packed, scale_of
from barreno.report.fields import PLASTIC_STRAIN, look_of, range_of, unit_of, values_of
from barreno.report.porosity import permanent_porosity, virgin_porosity
from barreno.report.zones import CHANGED
from barreno.runs.plots import plt

# In the order of the choice on the page; the fields of the still pictures come before them.
CHOICE = ("pressure", "speed", "equivalent_plastic_strain", "plastic_strain", "plastic_volume_strain", "porosity", "damage", "density",
    "temperature", "pore_pressure", "shear_stress", "velocity_x", "velocity_y", "coherence", "burn", "cell_size", "step_length")
COLOURS = 254  # of a field; two more bytes mean no value and not drawn
DIVERGING = {"porosity": "RdBu"}  # the value at the start is neutral
IN_JET = ("speed", "velocity_x", "velocity_y", "temperature", "density", "cell_size", "step_length")  # looked at in the jet itself
CLOSE = ("temperature",)  # far from zero: colours do not begin there
LEAST = 1.5  # percent of the values that are below the colours of those
STATES = ("elastic", "yielded", "crushed", "dilated", "broken")
STATE_COLOURS = ("#d9dee3", "#f2c14e", "#c0392b", "#2e86c1", "#4a235a")
YIELDED = 0.002  # plastic strain
NOTHING = 1e-6  # of the unit of the picture: less is no difference
UNIFORM = 1e-3  # of the range: values of a material at the start that differ by less count as one


def chosen_fields(known, wished):
    """Names of fields on the page, the wished ones first; the two names of plastic strain are one field."""
    names, strain = [], False
    for name in (*wished, *CHOICE):
        if name not in known or name in names or (strain and name in PLASTIC_STRAIN):
            continue
        strain = strain or name in PLASTIC_STRAIN
        names.append(name)
    return names


def palette(name):
    """Colours as one text of six hexadecimal digits each."""
    found = plt.get_cmap(name)(np.linspace(0.0, 1.0, COLOURS))[:, :3]
    return "".join(f"{int(byte):02x}" for byte in np.rint(255.0 * found).ravel())


def starts(first, blocks, names):
    """[{value, materials}] at the first output, of materials in which it is one value; values that are close together are one."""
    known = np.isfinite(first)
    spread, found = float(np.ptp(first[known])) if known.any() else 0.0, []
    for block in np.unique(blocks[known]):
        values = first[known & (blocks == block)]
        value, close = float(np.median(values)), max(UNIFORM * spread, 1e-6 * float(np.abs(values).max()))
        if np.ptp(values) > close:
            continue
        same = next((one for one in found if abs(one["value"] - value) <= close), None)
        if same:
            same["materials"].append(names[block])
        else:
            found.append({"value": value, "materials": [names[block]]})
    return found


def limits_of(values, areas, look):
    """Range of the colours in SI: the median over the outputs of the range of each, widened to the last one's."""
    ranges = []
    for row, area in zip(values, areas):
        known = np.isfinite(row) & (area > 0.0)
        if known.any():
            ranges.append(range_of(row[known], area[known], look))
    if not ranges:
        return 0.0, 1.0
    low, high = np.array(ranges).T
    return min(float(np.median(low)), float(low[-1])), max(float(np.median(high)), float(high[-1]))


def limits_of_one(value, size, signed):
    """A range for a field that has one value everywhere, from zero to that value, or to one unit of the picture.

    @param size  of the unit"""
    reach = value if abs(value) >= NOTHING * size else size
    return (-abs(reach), abs(reach)) if signed else (min(0.0, reach), max(0.0, reach))


def around(middle, limits):
    """Range with a value in its middle: the neutral colour is that value."""
    reach = max(abs(limits[1] - middle), abs(limits[0] - middle), 1e-12)
    return middle - reach, middle + reach


def field_of(stack, deck, name, areas, levels):
    """A field as the page holds it."""
    look, (unit, size) = look_of(name), unit_of(name)
    values = stack.table(lambda frame: values_of(frame, deck, name))
    values[~(np.abs(values) < 1e300)] = np.nan
    blocks = stack.file.block[stack.elements]
    initial = starts(values[0], blocks, stack.file.block_names)
    middle = initial[0]["value"] if len(initial) == 1 else 0.0
    limits, colours = limits_of(values, areas, look), DIVERGING.get(name, look.colours)
    neutral = 0.0 if look.signed else middle if name in DIVERGING and len(initial) == 1 else None
    if neutral is not None:
        limits = around(neutral, limits)
    elif name in CLOSE and np.isfinite(values).any():
        limits = min(float(np.nanpercentile(values, LEAST)), limits[1] - UNIFORM * abs(limits[1])), limits[1]
    least, most = np.nanmin(values, initial=np.inf), np.nanmax(values, initial=-np.inf)
    if 0.0 <= most - least < NOTHING * size:
        limits = limits_of_one(float(most), size, look.signed)
    scale = scale_of(values, middle, limits[1] - limits[0], levels)
    lacking = [stack.file.block_names[block] for block in np.unique(blocks) if not np.isfinite(values[:, blocks == block]).any()]
    return {
        "name": name, "label": look.label.removesuffix(" [-]"), "unit": "" if unit == "-" else unit, "size": size, "limits": limits,
        "doubling": look.doubling, "lacking": lacking, "inJet": name in IN_JET,
        "palette": palette(colours), "initial": initial, "scale": scale, "neutral": neutral,
        "codes": packed(codes_of(values, scale, levels)),
    }  # fmt: skip


def states_of(frame, deck):
    """Number of the state of every particle from 1 on; nan where the material has nothing that tells.

    Crushed and dilated rock is that of the report's zones: its porosity has changed by more than a part of the virgin one."""
    strain, damage = values_of(frame, deck, PLASTIC_STRAIN[0]), frame.of_alive(["damage"])
    state = np.where(np.isfinite(strain), 1.0 + (strain > YIELDED), np.nan)
    virgin = np.array([virgin_porosity(deck, name) for name in frame.file.block_names])[frame.block]
    porosity = permanent_porosity(frame, deck)
    state[porosity < (1.0 - CHANGED) * virgin] = 1 + STATES.index("crushed")
    state[porosity > (1.0 + CHANGED) * virgin] = 1 + STATES.index("dilated")
    state[damage >= 1.0 - 1e-6] = 1 + STATES.index("broken")
    return state


def state_field(stack, deck):
    codes = np.nan_to_num(stack.table(lambda frame: states_of(frame, deck))).astype(np.uint8)
    return {
        "name": "state", "label": "state", "inJet": False, "classes": list(STATES), "colours": list(STATE_COLOURS), "codes": packed(codes),
    }  # fmt: skip


def material_field(stack, colours):
    """@param colours  one of every material"""
    codes = (1 + stack.file.block[stack.elements]).astype(np.uint8 if len(colours) < 255 else np.uint16)
    return {
        "name": "material", "label": "material", "inJet": True, "classes": stack.file.block_names, "colours": colours,
        "codes": packed(codes),
    }  # fmt: skip
