#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The generic behaviour of MFront that libBarrenoMGIS.so offers, looked up and called as MGIS does it: names of symbols, the
layout of the data, Kelvin's components. Its answers are those of the C interface, to the last bit but for the factors of the
shears; MGIS itself is not needed.

    test_mgis.py MGIS_LIBRARY LIBRARY
"""
import ctypes
import math
import os
import subprocess
import sys

import numpy

import barreno_library
from barreno import materials

REAL = ctypes.POINTER(ctypes.c_double)
KELVIN = numpy.array([1, 1, 1, math.sqrt(2), math.sqrt(2), math.sqrt(2)])
ROUND = 4e-16  # of one multiplication and one division by sqrt(2)
PATH = [[-2e-3, -1e-3, -4e-3, 3e-4, -2e-4, 5e-4], [-6e-3, 2e-3, -8e-3, 1e-3, 0, 0], [1e-3, 1e-3, 2e-3, 0, 4e-4, 0],
    [-2e-2, 1e-3, 1e-3, 0, 0, 2e-3]]
NO_TANGENT, CONSISTENT, ELASTIC, PREDICTION, WITH_SPEED = 0.0, 4.0, 1.0, -1.0, 100.0


class State(ctypes.Structure):
    _fields_ = [(name, REAL) for name in ("gradients", "forces", "mass_density", "properties", "internal", "stored", "dissipated",
        "external")]


class Data(ctypes.Structure):
    _fields_ = [("message", ctypes.c_char_p), ("dt", ctypes.c_double), ("K", REAL), ("rdt", REAL), ("speed", REAL), ("s0", State),
        ("s1", State)]


def pointer(array):
    return array.ctypes.data_as(REAL)


class Behaviour:
    """As mgis::behaviour::load reads it, version 1 of the interface."""

    def __init__(self, library, hypothesis):
        self.library = library
        assert self.short("mfront_mkt") == 1 and self.short("api_version") == 1 and self.text("mfront_interface") == "Generic"
        assert self.short("BehaviourType") == 1 and self.short("BehaviourKinematic") == 1 and self.short("SymmetryType") == 0
        assert (self.names("Gradients"), self.types("Gradients")) == (["Strain"], [1])
        assert (self.names("ThermodynamicForces"), self.types("ThermodynamicForces")) == (["Stress"], [1])
        assert self.names("TangentOperatorBlocks") == ["Stress", "Strain"] and hypothesis in self.names("ModellingHypotheses")
        for name in ("MaterialProperties", "ExternalStateVariables", "Parameters", "InitializeFunctions", "PostProcessings"):
            assert self.names(name) == []
        for name in ("requiresStiffnessTensor", "requiresThermalExpansionCoefficientTensor", "ElasticSymmetryType",
                "TemperatureRemovedFromExternalStateVariables"):
            assert self.short(name) == 0
        assert self.short("ComputesInternalEnergy") == self.short("ComputesDissipatedEnergy") == 1
        self.variables = self.names("InternalStateVariables")
        assert self.types("InternalStateVariables") == [0] * len(self.variables)
        self.size = 6 if hypothesis == "Tridimensional" else 4
        self.function = getattr(library, f"Barreno_{hypothesis}")

    def short(self, name):
        return ctypes.c_ushort.in_dll(self.library, f"Barreno_{name}").value

    def text(self, name):
        return ctypes.c_char_p.in_dll(self.library, f"Barreno_{name}").value.decode()

    def names(self, name):
        count = self.short(f"n{name}")
        return [one.decode() for one in (ctypes.c_char_p * count).in_dll(self.library, f"Barreno_{name}")] if count else []

    def types(self, name):
        return list((ctypes.c_int * self.short(f"n{name}")).in_dll(self.library, f"Barreno_{name}Types"))

    def integrate(self, point, strain, dt, want):
        """@return (code, message, stiffness, step factor, speed of sound); the point is moved if the code says so"""
        n = self.size
        message, stiffness, factor, speed = ctypes.create_string_buffer(512), numpy.zeros(n * n), numpy.ones(1), numpy.zeros(1)
        stiffness[0] = want
        new = {name: array.copy() for name, array in point.items()}
        new["gradients"] = strain.copy()
        views = [State(*(pointer(one[name])
            for name in ("gradients", "forces", "density", "none", "internal", "stored", "dissipated", "none"))) for one in (point, new)]
        data = Data(ctypes.cast(message, ctypes.c_char_p), dt, pointer(stiffness), pointer(factor), pointer(speed), *views)
        code = self.function(ctypes.byref(data))
        if code == 1 and want > -0.5:
            point.update(new)
        return code, message.value.decode(), stiffness.reshape(n, n), factor[0], speed[0]

    def point(self):
        n = self.size
        return {"gradients": numpy.zeros(n), "forces": numpy.zeros(n), "density": numpy.array([2120.0]), "none": numpy.zeros(1),
                "internal": numpy.zeros(len(self.variables)), "stored": numpy.zeros(1), "dissipated": numpy.zeros(1)}  # fmt: skip


def near(a, b, within=ROUND):
    return numpy.abs(numpy.asarray(a) - b).max() <= within * max(1e-300, numpy.abs(b).max())


def work_of(material, strain, stress, state, dt):
    """Recoverable and dissipated work of a step, which the module does not hand out."""
    work, new_stress, new_state = numpy.zeros(2), numpy.zeros(6), numpy.zeros(material.state_count)
    address = [array.ctypes.data for array in (strain, stress[0], new_stress, state[0], new_state, work)]
    fields = ("strain_increment", "stress_old", "stress_new", "state_old", "state_new", "work")
    batch = materials._Batch(count=1, want=barreno_library.STRESS, time_increment=dt, **dict(zip(fields, address)))
    assert material.library.barreno_material_update(material.handle, ctypes.byref(batch)) == 0
    return work


def check_path(library, material, hypothesis):
    """The same increments by both doors."""
    behaviour = Behaviour(library, hypothesis)
    n = behaviour.size
    assert behaviour.variables == material.state_names, behaviour.variables
    point, strain = behaviour.point(), numpy.zeros(n)
    stress, state = material.virgin(1)
    stored = dissipated = 0.0
    for step in PATH:
        tensor = numpy.array(step)
        tensor[n:] = 0.0
        # What arrives there has been multiplied, added up and subtracted: the other door takes the same.
        total = strain + (tensor * KELVIN)[:n]
        seen = numpy.zeros(6)
        seen[:n] = (total - strain) / KELVIN[:n]
        strain = total
        answer = material.update(seen[None], stress, state, 1e-6)
        work = work_of(material, seen, stress, state, 1e-6)
        code, message, stiffness, _, speed = behaviour.integrate(point, strain, 1e-6, CONSISTENT + WITH_SPEED)
        assert code == 1, message
        assert near(point["forces"], (answer.stress[0] * KELVIN)[:n]), (point["forces"], answer.stress)
        assert near(point["internal"], answer.state[0])
        assert near(stiffness, (answer.tangent[0] * numpy.outer(KELVIN, KELVIN))[:n, :n], 1e-9)
        stored, dissipated = stored + work[0], dissipated + work[1]
        assert near(point["stored"], stored, 1e-12) and near(point["dissipated"], dissipated, 1e-12)
        assert 500.0 < speed < 8000.0, speed
        stress, state = answer.stress, answer.state
    assert dissipated > 0.0, "the path stays elastic"


def check_wishes(library):
    """No stiffness, the elastic one, and a prediction, which moves nothing."""
    behaviour = Behaviour(library, "Tridimensional")
    step = numpy.array(PATH[0]) * KELVIN
    for want, filled, moved in ((NO_TANGENT, False, True), (ELASTIC, True, True), (PREDICTION, True, False)):
        point = behaviour.point()
        code, message, stiffness, _, _ = behaviour.integrate(point, step, 1e-6, want)
        assert code == 1, message
        assert bool(stiffness[1, 1]) == filled and bool(point["forces"].any()) == moved, want
        if filled:
            assert near(stiffness, stiffness.T) and stiffness[3, 3] > 0.0 and near(stiffness[3, 3],
                stiffness[0, 0] - stiffness[0, 1], 1e-12)


def check_failure(library):
    """A step that no material takes: code, sentence, a smaller step, and nothing moved."""
    behaviour = Behaviour(library, "Tridimensional")
    point = behaviour.point()
    code, message, _, factor, _ = behaviour.integrate(point, numpy.full(6, math.nan), 1e-6, CONSISTENT)
    assert code == -1 and factor == 0.25 and message and not point["forces"].any(), (code, message)


def check_cards(path):
    """Without a card, or with one that is none, every call says so."""
    program = (f"import ctypes, test_mgis\n"
               f"b = test_mgis.Behaviour(ctypes.CDLL({path!r}), 'PlaneStrain'); print(b.integrate(b.point(), b.point()['forces'], 0.0, "
               "0.0)[:2])")  # fmt: skip
    for card, sentence in ((None, "no card is chosen"), ("berea_sandston", "names no card")):
        folders = f"{os.path.dirname(os.path.abspath(__file__))}:{os.environ['PYTHONPATH']}"
        environment = {**{name: value for name, value in os.environ.items() if name != "BARRENO_CARD"}, "PYTHONPATH": folders,
            **({"BARRENO_CARD": card} if card else {})}
        said = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=False)
        assert said.returncode == 0 and said.stdout.startswith("(-1, ") and sentence in said.stdout, said.stdout + said.stderr


def main():
    path = os.path.abspath(sys.argv[1])
    os.environ["BARRENO_CARD"] = "berea_sandstone"
    library = ctypes.CDLL(path)
    material = barreno_library.Material("berea_sandstone", os.path.abspath(sys.argv[2]))
    for hypothesis in ("Tridimensional", "PlaneStrain", "Axisymmetrical", "GeneralisedPlaneStrain"):
        check_path(library, material, hypothesis)
    check_wishes(library)
    check_failure(library)
    check_cards(path)
    print("the behaviour answers as the C interface does")


if __name__ == "__main__":
    main()
