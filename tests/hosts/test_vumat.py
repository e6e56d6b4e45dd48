#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""VUMAT and UMAT called from Fortran, by the names of materials/hosts/abaqus_entry.c, against the C interface.

    test_vumat.py LIBRARY
"""

import ctypes
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy

import barreno_library
import calculix

HERE = pathlib.Path(__file__).resolve().parent
ENTRY = HERE.parents[1] / "materials" / "hosts" / "abaqus_entry.c"
STEPS = 20
ORDER = [0, 1, 2, 3, 5, 4]  # VUMAT's 11 22 33 12 23 31 among 11 22 33 12 13 23
SAME = 1e-11  # the sines of two libraries


def increments(points, step):
    """As in vumat_driver.f90, in VUMAT's order."""
    strain = numpy.array(
        [[4e-4 * math.sin(1.3 * k + 0.7 * c + 0.5 * step) for c in range(1, 7)] for k in range(1, points + 1)]
    )
    strain[:, :3] -= 3e-4
    return strain[:, ORDER]


def drive(material, points):
    stress, state = material.virgin(points)
    for step in range(1, STEPS + 1):
        stress, state, tangent, status = material.update(increments(points, step), stress, state, dt=1e-6)
        assert not status.any()
    return stress, state, tangent


def close(a, b):
    a, b = numpy.asarray(a), numpy.asarray(b)
    return a.shape == b.shape and abs(a - b).max() <= SAME * abs(b).max()


def build(folder, library):
    if shutil.which("gfortran") is None:
        calculix.skip("no gfortran (Debian package gfortran).")
    program = pathlib.Path(folder) / "vumat_driver"
    command = ["gfortran", "-O1", "-J", folder, HERE / "vumat_driver.f90", ENTRY, library, "-o", program]
    command += [f"-Wl,-rpath,{pathlib.Path(library).parent}"]
    subprocess.run(command, check=True, timeout=120)
    return program


def check_block(program, material, card, points):
    name = card.upper()
    result = subprocess.run([program, name, str(points), str(material.state_count)], capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stdout + result.stderr
    assert result.stdout.count(f"material {name} is") == 1, result.stdout
    rows = {}
    for line in result.stdout.splitlines():
        word, *values = line.split()
        if word != "barreno":
            rows.setdefault(word, []).append([float(v) for v in values])
    stress, state, tangent = drive(material, points)
    own = numpy.hstack([stress[:, ORDER], state])
    printed = numpy.array(rows["point"])
    assert printed.shape == (points, 6 + material.state_count + 2)
    for column in range(own.shape[1]):
        assert close(printed[:, column], own[:, column]) or abs(own[:, column]).max() < 1e-3, column
    internal, plastic = printed[:, -2], printed[:, -1]
    assert (internal > 0).all() and (plastic >= 0).all() and plastic.max() > 0

    # The data check: elastic, and the points stay virgin.
    _, _, elastic, _ = material.update(numpy.zeros((1, 6)), *material.virgin(1), want=barreno_library.ELASTIC)
    gamma = increments(1, 0)[0] * [1, 1, 1, 2, 2, 2]
    assert close(numpy.array(rows["check"][0]), (elastic[0] @ gamma)[ORDER])
    assert rows["virgin"][0] == [0.0]

    # UMAT on point 1.
    umat = numpy.array(rows["umat"][0])
    assert close(umat[:6], stress[0, ORDER]) and close(umat[6:-2], state[0])
    assert close(numpy.array(rows["tangent"][0]).reshape(6, 6).T, tangent[0])
    density = material.library.barreno_material_density(material.handle)
    assert close(umat[-2:] / density, [internal[0] - plastic[0], plastic[0]])
    assert rows["pnewdt"][0] == [1.0] and rows["cut"][0] == [0.25]
    assert rows["kept"][0] == rows["umat"][0]
    print(f"{card}: VUMAT with {points} points and UMAT are the library; stress_11 of point 1 is {stress[0, 0]:.7e} Pa")


def check_null_pointers(path):
    """What an unfinished host may leave out: all that is not needed."""
    os.environ["BARRENO_CARD"] = "berea_sandstone"  # such a host gives no name either
    library = barreno_library.load(path)
    material = barreno_library.Material("berea_sandstone", library)
    integer = lambda v: ctypes.byref(ctypes.c_int(v))
    real = lambda v: ctypes.byref(ctypes.c_double(v))
    strain = numpy.asfortranarray(increments(2, 1)[:, ORDER])
    old, new = numpy.zeros((2, 6), order="F"), numpy.full((2, 6), numpy.nan, order="F")
    state, new_state = (numpy.zeros((2, material.state_count), order="F") for _ in range(2))
    pointer = lambda a: a.ctypes.data_as(ctypes.c_void_p)
    arguments = [integer(2), integer(3), integer(3), integer(material.state_count), None, None, None, None, None]
    arguments += [real(1e-6), None, None, None, None, None, pointer(strain), None, None, None, None, None]
    arguments += [pointer(old), pointer(state), None, None, None, None, None, None, pointer(new), pointer(new_state)]
    arguments += [None, None]
    library.VUMAT(*arguments)
    stress, own_state, _, _ = material.update(increments(2, 1), *material.virgin(2), dt=1e-6)
    assert numpy.array_equal(new[:, ORDER], stress) and numpy.array_equal(new_state, own_state)
    print("VUMAT with null pointers: the same bits")


def main():
    path = sys.argv[1]
    library = barreno_library.load(path)
    with tempfile.TemporaryDirectory() as folder:
        program = build(folder, path)
        for card in ("berea_sandstone", "berea_sandstone_heat", "seeberger_sandstone_heat", "copper"):
            material = barreno_library.Material(card, library)
            for points in (1, 7, 512):
                check_block(program, material, card, points)
    check_null_pointers(path)


if __name__ == "__main__":
    main()
