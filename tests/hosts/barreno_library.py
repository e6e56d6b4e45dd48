# SPDX-License-Identifier: BSD-3-Clause
"""materials/include/barreno_material.h in Python: what the tests of hosts compare with, and drive GetFEM by."""

import ctypes
import pathlib

import numpy

ABI_VERSION = 1
STRESS, ELASTIC, CONSISTENT = 0, 1, 2
CARDS = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"

_doubles = ctypes.POINTER(ctypes.c_double)
_integers = ctypes.POINTER(ctypes.c_int)


class Batch(ctypes.Structure):
    _fields_ = [
        ("count", ctypes.c_int),
        ("want", ctypes.c_int),
        ("time_increment", ctypes.c_double),
        ("strain_increment", _doubles),
        ("stress_old", _doubles),
        ("stress_new", _doubles),
        ("state_old", _doubles),
        ("state_new", _doubles),
        ("tangent", _doubles),
        ("work", _doubles),
        ("status", _integers),
    ]


def load(path):
    library = ctypes.CDLL(str(path))
    signatures = {
        "abi_version": (ctypes.c_int, []),
        "version": (ctypes.c_char_p, []),
        "last_error": (ctypes.c_char_p, []),
        "material_open": (ctypes.c_void_p, [ctypes.c_char_p]),
        "material_close": (None, [ctypes.c_void_p]),
        "material_model": (ctypes.c_char_p, [ctypes.c_void_p]),
        "material_file": (ctypes.c_char_p, [ctypes.c_void_p]),
        "material_density": (ctypes.c_double, [ctypes.c_void_p]),
        "material_state_count": (ctypes.c_int, [ctypes.c_void_p]),
        "material_state_name": (ctypes.c_char_p, [ctypes.c_void_p, ctypes.c_int]),
        "material_state_initial": (ctypes.c_double, [ctypes.c_void_p, ctypes.c_int]),
        "material_update": (ctypes.c_int, [ctypes.c_void_p, ctypes.POINTER(Batch)]),
    }
    for name, (result, arguments) in signatures.items():
        function = getattr(library, "barreno_" + name)
        function.restype, function.argtypes = result, arguments
    assert library.barreno_abi_version() == ABI_VERSION, "the library has another interface version"
    return library


class Material:
    """A card, and the update of arrays of points: strain increments and stresses (n, 6), states (n, state_count)."""

    def __init__(self, library, card):
        self.library = library
        self.handle = library.barreno_material_open(str(card).encode())
        if not self.handle:
            raise ValueError(library.barreno_last_error().decode())
        self.state_count = library.barreno_material_state_count(self.handle)
        self.state_names = [library.barreno_material_state_name(self.handle, i).decode() for i in range(self.state_count)]

    def close(self):
        self.library.barreno_material_close(self.handle)
        self.handle = None

    def virgin(self, count):
        """Stress and state of points that a host has not touched."""
        return numpy.zeros((count, 6)), numpy.zeros((count, self.state_count))

    def update(self, strain, stress, state, dt=1.0, want=CONSISTENT):
        """New stress, new state, tangent and status of each point."""
        count = len(strain)
        strain, stress, state = (numpy.ascontiguousarray(a, dtype=float) for a in (strain, stress, state))
        new_stress, new_state = numpy.empty((count, 6)), numpy.empty((count, self.state_count))
        tangent, status = numpy.empty((count, 6, 6)), numpy.empty(count, dtype=numpy.intc)
        pointer = lambda a: a.ctypes.data_as(_doubles)
        batch = Batch(
            count, want, dt, pointer(strain), pointer(stress), pointer(new_stress), pointer(state), pointer(new_state),
            pointer(tangent), None, status.ctypes.data_as(_integers),
        )
        failed = self.library.barreno_material_update(self.handle, ctypes.byref(batch))
        if failed < 0:
            raise ValueError(self.library.barreno_last_error().decode())
        assert failed == numpy.count_nonzero(status)
        return new_stress, new_state, tangent, status
