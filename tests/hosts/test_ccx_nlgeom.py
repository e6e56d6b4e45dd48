#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One brick in CalculiX with NLGEOM, stretched far and turned, against `barreno drive` along the same deformation; with free
sides against `barreno drive` in strain and stress.

    test_ccx_nlgeom.py LIBRARY FOLDER_OF_CCX BARRENO
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

FUNCTION = "@ABAQUSNL_BARRENO_UMAT@"
PRINTED = 1e-6  # .dat shows seven digits
INCREMENTS, DURATION = 20, 1e-4
STRETCH = numpy.array([-0.12, 0.03, -0.04])  # ln of the principal stretches at the end
AXIS, ANGLE = numpy.array([1.0, 2.0, 3.0]) / math.sqrt(14.0), math.radians(60.0)
SHORTENING = 0.10  # with free sides
MORE = """
  <Parameter name="T1_rate_dependence" type="double" value="1e-5"/>
  <Parameter name="J3_type" type="string" value="Willam-Warnke"/>
  <Parameter name="J3_psi" type="double" value="0.8"/>
"""


def rotation(part):
    x, y, z = AXIS
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(part * ANGLE) * cross + (1 - math.cos(part * ANGLE)) * cross @ cross


def stretch(part):
    return numpy.diag(numpy.exp(part * STRETCH))


def tensor(xx, yy, zz, xy, xz, yz):
    return numpy.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def motion(box):
    """Displacements of every node along F = R U of the reference place, each with an amplitude of its own."""
    lines, conditions = [], []
    parts = [i / INCREMENTS for i in range(INCREMENTS + 1)]
    for n, place in enumerate(box.nodes, 1):
        moved = numpy.array([(rotation(p) @ stretch(p) - numpy.eye(3)) @ place for p in parts])
        for axis in range(3):
            lines.append(f"*AMPLITUDE,NAME=A{n}D{axis + 1}")
            lines += [f"{p * DURATION:.12g},{u:.12g}" for p, u in zip(parts, moved[:, axis])]
            conditions.append(f"*BOUNDARY,AMPLITUDE=A{n}D{axis + 1}\n{n},{axis + 1},{axis + 1},1.")
    return "\n".join(lines) + "\n", "\n".join(conditions) + "\n"


def step(control, conditions):
    return (
        f"*STEP,NLGEOM,INC=1000\n*STATIC{control}\n{DURATION / INCREMENTS},{DURATION}\n{calculix.TIGHT}{conditions}"
        "*EL PRINT,ELSET=EALL\nS,SDV\n*END STEP\n"
    )


def material(card, states):
    return calculix.material(card, states, function=FUNCTION)


def scales_of(names, states):
    """Largest value of each column; components of a tensor have that of the tensor."""
    scales = numpy.maximum(abs(states).max(axis=0), 1e-6)
    tensor_columns = [i for i, name in enumerate(names) if name.startswith("overstress_")]
    if tensor_columns:
        scales[tensor_columns] = scales[tensor_columns].max()
    return scales


def drive(barreno, folder, card, path):
    """Stress tensors, rows of the state behind the two that hosts keep and its scales, at each row of the path behind the first."""
    folder = pathlib.Path(folder)
    (folder / "path.csv").write_text("\n".join(path) + "\n")
    command = [barreno, "drive", "--material", card, "--path", "path.csv", "--out", "out.csv"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=100)
    assert result.returncode == 0, result.stderr
    table = read_csv(folder / "out.csv")
    names = list(table.columns)
    first = names.index("stress_xx")
    values = table.to_numpy(float)[1:, first:]
    stresses = numpy.array([tensor(xx, yy, zz, xy, zx, yz) for xx, yy, zz, xy, yz, zx in values[:, :6]])
    return stresses, values[:, 6:], scales_of(names[first + 6 :], values[:, 6:])


def gradients(turned):
    lines = ["time,F11,F12,F13,F21,F22,F23,F31,F32,F33"]
    for i in range(INCREMENTS + 1):
        part = i / INCREMENTS
        f = (rotation(part) if turned else numpy.eye(3)) @ stretch(part)
        lines.append(",".join(repr(float(x)) for x in [part * DURATION, *f.ravel()]))
    return lines


def check_turned(library, ccx, barreno, name, text):
    """ln U keeps its axes here, so that stress and state are those of the stretch alone, turned."""
    with tempfile.TemporaryDirectory() as folder:
        card = pathlib.Path(folder) / f"{name}.xml"
        card.write_text(text)
        states = barreno_library.Material(card, library).state_count
        box = calculix.Box((1, 1, 1), (1.0, 1.0, 1.0))
        amplitudes, conditions = motion(box)
        deck = box.deck() + material(name, states) + amplitudes + step(",DIRECT", conditions)
        code, said, printed = calculix.run(ccx, library, folder, deck, name="turned")
        calculix.assert_job(code, said, name)
        straight, states_of_stretch, scales = drive(barreno, folder, card, gradients(turned=False))
        along, _, _ = drive(barreno, folder, card, gradients(turned=True))
    times = sorted(printed["stresses"])
    assert len(times) == INCREMENTS, times
    size, worst, state_off, apart = abs(straight).max(), 0.0, 0.0, 0.0
    assert size > 1e7 and abs(states_of_stretch[-1, 1]) > 1e-2, "the path must be felt, and leave elasticity"
    for i, time in enumerate(times):
        turned = rotation((i + 1) / INCREMENTS)
        expected = turned @ straight[i] @ turned.T
        apart = max(apart, abs(along[i] - expected).max() / size)
        for point in printed["stresses"][time]:
            worst = max(worst, abs(tensor(*point[2:]) - expected).max() / size)
        for point in printed["internal state variables"][time]:
            state_off = max(state_off, (abs(point[4:] - states_of_stretch[i]) / scales).max())
    print(
        f"{name}, turned by {math.degrees(ANGLE):.0f} degrees: CalculiX differs by {worst:.1e} in stress and {state_off:.1e} in "
        f"state; barreno drive along R U by {apart:.1e}"
    )
    assert worst < PRINTED and state_off < 10 * PRINTED
    assert apart < 1e-3  # its velocity gradient turns within a step


def check_free_sides(library, ccx, barreno):
    """Uniaxial stress to large strain: Newton's method with CalculiX's own tangent of the geometry."""
    name = "BEREA_SANDSTONE"
    states = barreno_library.Material(barreno_library.CARDS / "berea_sandstone.xml", library).state_count
    conditions = f"*BOUNDARY\nXM,1,1\nYM,2,2\nZM,3,3\n*BOUNDARY\nZP,3,3,{-SHORTENING}\n"
    deck = calculix.Box((1, 1, 1), (1.0, 1.0, 1.0)).deck() + material(name, states) + step(",DIRECT", conditions)
    with tempfile.TemporaryDirectory() as folder:
        code, said, printed = calculix.run(ccx, library, folder, deck, name="free")
        calculix.assert_job(code, said, name)
        path = ["time,strain_zz,stress_xx,stress_yy"]
        for i in range(INCREMENTS + 1):
            part = i / INCREMENTS
            path.append(f"{part * DURATION!r},{math.log1p(-part * SHORTENING)!r},0,0")
        stress, _, _ = drive(barreno, folder, "berea_sandstone", path)
    size, worst = abs(stress).max(), 0.0
    assert size > 1e7 and len(printed["stresses"]) == INCREMENTS
    for i, time in enumerate(sorted(printed["stresses"])):
        for point in printed["stresses"][time]:
            worst = max(worst, abs(tensor(*point[2:]) - stress[i]).max() / size)
    print(f"free sides, shortened by {SHORTENING:.0%}: CalculiX differs from barreno drive by {worst:.1e}")
    assert worst < 10 * PRINTED  # two iterations, each to its own tolerance


def main():
    library, ccx, barreno = sys.argv[1], calculix.program(sys.argv[2]), sys.argv[3]
    berea = (barreno_library.CARDS / "berea_sandstone.xml").read_text()
    check_turned(library, ccx, barreno, "MY_BEREA", berea)
    check_turned(library, ccx, barreno, "RATE_BEREA", berea.replace("</ParameterList>", MORE + "</ParameterList>"))
    check_free_sides(library, ccx, barreno)


if __name__ == "__main__":
    main()
