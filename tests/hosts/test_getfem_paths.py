#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One brick of Berea sandstone in GetFEM against `barreno drive` along the same strains: the paths of
test_ccx_paths.py. And the plug's two files by themselves, as docs/finite_elements.md has users copy them.

    test_getfem_paths.py LIBRARY BARRENO
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy

import barreno_library
import getfem_box
import getfem_module
import test_ccx_paths as paths


def prescribed(box, path):
    """Increments of the displacements (nan where they are free)."""
    du = numpy.full(box.unknowns.nbdof(), numpy.nan)
    upper = {
        "uniaxial_strain": [0.0, 0.0, paths.UNIAXIAL_STRAIN],
        "uniaxial_stress": [numpy.nan, numpy.nan, paths.UNIAXIAL_STRESS],
        "hydrostatic": [paths.HYDROSTATIC] * 3,
    }[path]
    for axis in range(3):
        du[box.on_face(axis, False, axis)] = 0.0
        du[box.on_face(axis, True, axis)] = upper[axis] / paths.INCREMENTS
    return du


def drive(material, getfem, path):
    """Strain increments, and stress and state after each, of the first point; all points must have the same."""
    box = getfem_box.Box(getfem, (1, 1, 1), (1.0, 1.0, 1.0))
    du = prescribed(box, path)
    free = numpy.where(numpy.isnan(du))[0]
    du[free] = 0.0
    stress, state = material.virgin(box.points)
    strains, rows = [], []
    for _ in range(paths.INCREMENTS):
        done, stress, state, _, _ = getfem_box.equilibrium(box, material, du, free, stress, state)
        assert abs(stress - stress[0]).max() < paths.TOLERANCE * abs(stress).max(), path
        strains.append(box.strain(done)[0])
        rows.append(numpy.concatenate([stress[0], state[0]]))
    return numpy.array(strains), numpy.array(rows)


def check_copied_files(library):
    """The first increments of the plug in a folder with nothing else: elastic, so the force follows the displacement."""
    here = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        for name in ("getfem_box.py", "getfem_plug.py"):
            shutil.copy(here / name, folder)
        environment = {**os.environ, "BARRENO_LIBRARY": library}
        command = [sys.executable, pathlib.Path(folder) / "getfem_plug.py", "berea_sandstone", "2"]
        result = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True)
        assert result.returncode == 0, result.stderr
        lines = [line for line in result.stdout.splitlines() if line.startswith("increment")]
        forces = [float(line.split()[2]) for line in lines]
        assert len(forces) == 2 and 1.5 < forces[1] / forces[0] < 2.5, result.stdout


def main():
    getfem = getfem_module.module()
    card = barreno_library.CARDS / f"{paths.CARD.lower()}.xml"
    material = barreno_library.Material(card, sys.argv[1])
    check_copied_files(sys.argv[1])
    for path in paths.PATHS:
        strains, own = drive(material, getfem, path)
        print(f"{path}: stress_zz ends at {own[-1, 2]:.7e} Pa in GetFEM")
        assert abs(own[:, :6]).max() > 1e7 and (own[-1, 9] > 1e-3 or abs(own[-1, 8]) > 1e-3), path
        paths.compare_drive(sys.argv[2], path, strains, own)


if __name__ == "__main__":
    main()
