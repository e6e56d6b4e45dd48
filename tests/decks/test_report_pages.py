#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno report` and `barreno film` on short runs: the page, the hole profile against depth.csv, plain points, refined cells, three
dimensions, a film by ffmpeg, and the script for ParaView, whose names VTK's reader must know.

    test_report_pages.py BARRENO
"""
import ast
import os
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest.mock

import numpy as np

from barreno.report import hole as holes
from barreno.report.deck import read_deck
from barreno.report.files import read_columns
from barreno.report.particles import ParticleFile
from barreno.report.penetration import volumes_of
from python_commands import process_of, said_by
from tools.runs import run_deck

TARGET = {"Grid/Upper": "{80 mm, 130 mm}", "Bodies/Rock/Upper": "{50.8 mm, 112.7 mm}"}
SHORT = {**TARGET, "Time/End Time": "8 us", "Output/Field Interval": "4 us", "Output/Checkpoint Wall Interval": "0 s"}


def started(*words):
    """A command in a process of its own."""
    result = subprocess.run(**process_of("barreno.report", *words), capture_output=True, timeout=300, check=False)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stdout}{result.stderr}"


def command(*words, code=0, path=None):
    more = {"PATH": f"{path}:{os.environ['PATH']}"} if path else {}
    return said_by("barreno.report", *words, code=code, **more)


def check_page(run):
    started("report", run, "--right", "plastic_volume_strain", "--particles", "near tip", "--pdf")
    page = (run / "report" / "index.html").read_text()
    for words in ("data:image/png;base64,", "entrance diameter", "Kozeny", "error from the size of the cells", "remainder of the ledger",
            "Strength at the tip", "of the jet&#39;s table has been launched"):
        assert words in page, f"the page lacks {words}"
    assert (run / "report" / "report.pdf").stat().st_size > 50_000
    lines = (run / "report" / "profile.csv").read_text().splitlines()
    columns = "depth,radius,crushed_from,crushed_to,dilated_to,porosity_at_wall,impaired_to,breakage_at_wall"
    assert lines[1] == columns and len(lines) > 20, lines[:2]


def check_paths(run):
    """Stress paths at the tip, of the report of check_page: rock that flows is on its own surface, and 4 us from one time to the next are
    no path."""
    marked = (run / "report" / "index.md").read_text().split("## Stress paths")[1]
    rows = [line.strip("| ").split(" | ") for line in marked.splitlines() if line.startswith("| ") and "Sandstone" in line]
    shares = [float(row[8]) for row in rows if row[8] != "none"]
    assert 1 <= len(rows) <= 3 and shares and max(abs(share - 1.0) for share in shares if share > 0.9) < 0.01 and max(shares) < 1.01, rows
    assert "The times of particles.e are too far apart for these paths: from one to the next, 4 µs later" in marked, marked
    said = command("report", run, "--particles", "20000", code=1)
    assert "--particles has 20000, but the particles of this run are 1 to" in said, said


def check_radius(run):
    """Half way down, the wall is where depth.csv has it, to what boxes around sheared particles and lines between its rows leave of a
    jagged wall; the hole is as long as the channel to a cell."""
    table, file, deck = read_columns(run / "depth.csv"), ParticleFile(run / "particles.e"), read_deck(run / "deck.xml")
    hole = holes.measure_hole(file.frame(), deck, holes.face_of(table, file, deck))
    radius = hole.radius_at(0.5 * table["channel_depth"][-1])
    assert abs(radius - table["channel_radius_mid"][-1]) <= hole.cell / 4.0, (radius, table["channel_radius_mid"][-1])
    assert abs(hole.length - table["channel_depth"][-1]) <= hole.cell and hole.face == 0.0, (hole.length, table["channel_depth"][-1])
    return hole


def check_jet_mass(run):
    """Masses from the shapes of young jet material add up to those of the slugs launched so far."""
    file, deck = ParticleFile(run / "particles.e"), read_deck(run / "deck.xml")
    frame, slugs = file.frame(1), deck.slugs()
    mass = (frame.of_alive(["density"]) * volumes_of(frame, deck))[holes.jet_particles(frame, deck)].sum()
    launched = (np.pi * slugs[:, 2] ** 2 * slugs[:, 3] * slugs[:, 4])[slugs[:, 0] <= frame.time].sum()
    assert 0.8 * launched < mass < 1.05 * launched, (mass, launched)


def constants_of(script):
    """{name: value} of the constants that the script begins with."""
    tree = ast.parse(script.read_text())
    return {node.targets[0].id: ast.literal_eval(node.value) for node in tree.body if isinstance(node, ast.Assign)
        and node.targets[0].id.isupper() and node.targets[0].id != "HERE"}


def check_names(script):
    """Blocks and arrays of the script are those that VTK's Exodus reader finds in the file that it names."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader

    found = constants_of(script)
    reader = vtkExodusIIReader()
    reader.SetFileName(str(script.parent / found["FILES"][0]))
    reader.UpdateInformation()
    blocks = [reader.GetElementBlockArrayName(i) for i in range(reader.GetNumberOfElementBlockArrays())]
    arrays = [reader.GetElementResultArrayName(i) for i in range(reader.GetNumberOfElementResultArrays())]
    groups = found["TARGET"], found["OTHERS"], found["JET"]
    assert sorted(sum(groups, [])) == sorted(blocks), (groups, blocks)
    assert found["JET"] == ["Tungsten"] or "Tungsten" not in blocks, found["JET"]
    for array in ("status", "volume_ratio", found["LEFT"][0], found["RIGHT"][0]):
        assert array in arrays, f"VTK knows no {array}: {arrays}"


class Proxies(types.ModuleType):
    """In the place of paraview.simple: notes what a script makes."""

    def __init__(self):
        super().__init__("paraview.simple")
        self.made = []

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_, **words: self.made.append((name, words)) or unittest.mock.MagicMock(CameraFocalPoint=[0, 0, 0],
            CameraPosition=[0, 0, 1])


def made_by(script, *words):
    """What the script asks of ParaView, which is not there: names of its functions, in their order."""
    simple = Proxies()
    with unittest.mock.patch.dict(sys.modules, {"paraview": types.ModuleType("paraview"),
            "paraview.simple": simple}), unittest.mock.patch.object(sys, "argv", [str(script), *words]):
        exec(compile(script.read_text(), str(script), "exec"), {"__file__": str(script), "__name__": "__main__"})
    return [name for name, _ in simple.made]


def check_script(run):
    script = run / "report" / "paraview" / "view.py"
    check_names(script)
    made = made_by(script, "--save", "a.png")
    parts = 3  # rock, rubble and jet, each on both sides
    assert made.count("Show") == 2 * parts and made.count("Transform") == parts and "Glyph" not in made, made
    assert made[-1] == "SaveScreenshot" and (script.parent / constants_of(script)["WALLS"]).is_file(), made
    assert "Glyph" in made_by(script, "--glyphs", "--save", "a.png")
    made = made_by(script, "--map", "--state", "a.pvsm")
    assert (
        made.count("Calculator") == 2 * parts and made.index("Transform") < len(made) - 1 - made[::-1].index("Calculator")
        and made[-1] == "SaveState"
    ), made


def check_film(run, folder):
    """MP4 goes through ffmpeg, here one that keeps what it is given; without it there is a sentence."""
    bin_folder = folder / "bin"
    bin_folder.mkdir()
    said = command("film", run, "--field", "pressure", "--out", folder / "a.mp4", code=2,
        path=None) if not any((pathlib.Path(p) / "ffmpeg").exists() for p in os.environ["PATH"].split(":")) else "needs ffmpeg"
    assert "needs ffmpeg" in said, said
    (bin_folder / "ffmpeg").write_text('#!/bin/sh\nfor last; do :; done\ncat >"$last"\n')
    (bin_folder / "ffmpeg").chmod(0o755)
    command("film", run, "--field", "pressure", "--out", folder / "a.mp4", path=bin_folder)
    assert (folder / "a.mp4").stat().st_size > 3 * 100_000, "three pictures without compression"
    said = command("film", run, "--field", "pore_pressure", code=1)
    assert '--field "pore_pressure" is not a field of this run' in said, said
    assert "pressure.gif" in command("film", run, "--field", "pressure")


def check_points(barreno, folder):
    """Plain points have a report too, with the size of particles from the file; here of other fields, at an earlier time."""
    run = run_deck(barreno, "perforation_quick.xml", {**SHORT, "Output/Particle Glyph": "point"}, folder=folder / "points")
    command("report", run.folder, "--left", "velocity_x", "--right", "speed", "--time", "4 us")
    check_radius(run.folder)
    script = run.folder / "report" / "paraview" / "view.py"
    check_names(script)
    found = constants_of(script)
    made = made_by(script, "--save", "a.png")
    assert found["POINTS"] and 2e-4 < found["SIZE"] < 1.1e-3 and {"Glyph",
        "CreateView"} <= set(made) and abs(found["TIME"] - 4e-6) < 1e-7, found


def check_refined(barreno, folder, coarse):
    """The hole is measured in the cells along the path, and cells and steps are fields."""
    settings = {**SHORT, "Time/End Time": "4 us", "Jet/Cells Per Radius": "1", "Step/Subcycles": "4", "Step/Courant Fraction": "0.8"}
    run = run_deck(barreno, "perforation_quick.xml", settings, folder=folder / "refined")
    command("report", run.folder, "--left", "cell_size", "--right", "step_length")
    assert check_radius(run.folder).cell == 0.5 * coarse.cell
    check_levels(run.folder, coarse.cell)


def check_levels(run, whole):
    """Small cells lie along the axis and large ones beside them; steps of tiles are 1, 2 or 4 parts, the shortest of them where small cells
    are."""
    file = ParticleFile(run / "particles.e")
    frame = file.frame()
    size, step = frame.of_alive(["cell_size"]), frame.of_alive(["step_length"])
    assert set(np.round(size / whole, 12)) == {0.5, 1.0}, set(size)
    assert size[frame.centres[:, 0] < 2.0 * whole].max() == 0.5 * whole and size[frame.centres[:, 0] > 20.0 * whole].min() == whole
    part = float(file.data.variables["vals_glo_var"][-1][1])  # time_step
    assert set(np.round(step / part, 6)) <= {1.0, 2.0, 4.0} and step[size < whole].min() == step.min(), (set(step), part)
    assert (file.frame(0).of_alive(["step_length"]) == 0.0).all() and set(file.frame(0).of_alive(["cell_size"])) == set(size)


def check_space(barreno, folder):
    smaller = {"Grid/Upper": "{32 mm, 60 mm, 32 mm}", "Bodies/Plate/Upper": "{24 mm, 12 mm, 24 mm}",
        "Bodies/Rock/Upper": "{24 mm, 48 mm, 24 mm}"}
    run = run_deck(barreno, "perforation_3d.xml",
        {**smaller, "Time/End Time": "3 us", "Output/Field Interval": "3 us", "Output/Checkpoint Wall Interval": "0 s"},
        folder=folder / "space")
    command("report", run.folder, "--particles", "near tip")
    check_radius(run.folder)
    check_names(run.folder / "report" / "paraview" / "view.py")
    paths = read_columns(run.folder / "report" / "paths.csv")
    assert paths["along_y"][0] > 6e7 and set(paths["time"]) == {0.0, 3e-6}, paths
    rows = [line.split(" | ")[2] for line in (run.folder / "report" / "index.md").read_text().split("## Stress paths")[1].splitlines()
        if "Sandstone |" in line]
    assert rows and all(max(map(abs, np.array(row.split(", "), float)[[0, 2]])) < 17.0
        for row in rows), rows  # mm beside the axis: eight cells
    assert "in the plane of the picture" in (run.folder / "report" / "index.md").read_text()


def check_without_jet(barreno, folder):
    """A run that has no jet has a channel picture and its energies."""
    run = run_deck(barreno, "bar_wave.xml", {}, folder=folder / "bar")
    command("report", run.folder, "--left", "velocity_x")
    marked = (run.folder / "report" / "index.md").read_text()
    assert "## Energy" in marked and "## Hole" not in marked and not (run.folder / "report" / "profile.csv").exists(), marked


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        run = run_deck(barreno, "perforation_quick.xml", SHORT, folder=folder / "quick")
        check_page(run.folder)
        coarse = check_radius(run.folder)
        check_jet_mass(run.folder)
        check_paths(run.folder)
        check_script(run.folder)
        check_film(run.folder, folder)
        check_points(barreno, folder)
        check_refined(barreno, folder, coarse)
        check_space(barreno, folder)
        check_without_jet(barreno, folder)
    print("reports and films of short runs are as their page says")


if __name__ == "__main__":
    main()
