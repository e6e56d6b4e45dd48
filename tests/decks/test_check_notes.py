#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `check` and a run say of a deck that is valid but may not be meant: each warning on a deck with that mistake, and none on a deck of
input_xml that has not made it.

    test_check_notes.py BARRENO SERVE_RUNS

Plans come from a server (verification/adversary/serve_runs.cpp), which starts MPI once for all of them.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from adversary.run_server import RunServer
from tools.runs import DECKS, mpi_environment

QUICK = DECKS / "perforation_quick.xml"
# Their jets still fly when they end.
ENDS_EARLY = {"api_section_2.xml", "api_section_4.xml", "perforation_120us.xml", "perforation_3d.xml", "perforation_cement.xml",
    "perforation_plane_cpdi.xml", "perforation_plane_gimp.xml", "perforation_quick.xml", "perforation_refined.xml"}
OF_FIDELITY = ("Fidelity ", "The deck's own values take precedence over fidelity ")  # how its notes begin
THIN_WALLS = {"driven_cone_3d.xml", "jet_formation_3d.xml"}
THIN = " cells beside the explosive, fewer than 2"
EARLY = "ends the run before the jet stops"
SLUG = "1x5:{{0, {velocity}, {radius}, 0.01, 17600}}"
SLUGS = ("Jet/Table=", f"Jet/Slugs={SLUG.format(velocity=7000, radius=0.002)}")
TWO_SLUGS = ("Jet/Table=", "Jet/Slugs=2x5:{0, 7000, 0.002, 0.005, 17600, 2e-6, 6000, 0.004, 0.005, 17600}")
# Rock that holds water and is written with the density of the dry rock, and a deck with the step's own Largest Strain where its jet meets
# refined cells.
DRY_WITH_WATER = {"perforation_drainage.xml": "Materials/Sandstone/Density = 2120 kg/m3 looks like that of the dry rock"}
LARGE_STRAIN = {"perforation_refined.xml", "steady_penetration.xml"}
DRY = "looks like that of the dry rock"
STRAIN = "Step/Largest Strain = 0.5 lets single particles of spent jet gain energy"
WATER = "Materials/Sandstone/fluid_B0=2.25 GPa"
BORE = ("Bodies/Casing/Lower={3 mm, 0 mm}", "Bodies/Rock/Lower={3 mm, 12.7 mm}")

MISTAKES = {  # what: (settings, words)
    "gap": (["Bodies/Rock/Lower={0 mm, 13 mm}"],
        "Bodies/Rock and Bodies/Casing do not touch in the path of the jet (a gap of 0.0003 m or 0.15 cells"),
    "thin body": (["Bodies/Casing/Upper={50.8 mm, 1 mm}", "Bodies/Rock/Lower={0 mm, 1 mm}"],
        "Bodies/Casing is 0.001 m thick, less than a cell (Grid/Cell Size = 0.002 m)"),
    "target of 40 m": (["Grid/Cell Size=0.5 m", "Grid/Lower={0 m, -1 m}", "Grid/Upper={8 m, 41 m}", "Bodies/Casing/Upper={5 m, 0.5 m}",
        "Bodies/Rock/Lower={0 m, 0.5 m}", "Bodies/Rock/Upper={5 m, 40 m}"], "the target is 40 m thick along the jet"),
    "jet of 5 m/s": (["Jet/Table=", f"Jet/Slugs={SLUG.format(velocity=5, radius=0.001)}"],
        "Jet/Slugs gives the fastest slug 5 m/s, which is unusual for a jet"),
    "radius of a metre": (["Jet/Table=", f"Jet/Slugs={SLUG.format(velocity=7000, radius=0.06)}"],
        "Jet/Slugs gives a slug a radius of 0.06 m, which is unusual for a jet"),
    "end of two minutes": (["Time/End Time=120 s"], "Time/End Time = 120 s takes"),
    "jet in a bore": ([*SLUGS, *BORE], "the jet hits no body"),
    "jet that grazes its bore": ([*TWO_SLUGS, *BORE], "the thinnest slugs of the jet hit no body along +y"),
    "pressure without its unit": (["Materials/Sandstone/fluid_B0=2.25", "Materials/Sandstone/Fluid Density=1000"],
        'Materials/Sandstone/fluid_B0 = 2.25 Pa is outside the usual range (50000 to 3e+10 Pa); if a unit was forgotten, write it behind '
        'the number, "2.25 MPa" or "2.25 GPa"'),
    "strength in MPa": (["Materials/Steel/A=792"],
        'Materials/Steel/A = 792 Pa is outside the usual range (10000 to 2e+10 Pa); if a unit was forgotten, write it behind the number, '
        '"792 MPa"'),
    "modulus in GPa": (["Materials/Sandstone/B1=28.6"], "Materials/Sandstone/B1 = 28.6 Pa is outside the usual range (100000 to 1e+12 Pa)"),
    "water without its mass": ([WATER], "while fluid_B0 fills its pores (0.2 of the volume); write Fluid Density, for water 1000 kg/m3, "
        "and the rock starts with 2320 kg/m3"),
    "refined cells": (["Jet/Cells Per Radius=2"], STRAIN + " where they collide in refined cells (docs/method.md, 4); take 0.1"),
    "splines in motion": (["Step/Shape Function=quadratic B-spline", "Bodies/Rock/Velocity={0 m/s, 10 m/s}"],
        "will ring under its confinement with Shape Function quadratic B-spline"),
    "cubic splines": (["Step/Shape Function=cubic B-spline"],
        "will ring under its confinement with Shape Function cubic B-spline, because its faces bear a pressure"),
    "linear functions": (["Step/Shape Function=linear"], "will ring under its confinement with Shape Function linear"),
    "thin slugs": (["Materials/Tungsten/Card=tungsten_alloy.xml", "Jet/Table=", "Jet/Slugs=1x5:{0, 2000, 0.002, 0.0005, 17600}"],
        'late slugs of the jet, 0.0005 m long, are too thin for their particles (layers: 1 of at least 3): they pile up at the bottom, and '
        'the depth at rest comes out too small (docs/trade.md, Depth at rest); choose Jet/Splits = 4'),
    "early end": ([], f"Time/End Time = 4e-05 s {EARLY} (69 % of its mass and 34 % of its energy"),
}  # fmt: skip


def barreno(*words, code=0):
    result = subprocess.run([sys.argv[1], *map(str, words)], env=mpi_environment(), capture_output=True, text=True, timeout=300)
    assert result.returncode == code, f"{words}: exit {result.returncode}\n{result.stderr}"
    return result.stdout


def plan_of(server, *words):
    ended = server.run("check", *words, limit=120)
    assert ended.text() == "exit 0", f"{words}: {ended.text()}\n{ended.err}"
    return ended.out


def notes_of(text):
    return [line.removeprefix("Note: ") for line in text.splitlines() if line.startswith("Note: ")]


NOT_MISTAKEN = {  # what: (settings, words that no note has)
    "water with its mass": ([WATER, "Materials/Sandstone/Fluid Density=1000 kg/m3"], DRY),
    "density of the wet rock": ([WATER, "Materials/Sandstone/Density=2320 kg/m3"], DRY),
    "small strains of a step": (["Jet/Cells Per Radius=2", "Step/Largest Strain=0.1"], STRAIN),
    "fidelity": (["Jet/Cells Per Radius=2", "Fidelity=balanced"], STRAIN),
    "GIMP": (["Step/Shape Function=GIMP"], "will ring"),
}


def check_liquid_out_of_equilibrium(server):
    """Loads on a liquid with another pressure than that of its start."""
    deck, said = DECKS / "api_section_4.xml", "a liquid that starts under {} MPa, and Loads/Scallop water presses on it with {} MPa"
    for settings, words in (((), ""), (["Materials/Water/Initial Pressure=30 MPa"], said.format(30, 17)),
            (["Loads/Scallop water/Pressure=12 MPa"], said.format(17, 12))):  # fmt: skip
        plan = plan_of(server, deck, *(word for one in settings for word in ("--set", one)))
        notes = [note for note in notes_of(plan) if "a liquid that" in note]
        assert len(notes) == bool(words) and all(words in note for note in notes), notes


def check_shipped_decks(server):
    for deck in sorted(DECKS.glob("*.xml")):
        notes = notes_of(plan_of(server, deck))
        dry, strain = ([note for note in notes if words in note] for words in (DRY, STRAIN))
        assert [DRY_WITH_WATER.get(deck.name, "") in note
            for note in dry] == [True] * (deck.name in DRY_WITH_WATER), f"{deck.name}: {notes}"
        assert len(strain) == (deck.name in LARGE_STRAIN), f"{deck.name}: {notes}"
        chosen = [note for note in notes if note.startswith(OF_FIDELITY)]
        text = deck.read_text()
        # It chooses no intervals for a run whose end is open: there is none that the deck's own could take precedence over.
        assert len(chosen) == (2 - ('value="at rest"' in text)) * ('"Fidelity"' in text), f"{deck.name}: {notes}"
        notes = [note for note in notes if note not in dry + strain + chosen]
        early, thin, cells = ([note for note in notes if words in note] for words in (EARLY, THIN, "Grid/Cell Size = "))
        assert len(early) == (deck.name in ENDS_EARLY) and notes == cells + early + thin, f"{deck.name}: {notes}"
        assert len(thin) == (deck.name in THIN_WALLS), f"{deck.name}: {notes}"
        assert len(cells) == ('"Cell Size"' not in deck.read_text()), f"{deck.name}: {notes}"


def check_mistakes(server):
    for what, (settings, words) in MISTAKES.items():
        notes = notes_of(plan_of(server, QUICK, *[x for one in settings for x in ("--set", one)]))
        assert sum(words in note for note in notes) == 1, f"{what}: {notes}"
        assert all(". " not in note for note in notes), f"{what}: more than one sentence in {notes}"
    for what, (settings, words) in NOT_MISTAKEN.items():
        notes = notes_of(plan_of(server, QUICK, *[x for one in settings for x in ("--set", one)]))
        assert not any(words in note for note in notes), f"{what}: {notes}"


def check_pore_flow_keeps_equal_cells(server):
    """Pore fluid flows between cells of one size: a fidelity leaves its refined path out, whether drainage is on or automatic."""
    for drainage in ("automatic", "on"):
        notes = notes_of(plan_of(server, DECKS / "perforation_drainage.xml", "--fidelity", "balanced", "--set",
            f"Pore Flow/Drainage={drainage}"))
        assert any(f"Cells Per Radius is left out: Pore Flow/Drainage = {drainage} does not work across" in note for note in notes), notes
    plan = plan_of(server, DECKS / "perforation_drainage.xml", "--fidelity", "balanced", "--set", "Pore Flow/Drainage=off")
    assert "refined to" in plan, plan


def check_thin_liner():
    """A wall of 1.5 mm in cells of 1 mm; with cells of 0.5 mm there is no note (check_shipped_decks)."""
    (note,) = notes_of(barreno("check", DECKS / "jet_formation.xml", "--set", "Grid/Cell Size=1 mm"))
    assert note.startswith("Bodies/Liner has a wall of about 1.") and THIN in note and ". " not in note, note


def check_plan():
    """Cells of the slugs and the error that was measured with them."""
    plan = barreno("check", QUICK)
    assert "at impact 0.5 to 1.1 cells per radius (tip 0.5, tail 1.1), 0.151 to 0.503 cells per length" in plan, plan
    assert "expected error at the end from the size of the cells: -25 % (-33 to -16 %) at 0.5 cells per jet radius" in plan, plan
    unknown = barreno("check", QUICK, "--set", "Step/Transfer=APIC")
    words = "at the end from the size of the cells: unknown (it was measured with Transfer FLIP only); barreno converge compares"
    assert words in unknown, unknown
    # At rest, and with metal that fails; the fidelities say why too.
    late = barreno("check", QUICK, "--set", "Time/End Time=330 us")
    assert "from the size of the cells: unknown (it was measured until 90 us only); barreno converge" in late, late
    assert late.count("depth unknown (it was measured until 90 us only)") == 3, late
    torn = barreno("check", QUICK, "--set", "Materials/Tungsten/Spall Stress=2 GPa")
    assert "unknown (it was measured with tungsten that does not break only" in torn, torn
    formed = barreno("check", DECKS / "jet_formation_penetration.xml")
    assert "from the size of the cells: unknown (it was measured with launched jets only); barreno converge" in formed, formed


def check_run(folder):
    """A run says the same, and its summary has the cells and the error."""
    words = ("--set", "Time/End Time=2 us", "--set", "Bodies/Rock/Lower={0 mm, 13 mm}")
    said = barreno("run", QUICK, *words, "--out", folder / "run")
    log = (folder / "run" / "run.log").read_text()
    for text in (said, log):
        assert text.count("do not touch in the path of the jet") == 1 and text.count(EARLY) == 1, text
        assert "error of the depth from the size of the cells: -33 % (-33 to -16 %) at 0.5 cells per jet radius" in text, text
    found = json.loads((folder / "run" / "summary.json").read_text())["penetration"]
    assert found["cells_per_radius"] == {"tip": 0.5, "tail": found["cells_per_radius"]["tail"], "least": 0.5,
        "most": found["cells_per_radius"]["most"]}, found
    error = found["depth_error"]
    assert (
        -0.34 < error["value"] < -0.32 and error["low"] <= error["value"] < error["high"] < 0.0 and error["cells_per_radius"] == 0.5
    ), error


def check_density_of_wet_rock(server):
    """Materials of the plan: dry, and with water in a fifth of the volume."""
    for settings, density in (([], "2120 kg"), ([WATER], "2120 kg"), ([WATER, "Materials/Sandstone/Fluid Density=1 g/cm3"], "2319.9")):
        plan = plan_of(server, QUICK, *[x for one in settings for x in ("--set", one)])
        assert f"Arenisca, {density}" in plan, plan


def check_title_of_lines(folder):
    """A line end in a title begins no line: not of the plan, the screen, run.log or the summary."""
    deck = folder / "lines.xml"
    forged = "barreno: forged line"
    text = QUICK.read_text()
    (title,) = [line for line in text.splitlines() if 'name="Title"' in line]
    text = text.replace(title, f'<Parameter name="Title" type="string" value="a&#10;{forged}&#13;x"/>').replace("jets/", f"{DECKS}/jets/")
    deck.write_text(text)
    plan = barreno("check", deck)
    assert plan.startswith(f"a {forged} x\nThe deck is valid.\n"), plan
    said = barreno("run", deck, "--set", "Time/End Time=0.1 us", "--out", folder / "lines")
    for lines in (plan, said, (folder / "lines" / "run.log").read_text()):
        assert not any(line.startswith(forged) for line in lines.splitlines()), lines
    assert json.loads((folder / "lines" / "summary.json").read_text())["title"] == f"a {forged} x"


def check_print_deck(folder):
    """--print-deck is what a run writes."""
    (printed,) = [barreno("check", QUICK, "--set", "Time/End Time=0.1 us", "--print-deck")]
    barreno("run", QUICK, "--set", "Time/End Time=0.1 us", "--out", folder / "short")
    assert printed == (folder / "short" / "deck.xml").read_text()


def main():
    check_thin_liner()
    check_plan()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        server = RunServer(pathlib.Path(sys.argv[2]).resolve(), folder)
        check_mistakes(server)
        check_pore_flow_keeps_equal_cells(server)
        check_liquid_out_of_equilibrium(server)
        check_shipped_decks(server)
        check_density_of_wet_rock(server)
        server.end()
        check_run(folder)
        check_title_of_lines(folder)
        check_print_deck(folder)


if __name__ == "__main__":
    main()
