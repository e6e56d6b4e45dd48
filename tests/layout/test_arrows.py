#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The checks of arrows between rooms find what they are for: a call that the linker ties to a room on the right, a function that one room
declares and another defines, scripts that import each other.

    test_arrows.py COMPILER [NM]
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import check_link_arrows
import import_cycles

COMPILER, NM = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "nm"
DECLARED = "#pragma once\nnamespace barreno {\nint shape_count();\n}\n"
DEFINED = '#include "{}/shape_count.hpp"\nint barreno::shape_count() {{ return 6; }}\n'
CALLED = '#include "{}/shape_count.hpp"\nnamespace barreno {{\nint twice() {{ return 2 * shape_count(); }}\n}}\n'
OWN = "#pragma once\nnamespace barreno {\nint twice();\n}\n"


def write(folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def problems_of(files):
    """What the check says of these sources, compiled as the program is."""
    with tempfile.TemporaryDirectory() as scratch:
        src, objects = pathlib.Path(scratch) / "src", pathlib.Path(scratch) / "objects"
        write(src, files)
        members = set()
        for name in files:
            if name.endswith(".cpp"):
                made = objects / f"{name}.o"
                made.parent.mkdir(parents=True, exist_ok=True)
                subprocess.run([COMPILER, "-I", src, "-c", src / name, "-o", made], check=True)
                members.add(made.name)
        return check_link_arrows.problems(objects, members, src, NM)


class LinkArrows(unittest.TestCase):
    def test_a_room_that_needs_one_to_its_right(self):
        found = problems_of({"deck/shape_count.hpp": DECLARED, "deck/section.hpp": OWN, "deck/section.cpp": CALLED.format("deck"),
                             "shape/facts.cpp": DEFINED.format("deck")})  # fmt: skip
        self.assertIn("deck needs barreno::shape_count(), which shape defines, to its right", found)

    def test_a_declaration_whose_definition_is_elsewhere(self):
        found = problems_of({"deck/shape_count.hpp": DECLARED, "shape/facts.cpp": DEFINED.format("deck")})
        self.assertEqual(found, ["shape_count is declared in a header of deck and defined in shape"])

    def test_a_room_of_the_step_that_needs_one_to_its_right(self):
        found = problems_of({"step/loads/shape_count.hpp": DECLARED, "step/loads/count.cpp": DEFINED.format("step/loads"),
                             "step/order/section.hpp": OWN, "step/order/section.cpp": CALLED.format("step/loads")})  # fmt: skip
        self.assertEqual(found, ["step/order needs barreno::shape_count(), which step/loads defines, to its right"])

    def test_arrows_to_the_left_are_sound(self):
        found = problems_of({"deck/shape_count.hpp": DECLARED, "deck/count.cpp": DEFINED.format("deck"), "shape/section.hpp": OWN,
                             "shape/section.cpp": CALLED.format("deck")})  # fmt: skip
        self.assertEqual(found, [])

    def test_files_of_an_earlier_build_do_not_count(self):
        with tempfile.TemporaryDirectory() as scratch:
            objects, src = pathlib.Path(scratch) / "objects", pathlib.Path(scratch) / "src"
            write(objects, {"deck/gone.cpp.o": "", "Unity/unity_folder_gone_cxx.cxx.o": ""})
            src.mkdir()
            self.assertEqual(check_link_arrows.objects_in(objects, src, {"gone.cpp.o"}), {})

    def test_folders_of_objects_are_rooms(self):
        self.assertEqual([check_link_arrows.place_of(check_link_arrows.folder_of(name))[1] for name in (
            "Unity/unity_folder_pore_flow_cxx.cxx.o", "Unity/unity_folder_deck_files_cxx.cxx.o", "Unity/unity_folder__cxx.cxx.o",
            "run.cpp.o",
            "step/order/sort_by_cell.cpp.o", "step/advance.cpp.o")], ["pore_flow", "deck", ".", ".", "step/order", "step"])  # fmt: skip


class ImportCycles(unittest.TestCase):
    def circles_of(self, files):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            write(folder, files)
            return [[path.relative_to(folder).as_posix() for path in circle] for circle in import_cycles.circles(folder)]

    def test_scripts_that_import_each_other(self):
        files = {"pages.py": "import extremes\n", "extremes.py": "def main():\n    from pages import write_pages\n",
            "runs.py": "import pages\n"}
        self.assertEqual(self.circles_of(files), [["extremes.py", "pages.py"]])

    def test_three_in_a_circle_through_a_folder(self):
        files = {"pages.py": "import parts\n", "tools/parts.py": "from rows import point\n", "rows/point.py": "import pages\n"}
        self.assertEqual(self.circles_of(files), [["pages.py", "rows/point.py", "tools/parts.py"]])

    def test_a_name_of_python_itself_is_no_script(self):
        self.assertEqual(self.circles_of({"rows/time.py": "import decks\n", "decks.py": "import time\n"}), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
