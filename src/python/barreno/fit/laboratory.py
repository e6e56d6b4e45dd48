# SPDX-License-Identifier: BSD-3-Clause
"""What laboratories call columns and measure instead of stress and strain, and whether the signs of a test can be those of rock."""

import re
from dataclasses import dataclass, field

import numpy

from barreno.fit import units
from barreno.fit.kinds import DIMENSIONS, KINDS, columns_of
from barreno.runs.faults import Fault

# What a column may be beside the columns of a kind; stress and strain follow from it.
RAW = {
    "axial_force": "force", "differential_force": "force", "axial_displacement": "length", "diameter_change": "length", "time": "time",
    "confinement": "stress",
}  # fmt: skip
SYNONYMS = {
    "axial_strain": ("strain_axial", "eps_a", "eps_1", "eps1", "epsilon_1", "ε1", "ε_a", "vertical_strain"),
    "radial_strain": ("lateral_strain", "transverse_strain", "strain_radial", "strain_lateral", "eps_r", "eps_3", "eps3", "ε3", "ε_r"),
    "volume_strain": ("volumetric_strain", "vol_strain", "vol._strain", "strain_volumetric", "eps_v", "ε_v", "εv"),
    "axial_stress": ("stress_axial", "sigma_1", "sigma1", "sig1", "σ1", "vertical_stress"),
    "differential_stress": ("deviatoric_stress", "deviator_stress", "deviator", "stress_difference", "q", "sigma_d", "σ1_σ3"),
    "radial_stress": ("lateral_stress",),
    "pressure": ("hydrostatic_pressure", "confining_pressure", "cell_pressure", "hydrostatic_stress"),
    "confinement": ("confining_pressure", "cell_pressure", "confining_stress", "sigma_3", "sigma3", "σ3"),
    "axial_displacement": ("displacement", "stroke", "axial_deformation"),
    "time": ("elapsed_time", "test_time", "t"),
}
TITLES = {  # lines above the column names that say what a line of the header does
    "confinement": r"confin\w*(\s+(pressure|stress))?|cell pressure",
    "diameter": r"(specimen |sample |core )?(diameter|dia\.?)",
    "length": r"(specimen |sample |core )?(length|height)",
    "porosity": r"porosity",
}
COMPRESSIVE = ("pressure", "axial_stress", "differential_stress", "axial_strain", "confinement", "axial_force", "differential_force",
    "axial_displacement")
ELASTIC = 0.3  # of the largest stress, up to which a rock is taken as elastic
SURE = 3.0  # standard deviations by which a slope must be wrong


@dataclass
class Said:
    """What the words of the command add to the files."""

    columns: dict = field(default_factory=dict)  # name in the file -> column
    signs: dict = field(default_factory=dict)  # column -> whether compression is negative in it
    keys: list = field(default_factory=list)  # (file name or "", key, value)
    used: set = field(default_factory=set)  # names of columns that a file had

    def keys_of(self, file):
        return {key: value for name, key, value in self.keys if not name or name == file.rsplit("/", 1)[-1]}


def known_names(said):
    names = {*DIMENSIONS, *RAW, *said.columns}
    return names.union(*SYNONYMS.values())


def dimension_of(name):
    return DIMENSIONS.get(name) or RAW[name]


def keys_of_titles(file, table):
    """Lines such as "Confining pressure: 40 MPa" above the column names."""
    keys = {}
    for _, cells in table.titles:
        text = " ".join(filter(None, cells))
        for key, pattern in TITLES.items():
            found = re.fullmatch(rf"(?:{pattern})\s*[:=]?\s*(?:[\[(](\S+)[\])]\s*[:=]?)?\s*([-+\d.,eE]+)\s*(\S*)", text, re.IGNORECASE)
            if found and key not in keys:
                number, unit = found.groups()[-2:]
                keys[key] = f"{number.replace(',', '.')} {unit or found.groups()[-3] or ''}".strip()
                table.notes.append(f"'{text}' is read as {key}.")
    return keys


def raw_columns(what):
    """From which stresses and strains of a kind may follow."""
    if not what.curve:
        return ()
    return (*RAW, "axial_strain", "radial_strain") if what.control == "volume_strain" else tuple(RAW)


def renamed(file, table, what, said):
    """Names of the columns: as said, as known, or as guessed."""
    possible = {*columns_of(what), *raw_columns(what), "source"}
    names = []
    for name in table.names:
        if name in said.columns:
            said.used.add(name)
            if said.columns[name] not in possible:
                raise Fault(f"--column \"{name}={said.columns[name]}\" names no column of {file}; they are {', '.join(sorted(possible))}.")
            names.append(said.columns[name])
            continue
        names.append(name)
    for i, name in enumerate(names):
        guess = next((known for known, words in SYNONYMS.items() if name in words and known in possible and known not in names), None)
        if name not in possible and guess:
            table.notes.append(f"'{table.heads[i]}' is read as {guess}.")
            names[i] = guess
    return names


def negative_columns(file, keys, said, names):
    """Columns in which compression is negative: "positive", or "positive, volume_strain negative"."""
    first, *others = [part.strip().lower() for part in keys.get("compression", "").split(",")]
    if first not in ("positive", "negative"):
        raise Fault(f"{file} does not say its sign convention; add a line '# compression: positive' (or negative), or --say "
            "compression=positive.")
    negative = {name for name in names if (first == "negative") != (name == "diameter_change")}
    for other in others:
        name, _, word = other.replace("dilatancy positive", "volume_strain negative").partition(" ")
        if name not in names or word not in ("positive", "negative"):
            raise Fault(f"{file} has '# compression: {keys['compression']}', of which '{other}' is no column with positive or negative; "
                "write for example 'positive, volume_strain negative'.")
        negative = negative | {name} if word == "negative" else negative - {name}
    for name, is_negative in said.signs.items():
        negative = negative | {name} if is_negative else negative - {name}
    return negative


def turn_signs(file, keys, said, columns):
    """Turns signs that are those of mechanics, and checks that the data are as the file says."""
    signed = [name for name in columns if dimension_of(name) in ("stress", "strain", "force")
        or name in ("axial_displacement", "diameter_change")]
    negative = negative_columns(file, keys, said, signed)
    for name in signed:
        if name in negative:
            columns[name] = -columns[name] + 0.0
    for name in set(COMPRESSIVE) & set(columns):
        values = columns[name]
        if values[numpy.argmax(numpy.abs(values))] < 0.0:
            said_sign, other = ("negative", "positive") if name in negative else ("positive", "negative")
            raise Fault(f"{file} says that compression is {said_sign}, but the largest value of '{name}' has the other sign; correct the "
                f"column, or write '# compression: {other}' (--sign {name}={other} for the column alone).")


def dimensions_of_specimen(file, keys, key, need):
    if key not in keys:
        raise Fault(f"{file} has the column '{need}' but not the {key} of the specimen; add a line such as '# {key}: 50 mm', or --say "
            f"\"{key}=50 mm\".")
    value = units.quantity(keys[key], "length", f"{file}, '{key}'")
    if not 1e-4 <= value <= 10.0:
        raise Fault(f"{file} has '# {key}: {keys[key]}', which no specimen has; correct the line.")
    return value


def strains_from_lengths(file, kind, keys, columns, notes):
    if "axial_displacement" in columns and "axial_strain" not in columns:
        length = dimensions_of_specimen(file, keys, "length", "axial_displacement")
        columns["axial_strain"] = columns["axial_displacement"] / length
        notes.append(f"{file}: axial_strain is axial_displacement over {1e3 * length:.4g} mm (the machine's own compliance is in it).")
    if "diameter_change" in columns and not {"radial_strain", "volume_strain"} & set(columns):
        columns["radial_strain"] = columns["diameter_change"] / dimensions_of_specimen(file, keys, "diameter", "diameter_change")
        notes.append(f"{file}: radial_strain is diameter_change over the diameter.")
    if kind == "hydrostatic" and "volume_strain" not in columns:
        axial, radial = (columns.get(name) for name in ("axial_strain", "radial_strain"))
        axial, radial = radial if axial is None else axial, axial if radial is None else radial
        if keys.get("strain", "").lower() == "logarithmic":
            columns["volume_strain"] = axial + 2.0 * radial
        else:
            columns["volume_strain"] = 1.0 - (1.0 - axial) * (1.0 - radial) ** 2
        names = sorted({"axial_strain", "radial_strain"} & set(columns))
        notes.append(f"{file}: volume_strain is that of {' and '.join(names)}{' alike on all sides' if len(names) == 1 else ''}.")


def stress_from_force(file, kind, keys, columns, confinement, notes):
    """True stress where the radial strain is known, else per original area."""
    force = next((name for name in ("axial_force", "differential_force") if name in columns), None)
    if force is None or {"axial_stress", "differential_stress"} & set(columns):
        return
    diameter = dimensions_of_specimen(file, keys, "diameter", force)
    strain = columns.get("radial_strain")
    if strain is None and {"axial_strain", "volume_strain"} <= set(columns):
        strain = 0.5 * (columns["volume_strain"] - columns["axial_strain"])
    area = 0.25 * numpy.pi * diameter**2 * (1.0 if strain is None else (1.0 - (strain - strain[0])) ** 2)
    stress = columns[force] / area
    name = "axial_stress"
    if kind == "triaxial":
        first, least = abs(stress[0]), 0.02 * stress.max()
        if force == "differential_force" or first <= max(0.1 * confinement, least if not confinement else 0.0):
            name = "differential_stress"
        elif abs(first - confinement) > 0.2 * confinement:
            raise Fault(f"{file} begins with an {force} of {stress[0] / 1e6:.4g} MPa over the area, neither 0 nor the confinement of "
                f"{confinement / 1e6:.4g} MPa, so it is open whether the force includes it; say which with --column "
                "\"NAME=differential_force\", or correct it.")
    columns[name] = stress
    area_words = "original area (no radial strain is known)" if strain is None else "present area"
    notes.append(f"{file}: {name} is {force} per {area_words}, diameter {1e3 * diameter:.4g} mm.")


def tell_rate(file, control, columns, notes):
    """The fit takes tests as slow: the rate is told."""
    if "time" not in columns or control not in columns:
        return
    time = columns["time"]
    if not time[-1] > time[0]:
        raise Fault(f"{file} has a column 'time' that does not increase; sort the rows or take the column out.")
    rate = numpy.abs(numpy.diff(columns[control])).sum() / (time[-1] - time[0])
    fast = " (a fit takes tests as slow: the strength of a fast one is too high)" if rate > 1.0 else ""
    notes.append(f"{file}: mean strain rate {rate:.3g} 1/s{fast}.")


def confinement_of_column(file, columns, notes):
    """Of a column, which must hardly change; None without one."""
    values = columns.pop("confinement", None)
    if values is None:
        return None
    middle = float(numpy.median(values))
    if numpy.abs(values - middle).max() > max(0.05 * middle, 0.5e6):
        raise Fault(f"{file} has a confinement from {values.min() / 1e6:.4g} to {values.max() / 1e6:.4g} MPa, and a triaxial test has a "
            "constant one; take out the rows of the hydrostatic loading.")
    notes.append(f"{file}: confinement {middle / 1e6:.4g} MPa, the median of its column.")
    return middle


def scatter_of(values):
    """Standard deviation of the scatter of a curve: from its second differences, of which the middle one is hardly the curve's own."""
    differences = numpy.abs(numpy.diff(values, 2))
    return float(numpy.median(differences)) / (0.6745 * 6.0**0.5) if len(differences) else 0.0


def slope_of(columns, control, name, stress):
    """Of a column over that which drives the specimen, by least squares through the first row, where the rock is elastic, and the standard
    deviation that the column's scatter gives it, that of the first row included; None for few rows."""
    drive, load = columns[control] - columns[control][0], stress - stress[0]
    beyond = numpy.flatnonzero((load > ELASTIC * load.max()) | (numpy.append(numpy.diff(drive), 1.0) < 0.0))
    rows = max(int(beyond[0]) if len(beyond) else len(load), 4)
    drive = drive[:rows]
    square = float((drive**2).sum())
    if rows > len(load) or square == 0.0:
        return None
    slope = float((drive * (columns[name][:rows] - columns[name][0])).sum()) / square
    return slope, scatter_of(columns[name]) * (1.0 / square + (drive.sum() / square) ** 2) ** 0.5


def check_elastic_signs(file, kind, columns):
    """A specimen that is compressed elastically neither swells nor thins, by more than the scatter of the rows may make of it."""
    control = KINDS[kind].control
    stress = next((columns[name] for name in ("axial_stress", "differential_stress", "pressure") if name in columns), None)
    if stress is None:
        return
    checks = {  # kind, column: least and largest slope over the strain along the axis (the pressure, over the volume strain: above 0)
        ("triaxial", "volume_strain"): (-0.02, 1.2), ("triaxial", "radial_strain"): (-0.6, 0.05),
        ("uniaxial strain", "radial_stress"): (0.0, numpy.inf), ("hydrostatic", "pressure"): (0.0, numpy.inf),
    }  # fmt: skip
    for (of_kind, name), (low, high) in checks.items():
        if of_kind != kind or name not in columns:
            continue
        found = slope_of(columns, control, name, stress)
        if found is None:
            continue
        slope, deviation = found
        if not low - SURE * deviation <= slope <= high + SURE * deviation:
            refuse_sign(file, control, name, slope, slope < low)


def refuse_sign(file, control, name, slope, low):
    column = control if name == "pressure" else name
    advice = (
        f"if compression is negative in that column (dilatancy positive), say --sign {column}=negative, or positive where it is turned "
        "already, else check its unit"
    )
    if name == "radial_strain" and not low:
        raise Fault(f"{file} has a specimen that becomes thinner while it is compressed elastically ('{name}' is {slope:.3g} of "
            f"'{control}', and rock widens); {advice}.")
    if name == "volume_strain" and not low:
        raise Fault(f"{file} has a specimen that becomes thinner while it is compressed elastically ('{name}' is {slope:.3g} of "
            f"'{control}', at most 1 is possible); check the units of both.")
    if name == "radial_stress":
        raise Fault(f"{file} has a radial stress that falls while the specimen is compressed elastically; {advice}.")
    raise Fault(f"{file} has a specimen that swells while it is compressed elastically ('{name}' over '{control}' is {slope:.3g}); "
        f"{advice}.")
