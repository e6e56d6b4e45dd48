#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""input_xml/jets/whole_jet.py: what flies ahead of a jet is left out, with its mass written down."""
import contextlib
import io
import tempfile
import unittest

import move_jet
import whole_jet

DENSITY = 8930.0


def row(time_us, radius_mm, density=DENSITY):
    """A slice of a microsecond."""
    velocity = 8000.0 - 200.0 * time_us
    return (1e-6 * time_us, velocity, 1e-3 * radius_mm, velocity * 1e-6, density)


# A stray, a gap, a row of single particles in a wide radius (metal of 0.1 mm), then the jet, with one thin row in its tail.
ROWS = [row(1, 0.2), row(3, 1.0), row(4, 1.0, 0.01 * DENSITY), *[row(t, 1.0, 0.8 * DENSITY) for t in range(5, 14)], row(14, 0.05)]


def answer(rows, *words):
    """(what is printed, why it ended)"""
    out, why = io.StringIO(), ""
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
        table.write(move_jet.HEADER + "\n" + "".join(",".join(map(repr, one)) + "\n" for one in rows))
        table.flush()
        try:
            with contextlib.redirect_stdout(out):
                whole_jet.main([table.name, *words])
        except SystemExit as end:
            why = str(end.code)
    return out.getvalue(), why


class WholeJet(unittest.TestCase):
    def test_metal_of_a_row_that_is_partly_void(self):
        self.assertAlmostEqual(whole_jet.metal_radius(ROWS[2], DENSITY), 1e-4, delta=1e-12)

    def test_what_is_thin_or_before_a_gap_is_left_out_at_the_tip_alone(self):
        self.assertEqual(whole_jet.first_of_whole(ROWS, 0.15e-3), 3)
        self.assertEqual(whole_jet.first_of_whole(ROWS, 0.05e-3), 1)  # the gap
        self.assertEqual(whole_jet.first_of_whole(ROWS[3:], 0.15e-3), 0)

    def test_the_rest_is_the_table_and_what_is_gone_is_written_down(self):
        text, why = answer(ROWS, "--thinnest", "0.15e-3")
        self.assertEqual(why, "")
        rows = move_jet.read_table(text.splitlines(), "answer")
        self.assertEqual(len(rows), len(ROWS) - 3)
        for found, given in zip(rows, ROWS[3:]):
            for value, expected in zip(found, given):
                self.assertAlmostEqual(value / expected, 1.0, delta=1e-8)
        gone, whole = (move_jet.totals(part)[0] for part in (ROWS[:3], ROWS))
        self.assertIn(f"# mass {gone:.6g} of {whole:.6g} kg left out", text)

    def test_refusals(self):
        self.assertIn("is not above 0", answer(ROWS, "--thinnest", "0")[1])
        self.assertIn("through half of its rows", answer(ROWS, "--thinnest", "2e-3")[1])
        self.assertIn("needs at least two", answer(ROWS[:1], "--thinnest", "1e-4")[1])


if __name__ == "__main__":
    unittest.main()
