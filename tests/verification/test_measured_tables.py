#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The measured numbers of the program are written with the digits of their results, and a measurement changes its own rows alone."""
import unittest

from tools import depth_shots_table, measured_tables
import predictions
from tools.uniform_cells import read


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [line.split(",") for line in lines[1:]]


class MeasuredTables(unittest.TestCase):
    def test_a_point_moves_and_no_digit_changes(self):
        for text, digits, moved in (("13.87", -3, "0.01387"), ("5", -6, "0.000005"), ("-29", -2, "-0.29"), ("0", -2, "0"),
                ("181.0", -3, "0.181")):
            self.assertEqual(measured_tables.moved(text, digits), moved)

    def test_every_depth_is_that_of_its_run(self):
        rows = rows_of(measured_tables.depths_of_cells())
        runs = [row for row in rows if row[0] != "estimate"]
        results = read("perforation_cells.csv")
        self.assertEqual(len(runs), len(results))
        for (_, cell, time, depth), row in zip(runs, results):
            for found, text, unit in ((cell, row["cells_mm"], 1e-3), (time, row["time_us"], 1e-6), (depth, row["depth_mm"], 1e-3)):
                self.assertAlmostEqual(float(found), float(text) * unit, delta=1e-15)

    def test_the_last_line_counts_the_rows(self):
        for text in (*measured_tables.files().values(), predictions.COSTS.read_text()):
            self.assertEqual(text.splitlines()[-1], f"# end of {len(rows_of(text))} rows")

    def test_a_measurement_changes_its_own_costs(self):
        text = predictions.COSTS.read_text()
        self.assertEqual(predictions.with_costs(text, {}), text)
        found = {"perforation_quick, plastic, to 4 us": {"update_stress Arenisca general": (1000.0, 6000.04)}}
        changed = set(predictions.with_costs(text, found).splitlines()) - set(text.splitlines())
        self.assertEqual(changed, {f"update_stress Arenisca general, {law},1000.0,6000.0,1" for law in ("plastic", "arenisca3")})

    def test_every_cost_with_a_run_is_measured(self):
        rows = {line.rsplit(",", 3)[0] for line in predictions.COSTS.read_text().splitlines() if not line.startswith("#")}
        self.assertLessEqual({*predictions.RUN_OF_COST, *predictions.SAME_COST, *predictions.SAME_COST.values()}, rows)
        self.assertLessEqual(set(predictions.RUN_OF_COST.values()), set(predictions.FLOWING))


class DividedErrors(unittest.TestCase):
    """The intervals are made from some shots; the others try them."""

    def test_an_interval_holds_what_lies_in_it(self):
        error = (-0.05, -0.1, 0.02)
        for truth, held in ((100.0, True), (111.0, True), (98.1, True), (112.0, False), (97.0, False)):
            self.assertEqual(depth_shots_table.covered(100.0, error, truth), held, truth)

    def test_every_interval_of_the_wide_hole_holds_the_smaller_cells(self):
        trials = [one for one in depth_shots_table.trials() if one[3] == "probed depth"]
        self.assertGreaterEqual(len(trials), 2)
        for shot, cells, finest, _, depth, interval, truth, held in trials:
            self.assertTrue(held, f"{shot}, {cells} against {finest} cells per radius: {depth} has {interval}, which lacks {truth}")

    def test_the_table_of_the_program_is_that_of_the_results(self):
        rows = rows_of(measured_tables.divided_errors())
        self.assertEqual([row[0] for row in rows[:3]], ["depth", "depth at rest", "probed depth"])
        for what, cells, value, low, high in rows:
            self.assertTrue(float(low) < float(value) < float(high), (what, cells))


if __name__ == "__main__":
    unittest.main()
