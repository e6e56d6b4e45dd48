#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/output.md defines every column of the tables, every field of particles.e and every number of summary.json that real runs write, and
nothing that none writes.

    test_output_words.py BARRENO
"""
import json
import pathlib
import re
import sys
import tempfile

from netCDF4 import Dataset, chartostring

from tools.runs import run_deck

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "output.md"
FILES = ("depth.csv", "history.csv", "radii.csv", "cavities.csv", "particles.e", "summary.json")
ROCK = "Materials/Sandstone"
MONITOR = {"Jet Monitor/Bodies": "{Rod}", "Jet Monitor/Position": "35 mm", "Jet Monitor/Direction": "+y", "Jet Monitor/Interval": "1 us"}
# Few steps each; together they write everything.
RUNS = [
    # A jet into rock with water, rate dependence and scattered strength.
    ("perforation_quick.xml", {"Time/End Time": "0.8 us", f"{ROCK}/fluid_B0": "2.2 GPa", f"{ROCK}/T1_rate_dependence": "1e-7",
        f"{ROCK}/Weibull modulus": "10", f"{ROCK}/Weibull reference volume": "1e-6"}),
    ("perforation_quick.xml", {"Time/End Time": "7 us"}),  # a hole in rock, the error of its depth is known, particles are torn off
    ("perforation_quick.xml", {"Time/End Time": "1 us", "Fidelity": "balanced"}),  # cells and steps of several sizes
    ("perforation_quick.xml", {"Time/End Time": "0.8 us", f"{ROCK}/Card": "berea_sandstone_heat.xml"}),  # damage and heat
    ("perforation_quick.xml", {"Time/End Time": "0.8 us", f"{ROCK}/Card": "seeberger_sandstone_heat.xml"}),  # and rate dependence
    # Divided particles of a jet, whose error of the wide hole is known, and unknown with larger cells.
    ("perforation.xml", {"Time/End Time": "1.5 us", "Jet/Cells Per Radius": "1.2"}),
    ("perforation.xml", {"Time/End Time": "1.5 us", "Jet/Cells Per Radius": "1"}),
    ("terzaghi.xml", {"Time/End Time": "1e-3 s", "Quasi-Static/Inertia Factor": "100"}),  # fluid that flows
    ("shell_squeezed.xml", {"Time/End Time": "0.1 us"}),  # a ball with a fluid in its cavity
    ("rigid_plate.xml", {"Time/End Time": "1 us"}),
    ("manufactured_box.xml", {"Time/End Time": "1e-4 s", "Step/Shape Function": "CPDI"}),
    ("taylor_bar_3d.xml", {"Time/End Time": "0.05 us", **MONITOR}),
    ("porous_slug.xml", {"Time/End Time": "0.1 us"}),  # metal with voids
    ("water_hammer.xml", {"Time/End Time": "1 us"}),  # a liquid
    ("jet_formation.xml", {"Time/End Time": "0.2 us"}),  # an explosive, and a material's name with a space in it
    ("perforation_quick.xml", {"Jet": "", "Time/End Time": "0.2 us", "Continue/Run": "1"}),  # from the second of these runs
]  # fmt: skip
# Written after runs, by another program: its source has the names.
CONVERGENCE = "penetration.convergence."
CONVERGE = ROOT / "src" / "python" / "barreno" / "converge" / "report.py"
# Names that are a run's own; those of materials and bodies may have spaces.
FREE = {"NAME": r"\w[\w ]*", "VERB": "[^.]+", "CAUSE": "[a-z_]+", "KIND": ".+"}


def names_of(cell):
    """[family] of the words in a table's first column; a word that begins with _ or . has another end than the first."""
    names = []
    for word in re.findall(r"`([^`]+)`", cell):
        names.append(names[0][: names[0].rindex(word[0])] + word if word[0] in "_." else word)
    return names


def words_of_page(page):
    """{file: families of names}, a family from each row of its table."""
    words = {}
    for file, table in re.findall(r"<!-- words of (\S+) -->(.*?)<!-- end of words -->", page, re.DOTALL):
        words[file] = [names_of(row.split("|")[1]) for row in table.strip().splitlines()[2:]]
    return words


def pattern(name):
    text = re.escape(name)
    for free, means in FREE.items():
        text = re.sub(rf"\b{free}(?=\b|_)", lambda _: means, text)
    return re.compile(text)


def leaves(value, path=""):
    """Dotted names of all numbers and words of a JSON file."""
    if not isinstance(value, dict):
        return {path}
    return set().union(*(leaves(part, f"{path}.{name}".lstrip(".")) for name, part in value.items())) if value else set()


def exodus_names(file):
    with Dataset(file) as data:
        tables = [name for name in data.variables if re.match(r"name_(elem|nod|glo)_var$", name)]
        return {str(word) for table in tables for word in chartostring(data.variables[table][:])}


def columns(file):
    return set(next(line for line in file.read_text().splitlines() if not line.startswith("#")).split(","))


def written(folder):
    """{file: names in it} of a run."""
    out = {}
    for name in FILES:
        file = folder / name
        if not file.exists():
            continue
        if name == "summary.json":
            out[name] = leaves(json.loads(file.read_text()))
        else:
            out[name] = exodus_names(file) if name == "particles.e" else columns(file)
    return out


def compare(file, families, names):
    """Names without a definition, and definitions without a name."""
    patterns = [[pattern(name) for name in family] for family in families]
    problems = [f"docs/output.md does not define {name} of {file}"
        for name in sorted(names) if not any(one.fullmatch(name) for family in patterns for one in family)]
    for family, wanted in zip(families, patterns):
        absent = [name for name, one in zip(family, wanted) if not any(one.fullmatch(found) for found in names)]
        # An axis that a mode lacks may be absent; a whole family, or any other name, may not.
        axes_alone = len(absent) < len(family) and all(re.search(r"_[xyz]{1,2}$", name) for name in absent)
        if absent and not axes_alone:
            problems += [f"docs/output.md defines {name} of {file}, which no run has" for name in absent]
    return problems


def check_convergence(families):
    """The names that `barreno converge` adds are those of its source."""
    source = CONVERGE.read_text()
    named = set(re.findall(r'"(\w+)": ', source[source.index('["penetration"]["convergence"] = {') :].split("}")[0]))
    on_page = {name.removeprefix(CONVERGENCE) for family in families for name in family if name.startswith(CONVERGENCE)}
    return [] if named == on_page and named else [f"docs/output.md defines {sorted(on_page)} of a convergence, converge writes "
        f"{sorted(named)}"]


def main():
    words = words_of_page(PAGE.read_text())
    assert set(words) == set(FILES), sorted(words)
    found = {file: set() for file in FILES}
    with tempfile.TemporaryDirectory() as scratch:
        for number, (deck, values) in enumerate(RUNS):
            folder = pathlib.Path(scratch) / str(number)
            if "Continue/Run" in values:
                values = {**values, "Continue/Run": str(folder.with_name(values["Continue/Run"]))}
            run_deck(sys.argv[1], deck, values, folder=folder)
            for file, names in written(folder).items():
                found[file] |= names
    problems = check_convergence(words["summary.json"])
    rest = [[name for name in family if not name.startswith(CONVERGENCE)] for family in words["summary.json"]]
    words["summary.json"] = [family for family in rest if family]
    for file in FILES:
        problems += compare(file, words[file], found[file])
    print("\n".join(problems) or f"{sum(map(len, found.values()))} names of real runs are defined")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
