#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""barreno import-ups: inputs of Uintah's MPM, written for this test in its format, become valid decks with the numbers that
they have; what cannot carry over is said, one sentence each; what cannot be read is refused in one sentence.

    test_import.py BARRENO
"""
import contextlib
import io
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from barreno.imports.command import main as import_ups

ROOT = pathlib.Path(__file__).resolve().parents[2]
UPS = ROOT / "tests" / "decks" / "ups"


def imported(*words, code=0):
    """Its words on the screen, or those of its refusal; in this process, as an interpreter takes longer to start than to import."""
    os.environ.update({"BARRENO_PROGRAM": str(pathlib.Path(sys.argv[1]).resolve()), "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        found = import_ups([str(word) for word in words])
    said, complaint = (stream.seek(0) or stream.read() for stream in (out, err))
    assert found == code, f"exit {found}, not {code}: {said}{complaint}"
    return said if code == 0 else complaint


def numbers(text):
    return [float(part) for part in text.split(":")[-1].strip("{}").split(",")]


class Deck:
    def __init__(self, path):
        self.root = ElementTree.parse(path).getroot()

    def value(self, path):
        """Of "List/List/Parameter", None if it is not there."""
        *lists, name = path.split("/")
        place = self.root
        for one in lists:
            place = next((child for child in place if child.tag == "ParameterList" and child.get("name") == one), ())
        return next((child.get("value") for child in place if child.tag == "Parameter" and child.get("name") == name), None)

    def names(self, path):
        return [child.get("name") for child in next(child for child in self.root if child.get("name") == path)]


def said(text, *sentences):
    remarks = [line for line in text.splitlines() if line.startswith("  - ")]
    for sentence in sentences:
        assert sum(sentence in line for line in remarks) == 1, f"{sentence!r} in\n{text}"
    return remarks


def check_three_dimensions(folder):
    out = folder / "projectile.xml"
    text = imported(UPS / "projectile.ups", "--out", out)
    remarks = said(
        text, "Cells of 0.001, 0.0012, 0.001 become squares or cubes", "yield_condition gurson is left out",
        "the start at 300 K is left out",
        "Steel: the pressure of a constant bulk modulus", "2 x 3 x 2 particles per cell", "p2_crush_curve is left out",
        "subcycling_characteristic_number is left out",
        "erosion AllowNoTension", "delete_rogue_particles = true", "Output every 50 steps becomes one every 1e-06", "left out: p.color",
        "Variables of the grid", "D0 and Dc",
        "No contact of the file holds for Iron and Sandstone; Steel and Sandstone",
    )  # fmt: skip
    assert (
        len(remarks) == 15 and "15 remarks" in text and "The deck is incomplete: 5 things did not carry over (the first 5 remarks)" in text
    ), text
    deck = Deck(out)
    expected = {
        "Grid/Mode": "3D", "Grid/Cell Size": 0.001, "Time/End Time": 2e-5, "Output/Checkpoint Steps": 400, "Step/Shape Function": "CPDI",
        "Step/Linear Viscosity": 0.3,
        "Step/Quadratic Viscosity": 2.0, "Step/Courant Fraction": 0.4, "Step/Largest Step": 1e-6, "Materials/Iron/Sound Speed": 4569.0,
        "Materials/Iron/Density": 7850.0,
        "Materials/Iron/D3": -0.47, "Materials/Iron/Melt Temperature": 1811.0, "Materials/Steel/A": 1.5e9, "Materials/Steel/B": 1e9,
        "Materials/Steel/n": 1.0,
        "Materials/Steel/Sound Speed": math.sqrt(1.6e11 / 7850.0), "Materials/Sandstone/p0_crush_curve": -4e8,
        "Materials/Sandstone/Model": "Arenisca",
        "Bodies/Steel/Particles Per Cell": 3, "Bodies/rock/Shape": "cylinder", "Bodies/Iron/Shape": "difference",
        "Contact/Iron and Steel/Friction Coefficient": 0.25,
        "Conditions/Face x lower/Kind": "symmetry", "Conditions/Face y lower/Kind": "fixed", "Conditions/Face x upper/Kind": None,
        "Body Force/Kind": "gravity",
        "Materials/Sandstone/p2_crush_curve": None,
    }  # fmt: skip
    for path, value in expected.items():
        found = deck.value(path)
        same = found == value if isinstance(value, (str, type(None))) else found is not None and math.isclose(float(found), value,
            rel_tol=1e-14)
        assert same, f"{path} = {found}, not {value}"
    assert numbers(deck.value("Bodies/Steel/Velocity")) == [0.0, -800.0,
        0.0] and numbers(deck.value("Body Force/Acceleration")) == [0.0, -9.81, 0.0]
    # Uintah makes no particles beyond the grid, through whose face the projectile's axis goes.
    assert deck.value("Bodies/Steel/Shape") == "intersection" and len(deck.names("Shapes")) == 6, deck.names("Shapes")
    assert all(remark[4:].replace("--", "- -") in out.read_text() for remark in remarks), "the deck lacks what was said"


def check_axisymmetry(folder):
    """A jet of inserted pieces, a tube, its pressures, in units of their own."""
    out = folder / "jet.xml"
    text = imported(UPS / "jet.ups", "--out", out, "--units", "mm-us-g")
    said(text, "The material Foam is left out with its bodies", "hypo_elastic becomes Linear Elastic",
        "2 insertions of jet_insertions.dat become slugs", "Courant Fraction of 0.8")
    deck = Deck(out)
    assert deck.value("Units") == "mm-us-g" and deck.value("Grid/Mode") == "axisymmetric" and deck.names("Bodies") == ["Shale"]
    assert numbers(deck.value("Jet/Slugs")) == [1.0, 6.0, 1.5, 4.0, 8.93e-3, 2.0, 4.5, 1.0, 5.0, 8.93e-3]
    assert deck.value("Jet/Launch Position") == "12.0" and deck.value("Jet/Direction") == "-y" and deck.value("Jet/Material") == "Copper"
    assert (numbers(deck.value("Bodies/Shale/Lower")), numbers(deck.value("Bodies/Shale/Upper"))) == ([2.0, 0.0], [12.0, 10.0])
    assert deck.value("Loads/Pressure on Shale 1/Faces") == "{x_upper}" and numbers(
        deck.value("Loads/Pressure on Shale 1/Pressures")) == [0.0, 1e-5]
    assert deck.value("Loads/Pressure on Shale 2/Faces") == "{y_lower}" and deck.value("Loads/Pressure on Shale 2/Pressure") == "2e-06"
    assert deck.value("Step/Damping") == "0.5" and deck.value("Step/Linear Viscosity") == "0.0" and deck.value("Step/Largest Step") is None
    assert deck.value("Materials/Copper/Room Temperature") == "298.0" and numbers(deck.value("Conditions/Face y lower/Velocity")) == [0.0,
        0.01]
    text = imported(UPS / "jet.ups", "--out", out, "--units", "mm-us-g", "--overwrite", "--card", "Foam=berea_sandstone")
    deck = Deck(out)
    assert (
        "Foam is left out" not in text and deck.value("Materials/Foam/Card") == "berea_sandstone"
        and numbers(deck.value("Bodies/foam/Lower")) == [0.0, -4.0]
    ), text


def changed(folder, pairs, source="projectile.ups"):
    """A copy of an input, with its files beside it, in which texts are others."""
    text = (UPS / source).read_text()
    for old, new, *_ in pairs:
        assert old in text, old
        text = text.replace(old, new, 1)
    for name in ("data", "jet_insertions.dat"):
        if not (folder / name).exists():
            (folder / name).symlink_to(UPS / name)
    path = folder / "changed.ups"
    path.write_text(text)
    return path


def check_variants(folder):
    """Plane strain, other pieces, other models: the deck is valid, and remarks name what changed."""
    out = folder / "variant.xml"
    pairs = (
        ("<interpolator>cpdi<", "<interpolator>cpti<", "The interpolator cpti has no counterpart"),
        ("<BETA_nonassociativity>1.0<", "<BETA_nonassociativity>1.5<", "BETA_nonassociativity = 1.5 is above 1"),
        ("<type>friction</type>", "<type>approach</type>", "Contact approach becomes sticking"),
        ('<Face side="y-">', '<Face circle="y-">', "A condition on a part of a face"),
        ("<bulk_modulus>1.64e11<", "<bulk_modulus>1.2e11<", "bulk_modulus = 1.2e+11 is left out"),
        ('<cylinder label="rock">', '<ellipsoid label="rock"><r1>1</r1></ellipsoid><cylinder label="rock">',
            "Body rock of Sandstone: left out (the piece <ellipsoid>"),
        ("<initTime>0.0<", "<initTime>1e-6<", "initTime is left out"),
        ("<DoExplicitHeatConduction>false", "<DoExplicitHeatConduction>true", "Conduction of heat is left out"),
    )
    said(imported(changed(folder, pairs), "--out", out, "--overwrite"), *(sentence for _, _, sentence in pairs))
    said(imported(changed(folder, [("<fluid_B0>0.0<", "<fluid_B0>2.2e9<")]), "--out", out, "--overwrite"),
        "the pore fluid keeps the published form")
    plane = changed(folder, [("<axisymmetric>true<", "<axisymmetric>false<")], "jet.ups")
    text = imported(plane, "--out", out, "--overwrite", "--units", "mm-us-g")
    said(text, "The particles that jet_insertions.dat inserts are left out", 'The load <pressure> on "outside" of PhysicalBC is left out',
        'The load <pressure> on "below"')
    assert Deck(out).value("Grid/Mode") == "plane strain"


def check_refusals(folder):
    for old, new, code, *words in (
        ("<Uintah_specification>", "<Other>", 1, "is not XML"),
        ("[25, 50, 25]", "[25, 50]", 1, "changed.ups/Grid/Level/Box/resolution", "which is not a vector"),
        ("<maxTime>2.0e-5<", "<maxTime>soon<", 1, "changed.ups/Time/maxTime", "which is not a number"),
        ("<PEAKI1>5.0e6</PEAKI1>", "", 1, "PEAKI1", "barreno check refuses it"),
        ("<m>0.55</m>", "", 1, "has no <m>"),
        ("data/iron.xml", "data/brass.xml", 2, "brass.xml does not exist"),
        ("-800.0", "-8e9", 1, "barreno check refuses it"),
    ):
        text = imported(changed(folder, [(old, new)]), "--out", folder / "refused.xml", "--overwrite", code=code)
        assert len(text.splitlines()) == 1 and text.startswith("barreno: ") and all(word in text for word in words), text
    good = UPS / "projectile.ups"
    (folder / "there.xml").write_text("keep")
    (folder / "deck.ups").write_text("<ParameterList/>")
    for words, code, sentence in (
        ((good, "--out", folder / "there.xml"), 2, "exists already; name another deck with --out, or add --overwrite."),
        ((folder / "nowhere.ups",), 2, "nowhere.ups cannot be read"),
        ((folder / "deck.ups",), 1, "is no input file of Uintah"),
        ((good, "--card", "Iron", "--out", folder / "a.xml"), 1, "is not MATERIAL=CARD"),
        ((good, "--card", "Brass=copper", "--out", folder / "a.xml"), 1,
            'names "Brass", which is no material of the file; it has Iron, Steel, Sandstone.'),
        ((good, "--output", "a.xml"), 1, "write for example barreno import-ups"),
    ):
        text = imported(*words, code=code)
        assert sentence in text and len(text.splitlines()) == 1, text
    assert (folder / "there.xml").read_text() == "keep" and not (folder / "a.xml").exists()


def main():
    with tempfile.TemporaryDirectory() as name:
        for check in (check_three_dimensions, check_axisymmetry, check_variants, check_refusals):
            check(pathlib.Path(name))
    print("inputs of Uintah become valid decks, and what does not is said")


if __name__ == "__main__":
    main()
