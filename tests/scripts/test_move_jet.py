#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""input_xml/jets/move_jet.py: a table moved to a second plane is the one taken there; break-up times and depths."""
import contextlib
import io
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import move_jet
import quantity
from barreno.runs import units

ROOT = pathlib.Path(__file__).resolve().parents[2]
JETS = ROOT / "input_xml" / "jets"

DENSITY, TIP, ORIGIN = 8930.0, 7000.0, 0.05
RADIUS = 1.5e-3


def stretching_jet(plane, count=100):
    """Rows of v = TIP X / ORIGIN, whole and of one radius when its tip is at the plane ORIGIN from the virtual origin, at a plane
    further on: x = X t / t0 passes at t, v = x / t, and what passes from t1 to t2 has lasted as long everywhere in proportion."""
    rows = []
    for i in range(count):
        velocity = TIP * (1.0 - 0.7 * i / (count - 1))
        rows.append([plane / velocity, velocity])
    duration = move_jet.durations([row[0] for row in rows])
    # At ORIGIN the radius is RADIUS; a slice's length grows as the way from the origin.
    radius = RADIUS * math.sqrt(ORIGIN / plane)
    return [(t, v, radius, v * dt, DENSITY) for (t, v), dt in zip(rows, duration)]


def refusal(arguments, text):
    """What the tool ends with."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
        table.write(text)
        table.flush()
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                move_jet.main([table.name, *arguments])
        except SystemExit as end:
            return str(end.code)
    return "accepted"


class MoveJet(unittest.TestCase):
    def test_a_moved_table_is_the_one_taken_there(self):
        moved, heat = move_jet.move(stretching_jet(0.05), 0.15)
        self.assertEqual(heat, 0.0)
        for row, exact in zip(moved, stretching_jet(0.2)):
            for value, expected in zip(row, exact):
                self.assertAlmostEqual(value / expected, 1.0, delta=1e-12)

    def test_the_rule_of_short_slices(self):
        rows = stretching_jet(0.05)
        moved, _ = move_jet.move(rows, 0.01)
        times = [row[0] for row in rows]
        for i in range(1, len(rows) - 1):
            gradient = (rows[i + 1][1] - rows[i - 1][1]) / (times[i + 1] - times[i - 1])
            longer = moved[i][3] / rows[i][3]
            self.assertAlmostEqual(longer, 1.0 - 0.01 * gradient / rows[i][1] ** 2, delta=1e-3)

    def test_mass_momentum_and_energy_stay(self):
        with open(JETS / "tungsten_154.csv", encoding="utf-8") as stream:
            rows = move_jet.read_table(stream, "tungsten_154.csv")
        choices = (None, lambda radius, rate, density: 30e-6, lambda radius, rate, density: move_jet.hirsch(radius, 110.0))
        for choice in choices:
            moved, heat = move_jet.move(rows, 0.1, 0.12, choice)
            self.assertEqual(heat, 0.0)
            for before, after in zip(move_jet.totals(rows), move_jet.totals(moved)):
                self.assertAlmostEqual(after / before, 1.0, delta=1e-12)

    def test_what_has_broken_keeps_radius_and_length(self):
        rows = stretching_jet(0.05)
        moved, _ = move_jet.move(rows, 0.15, 0.05, lambda radius, rate, density: 10e-6)
        half, _ = move_jet.move(rows, 0.02, 0.05, lambda radius, rate, density: 10e-6)
        for row, before, nearer in zip(moved, rows, half):
            at_break = before[1] * 10e-6  # way from the origin
            if at_break <= 0.05:
                self.assertAlmostEqual(row[2], before[2], delta=1e-15)
                self.assertAlmostEqual(row[3], before[3], delta=1e-15)
            elif at_break < 0.07:
                self.assertAlmostEqual(row[2] / nearer[2], 1.0, delta=1e-12)
                self.assertAlmostEqual(row[2] / (RADIUS * math.sqrt(0.05 / at_break)), 1.0, delta=1e-12)
        self.assertLess(moved[-1][3], move_jet.move(rows, 0.15)[0][-1][3])

    def test_rows_that_catch_up_merge(self):
        rows = [(0.0, 1000.0, 1e-3, 5e-4, 1000.0), (1e-6, 1100.0, 1e-3, 5e-4, 1000.0), (2e-6, 800.0, 1e-3, 5e-4, 1000.0)]
        meet = 1e-6 / (1.0 / 1000.0 - 1.0 / 1100.0)
        self.assertEqual(len(move_jet.merge_colliding(move_jet.with_filled_part(rows), 0.99 * meet)), 3)
        moved, heat = move_jet.move(rows, 1.5 * meet)
        self.assertEqual(len(moved), 2)
        mass = move_jet.mass_of(rows[0])
        self.assertAlmostEqual(moved[0][1], 1050.0, delta=1e-9)
        self.assertAlmostEqual(heat / (mass * 50.0**2), 1.0, delta=1e-9)  # of two halves at +-50 m/s
        self.assertAlmostEqual(moved[0][0], meet / 1000.0 + 0.5 * meet / 1050.0, delta=1e-15)
        self.assertAlmostEqual(move_jet.totals(moved)[1] / move_jet.totals(rows)[1], 1.0, delta=1e-12)

    def test_break_up_times(self):
        self.assertAlmostEqual(move_jet.hirsch(1.5e-3, 120.0), 25e-6, delta=1e-12)
        for radius, rate, expected in ((1e-3, 3e4, 58.2e-6), (1e-3, 6e4, 41.4e-6), (2e-3, 3e4, 82.8e-6), (2e-3, 6e4, 65.4e-6)):
            self.assertAlmostEqual(move_jet.chou_carleone(radius, rate, 200e6, 8930.0), expected, delta=0.06e-6)

    def test_depths_from_a_virtual_origin(self):
        """Copper into rock of 2300 kg/m3, 7000 to 2000 m/s; the three forms meet where they change over."""
        for standoff, times in ((0.1, (0.1925, 0.4331, 0.6459, 1.0805)), (0.05, (0.1652, 0.3230, 0.4423, 0.5402))):
            for break_up, expected in zip((20e-6, 60e-6, 120e-6, math.inf), times):
                depth = move_jet.virtual_origin_depth(standoff, 7000.0, 2000.0, break_up, 8930.0, 2300.0)
                self.assertAlmostEqual(depth, expected, delta=6e-5)
        for break_up in (0.1 / 7000.0, 0.1 / 7000.0 * 3.5 ** (1.0 + 1.0 / math.sqrt(2300.0 / 8930.0))):
            below, above = (
                move_jet.virtual_origin_depth(0.1, 7000.0, 2000.0, break_up * (1.0 + sign * 1e-9), 8930.0, 2300.0) for sign in (-1, 1)
            )
            self.assertAlmostEqual(below / above, 1.0, delta=1e-6)

    def test_refusals(self):
        header = move_jet.HEADER + "\n"
        good = header + "0,1000,1e-3,1e-3,8930\n1e-6,900,1e-3,0.9e-3,8930\n"
        for arguments, text, words in (
            (["--by", "0.1"], "a,b\n", "is not the header of a jet table"),
            (["--by", "0.1"], header + "0,1,1,1\n", "is not five plain numbers"),
            (["--by", "0.1"], header + "0,-1,1,1,1\n", "must be above 0"),
            (["--by", "0.1"], header + "1,1,1,1,1\n0,1,1,1,1\n", "is not after the row before it"),
            (["--by", "0.1"], header + "1,1,1,1,1\n", "needs at least two"),
            (["--by", "0.1"], "# units: mm-us-g\n" + good, "reads SI alone"),
            (["--by", "0"], good, "is not above 0"),
            (["--by", "0.1", "--origin", "-1"], good, "is negative"),
            (["--by", "0.1", "--break-up", "soon"], good, "is none of never"),
            (["--by", "0.1", "--break-up", "90 mm"], good, 'has the unit "mm", which is none of a time'),
            (["--by", "0.1", "--break-up", "nan"], good, "is not a time"),
            (["--by", "0.1", "--break-up", "-1 us"], good, "before the virtual origin"),
            (["--by", "0.1", "--break-up", "hirsch", "--plastic-velocity", "0"], good, "--plastic-velocity must be above 0"),
            (["--by", "0.1", "--break-up", "chou-carleone", "--yield", "0"], good, "--yield must be above 0"),
            (["--by", "0.1", "--target", "2300"], good, "--cut-off must be given"),
            (["--by", "0.1", "--target", "2300", "--cut-off", "500"], good, "--origin above 0"),
            (["--by", "0.1"], header + "0,1000,1e-3,9e-3,8930\n1e-6,1000,1e-3,9e-3,8930\n", "slugs overlap"),
            (["--by", "9"], header + "0,1000,1e-3,1e-3,8930\n1e-6,2000,1e-3,1e-3,8930\n", "all rows merge"),
            (
                ["--by", "5e-4", "--break-up", "0"],
                header + "0,1000,1e-3,9.9e-4,8930\n1e-6,1100,1e-3,1e-3,8930\n2e-6,1100,1e-3,1e-3,8930\n",
                "let it break later",
            ),
        ):
            sentence = refusal(arguments, text)
            self.assertIn(words, sentence)
            self.assertTrue(sentence.startswith("move_jet.py: "), sentence)

    def test_the_generator_audits_every_kind(self):
        """make_jet.py: what it prints is the shipped table, and the three kinds carry the same."""
        printed = {}
        for kind in ("discrete", "thinned", "continuous"):
            done = subprocess.run([sys.executable, JETS / "make_jet.py", kind], capture_output=True, text=True, check=True)
            printed[kind] = done.stdout
        self.assertEqual(printed["discrete"], (JETS / "tungsten_154.csv").read_text(encoding="utf-8"))
        tail = subprocess.run([sys.executable, JETS / "make_jet.py", "--tail"], capture_output=True, text=True, check=True)
        self.assertEqual(tail.stdout, (JETS / "tungsten_320.csv").read_text(encoding="utf-8"))
        rows = {kind: move_jet.read_table(io.StringIO(text), kind) for kind, text in printed.items()}
        for kind in ("thinned", "continuous"):
            for found, expected in zip(move_jet.totals(rows[kind]), move_jet.totals(rows["discrete"])):
                self.assertAlmostEqual(found / expected, 1.0, delta=1e-8)  # nine digits of a table
            self.assertTrue(all(row[5] > 0.999 for row in move_jet.with_filled_part(rows[kind])[1:-1]))
        bad = subprocess.run([sys.executable, JETS / "make_jet.py", "solid"], capture_output=True, text=True)
        self.assertEqual((bad.returncode, "is no kind of a jet" in bad.stderr), (1, True))

    def test_quantities_with_units(self):
        """Words are as in decks: the same table as with plain numbers in SI."""
        plain = ("--by", "0.05", "--origin", "0.12", "--break-up", "90e-6", "--target", "2300", "--cut-off", "2000")
        named = ("--by", "50 mm", "--origin", "12cm", "--break-up", "90 us", "--target", "2.3 g/cm3", "--cut-off", "2 km/s")
        calls = [[sys.executable, JETS / "move_jet.py", JETS / "tungsten_154.csv", *words] for words in (plain, named)]
        first, second = [subprocess.run(call, capture_output=True, text=True, check=True) for call in calls]
        rows = [[line for line in done.stdout.splitlines() if not line.startswith("# Made by")] for done in (first, second)]
        self.assertEqual(rows[0], rows[1])
        self.assertEqual(first.stderr, second.stderr)
        for words in (["--by", "50 kg"], ["--by", "far"], ["--by", "1", "--yield", "3 mm"], ["--by", "1", "--plastic-velocity", "3 s"]):
            done = subprocess.run([sys.executable, JETS / "move_jet.py", JETS / "tungsten_154.csv", *words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn("write for example", done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_units_are_those_of_decks(self):
        """A unit has one factor in all tools."""
        for kind, known in quantity.UNITS.items():
            self.assertGreaterEqual(len(known), 2)
            self.assertEqual(known, {unit: units.UNITS[kind].get(unit) for unit in known})
        self.assertEqual(quantity.value_of("90 us", "time"), 90e-6)
        self.assertEqual(quantity.value_of("7 mm/us", "speed"), 7000.0)

    def test_what_it_prints_is_a_table(self):
        done = subprocess.run(
            [sys.executable, JETS / "move_jet.py", JETS / "tungsten_154.csv", "--by", "0.05"], capture_output=True, text=True, check=True
        )
        rows = move_jet.read_table(io.StringIO(done.stdout), "moved")
        self.assertEqual(len(rows), 154)


if __name__ == "__main__":
    unittest.main()
