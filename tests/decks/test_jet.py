#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno jet` from the outside: depths against the closed forms of a virtual origin and of a rod, the audit of each kind, that its table
is one that a deck reads, and a sentence for every bad input.

    test_jet.py BARRENO
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

from python_commands import said_by
from tools.runs import DECKS

from barreno import Deck

STANDOFF, TIP, TAIL, METAL, ROCK = 0.1, 7000.0, 1000.0, 8930.0, 2700.0
LAUNCH = 0.005  # before the face [m]


def virtual_origin_depth(standoff, break_up, cut_off):
    """Allison and Vitali 1963, DiPersio and Simon 1964, as in method books: whole, broken during penetration, broken before."""
    g = math.sqrt(ROCK / METAL)
    if break_up >= standoff / TIP * (TIP / cut_off) ** (1.0 + 1.0 / g):
        return standoff * ((TIP / cut_off) ** (1.0 / g) - 1.0)
    if break_up <= standoff / TIP:
        return (TIP - cut_off) * break_up / g
    return ((1.0 + g) * (TIP * break_up) ** (1.0 / (1.0 + g)) * standoff ** (g / (1.0 + g)) - cut_off * break_up) / g - standoff


def deck_of(profile, kind="thinned"):
    deck = Deck.read(DECKS / "perforation_quick.xml")
    deck["Materials"] = {"Copper": {"Card": "copper.xml", "Density": METAL}, "Rock": {"Card": "aluminium_6061_t6.xml", "Density": ROCK}}
    deck["Bodies"] = {"Rock": {"Material": "Rock", "Lower": "{0 mm, 0 mm}", "Upper": "{50 mm, 1900 mm}"}}
    deck["Grid"] = {"Mode": "axisymmetric", "Lower": "{0 mm, -40 mm}", "Upper": "{80 mm, 2000 mm}", "Cell Size": "4 mm"}
    if "Confinement" in deck:
        del deck["Confinement"]
    deck["Jet"] = {"Material": "Copper", "Kind": kind, "Profile": profile, "Launch Position": "-5 mm", "Direction": "+y"}
    return deck


def profile_of(**more):
    return {"Tip Velocity": TIP, "Tail Velocity": TAIL, "Virtual Origin": STANDOFF, "Tip Radius": "1 mm", "Tail Radius": "2 mm",
        "Rows": 800, **{name.replace("_", " "): value for name, value in more.items()}}


def jet(folder, deck, *words, code=0):
    file = pathlib.Path(folder) / "jet_deck.xml"
    deck.write(file)
    said = said_by("barreno.jet", file, "--out", pathlib.Path(folder) / "out", *words, code=code)
    return said, (json.loads((pathlib.Path(folder) / "out" / "jet.json").read_text()) if code == 0 else None)


def check_virtual_origin(folder):
    """Whole, broken on the way through the target, and before it."""
    for break_up, cut_off in ((None, 1600.0), (None, 2500.0), (60e-6, 2000.0), (10e-6, 2000.0)):
        profile = profile_of(**({"Break-up_Time": break_up} if break_up else {}))
        _, found = jet(folder, deck_of(profile), "--cut-off", f"{cut_off:g} m/s")
        # Slugs are looked at by their mean velocity: a whole one counts.
        exact = virtual_origin_depth(STANDOFF + LAUNCH, break_up or math.inf, cut_off)
        depth = found["depths"][f"the same, cut off at {cut_off:g} m/s"]
        assert abs(depth / exact - 1.0) < 0.01, (break_up, cut_off, depth, exact)
        assert abs(found["virtual_origin"] / STANDOFF - 1.0) < 1e-6, found
        if break_up:
            assert abs(found["break_up_time"] / break_up - 1.0) < 1e-6, found


def check_rod(folder):
    """One velocity: L u / (v - u) with u of Tate's equation, and nothing where the stagnation pressure is below the resistance."""
    deck = deck_of({}, "discrete")
    speed, length, strength = 3000.0, 8e-3, 1e9
    deck["Jet"] = {**deck["Jet"], "Slugs": f"1x5:{{0, {speed}, 2e-3, {length}, {METAL}}}"}
    del deck["Jet/Profile"]
    for resistance in (0.0, 4e9, 60e9):
        _, found = jet(folder, deck, "--resistance", f"{resistance:g} Pa", "--strength", f"{strength:g} Pa")
        depth = found["depths"][f"Alekseevskii-Tate, R = {resistance:g} Pa, Y = {strength:g} Pa"]
        # METAL (v - u)^2 / 2 + Y = ROCK u^2 / 2 + R, by bisection
        low, high = 0.0, speed
        for _ in range(200):
            u = 0.5 * (low + high)
            digs = METAL * (speed - u) ** 2 / 2.0 + strength > ROCK * u * u / 2.0 + resistance
            low, high = (u, high) if digs else (low, u)
        exact = length * u / (speed - u) if resistance < METAL * speed**2 / 2.0 + strength else 0.0
        assert abs(depth - exact) < 1e-9, (resistance, depth, exact)
        assert found["virtual_origin"] == 0.0, found


def check_kinds(folder):
    """Every kind has the mass, momentum and energy that the profile asks for; a table that it writes gives the jet again."""
    for kind, more in (("discrete", {}), ("thinned", {}), ("thinned", {"Break-up Time": 40e-6})):
        profile = {**profile_of(), **more}
        del profile["Tail Radius"]
        deck = deck_of({**profile, "Mass": "30 g"}, kind)
        said, found = jet(folder, deck)
        assert abs(found["mass"] / 0.03 - 1.0) < 1e-9, found
        assert abs(found["whole_mass"] / found["mass"] - 1.0) < 1e-9 or more, found
        assert "(+0.0e+00" in said or "e-1" in said, said
        deck["Jet"] = {name: value for name, value in deck["Jet"].items() if name != "Profile"}
        deck["Jet/Table"] = str(pathlib.Path(folder) / "out" / "jet.csv")
        deck["Jet/Pieces Below"] = STANDOFF / more["Break-up Time"] if more else 0.0
        _, again = jet(folder, deck)
        for name in ("mass", "momentum", "kinetic_energy", "whole_mass"):
            assert abs(again[name] / found[name] - 1.0) < 1e-6, (name, again, found)
    picture = pathlib.Path(folder) / "out" / "jet.png"
    assert picture.read_bytes()[:4] == b"\x89PNG" and picture.stat().st_size > 5000


def mass_of(slug):
    return slug["density"] * slug["radius"] ** 2 * slug["length"]


def check_launched(folder):
    """`check --print-jet`: every kind keeps the mass of each slug; whole metal touches, of a continuous jet at the density of the table."""
    profile = {**profile_of(), "Density": "6 g/cm3", "Rows": 40, "Break-up Time": "40 us"}
    for kind in ("discrete", "thinned", "continuous"):
        deck = deck_of(profile, kind)
        deck["Materials/Copper/Expansion Strain"] = "on"
        file = pathlib.Path(folder) / "launched.xml"
        deck.write(file)
        answer = subprocess.run([os.environ["BARRENO_PROGRAM"], "check", file, "--print-jet"], capture_output=True, text=True, check=True)
        table, slugs = (json.loads(answer.stdout)[name] for name in ("table", "slugs"))
        assert len(table) == len(slugs) == 40 and all(abs(mass_of(a) / mass_of(b) - 1.0) < 1e-12 for a, b in zip(table, slugs)), slugs
        broken = [slug["velocity"] < STANDOFF / 40e-6 for slug in slugs]
        assert [slug["piece"] for slug in slugs] == (broken if kind != "discrete" else [False] * 40) and 0 < sum(broken) < 40, slugs
        whole = [slug for slug, piece in zip(slugs, broken) if not piece]
        for one, other in zip(whole[1:-2], whole[2:-1]):  # those of the ends last for one interval
            touches = 0.5 * (one["length"] / one["velocity"] + other["length"] / other["velocity"]) / (other["time"] - one["time"])
            assert abs(touches - (6.0 / 8.93 if kind == "discrete" else 1.0)) < 0.01, (kind, touches)
        assert abs(whole[3]["density"] - (6000.0 if kind == "continuous" else METAL)) < 1e-6 * METAL, whole[3]
    del deck["Jet"]
    deck.write(file)
    answer = subprocess.run([os.environ["BARRENO_PROGRAM"], "check", file, "--print-jet"], capture_output=True, text=True)
    assert answer.returncode == 1 and "Jet is missing, so nothing is launched (--print-jet); give one" in answer.stderr, answer.stderr


def check_faults(folder):
    deck = deck_of(profile_of())
    for words, sentence in (
        (("--cut-off", "fast"), '--cut-off "fast" is no velocity; write for example --cut-off "2 km/s".'),
        (("--resistance", "1 GHz"), '--resistance "1 GHz" is no stress; write for example --resistance "1 GPa".'),
        (("--depth",), "unrecognized arguments: --depth"),
        (("--set", "Jet/Profile/Tail Velocity=9 km/s"), "is not below Tip Velocity"),
    ):
        said, _ = jet(folder, deck, *words, code=1)
        assert sentence in said, said
    deck["Bodies/Rock/Lower"], deck["Bodies/Rock/Upper"] = "{20 mm, 0 mm}", "{50 mm, 1900 mm}"
    said, _ = jet(folder, deck, code=1)
    assert "no box lies on the jet's path" in said, said
    del deck["Jet"]
    said, _ = jet(folder, deck, code=1)
    assert "the deck has no Jet" in said, said
    said = said_by("barreno.jet", pathlib.Path(folder) / "absent.xml", code=2)
    assert "does not exist (needed as the deck)" in said, said


def main():
    os.environ["BARRENO_PROGRAM"] = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_virtual_origin, check_rod, check_kinds, check_launched, check_faults):
            check(folder)


if __name__ == "__main__":
    main()
