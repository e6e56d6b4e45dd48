#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments of docs/validation.md: only what was seen is required, what fails is found, and a crater of known shape is measured."""
import pathlib
import unittest
import unittest.mock

import numpy as np
from tools import validation_part
from tools.crater import ROW, Rock, filled, floors_of, wall_of
from tools.experiment import ASSUMED, CHEAP, DERIVED, EXPERIMENTS, FORM, RECALLED, SEEN, Experiment, spread
from tools.demands import read_open
from tools.validation_results import stored_experiments

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "verification" / "experiments"
HOLE, DEPTH, SIDE = 3e-3, 5e-3, 0.25e-3  # of a cylindrical crater, of its particles [m]


def experiment(mark, ours):
    one = Experiment("A test", "It is a test.", "none", cells=[2.0, 1.0])
    return one, one.compare("depth [mm]", "10", mark, "a text", ours)


def block(debris):
    """Squares around a cylindrical hole, which holds debris of a share of the rock's mass."""
    places = SIDE * (np.arange(160) + 0.5)
    x, y = (axis.ravel() for axis in np.meshgrid(places, places))
    inside = (x < HOLE) & (y < DEPTH)
    volume = 2.0 * np.pi * x * SIDE**2 * np.where(inside, debris, 1.0)
    return Rock(x, y, np.full_like(x, 0.5 * SIDE), volume, np.zeros_like(x))


class Requirements(unittest.TestCase):
    def test_only_what_was_seen_is_required(self):
        for mark in (RECALLED, ASSUMED):
            one, row = experiment(mark, [9.0, 9.5])
            with self.assertRaises(ValueError):
                one.within(row, 10.0, 0.1)
        for mark in (SEEN, DERIVED):
            one, row = experiment(mark, [9.0, 9.5])
            one.within(row, 10.0, 0.1)
            self.assertAlmostEqual(row["check"]["value"], 0.05)

    def test_the_interval_is_what_halving_changed(self):
        self.assertEqual(spread([9.0, 9.5]), 0.5)
        self.assertEqual(validation_part.ours([9.0, 9.5]), "9.5 +- 0.5")
        self.assertEqual(validation_part.ours([9.5]), "9.5")

    def test_every_experiment_has_its_file_and_is_stored(self):
        self.assertEqual(sorted(EXPERIMENTS), sorted(file.stem for file in FOLDER.glob("*.py")))
        self.assertLessEqual(set(CHEAP), set(EXPERIMENTS))
        self.assertEqual(list(stored_experiments()), list(EXPERIMENTS))
        named = {case.removeprefix(FORM) for case, _ in read_open() if case.startswith(FORM)}
        self.assertLessEqual(named, set(EXPERIMENTS))

    def test_a_stored_figure_that_fails_is_found(self):
        found = stored_experiments()
        self.assertEqual(validation_part.failing(), [])
        row = next(row for row in found["sphere"]["rows"] if row["check"] and row["check"]["limit"] == 0.25)
        row["check"]["value"] = 0.3
        with unittest.mock.patch.object(validation_part, "stored_experiments", lambda: found):
            self.assertTrue(any(row["what"] in line for line in validation_part.failing()))
            self.assertTrue(any("**FAILS**" in line for line in validation_part.overview()))


class Crater(unittest.TestCase):
    def test_a_cylinder_has_its_floor_and_wall(self):
        for debris in (0.0, 0.3):
            rock = block(debris)
            for floor in floors_of(rock, 1.25e-3):
                self.assertAlmostEqual(floor, DEPTH, delta=0.5 * ROW)
            self.assertAlmostEqual(wall_of(rock, (1e-3, 2e-3)), HOLE, delta=0.5 * ROW)
            self.assertEqual(wall_of(rock, (6e-3, 7e-3)), 0.0)

    def test_a_crack_below_the_floor_is_no_crater(self):
        rock = block(0.0)
        kept = (rock.y < DEPTH + 2e-3) | (rock.y > DEPTH + 3e-3)
        parted = Rock(*(values[kept] for values in (rock.x, rock.y, rock.half, rock.volume, rock.damage)))
        first, last = floors_of(parted, 1.25e-3)
        self.assertAlmostEqual(first, DEPTH, delta=0.5 * ROW)
        self.assertAlmostEqual(last, DEPTH + 3e-3, delta=0.5 * ROW)

    def test_whole_rock_is_full(self):
        self.assertAlmostEqual(filled(block(0.0), (4e-3, 5e-3), (1e-3, 2e-3)), 1.0, places=3)


if __name__ == "__main__":
    unittest.main()
