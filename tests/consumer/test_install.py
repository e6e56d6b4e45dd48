#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Installs the material library to a new place, moves it, and builds and runs a project outside on it.

    test_install.py CMAKE BUILD_FOLDER_OF_MATERIALS
"""

import os
import pathlib
import subprocess
import sys
import tempfile

NO_CARD = (
    '"berea_sandston" names no card (there is none of that name in the working directory, in BARRENO_MATERIALS or among those '
    "that Barreno comes with); did you mean 'berea_sandstone'?\n"
)
HERE = pathlib.Path(__file__).resolve().parent


def run(*command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=500, **more)
    assert result.returncode == 0, f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}"
    return result.stdout + result.stderr


def numbers(line):
    model, *values = line.split()
    return model, [float(v) for v in values]


def main():
    cmake, build = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        run(cmake, "--install", build, "--prefix", scratch / "first")
        prefix = (scratch / "first").rename(scratch / "moved")
        for file in ("include/barreno_material.h", "share/barreno/cards/berea_sandstone.xml", "share/barreno/hosts/abaqus_entry.c"):
            assert (prefix / file).is_file(), f"{file} is not installed"
        assert list(prefix.glob("lib*/**/libBARRENO.so")), "libBARRENO.so is not installed"

        outside = scratch / "build"
        said = run(cmake, "-S", HERE, "-B", outside, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
        assert f"cards in {prefix / 'share/barreno/cards'}" in said, said
        run(cmake, "--build", outside)

        card = prefix / "share/barreno/cards/berea_sandstone.xml"
        in_c = numbers(run(outside / "consumer_c"))
        in_cpp = numbers(run(outside / "consumer_cpp"))
        print("C  ", in_c)
        print("C++", in_cpp)
        assert in_c[0] == in_cpp[0] == "Arenisca" and in_c[1][0] < -1e7
        # Two compilations of one source, for this processor and for any.
        assert all(abs(a - b) <= 1e-9 * abs(a) for a, b in zip(in_c[1], in_cpp[1]))

        for program in ("consumer_c", "consumer_cpp"):
            assert numbers(run(outside / program, card)) == numbers(run(outside / program)), f"{program}: path and name differ"
            refused = subprocess.run([outside / program, "berea_sandston"], capture_output=True, text=True, timeout=60)
            assert refused.returncode == 1 and refused.stderr == NO_CARD, refused.stderr

        # The library that hosts load finds the cards that it was installed and moved with.
        library = next(prefix.glob("lib*/**/libBARRENO.so"))
        program = (
            "import ctypes, sys; l = ctypes.CDLL(sys.argv[1]); l.barreno_material_open.restype = ctypes.c_void_p;"
            "l.barreno_material_file.restype = ctypes.c_char_p; l.barreno_material_file.argtypes = [ctypes.c_void_p];"
            "print(l.barreno_material_file(l.barreno_material_open(b'COPPER')).decode())"
        )
        environment = {k: v for k, v in os.environ.items() if k != "BARRENO_MATERIALS"}
        found = run(sys.executable, "-c", program, library, env=environment).strip()
        assert pathlib.Path(found).resolve() == (prefix / "share/barreno/cards/copper.xml").resolve(), found


if __name__ == "__main__":
    main()
