#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Stress paths of a report: principal stresses that are followed by their direction, shapes in the octahedral plane against the oracle's,
which particles are meant, what is said of coarse times, the page, and the sentence of every refusal."""
import contextlib
import io
import math
import pathlib
import tempfile

import numpy as np

from oracles.arenisca_laws import lode_function
from barreno.report import command, principal, stress_paths
from barreno.report.build import Wishes, paths_wished
from barreno.report.deck import read_deck
from barreno.report.path_section import coarse_words, path_section
from barreno.report.run import opened
from barreno.report.strength import lode_shape, strength_of
from barreno.report.stress_paths import StressPath
from synthetic_run import CELL, jet, lattice, rock, stresses, write_run

DEPTH = 20 * CELL


def turn(angle, axis):
    first, second = [other for other in range(3) if other != axis]
    matrix = np.eye(3)
    matrix[[first, second], [first, second]] = math.cos(angle)
    matrix[first, second], matrix[second, first] = -math.sin(angle), math.sin(angle)
    return matrix


def check_along_path():
    """Stresses that turn by 200 degrees, cross each other and pass through an isotropic state keep their order."""
    steps = np.linspace(0.0, 1.0, 41)
    wanted = np.stack([1.0 + 4.0 * steps, 3.0 - 2.0 * steps, 2.0 + 0.0 * steps], axis=-1)
    wanted[0] = 2.0  # isotropic: no direction of its own
    axes = [turn(math.radians(200.0 * step), 0) @ turn(math.radians(30.0 * step), 2) for step in steps]
    found = principal.along_path(np.array([-a @ np.diag(values) @ a.T for a, values in zip(axes, wanted)]))
    assert np.abs(found - wanted).max() < 0.03, np.abs(found - wanted).max(axis=0)  # where two cross, either may be taken for the other
    plane = principal.along_path(principal.tensors([-1.0, -2.0], [-5.0, -5.0], [-3.0, -3.0], [0.0, 1.0]))
    assert np.allclose(plane[0], [1.0, 5.0, 3.0]) and plane[1, 0] < 2.0 and plane[1, 1] > 5.0 and plane[1, 2] == 3.0, plane


def check_shapes():
    """1 in triaxial compression, psi in extension, between them as the oracle, whose angle is 0 in extension."""
    lode = np.linspace(0.0, 60.0, 13)
    for number, (kind, psi) in enumerate([("none", 0.7), ("Gudehus", 0.85), ("Willam-Warnke", 0.7), ("Mohr-Coulomb", 0.75)]):
        oracle = lode_function(number, psi)
        by_oracle = [1.0 if number == 0 else oracle(math.radians(60.0 - angle))[0] for angle in lode]
        assert np.allclose(lode_shape(kind, psi)(lode), by_oracle, rtol=1e-12), (kind, lode_shape(kind, psi)(lode), by_oracle)
    wide = lode_shape("Willam-Warnke", 1.4)(lode)
    assert abs(wide[0] - 1.0) < 1e-12 and abs(wide[-1] - 1.4) < 1e-12 and (np.diff(wide) > 0.0).all(), wide
    assert np.allclose(principal.lode_of_turn(np.radians([0.0, 60.0, 90.0, 120.0, 180.0, -90.0])), [0.0, 60.0, 30.0, 0.0, 60.0, 30.0])


def check_surface(run):
    """Vertex and cap bound the surface; scatter moves its vertex; a revolved meridian has its own pressure and shear."""
    card = strength_of(read_deck(run / "deck.xml"), "Sandstone")
    assert card.shear_at(-9.37e6 / 3.0, 0.0) == 0.0 < card.shear_at(-9.35e6 / 3.0, 0.0) and card.shear_at(1.23e9 / 3.0,
        0.0) == 0.0 < card.shear_at(1.22e9 / 3.0, 0.0)
    assert card.scaled(2.0).shear_at(-18e6 / 3.0, 0.0) > 0.0 == card.shear_at(-18e6 / 3.0, 0.0) and card.peak == 9.36e6
    broken = card.scaled(1.0, 1.0)
    assert broken.shear_at(0.0, 0.0) == 0.0 < broken.shear_at(1e8, 0.0) < card.shear_at(1e8, 0.0)
    p, q = card.curve(0.0, 1e9, 50)
    points = np.moveaxis(np.array(principal.revolved(p, q, 13, lode_shape("Mohr-Coulomb", 0.75))), 0, -1)
    mean, shear = principal.pressure_and_shear(points)
    assert np.allclose(mean, p[:, None], atol=1.0) and np.allclose(shear[:, 0], q, atol=1.0) and np.allclose(shear[:, 2], 0.75 * q,
        atol=1.0), (shear[5], q[5])  # Pa; the third point: triaxial extension
    lode = principal.lode_angle(-np.sort(-points[5], axis=-1))
    assert np.allclose(lode, [0, 30, 60, 30, 0, 30, 60, 30, 0, 30, 60, 30, 0], atol=1e-5), lode


def check_sectors():
    """The nearest ahead, obliquely ahead and beside; none behind, none under the tip itself."""
    centres = np.array([[0.0, 5.0], [0.0, 3.0], [0.0, 0.5], [2.0, 2.0], [4.0, 0.0], [3.0, -1.0], [0.0, -3.0]])
    assert stress_paths.nearest_in_sectors(centres, (0.0, 0.0), 1.0, 1.0) == [1, 3, 5]
    assert stress_paths.nearest_in_sectors(centres, (0.0, 0.0), -1.0, 1.0) == [6, 5, 4]
    in_space = np.array([[0.0, 3.0, 9.0], [0.0, 4.0, 0.0], [0.0, 0.0, 2.0], [1.0, 0.0, 9.0]])
    assert stress_paths.nearest_in_sectors(in_space, (0.0, 0.0), 1.0, 1.0) == [1, 0, 2]


def path(stress, times=None):
    stress = np.array(stress, float)
    count = len(stress)
    return StressPath(7, "Sandstone", np.arange(count) * 1e-6 if times is None else times, np.zeros((count, 2)), stress,
        np.full(count, np.nan), np.ones(count), np.zeros(count))


def check_coarse():
    """A path in a hundred equal steps needs no words; one jump of a half of it does, and so much finer times would cure it."""
    fine = np.linspace(0.0, 1e8, 101)[:, None] * [3.0, 1.0, 1.0]
    assert coarse_words([path(fine)]) == [] and coarse_words([path(np.ones((3, 3)))]) == []
    (words,) = coarse_words([path(fine), path(np.concatenate([fine[:30], fine[80:]]))])
    assert (
        "1 µs later, the stress of particle 7 changes by 51 % of all that" in words and "Output/Field Interval of 0.1 µs or less" in words
    ), words


def wall():
    """A hole of three cells' radius, down to DEPTH; two thirds of the strength of the card in pressure and shear."""
    block = rock(np.concatenate([lattice(3 * CELL, 14 * CELL, 0.0, DEPTH), lattice(0.0, 14 * CELL, DEPTH, 32 * CELL)]))
    block.fields.update(stresses(1e8 + 1e9 * block.start.mean(axis=1)[:, 0], 5e7))
    return block


def said(*words, code=0):
    """What the command prints, on either stream."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        found = command.main([str(word) for word in words])
    assert found == code, f"{words}: exit {found}, {err.getvalue()}"
    return err.getvalue() if code else out.getvalue()


def check_page(run):
    """Three particles at the tip, with their place, their share of the strength and a file of their paths."""
    assert "paths.csv" in said("report", run, "--particles", "near  tip")
    marked = (run / "report" / "index.md").read_text()
    rows = [line.strip("| ").split(" | ") for line in marked.split("## Stress paths")[1].splitlines() if line.startswith("| ")
        and "Sandstone" in line]
    assert len(rows) == 3 and all(name in marked for name in ("(map.png)", "(paths.png)")), rows
    card = strength_of(read_deck(run / "deck.xml"), "Sandstone")
    for row in rows:  # of numbers to a tenth of a mm and of a MPa
        r, y = (1e-3 * float(value) for value in row[2].split(", "))
        p = 1e8 + 1e9 * r
        assert math.hypot(r, y - DEPTH) < 4 * CELL and abs(1e6 * float(row[4]) - p) < 1.01e5 and abs(float(row[5]) - 50.0) < 0.1, row
        assert row[6] == "0" and abs(float(row[8]) - 5e7 / card.shear_at(p, 0.0)) < 0.006, row
    numbers = [int(row[0]) for row in rows]
    lines = (run / "report" / "paths.csv").read_text().splitlines()
    assert lines[1] == "particle,time,axial,radial,hoop,pressure,shear_stress,lode,plastic_volume_strain" and len(lines) == 2 + 2 * 3, lines
    axial, radial, hoop = (float(value) for value in lines[2].split(",")[2:5])
    assert abs(axial - radial - math.sqrt(3.0) * 5e7) < 1e3 and abs(radial - hoop) < 1e3, lines[2]
    return numbers, lines


def check_numbers(run, numbers, lines):
    """The same by their numbers; a material without a surface has its path, and a sentence."""
    with opened(run) as whole:
        of_jet = int(whole.file.numbers[np.flatnonzero(whole.file.block == whole.file.block_names.index("Tungsten"))[0]])
        paths = paths_wished(whole, Wishes(particles=", ".join(map(str, [*numbers, of_jet, numbers[0]]))))
        section = path_section(whole, whole.frame(), paths, None, run / "report")
    assert (
        "Tungsten: a report knows no surface of its model (Johnson-Cook), so only the path is drawn." in section.words
        and len(section.pictures) == 2
    ), section.words
    assert [row[0] for row in section.table] == [*map(str, numbers), str(of_jet)], section.table
    found = (run / "report" / "paths.csv").read_text().splitlines()
    assert found[:-1] == lines and found[-1].startswith(f"{of_jet},"), "the jet is there at one of the two times"


REFUSED = [  # words, part of the sentence
    ("deep", '--particles "deep" is neither "near tip" nor numbers of particles; write for example --particles "near tip" or --particles '
        '120,340.'),
    ("", '--particles "" is neither'),
    ("3,,4", '--particles "3,,4" is neither'),
    ("-3", '--particles "-3" is neither'),
    ("4,123456789012345678901", "--particles has 123456789012345678901, but the particles of this run are 1 to"),
    ("0", "--particles has 0, but the particles of this run are 1 to"),
    ("1,2,3,4,5,6,7,8,9", "--particles has 9 particles, of which no more than 8 can be told apart; choose fewer."),
]


def check_refusals(run, folder):
    before = sorted(run.rglob("*"))
    for words, sentence in REFUSED:
        found = said("report", run, f"--particles={words}", code=1)
        assert found.startswith("barreno: ") and found.count("\n") == 1 and sentence in found, f"{words}: {found}"
    found = said("report", run, "--particles", "near tip", "--time", "0 us", code=1)
    assert '--particles "near tip" finds no tip (the jet has not hit the target at 0 us); name particles by their numbers' in found, found
    assert sorted(run.rglob("*")) == before, "a refusal leaves files"
    far = write_run(folder / "far", [jet(np.array([[0.2 * CELL, CELL]]), np.array([100.0])), rock(lattice(0.0, 5 * CELL, 0.0, 5 * CELL))],
        depth=0.04)
    found = said("report", far, "--particles", "near tip", code=1)
    assert '--particles "near tip" finds no particle of the target within 8 mm of the tip' in found, found
    bare = write_run(folder / "bare", [rock(lattice(0.0, 5 * CELL, 0.0, 5 * CELL))])
    (bare / "depth.csv").unlink()
    (bare / "deck.xml").write_text((bare / "deck.xml").read_text().replace('name="Jet"', 'name="Other"'))
    found = said("report", bare, "--particles", "near tip", code=1)
    assert "finds no tip (this run has no jet)" in found, found
    gone = rock(lattice(0.0, 2 * CELL, 0.0, 2 * CELL))
    gone.fields = {name: values for name, values in gone.fields.items() if not name.startswith("stress_")}
    found = said("report", write_run(folder / "gone", [gone]), "--particles", "1", code=2)
    assert "it has no stresses of particle 1" in found, found


def main():
    check_along_path()
    check_shapes()
    check_sectors()
    check_coarse()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        run = write_run(folder / "run", [jet(np.array([[0.25 * CELL, CELL]]), np.array([5000.0])), wall()], depth=DEPTH)
        check_surface(run)
        check_refusals(run, folder)
        check_numbers(run, *check_page(run))
    print("stress paths are those of the particles, and their surfaces those of the card")


if __name__ == "__main__":
    main()
