#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""UMAT in a host that turns: the answer to a turned path is the turned answer, tensors of the state included.

    test_rotation.py LIBRARY
"""

import ctypes
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

import barreno_library

ELASTIC = """<ParameterList name="Rubber">
  <Parameter name="Schema Version" type="int" value="1"/>
  <Parameter name="Units" type="string" value="SI"/>
  <Parameter name="Model" type="string" value="Neo-Hookean"/>
  <Parameter name="Density" type="double" value="1000"/>
  <Parameter name="Bulk Modulus" type="double" value="2e6"/>
  <Parameter name="Shear Modulus" type="double" value="1e6"/>
</ParameterList>
"""
MORE = """
  <Parameter name="T1_rate_dependence" type="double" value="1e-5"/>
  <Parameter name="J3_type" type="string" value="Willam-Warnke"/>
  <Parameter name="J3_psi" type="double" value="0.8"/>
"""
STEPS, DT = 20, 1e-6
SAME = 1e-9  # of the stress: sines and sums in another order, through twenty plastic steps
UMAT_ORDER = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
STATE_ORDER = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
STOPPED = 201


def write_cards(folder):
    (pathlib.Path(folder) / "RUBBER.xml").write_text(ELASTIC)
    text = (barreno_library.CARDS / "berea_sandstone.xml").read_text()
    (pathlib.Path(folder) / "RATE_BEREA.xml").write_text(text.replace("</ParameterList>", MORE + "</ParameterList>"))


def tensor(values, order):
    full = numpy.zeros((3, 3))
    for value, (i, j) in zip(values, order):
        full[i, j] = full[j, i] = value
    return full


def components(full, order):
    return numpy.array([full[i, j] for i, j in order])


def turn(axis, angle):
    axis = numpy.array(axis) / numpy.linalg.norm(axis)
    cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


class Host:
    """One point of an implicit code; STRESS is turned by the host, as its documentation has it."""

    def __init__(self, library, name, states):
        self.library, self.name = library, name.ljust(80).encode()
        self.stress, self.state = numpy.zeros((3, 3)), numpy.zeros(states)

    def step(self, strain, drot):
        """Strain increment in the axes at the end of the step; returns PNEWDT."""
        stress = components(drot @ self.stress @ drot.T, UMAT_ORDER)
        dstran = components(strain, UMAT_ORDER) * [1, 1, 1, 2, 2, 2]
        by_columns = numpy.asfortranarray(drot)
        tangent, pnewdt = numpy.zeros((6, 6)), ctypes.c_double(1.0)
        array = lambda a: a.ctypes.data_as(ctypes.c_void_p)
        integer = lambda v: ctypes.byref(ctypes.c_int(v))
        arguments = [array(stress), array(self.state), array(tangent)] + [None] * 8 + [array(dstran), None]
        arguments += [ctypes.byref(ctypes.c_double(DT))] + [None] * 4 + [ctypes.c_char_p(self.name)]
        arguments += [integer(3), integer(3), integer(6), integer(len(self.state)), None, integer(0), None]
        arguments += [array(by_columns), ctypes.byref(pnewdt)] + [None] * 9
        assert len(arguments) == 37
        self.library.UMAT(*arguments)
        self.stress = tensor(stress, UMAT_ORDER)
        return pnewdt.value


def strain_of(step):
    parts = [2e-3 * math.sin(1.3 + 0.7 * c + 0.2 * step) - (3e-4 if c < 3 else 0.0) for c in range(6)]
    return tensor(parts, UMAT_ORDER)


def run(host, drot, told):
    """All steps in axes that turn by drot in each; `told` is what the host says of that. The last axes."""
    axes = numpy.eye(3)
    for step in range(STEPS):
        axes = drot @ axes
        host_stress = host.stress
        host.stress = told.T @ drot @ host_stress @ drot.T @ told  # step() turns it by `told`
        assert host.step(axes @ strain_of(step) @ axes.T, told) == 1.0
    return axes


def check_turning(library, name, states, first):
    still, turned, untold = (Host(library, name, states) for _ in range(3))
    drot = turn((1.0, -2.0, 0.5), 0.3)
    run(still, numpy.eye(3), numpy.eye(3))
    axes = run(turned, drot, drot)
    run(untold, drot, numpy.eye(3))
    size = abs(still.stress).max()
    inside = tensor(still.state[first : first + 6], STATE_ORDER)
    scale = abs(inside).max()

    def off(host):
        in_state = tensor(host.state[first : first + 6], STATE_ORDER)
        return max(
            abs(axes.T @ host.stress @ axes - still.stress).max() / size,
            abs(axes.T @ in_state @ axes - inside).max() / scale,
        )

    print(f"{name} turned by {STEPS} times 0.3: off by {off(turned):.1e} of the stress; without DROT by {off(untold):.1e}")
    assert off(turned) < SAME and off(untold) > 1e-2

    # A step that fails leaves the state as it was, unturned.
    before = turned.state.copy()
    assert turned.step(numpy.diag([-1000.0, 0, 0]), drot) == 0.25
    assert numpy.array_equal(turned.state, before)


def check_refusal(arguments, sentences):
    result = subprocess.run([sys.executable, __file__] + arguments, capture_output=True, text=True, timeout=60)
    assert result.returncode == STOPPED, f"{result.returncode}: {result.stderr}"
    assert result.stderr.count("\n") == 1 and all(s in result.stderr for s in sentences), result.stderr
    print(result.stderr.strip())


def main():
    path = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        if len(sys.argv) > 2:  # called by check_refusal()
            folder = sys.argv[2]
        write_cards(folder)
        os.environ["BARRENO_MATERIALS"] = folder
        library = barreno_library.load(path)
        if len(sys.argv) > 2:
            states = len(barreno_library.Material("RATE_BEREA", library).state_names)
            Host(library, "RATE_BEREA", states).step(strain_of(0), 2 * numpy.eye(3))
            return
        for card, tensor_name in (("RATE_BEREA", "overstress_xx"), ("RUBBER", "green_strain_xx")):
            names = barreno_library.Material(card, library).state_names
            check_turning(library, card, len(names), names.index(tensor_name))
        check_refusal([path, folder], ["DROT is not a rotation", "overstress_xx and the like", "unit matrix"])


if __name__ == "__main__":
    main()
