#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The checks of pages find what they are for: a figure that was changed by hand, a mark that nobody writes, a picture of other figures,
a link that leads nowhere, a figure that no results file gives."""
import pathlib
import unittest
import unittest.mock

import check_columns
import check_links
import pages
from tools import depth_aims
from tools import uniform_cells
from tools.wrap_text import wrapped
from tools.case_pictures import curves_of, digest, stored_digest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Pages(unittest.TestCase):
    def test_a_changed_figure_is_put_right(self):
        text = (ROOT / "docs" / "figures.md").read_text()
        part = text.split("<!-- figures -->")[1].split("<!-- end of figures -->")[0]
        at = next(i for i in range(text.index(part), len(text)) if text[i].isdigit())
        changed = text[:at] + str((int(text[at]) + 1) % 10) + text[at + 1 :]
        self.assertEqual(pages.with_parts(text), text)
        self.assertEqual(pages.with_parts(changed), text)

    def test_a_mark_needs_a_writer(self):
        with self.assertRaises(SystemExit):
            pages.with_parts("<!-- nobody -->\n\n1 s\n\n<!-- end of nobody -->\n")

    def test_a_picture_is_of_its_figures(self):
        picture = {"x": "cells", "y": ["error"]}
        data = {"columns": ["cells", "error"], "rows": [[10, 0.1], [20, 0.05]]}
        other = {**data, "rows": [[10, 0.1], [20, 0.04]]}
        self.assertNotEqual(digest(picture, curves_of(picture, data)), digest(picture, curves_of(picture, other)))
        self.assertIsNone(stored_digest(ROOT / "docs" / "pictures" / "arenisca_cost.png"))
        self.assertIsNotNone(stored_digest(ROOT / "docs" / "pictures" / "case_bar_wave.png"))

    def test_a_picture_of_curves_is_of_their_points(self):
        picture = {"curves": True, "x": "time", "y": ["depth"]}
        data = {"columns": [], "rows": [], "curves": {"a rod": [[0.0, 0.0], [1.0, 2.0]]}}
        other = {**data, "curves": {"a rod": [[0.0, 0.0], [1.0, 2.5]]}}
        self.assertEqual(curves_of(picture, data), {"a rod": [(0.0, 0.0), (1.0, 2.0)]})
        self.assertNotEqual(digest(picture, curves_of(picture, data)), digest(picture, curves_of(picture, other)))

    def test_a_figure_without_a_file_is_found(self):
        for words in ("It takes 42.4 s instead of 58.4 s.", "12 % of the energy", "132 MB in all", "120 ns per particle-step"):
            self.assertTrue(pages.loose_figures("docs/performance.md", words), words)
        for words in ("`--set \"Time/End Time=1 us\"`", "three ranks", "    run --until \"200 us\"",
                "<!-- a -->\n\n1 s\n\n<!-- end of a -->\n"):
            self.assertFalse(pages.loose_figures("docs/performance.md", words), words)

    def test_a_page_of_what_fails_is_found(self):
        with unittest.mock.patch.object(pages, "open_demands", lambda name, full: {}):
            self.assertTrue(any("does not hold" in line for line in pages.failing()))


class Columns(unittest.TestCase):
    def test_paragraphs_and_list_items_are_wrapped_and_nothing_else(self):
        words = "word " * 40
        for text, first, rest in (("", "word", "word"), ("- ", "- word", "  word"), ("1. a\n\n    ", "    word", "    word")):
            lines = wrapped(text + words).split("\n")[-2:]
            self.assertTrue(lines[0].startswith(first) and lines[1].startswith(rest), text)
            self.assertLessEqual(max(map(len, lines)), 140)
            self.assertFalse(check_columns.long_on_page("\n".join(lines)))
        for text in (f"| {words} |", f"# {words}", f"    {words}", f"```\n{words}\n```", f"![{words}](p.png)", f"- a\n\n      {words}",
                f"`{words}`"):
            self.assertEqual(wrapped(text), text)
            self.assertFalse(check_columns.long_on_page(text), text)

    def test_no_line_begins_with_what_would_be_a_list(self):
        for mark in ("-", "2."):
            lines = wrapped("word " * 27 + f"word {mark} " + "word " * 5).split("\n")
            self.assertTrue(lines[1].startswith(f"word {mark}"), lines)

    def test_long_lines_are_found(self):
        words = "word " * 40
        self.assertEqual(check_columns.long_on_page(f"a\n{words}"), [2])
        self.assertEqual(check_columns.long_in_python(f'def f():\n    """{words}"""\n    # {words}\n    x = "{words}"\n'), [2, 3, 4])
        self.assertEqual(check_columns.long_lines(f"// {words}"), [1])


class Intervals(unittest.TestCase):
    def test_depths_lie_in_the_intervals_of_larger_cells(self):
        found = uniform_cells.depths()
        for (cells, time), depth in found.items():
            low, high = uniform_cells.interval(depth, uniform_cells.TIP / cells)
            reference = found.get((uniform_cells.REFERENCE, time))
            if reference and cells >= uniform_cells.REFERENCE:
                self.assertTrue(low * (1.0 - 1e-12) <= reference <= high * (1.0 + 1e-12), (cells, time))

    def test_errors_are_those_of_the_program_between_measured_sizes_too(self):
        for cells, low, high in ((1.0, -0.15, -0.03), (2.0, -0.04, 0.02), (2.0**0.5, -0.095, -0.005)):
            for found, expected in zip(uniform_cells.range_of_errors(cells), (low, high)):
                self.assertAlmostEqual(found, expected, places=12)


class Aims(unittest.TestCase):
    def test_the_requirement_nearest_to_its_limit_stands_for_an_aim(self):
        near, far = ({"value": value, "limit": limit, "at_least": at_least}
            for value, limit, at_least in ((0.9, 1.0, False), (4.0, 1.0, True)))
        self.assertIs(depth_aims.nearest([(far, "", ""), (near, "", "")])[0], near)

    def test_every_aim_is_a_requirement_of_its_case(self):
        for aim, which in depth_aims.CASES.items():
            self.assertTrue(depth_aims.counted(*which), aim)


class Links(unittest.TestCase):
    def problems(self, text):
        return check_links.problems_of(ROOT / "docs" / "page.md", text, set())

    def test_links(self):
        self.assertFalse(self.problems("[a](method.md), [b](verification.md#open-requirements), [c](https://example.org), `src/main.cpp`"))
        for text in ("[a](nothing.md)", "[b](verification.md#nothing)", "`src/nothing.cpp`", "![p](pictures/nothing.png)"):
            self.assertEqual(len(self.problems(text)), 1, text)

    def test_glossary(self):
        glossary = "| term | in the code |\n|---|---|\n| cell | `grid/cell.hpp`, `Grid::cell_size` |\n| tile | `%s` |\n\nand `nothing`"
        sources = "src/grid/cell.hpp\ndouble cell_size = tile_size;"
        self.assertEqual(check_links.missing_names(glossary % "tile_*", sources), [])
        self.assertEqual(len(check_links.missing_names(glossary % "tile_count", sources)), 1)


if __name__ == "__main__":
    unittest.main()
