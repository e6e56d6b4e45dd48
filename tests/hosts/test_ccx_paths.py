#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One brick of Berea sandstone in CalculiX against the library driven directly, and `barreno drive`, along the same
strains.

    test_ccx_paths.py LIBRARY FOLDER_OF_CCX BARRENO
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
from barreno.runs.csv_table import read_csv

import barreno_library
import calculix

CARD = "BEREA_SANDSTONE"
TOLERANCE = 1e-6  # .dat shows seven digits
INCREMENTS = 20

# End values: a crushed state, flow after the peak, pores crushing under pressure.
UNIAXIAL_STRAIN, UNIAXIAL_STRESS, HYDROSTATIC = -0.10, -0.02, -0.05

FIXED_SIDES = "*BOUNDARY\nXM,1,1\nYM,2,2\nZM,3,3\n"
PATHS = {
    # name: conditions that hold, and displacements of the faces at the end of the step
    "uniaxial_strain": (FIXED_SIDES + "XP,1,1\nYP,2,2\n", f"ZP,3,3,{UNIAXIAL_STRAIN}\n"),
    "uniaxial_stress": (FIXED_SIDES, f"ZP,3,3,{UNIAXIAL_STRESS}\n"),
    "hydrostatic": (FIXED_SIDES, "".join(f"{a}P,{i},{i},{HYDROSTATIC}\n" for i, a in enumerate("XYZ", 1))),
}


def deck(conditions, loads, state_count):
    step = 1.0 / INCREMENTS
    return (
        calculix.Box((1, 1, 1), (1.0, 1.0, 1.0)).deck()
        + calculix.material(CARD, state_count)
        + conditions
        + "*STEP,INC=1000\n*STATIC,DIRECT\n"
        + f"{step},1.0\n"
        + calculix.TIGHT
        + "*BOUNDARY\n"
        + loads
        + "*EL PRINT,ELSET=EALL\nS,SDV\n*END STEP\n"
    )


def lateral_equilibrium(material, axial, stress, state):
    """Strain increment with this axial part that leaves the sides without stress: Newton on the tangent."""
    strain = numpy.zeros((1, 6))
    strain[0, 2] = axial
    for _ in range(50):
        new_stress, _, tangent, status = material.update(strain, stress, state, dt=1.0 / INCREMENTS)
        assert status[0] == 0
        side = new_stress[0, :2]
        if abs(side).max() < 1e-3:  # Pa, of some 1e8
            return strain
        strain[0, :2] -= numpy.linalg.solve(tangent[0, :2, :2], side)
    raise AssertionError("no lateral equilibrium")


def drive(material, path):
    """Strain increments, and stress and state after each, by the library alone."""
    stress, state = material.virgin(1)
    rows, strains = [], []
    for _ in range(INCREMENTS):
        if path == "uniaxial_stress":
            strain = lateral_equilibrium(material, UNIAXIAL_STRESS / INCREMENTS, stress, state)
        else:
            strain = numpy.zeros((1, 6))
            end = {"uniaxial_strain": [0, 0, UNIAXIAL_STRAIN], "hydrostatic": [HYDROSTATIC] * 3}[path]
            strain[0, :3] = numpy.array(end) / INCREMENTS
        stress, state, _, status = material.update(strain, stress, state, dt=1.0 / INCREMENTS)
        assert status[0] == 0
        rows.append(numpy.concatenate([stress[0], state[0]]))
        strains.append(strain[0])
    return numpy.array(strains), numpy.array(rows)


def compare_drive(barreno, path, strains, own):
    """`barreno drive` along F = exp(strain): the same integration behind another face."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        lines = ["time,F11,F12,F13,F21,F22,F23,F31,F32,F33"]
        for i, total in enumerate(numpy.vstack([numpy.zeros(6), strains.cumsum(axis=0)])):
            stretch = [repr(math.exp(e)) for e in total[:3]]
            lines.append(f"{i},{stretch[0]},0,0,0,{stretch[1]},0,0,0,{stretch[2]}")
        (folder / "path.csv").write_text("\n".join(lines) + "\n")
        card = barreno_library.CARDS / f"{CARD.lower()}.xml"
        command = [barreno, "drive", "--material", card, "--path", folder / "path.csv", "--out", folder / "out.csv"]
        result = subprocess.run(command, capture_output=True, text=True, timeout=100)
        assert result.returncode == 0, result.stderr
        driven = read_csv(folder / "out.csv")[[f"stress_{c}" for c in ("xx", "yy", "zz", "xy", "zx", "yz")]].to_numpy(float)[1:]
    worst = abs(driven - own[:, :6]).max() / abs(own[:, :6]).max()
    print(f"{path}: barreno drive differs by {worst:.1e}")
    assert worst < TOLERANCE, path


def compare(path, printed, own):
    """Largest difference relative to the largest value of the same kind on the path."""
    assert len(printed["stresses"]) == INCREMENTS, sorted(printed["stresses"])
    worst = 0.0
    scale_stress = abs(own[:, :6]).max()
    assert scale_stress > 1e7, "the path must be felt"
    scale_state = numpy.maximum(abs(own[:, 6:]).max(axis=0), 1e-6)
    for row, time in zip(own, sorted(printed["stresses"])):
        for point in printed["stresses"][time]:
            worst = max(worst, abs(point[2:] - row[:6]).max() / scale_stress)
        for point in printed["internal state variables"][time]:
            worst = max(worst, (abs(point[2:] - row[6:]) / scale_state).max())
    print(
        f"{path}: stress_zz ends at {own[-1, 2]:.7e} Pa, plastic volume strain at {own[-1, 8]:.5e}; "
        f"CalculiX differs by {worst:.1e}"
    )
    assert worst < TOLERANCE, path
    # Every path must leave elasticity, or it would test little.
    assert own[-1, 9] > 1e-3 or abs(own[-1, 8]) > 1e-3, path


def main():
    library, ccx = sys.argv[1], calculix.program(sys.argv[2])
    material = barreno_library.Material(barreno_library.CARDS / f"{CARD.lower()}.xml", library)
    for path, (conditions, loads) in PATHS.items():
        with tempfile.TemporaryDirectory() as folder:
            code, said, printed = calculix.run(
                ccx, library, folder, deck(conditions, loads, material.state_count), name=path
            )
        calculix.assert_job(code, said, CARD)
        strains, own = drive(material, path)
        compare(path, printed, own)
        compare_drive(sys.argv[3], path, strains, own)


if __name__ == "__main__":
    main()
