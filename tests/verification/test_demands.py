#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Requirements fail when they must: a value that is not finite, beyond the bound, beyond the largest value of an open
requirement, and an open requirement that holds."""
import math
import pathlib
import tempfile
import unittest
import unittest.mock

from tools.case import Result
from tools.demands import FAILS, HOLDS, OPEN, Open, judge, judge_all, open_demands, read_open
from tools.extreme import RED, Table
import verify

VERIFICATION = pathlib.Path(__file__).resolve().parents[2] / "verification"
KNOWN = Open("a reason", 0.05)
LEAST = Open("a reason", 1.2)
NO_NUMBERS = (math.nan, math.inf, -math.inf)


class Outcome:
    finished, run, code, sentence = True, None, 0, ""


def read(text):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        return read_open(file.name)


class Judgement(unittest.TestCase):
    def test_closed(self):
        self.assertEqual(judge(0.01, 0.02, False), (HOLDS, ""))
        self.assertEqual(judge(1.9, 1.8, True), (HOLDS, ""))
        self.assertEqual(judge(0.03, 0.02, False)[0], FAILS)
        self.assertEqual(judge(1.7, 1.8, True)[0], FAILS)

    def test_open(self):
        self.assertEqual(judge(0.04, 0.02, False, KNOWN), (OPEN, "a reason"))
        self.assertEqual(judge(1.3, 1.8, True, LEAST), (OPEN, "a reason"))

    def test_open_beyond_its_worst_value(self):
        self.assertEqual(judge(0.051, 0.02, False, KNOWN)[0], FAILS)
        self.assertEqual(judge(1.19, 1.8, True, LEAST)[0], FAILS)

    def test_open_that_holds(self):
        self.assertEqual(judge(0.02, 0.02, False, KNOWN), (FAILS, "now holds: close it"))
        self.assertEqual(judge(1.8, 1.8, True, LEAST), (FAILS, "now holds: close it"))

    def test_no_number(self):
        for value in NO_NUMBERS:
            for known in (None, KNOWN):
                for at_least in (False, True):
                    self.assertEqual(judge(value, 0.02, at_least, known), (FAILS, "not a finite number"), (value, known, at_least))


class Declaration(unittest.TestCase):
    def test_an_open_demand_has_a_worst_value_and_a_reason(self):
        with self.assertRaises(TypeError):
            Open("a reason")
        for worst in (*NO_NUMBERS, None, "0.05", True):
            with self.assertRaises(ValueError):
                Open("a reason", worst)
        with self.assertRaises(ValueError):
            Open(" ", 0.05)

    def test_the_file_must_be_complete(self):
        for text in ('[[case]]\nreason = "r"\n', '[[case]]\n[case.full]\n"a" = 1.0\n', '[[case]]\nreason = "r"\n[case.full]\n"a" = nan\n',
                     '[[case]]\nreason = "r"\n[case.slow]\n"a" = 1.0\n',
                     '[[case]]\nreason = "r"\n[case.full]\n"a" = 1.0\n[[case]]\nreason = "s"\n[case.full]\n"a" = 2.0\n'):  # fmt: skip
            with self.assertRaises(ValueError, msg=text):
                read(text)

    def test_each_form_has_its_own(self):
        known = read('[[case]]\nreason = "r"\n[case.cheap]\n"a" = 1.0\n[case.full]\n"a" = 2.0\n"b" = 3.0\n')
        self.assertEqual(known["case", "cheap"], {"a": Open("r", 1.0)})
        self.assertEqual(known["case", "full"], {"a": Open("r", 2.0), "b": Open("r", 3.0)})

    def test_what_is_open_must_be_measured_and_names_must_differ(self):
        result = Result("", "", "", [], [])
        result.demand("a", 0.04, 0.02)
        result.demand("c", 0.01, 0.02)
        result.demand("c", 0.01, 0.02)
        _, wrong = judge_all(result.checks, {"a": KNOWN, "b": KNOWN})
        self.assertEqual(wrong, ["'b' is declared open but was not measured", "'c' is measured twice"])

    def test_the_list_of_the_repository(self):
        for (case, form), known in read_open().items():
            self.assertEqual(open_demands(case, form == "full"), known)
            group, _, name = case.rpartition("/")
            file = VERIFICATION / {"": "cases", "extremes": "extreme_rows", "validation": "experiments"}[group] / f"{name}.py"
            self.assertTrue(case == "trade" or file.exists(), case)


class Verdict(unittest.TestCase):
    def failures(self, value):
        result = Result("", "", "", [], [])
        result.demand("a", value, 0.02)
        with unittest.mock.patch.object(verify, "open_demands", lambda name, full: {"a": KNOWN}):
            return verify.failures("case", result.checks, True)

    def test_what_ends_a_case_with_1(self):
        self.assertEqual(self.failures(0.04), [])
        for value in (*NO_NUMBERS, 0.06, 0.01):
            self.assertEqual(len(self.failures(value)), 1, value)
        self.assertEqual(verify.failures("bar_wave", [], True), ["nothing was demanded"])


class Extremes(unittest.TestCase):
    def row(self, value, known=None):
        table = Table()
        table.known = known or {}
        table.within("E", "a set-up", "error", value, 0.02)
        return table

    def test_rows(self):
        open_row = {"E: a set-up: error": KNOWN}
        self.assertEqual(self.row(0.01).failures(), [])
        self.assertEqual(len(self.row(0.03).failures()), 1)
        self.assertEqual(self.row(0.04, open_row).failures(), [])
        self.assertEqual(self.row(0.04, open_row).rows[0].verdict, RED)
        self.assertEqual(len(self.row(0.06, open_row).failures()), 1)
        self.assertIn("now holds: close it", self.row(0.01, open_row).failures()[0])
        for value in NO_NUMBERS:
            self.assertEqual(len(self.row(value).failures()), 1)
            self.assertEqual(len(self.row(value, open_row).failures()), 1)

    def test_what_is_open_must_be_measured(self):
        table = self.row(0.01)
        table.known = {"E: another set-up: error": KNOWN}
        self.assertEqual(len(table.unmeasured(0)), 1)

    def test_a_row_without_a_figure_is_never_open(self):
        table = Table()
        table.known = {"E: a set-up: exit 3, a sentence with 'at t'": KNOWN}
        table.stops("E", "a set-up", Outcome(), 3, "at t")
        self.assertEqual(len(table.failures()), 1)


if __name__ == "__main__":
    unittest.main()
