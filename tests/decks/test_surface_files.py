#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run has its own copy of the STL files of its deck: test_surface_files.py BARRENO. It is resumed, and run again from its
deck.xml, whatever became of the originals; another file under the copy's name is refused."""
import pathlib
import shutil
import sys
import tempfile

from test_rigid_shapes import deck, samples, write_pyramid

from tools.resumed import at_previous, different_fields, must_work, program


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        original, path, plain = folder / "pyramid.stl", folder / "deck.xml", folder / "plain"
        write_pyramid(original)
        parameters, parts = samples("3D")["STL"]
        path.write_text(deck("3D", "STL", parameters, parts, "block"))
        must_work(program(barreno, 1, "run", path, "--out", plain, "--set", "Output/Checkpoint Steps=6"))
        copies = list(plain.glob("surface_*.stl"))
        assert len(copies) == 1 and copies[0].read_bytes() == original.read_bytes(), copies
        original.unlink()

        resumed = at_previous(pathlib.Path(shutil.copytree(plain, folder / "resumed")))
        must_work(program(barreno, 2, "resume", resumed))
        assert not different_fields(plain, resumed), different_fields(plain, resumed)

        again = folder / "again"
        must_work(program(barreno, 1, "run", plain / "deck.xml", "--out", again))
        assert not different_fields(plain, again) and (again / copies[0].name).exists()
        must_work(program(barreno, 1, "run", again / "deck.xml", "--out", again, "--overwrite"))  # over itself
        assert not different_fields(plain, again)

        for text, code, said in ((copies[0].read_text().replace("1.5", "1.6"), 1, "has the digest"), (None, 2, "names no file")):
            changed = at_previous(pathlib.Path(shutil.copytree(plain, folder / f"changed{code}")))
            before = (changed / "history.csv").read_bytes()
            (changed / copies[0].name).unlink()
            if text is not None:
                (changed / copies[0].name).write_text(text)
            result = program(barreno, 1, "resume", changed)
            assert (
                result.returncode == code and said in result.stderr and result.stderr.count("\n") == 1
            ), f"exit {result.returncode}: {result.stderr}"
            assert (changed / "history.csv").read_bytes() == before
    print("surfaces stay with their run")


if __name__ == "__main__":
    main()
