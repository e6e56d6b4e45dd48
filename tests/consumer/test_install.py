#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Installs the material library to a new place, moves it, and builds and runs a project outside on it.

    test_install.py CMAKE BUILD_FOLDER_OF_MATERIALS
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

NO_CARD = (
    '"berea_sandston" names no card (there is none of that name in the working directory, in BARRENO_MATERIALS or among those '
    "that Barreno comes with); did you mean 'berea_sandstone'?\n"
)
HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = ("CMakeLists.txt", "consumer.c", "consumer.cpp", "build_ccx.sh", "getfem_box.py", "getfem_plug.py")


def run(*command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=500, **more)
    assert result.returncode == 0, f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}"
    return result.stdout + result.stderr


def numbers(line):
    model, *values = line.split()
    return model, [float(v) for v in values]


PYTHON_PROGRAM = """
import numpy
from barreno.materials import Material
with Material("berea_sandstone") as rock:
    stress, state = rock.virgin(2)
    answer = rock.update(numpy.array([[-1e-2, 2e-3, 2e-3, 0, 0, 0], [2e-3, 2e-3, -1e-2, 0, 0, 0]]), stress, state)
    assert not answer.status.any() and answer.stress[0, 0] < -5e7, answer
    assert numpy.isclose(answer.stress[0, 0], answer.stress[1, 2], rtol=1e-12), answer
    assert answer.state[0, rock.state_index("equivalent_plastic_strain")] > 0.0, answer
    assert numpy.isclose(answer.tangent[0, 0, 0], answer.tangent[1, 2, 2], rtol=1e-6), answer
    print(rock.file)
try:
    Material("berea_sandston")
except ValueError as refusal:
    assert "did you mean 'berea_sandstone'?" in str(refusal), refusal
else:
    raise AssertionError("a card that is none was opened")
"""


def check_pkg_config(prefix, folder, expected):
    """A host without CMake: the compiler's options from pkg-config."""
    program, tool = folder / "plain_c", shutil.which("pkg-config")
    if tool is None:
        print("pkg-config is not here: its file was not tried")
        return
    where = {**os.environ, "PKG_CONFIG_PATH": str(next(prefix.glob("lib*/**/pkgconfig")))}
    options = run(tool, "--cflags", "--libs", "barreno", env=where).split()
    # The line of docs/finite_elements.md, on the source that the prefix has; the program starts without LD_LIBRARY_PATH.
    run("cc", prefix / "share/barreno/examples/consumer.c", "-o", program, *options, "-lm")
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    assert numbers(run(program, env=environment)) == expected
    needed = run("ldd", program)
    assert "libBARRENO.so.1 " in needed, needed


def main():
    cmake, build = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        run(cmake, "--install", build, "--prefix", scratch / "first")
        prefix = (scratch / "first").rename(scratch / "moved")
        for file in ("include/barreno_material.h", "share/barreno/cards/berea_sandstone.xml", "share/barreno/hosts/abaqus_entry.c"):
            assert (prefix / file).is_file(), f"{file} is not installed"
        for file in EXAMPLES:
            assert (prefix / "share/barreno/examples" / file).is_file(), f"{file} is not installed"
        assert os.access(prefix / "share/barreno/examples/build_ccx.sh", os.X_OK)
        for library in ("libBARRENO.so", "libBarrenoMGIS.so"):
            assert list(prefix.glob(f"lib*/**/{library}")), f"{library} is not installed"

        outside = scratch / "build"
        said = run(cmake, "-S", prefix / "share/barreno/examples", "-B", outside, f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_BUILD_TYPE=Debug")  # quickly compiled
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

        check_pkg_config(prefix, scratch, in_c)
        python = {k: v for k, v in os.environ.items() if k not in ("BARRENO_LIBRARY", "BARRENO_MATERIALS")}
        python["PYTHONPATH"] = str(prefix / "share/barreno/python")
        found = run(sys.executable, "-c", PYTHON_PROGRAM, env=python).strip()
        assert pathlib.Path(found).resolve() == card.resolve(), found
        # The fit comes with the module, and finds library and cards of the installation.
        command = [sys.executable, "-m", "barreno.fit", scratch / "nowhere.csv", "--out", scratch / "card.xml"]
        refused = subprocess.run(command, capture_output=True, text=True, timeout=60, env=python)
        assert refused.returncode == 2 and "nowhere.csv does not exist" in refused.stderr, refused.stderr

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
