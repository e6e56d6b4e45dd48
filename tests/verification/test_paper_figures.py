#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What docs/paper.md rests on: trends fail when they must, tables read back as written, finished runs are taken and others made, stresses
and the Lode angle are what they are called."""
import math
import os
import pathlib
import tempfile
import time
import unittest

import numpy as np

from barreno.report.inks import colour_of
from barreno.report.principal import lode_angle, pressure_and_shear, principal, revolved
from paper_figures import FIGURES, figure
from paper_figures.figure_5 import axial_radial_hoop
from paper_figures.figure_6 import limit_of
from paper_figures.lab import Lab, Table, least, most, read_table, write_table
from paper_figures.progress import Progress
from tools.paper_parts import unmeasured, unmeasured_words

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Trends(unittest.TestCase):
    def test_limits(self):
        self.assertTrue(least("a", 2.0, 1.0).holds)
        self.assertTrue(most("a", 1.0, 1.0).holds)
        self.assertFalse(least("a", 0.5, 1.0).holds)
        self.assertFalse(most("a", 1.5, 1.0).holds)
        for value in (math.nan, math.inf, -math.inf):
            self.assertFalse(least("a", value, 1.0).holds)
            self.assertFalse(most("a", value, 1.0).holds)

    def test_a_reversed_result_fails(self):
        """Each figure whose rows are runs: with the depths in the opposite order its trend is not found."""
        for number in (7, 8, 9, 10):
            tables = {name: read_table(ROOT / "verification" / "results" / f"{name}.csv") for name in figure(number).TABLES}
            self.assertTrue(all(trend.holds for trend in figure(number).trends(tables)), number)
            main = tables[f"paper_{number}"]
            at = next(i for i, column in enumerate(main.columns) if column.startswith("depth") and "30 us" not in column)
            depths = [row[at] for row in main.rows]
            for row, depth in zip(main.rows, reversed(depths)):
                row[at] = depth
            self.assertFalse(all(trend.holds for trend in figure(number).trends(tables)), number)

    def test_every_figure_has_its_results(self):
        for number in FIGURES:
            for name in figure(number).TABLES:
                self.assertTrue((ROOT / "verification" / "results" / f"{name}.csv").exists(), name)


class Tables(unittest.TestCase):
    def test_round_trip(self):
        table = Table("Figure 0: a\nb", ["word", "number"], [["a, b", 1.5], ["c", math.nan]])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "table.csv"
            write_table(file, table)
            found = read_table(file)
        self.assertEqual((found.remark, found.columns, found.rows[0]), (table.remark, table.columns, table.rows[0]))
        self.assertTrue(math.isnan(found.value("number", word="c")))
        with self.assertRaises(LookupError):
            found.value("number", word="d")


PROGRAM = """#!/bin/sh
while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done
mkdir -p "$out" && echo run >>"$out/made"
"""


class Runs(unittest.TestCase):
    """A program that only counts how often it makes a run."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.program = self.folder / "build" / "src" / "barreno"
        self.program.parent.mkdir(parents=True)
        self.program.write_text(PROGRAM)
        self.program.chmod(0o755)
        (self.folder / "runs").mkdir()

    def made(self, settings):
        lab = Lab(self.program, folder=self.folder / "runs", jobs=1)
        self.addCleanup(lab.scratch.cleanup)
        lab.progress.say = lambda *_, **__: None
        (folder,) = lab.runs([("rod.xml", settings, "rod")])
        return (folder / "made").read_text().count("run")

    def test_a_finished_run_is_taken(self):
        self.assertEqual([self.made({"a/b": "1"}), self.made({"a/b": "1"})], [1, 1])

    def test_other_settings_make_the_run_again(self):
        self.assertEqual([self.made({"a/b": "1"}), self.made({"a/b": "2"})], [1, 2])

    def test_another_program_makes_the_run_again(self):
        self.made({"a/b": "1"})
        later = time.time() + 10.0
        os.utime(self.program, (later, later))
        self.assertEqual(self.made({"a/b": "1"}), 2)

    def test_a_run_that_was_stopped_is_made_again(self):
        self.made({"a/b": "1"})
        self.program.write_text("#!/bin/sh\nexit 130\n")
        with self.assertRaises(RuntimeError):
            self.made({"a/b": "1"})
        self.program.write_text(PROGRAM)
        os.utime(self.program, (0.0, 0.0))  # only the mark that the run left tells
        self.assertEqual(self.made({"a/b": "1"}), 2)

    def test_time_left(self):
        """By what the figures took last, and once something was computed by the pace of this machine."""
        said = []
        progress = Progress({1: [0.0, 0.0], 2: [2.0, 100.0], 3: [1.0, 50.0]}, (1, 2, 3), 2, lambda text, **_: said.append(text))
        self.assertEqual(progress.left(), 100.0)
        progress.begin(2)
        progress.run_ended("a", 0.0, True)
        self.assertEqual((progress.left(), said), (75.0, ["  [1/2] a: is there already; about 75 s left"]))
        progress.began = time.monotonic() - 20.0
        progress.run_ended("b", 20.0, False)
        self.assertAlmostEqual(progress.left(), 40.0, delta=1.0)
        progress.figure_ended()
        self.assertEqual(progress.rest, 50.0)
        unknown = Progress({2: [2.0, 100.0]}, (2, 3), 2, lambda text, **_: said.append(text))
        unknown.begin(2)
        unknown.run_ended("c", 3.0, False)
        self.assertEqual((unknown.left(), said[-1], unknown.first_line()), (None, "  [1] c: 3 s", "How long this takes is not known."))


class Costs(unittest.TestCase):
    def test_runs_without_a_time_are_named(self):
        counts = {7: 24, 8: 13, 10: 25}
        self.assertEqual(unmeasured({7: 24, 8: 13, 10: 25}, counts.get), {})
        self.assertEqual(unmeasured({7: 24, 8: 9}, counts.get), {8: 4, 10: 25})
        self.assertEqual(unmeasured_words({}), [])
        self.assertIn("4 runs of figure 8, 25 runs of figure 10 (`verification/paper.py BARRENO --only 8 --only 10`",
            unmeasured_words({8: 4, 10: 25})[1])


class Stresses(unittest.TestCase):
    def test_lode_angle(self):
        cases = {0.0: (-3.0, -1.0, -1.0, 0.0), 30.0: (-3.0, -2.0, -1.0, 0.0), 60.0: (-3.0, -1.0, -3.0, 0.0)}
        for angle, stress in cases.items():
            self.assertAlmostEqual(float(lode_angle(principal(*map(np.array, stress)))), angle, places=9)

    def test_principal_stresses_do_not_depend_on_the_axes(self):
        turned = principal(np.array(-2.0), np.array(-2.0), np.array(-1.0), np.array(1.0))
        np.testing.assert_allclose(turned, [3.0, 1.0, 1.0])
        mean, shear = pressure_and_shear(turned)
        self.assertAlmostEqual(float(mean), 5.0 / 3.0)
        self.assertAlmostEqual(float(shear), 2.0 / math.sqrt(3.0))

    def test_a_path_keeps_its_axes_while_the_largest_stress_changes(self):
        radial, axial = np.array([-1e6, -2e6, -3e6]), np.array([-3e6, -2.5e6, -1e6])
        found = axial_radial_hoop(np.stack([radial, axial, np.full(3, -1e6), np.zeros(3)], axis=-1))
        np.testing.assert_allclose(found[:, 0], [3.0, 2.5, 1.0])
        np.testing.assert_allclose(found[:, 1], [1.0, 2.0, 3.0])

    def test_the_revolved_surface_has_the_meridian(self):
        p, q = np.array([0.0, 100.0]), np.array([10.0, 50.0])
        points = np.moveaxis(np.array(revolved(p, q, 7)), 0, -1)
        mean, shear = pressure_and_shear(points)
        np.testing.assert_allclose(mean, np.repeat(p[:, None], 7, axis=1), atol=1e-9)
        np.testing.assert_allclose(shear, np.repeat(q[:, None], 7, axis=1))

    def test_colours(self):
        np.testing.assert_allclose(colour_of(np.array(0.0), np.array(0.0)), [1.0, 1.0, 1.0])
        self.assertLess(colour_of(np.array(-1.0), np.array(0.0))[2], 0.5)  # tension is yellow
        self.assertLess(colour_of(np.array(3000.0), np.array(0.0))[0], colour_of(np.array(100.0), np.array(0.0))[0])


class Limits(unittest.TestCase):
    def test_limit_of_three_levels(self):
        h = np.array([2.0, 1.0, 0.5])
        limit, order = limit_of(h, 40.0 + 3.0 * h**1.5)
        self.assertAlmostEqual(limit, 40.0)
        self.assertAlmostEqual(order, 1.5)
        for slow in (np.array([1.0, 2.0, 1.5]), 40.0 - 3.0 * h**0.5, np.array([1.0, 2.0])):
            self.assertTrue(math.isnan(limit_of(h, slow)[0]))


if __name__ == "__main__":
    unittest.main()
