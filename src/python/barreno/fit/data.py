# SPDX-License-Identifier: BSD-3-Clause
"""A test from its CSV file: units, signs and strains are brought to SI, compression positive, logarithmic."""

import difflib
import hashlib
import pathlib
import re
from dataclasses import dataclass, field

import numpy

from barreno.fit import units
from barreno.fit.kinds import DIMENSIONS, KINDS, columns_of
from barreno.fit.laboratory import (
    Said, check_elastic_signs, confinement_of_column, dimension_of, keys_of_titles, known_names, raw_columns, renamed, strains_from_lengths,
    stress_from_force, tell_rate, turn_signs,
)  # fmt: skip
from barreno.fit.table import decoded, is_number, split_table
from barreno.runs.faults import FILE, Fault

LEAST_ROWS = 8  # of a curve
MOST_ROWS = 150  # of a curve that are compared
MOST_TURNS = 12  # of the strain: three loops of unloading, with room
LARGEST_STRAIN = 0.7
LARGEST_STRESS = 200e9
CURVE_UNCERTAINTY, TABLE_UNCERTAINTY = 0.02, 0.10
KEYS = ("kind", "compression", "confinement", "porosity", "uncertainty", "strain", "strain_limit", "source", "diameter", "length")
EXAMPLES = {"stress": "MPa", "strain": "%", "force": "kN", "length": "mm", "time": "s"}  # of units
RAW_OF = {"volume_strain": ("axial_strain", "radial_strain", "axial_displacement", "diameter_change"),
    "axial_strain": ("axial_displacement",), "axial_stress": ("axial_force", "differential_force")}


@dataclass
class Test:
    """What a file says."""

    file: str
    kind: str
    digest: str
    source: str
    columns: dict  # name -> values
    labels: list  # per row of a table: its source
    uncertainty: numpy.ndarray  # relative: of each row, or (curve) of the largest value of the channel
    confinement: float = 0.0
    porosity: float = 0.0  # 0: not said
    strain_limit: float = 0.1
    notes: list = field(default_factory=list)
    stated: bool = False  # the file says the uncertainty
    scales: dict = field(default_factory=dict)  # channel -> its scatter over the uncertainty (weights.py); 1 where it is absent

    @property
    def rows(self):
        return len(next(iter(self.columns.values())))

    @property
    def channels(self):
        return [name for group in KINDS[self.kind].channels for name in group if name in self.columns]


def text_of(file):
    path = pathlib.Path(file)
    try:
        if path.exists() and not path.is_file():
            raise Fault(f"{file} is no plain file (needed as the data of a test); give the path of a CSV file.", FILE)
        raw = path.read_bytes()
    except FileNotFoundError:
        raise Fault(f"{file} does not exist (needed as the data of a test); check the path.", FILE) from None
    except OSError as error:
        raise Fault(f"{file} cannot be read ({error.strerror}); check the path and its permissions.", FILE) from None
    text = decoded(raw)
    if text is None or raw[:4] in (b"PK\x03\x04", b"%PDF"):
        raise Fault(f"{file} is not text in UTF-8 (a spreadsheet?); save it as CSV.")
    return text, hashlib.sha256(raw).hexdigest()[:16]


def header_keys(file, comments):
    """`# key: value` of the comments."""
    keys = {}
    for _, key, value in comments:
        if key not in KEYS or not value:
            continue
        if key in keys and key != "source":
            raise Fault(f"{file} gives '{key}' twice; keep one of the two lines.")
        keys[key] = (keys.get("source", "") + " " + value).strip() if key == "source" else value
    return keys


def kind_of(file, keys):
    if "kind" not in keys:
        raise Fault(f"{file} does not say which kind of test it is; add a line '# kind: NAME', or --say "
            f"\"{pathlib.Path(file).name}:kind=NAME\", with one of {', '.join(KINDS)}.")
    name = keys["kind"].lower()
    if name in KINDS:
        return name
    near = difflib.get_close_matches(name, KINDS, 1, 0.6)
    advice = f"did you mean '{near[0]}'?" if near else f"it is one of {', '.join(KINDS)}."
    raise Fault(f"{file} has the kind '{keys['kind']}', which is not known; {advice}")


def numbers_of(file, name, unit, at, rows):
    """A column in SI."""
    dimension = dimension_of(name)
    if not unit:
        if dimension != "ratio" and any(is_number(cells[at]) for _, cells in rows):
            raise Fault(f"{file} gives no unit for the column '{name}'; write for example '{name} [{EXAMPLES[dimension]}]'.")
        unit = "-" if dimension == "ratio" else next(iter(units.UNITS[dimension]))
    scale = units.factor(unit, dimension, f"{file}, column '{name}'")
    values = []
    for number, cells in rows:
        own = re.fullmatch(r"([-+.\deE]*\d\.?)\s*([^\d\s.+-]\S*)", cells[at])
        if own and is_number(own.group(1)) and units.is_unit(own.group(2)):
            values.append(float(own.group(1)) * units.factor(own.group(2), dimension, f"{file}, line {number}"))
            continue
        if not is_number(cells[at]) or not numpy.isfinite(float(cells[at])):
            raise Fault(f"{file}, line {number} has '{cells[at]}' in the column '{name}', which is not a number; correct the row or take "
                "it out.")
        values.append(float(cells[at]) * scale)
    return numpy.array(values)


def check_rows(file, names, rows):
    for number, cells in rows:
        if len(cells) != len(names):
            commas = (
                "decimal commas need semicolons between the cells" if len(cells) == 2 * len(names) else "text with commas goes in quotes"
            )
            raise Fault(f"{file}, line {number} has {len(cells)} cells under {len(names)} column names; complete it ({commas}).")


def check_columns(file, kind, names, heads):
    """The columns that are needed are there, one of each group of alternatives."""
    what = KINDS[kind]
    for name in names:
        if names.count(name) > 1:
            raise Fault(f"{file} has the column '{name}' twice; take one out.")
    near = difflib.get_close_matches
    for group in ([(what.control,)] if what.control else []) + list(what.channels[:1]):
        if any(name in names for name in group):
            continue
        like = [found for name in names if name not in DIMENSIONS for found in near(name, group, 1, 0.7)]
        if any(name in names for name in RAW_OF.get(group[0], ())):
            continue
        advice = f" (is one misspelt? they are {', '.join(names)})" if like else ""
        raise Fault(f"{file} lacks the column '{group[0]}', which a test of kind '{kind}' needs{advice}; its columns are "
            f"{', '.join(columns_of(what))}; say which it is with --column \"NAME={group[0]}\", NAME one of {', '.join(heads)}.")
    for group in what.channels:
        both = [name for name in group if name in names]
        if len(both) > 1:
            raise Fault(f"{file} has the columns {' and '.join(both)}, which say the same; keep one.")


def check_curve(file, control, columns, confinement):
    values = columns[control]
    if len(values) < LEAST_ROWS:
        raise Fault(f"{file} has {len(values)} rows, too few for a curve ({LEAST_ROWS} at least); give more of the test.")
    turns = numpy.flatnonzero(numpy.diff(numpy.sign(numpy.diff(values)[numpy.diff(values) != 0.0])))
    if len(turns) > MOST_TURNS:
        raise Fault(f"{file} is not monotone: '{control}' turns {len(turns)} times (noise, or rows out of order; a loop of unloading has 2 "
            f"turns, and {MOST_TURNS} are possible); sort, smooth or thin the rows.")
    if "axial_stress" in columns and control == "axial_strain" and confinement is not None:
        stress = columns["axial_stress"]
        if stress.max() < confinement or stress[0] < 0.5 * confinement:
            raise Fault(f"{file} begins with an axial_stress of {stress[0] / 1e6:.4g} MPa under a confinement of {confinement / 1e6:.4g} "
                "MPa (the axial stress includes the confinement); if the column is the stress above the confinement, call it "
                "differential_stress.")


def check_magnitudes(file, columns):
    for name, values in columns.items():
        largest = numpy.abs(values).max()
        if DIMENSIONS[name] == "strain" and not 1e-6 < largest < LARGEST_STRAIN:
            raise Fault(f"{file} has a largest '{name}' of {100 * largest:.3g} %, which no test has; check the unit of the column.")
        if DIMENSIONS[name] == "stress" and not 1e3 < largest < LARGEST_STRESS:
            raise Fault(f"{file} has a largest '{name}' of {largest:.3g} Pa, which no test has; check the unit of the column.")


def logarithmic(file, keys, columns):
    """Change of length (volume) over the original one, positive in compression, to its logarithm."""
    said = keys.get("strain", "engineering").lower()
    if said not in ("engineering", "logarithmic"):
        raise Fault(f"{file} has '# strain: {keys['strain']}'; it is engineering (change over original length or volume) or logarithmic.")
    if said == "engineering":
        for name in columns:
            if DIMENSIONS[name] == "strain":
                columns[name] = -numpy.log1p(-columns[name])


def kept_rows(values):
    """At most MOST_ROWS of a curve, turns and ends among them."""
    if len(values) <= MOST_ROWS:
        return numpy.arange(len(values))
    turns = numpy.flatnonzero(numpy.diff(numpy.sign(numpy.diff(values)))) + 1
    even = numpy.linspace(0, len(values) - 1, MOST_ROWS - len(turns)).round().astype(int)
    return numpy.unique(numpy.concatenate([even, turns]))


def header_value(file, keys, key, dimension, default, low, high):
    if key not in keys:
        return default
    value = units.quantity(keys[key], dimension, f"{file}, '{key}'")
    if not low <= value <= high:
        raise Fault(f"{file} has '# {key}: {keys[key]}', which cannot be; correct the line.")
    return value


def read_table(file, said):
    """The table of a file, what its header says, its kind, its columns' names, and its digest."""
    text, digest = text_of(file)
    extra = said.keys_of(file)
    table = split_table(file, text, known_names(said), extra.get("decimal", ""))
    keys = header_keys(file, table.comments)
    titles = {key: value for key, value in keys_of_titles(file, table).items() if key not in keys}
    keys = {**titles, **keys, **extra}
    kind = kind_of(file, keys)
    if not table.header_line:
        raise Fault(f"{file} contains no table; write a line of column names, then rows of numbers.")
    names = renamed(file, table, KINDS[kind], said)
    check_rows(file, names, table.rows)
    check_columns(file, kind, names, table.heads)
    if not table.rows:
        raise Fault(f"{file} has no row of numbers; write them under the column names.")
    return table, keys, kind, names, digest


def confinement_of(file, kind, keys, columns, notes):
    column = confinement_of_column(file, columns, notes) if kind == "triaxial" else None
    if kind == "triaxial" and "confinement" not in keys and column is None:
        raise Fault(f"{file} does not say its confinement; add a line such as '# confinement: 40 MPa' (0 MPa for an unconfined test), or "
            f"--say \"{pathlib.Path(file).name}:confinement=40 MPa\".")
    return header_value(file, keys, "confinement", "stress", 0.0 if column is None else column, 0.0, LARGEST_STRESS)


def read_test(file, said=None):
    """The test of a file, or a Fault that says what to correct.

    @param said  what the words of the command add
    """
    file, said = str(file), said or Said()
    table, keys, kind, names, digest = read_table(file, said)
    what, rows = KINDS[kind], table.rows
    used = [name for name in names if name in columns_of(what) or name in raw_columns(what)]
    columns = {name: numbers_of(file, name, table.units[names.index(name)], names.index(name), rows) for name in used}
    labels = [cells[names.index("source")] for _, cells in rows] if "source" in names else [""] * len(rows)
    notes = [f"{file}: {note}" for note in table.notes]
    turn_signs(file, keys, said, columns)
    confinement = confinement_of(file, kind, keys, columns, notes)
    if what.curve:
        strains_from_lengths(file, kind, keys, columns, notes)
        stress_from_force(file, kind, keys, columns, confinement, notes)
        tell_rate(file, what.control, columns, notes)
        columns = {name: values for name, values in columns.items() if name in columns_of(what)}
    check_magnitudes(file, columns)
    default = header_value(file, keys, "uncertainty", "ratio", CURVE_UNCERTAINTY if what.curve else TABLE_UNCERTAINTY, 1e-4, 10.0)
    uncertainty = columns.pop("uncertainty", numpy.full(len(rows), default))
    if not (uncertainty > 0.0).all():
        raise Fault(f"{file} has an uncertainty that is not above 0; correct the column.")
    test = Test(
        file, kind, digest, keys.get("source", ""), columns, labels, uncertainty, confinement,
        header_value(file, keys, "porosity", "ratio", 0.0, 1e-3, 0.6),
        header_value(file, keys, "strain_limit", "strain", 0.1, 1e-3, LARGEST_STRAIN),
        notes, "uncertainty" in keys,
    )  # fmt: skip
    extra = [name for name in names if name not in used and name != "source"]
    if extra:
        test.notes.append(f"{file}: not used: {', '.join(extra)}.")
    if what.curve:
        check_elastic_signs(file, kind, test.columns)
        finish_curve(test, what, keys)
    elif any((test.columns[name] <= 0.0).any() for name in test.channels):
        raise Fault(f"{file} has a value of '{test.channels[0]}' that is not above 0; correct the row.")
    return test


def finish_curve(test, what, keys):
    logarithmic(test.file, keys, test.columns)
    check_curve(test.file, what.control, test.columns, test.confinement if test.kind == "triaxial" else None)
    kept = kept_rows(test.columns[what.control])
    if len(kept) < test.rows:
        test.notes.append(f"{test.file}: {len(kept)} of {test.rows} rows are compared.")
    for name in test.columns:
        test.columns[name] = test.columns[name][kept]
    test.uncertainty = test.uncertainty[kept]
    test.labels = [test.labels[i] for i in kept]
