#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A jet that meets no target has no depth: `check` and the run say so, and no file holds one. One that comes out of the rear of its
target is through, for good. The hole is the same in equal and in refined cells of one size, and the same in the report.

    test_jet_targets.py BARRENO
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from barreno.report import hole as holes
from barreno.report.deck import read_deck
from barreno.report.files import read_columns
from barreno.report.particles import ParticleFile
from barreno.report.zones import Rock, rings_at
from python_commands import said_by
from tools.runs import DECKS, Run, mpi_environment

COARSE = ("Grid/Cell Size=5 mm", "Time/End Time=3 us")


def barreno(command, *settings):
    words = [sys.argv[1], *command, *[x for s in COARSE + settings for x in ("--set", s)]]
    result = subprocess.run(words, env=mpi_environment(), capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stderr}"
    return result.stdout + result.stderr


def check_case(folder, words, met, *settings):
    """`words` of the note of `check` and of the run, or None where there is none; whether the jet met its target."""
    deck = DECKS / "perforation_quick.xml"
    for text in (barreno(["check", deck], *settings), barreno(["run", deck, "--out", folder], *settings)):
        notes = [line for line in text.splitlines() if "no depth will be computed" in line]
        if words is None:
            assert not notes, notes
        else:
            assert len(notes) == 1 and words in notes[0], text
    assert ("no depth: the jet has hit no target" in text) == (not met), text
    penetration = json.loads((folder / "summary.json").read_text())["penetration"]
    depths = Run(folder).table("depth.csv")
    assert penetration["met_target"] == met, penetration
    if met:
        assert penetration["depth"] == depths["depth"][-1] > 0.0, penetration
        return
    assert penetration["depth"] is None and penetration["channel_depth"] == penetration["jet_mass_inside"] == 0.0, penetration
    assert depths["tip_velocity"][-1] > 1000.0, "the jet does not fly"
    for name in ("depth", "channel_depth", "channel_radius_mid", "jet_mass_inside"):
        assert (depths[name] == 0.0).all(), f"{name}: {depths[name]}"


def run_quick(folder, *settings):
    """(words on the screen, penetration of the summary) of the perforation in cells of 2 mm, in a smaller box."""
    box = ("Grid/Upper={80 mm, 120 mm}", "Bodies/Rock/Upper={50.8 mm, 110 mm}", "Output/Checkpoint Steps=0")
    words = [sys.argv[1], "run", DECKS / "perforation_quick.xml", "--out", folder, *[x for s in (*box, *settings) for x in ("--set", s)]]
    result = subprocess.run(words, env=mpi_environment(), capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr
    return result.stdout, json.loads((folder / "summary.json").read_text())["penetration"]


def check_through(folder):
    """Rock of 2 mm behind the casing: the depth stays that of the rear, whatever becomes of the jet's tip."""
    said, reached = run_quick(folder, "Bodies/Rock/Upper={50.8 mm, 14.7 mm}", "Time/End Time=12 us")
    assert "depth: through the target of 14.70 mm since" in said, said
    table = Run(folder).table("depth.csv")
    first = int(table["through"].argmax())
    assert reached["through"] and reached["through_since"] == table["time"][first], reached
    assert first > 0 and (table["through"][first:] == 1).all() and (abs(table["depth"][first:] - 0.0147) < 1e-12).all(), table["depth"]


def check_liquid(folder):
    """A casing of water: depth and hole begin at the rock behind it, `check` says so, and water alone is no target."""
    liquid = "Materials/Steel/Card=water"
    said = barreno(["check", DECKS / "perforation_quick.xml"], liquid)
    assert "Liquid    12.7 mm of the jet's path; depth and hole are those in solids" in said, said
    assert "it was measured without liquids in the jet's path" in said, said
    assert "Liquid " not in barreno(["check", DECKS / "perforation_quick.xml"])
    _, reached = run_quick(folder, liquid, "Time/End Time=6 us")
    text = (folder / "depth.csv").read_text()
    assert "outer face at y = 0.0127" in text and "liquids do not count" in text, text
    assert reached["met_target"] and 0.0 < reached["depth"] < 0.04 and list(reached["depth_in_body"]) == ["Rock"], reached
    deck, file = read_deck(folder / "deck.xml"), ParticleFile(folder / "particles.e")
    face = holes.face_of(None, file, deck)
    assert abs(face - 0.0127) < 1e-9, face
    hole = holes.measure_hole(file.frame(), deck, face)
    assert abs(hole.length - reached["channel_depth"]) <= hole.cell, (hole.length, reached)
    check_case(folder / "alone", "the jet meets liquids alone", False, liquid, "Materials/Sandstone/Card=water")


def hole_in_report(folder):
    """(hole as the report measures it, its radius half way down the channel)."""
    table, file = read_columns(folder / "depth.csv"), ParticleFile(folder / "particles.e")
    hole = holes.measure_hole(file.frame(), read_deck(folder / "deck.xml"), 0.0)
    return hole, hole.radius_at(0.5 * table["channel_depth"][-1])


def check_refined_hole(folder):
    """Cells of 2 mm everywhere, however they are made: one depth of the channel, and its radius to 1 %."""
    everywhere = ("Refinement/All/Lower={0 mm, -40 mm}", "Refinement/All/Upper={80 mm, 120 mm}")
    kinds = {
        "equal": (),
        "from 4 mm": ("Grid/Cell Size=4 mm", *everywhere, "Refinement/All/Level=1"),
        "from 8 mm": ("Grid/Cell Size=8 mm", *everywhere, "Refinement/All/Level=2"),
    }
    found = {name: run_quick(folder / name, "Time/End Time=14 us", "Output/Field Interval=7 us", *more)[1] for name, more in kinds.items()}
    first = found["equal"]
    for name, one in found.items():
        assert one["channel_depth"] == first["channel_depth"] > 0.04, f"{name}: {one['channel_depth']} beside {first['channel_depth']}"
        for measure in (one["channel_radius_mid"] / first["channel_radius_mid"],
                *(one["entrance_diameter_in_body"][b] / first["entrance_diameter_in_body"][b] for b in ("Casing", "Rock"))):
            assert abs(measure - 1.0) < 0.01, f"{name}: {one} beside {first}"
        hole, radius = hole_in_report(folder / name)
        assert abs(hole.length - one["channel_depth"]) <= hole.cell and abs(radius - one["channel_radius_mid"]) < hole.cell / 6.0, (name,
            hole.length, radius, one)


def check_zones(folder, *settings):
    """Rock around the hole, half-way down it: as the report finds it in particles.e, with walls of its own."""
    found = run_quick(folder, "Time/End Time=20 us", "Output/Field Interval=20 us", *settings)[1]
    assert set(found["zones_in_body"]) == {"Rock"}, found["zones_in_body"]
    zones = found["zones_in_body"]["Rock"]
    assert abs(zones["depth"] - (0.0127 + 0.5 * found["channel_depth_in_body"]["Rock"])) < 1e-12, found
    file, deck = ParticleFile(folder / "particles.e"), read_deck(folder / "deck.xml")
    hole = holes.measure_hole(file.frame(), deck, 0.0)
    rings = rings_at(Rock(file.frame(), deck, 0.0), hole, zones["depth"])
    assert abs(zones["radius"] - rings.edges[0]) < hole.cell / 6.0, (zones, rings.edges[0])
    for name, radius in (("crushed_from", rings.crushed[0]), ("crushed_to", rings.crushed[1]), ("dilated_to", rings.dilated[1]),
            ("impaired_to", rings.impaired[1])):
        assert abs(zones[name] - radius) < 1.25 * hole.cell, (name, zones, radius)
    assert abs(zones["skin"] - rings.skin) < 0.1 * max(1.0, abs(rings.skin)), (zones, rings.skin)
    assert abs(zones["least_porosity"] - np.nanmin(rings.porosity)) < 0.02, (zones, rings.porosity)
    assert abs(zones["greatest_breakage"] - np.nanmax(rings.breakage)) < 0.02, (zones, rings.breakage)
    assert (zones["greatest_breakage"] > 0.0) == bool(settings), zones
    # With one wall what is left is how sheared particles are spread over rings.
    beside = rings_at(Rock(file.frame(), deck, 0.0), hole, zones["depth"], zones["radius"])
    assert abs(zones["skin"] - beside.skin) < 0.03 * max(1.0, abs(beside.skin)), (zones, beside.skin)
    said = said_by("barreno.report", "report", folder)
    page = (folder / "report" / "index.md").read_text()
    rows = [line.strip("| ").split(" | ") for line in page.split("least permeability / virgin")[1].splitlines()[2:5]]
    assert len(rows) == 3 and rows[1][0] == f"{1e3 * zones['depth']:.1f}" and rows[1][1] == f"{1e3 * zones['radius']:.2f}", (said, rows)
    assert rows[1][-1] == f"{zones['skin']:+.2f}" and rows[1][2] == f"{1e3 * zones['crushed_from']:.1f}", (zones, rows)


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_case(folder / "down", None, True)
        check_case(folder / "up", "hits no body (none lies in its path along -y", False, "Jet/Direction=-y")
        check_case(folder / "late", "not before Time/End Time", False, "Jet/Launch Position=-35 mm")
        check_through(folder / "through")
        check_liquid(folder / "liquid")
        check_refined_hole(folder)
        check_zones(folder / "zones")
        check_zones(folder / "broken", "Materials/Sandstone/Card=berea_sandstone_damage.xml")


if __name__ == "__main__":
    main()
