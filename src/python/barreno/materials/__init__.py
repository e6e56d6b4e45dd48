# SPDX-License-Identifier: BSD-3-Clause
"""Barreno's materials in Python: barreno_material.h by ctypes, with NumPy arrays.

    import numpy
    from barreno.materials import Material

    rock = Material("berea_sandstone")
    stress, state = rock.virgin(1)
    strain = numpy.array([[-1e-3, 0, 0, 0, 0, 0]])
    answer = rock.update(strain, stress, state)
    print(answer.stress, answer.state[:, rock.state_index("plastic_volume_strain")])

Components are 11 22 33 12 13 23, strains those of the tensor, units SI, tension positive (docs/finite_elements.md).
"""

import collections
import ctypes

import numpy

from barreno import places
from barreno.runs.faults import Fault

ABI_VERSION = 1
STRESS, ELASTIC, CONSISTENT = 0, 1, 2  # what an update is asked for: stress alone, or with one of two tangents
OK, SUBSTEP_LIMIT, NOT_CONVERGED, BAD_INPUT = 0, 1, 2, 3  # status of a point
STATUS = {
    OK: "the step is taken",
    SUBSTEP_LIMIT: "the step needs more substeps than are allowed: try a smaller step",
    NOT_CONVERGED: "the step did not converge: try a smaller step",
    BAD_INPUT: "the step or the state is impossible (not finite, too large, or a volume ratio, `initialized` or initial stress out of "
        "range): check what was passed",
}

Answer = collections.namedtuple("Answer", "stress state tangent status")
Followed = collections.namedtuple("Followed", "strain stress state status")


class _Batch(ctypes.Structure):
    _fields_ = [
        ("count", ctypes.c_int),
        ("want", ctypes.c_int),
        ("time_increment", ctypes.c_double),
        ("strain_increment", ctypes.c_void_p),
        ("stress_old", ctypes.c_void_p),
        ("stress_new", ctypes.c_void_p),
        ("state_old", ctypes.c_void_p),
        ("state_new", ctypes.c_void_p),
        ("tangent", ctypes.c_void_p),
        ("work", ctypes.c_void_p),
        ("status", ctypes.c_void_p),
    ]


class _Path(ctypes.Structure):
    _fields_ = [("count", ctypes.c_int), ("steps", ctypes.c_int), ("time_increment", ctypes.c_double)] + [
        (name, ctypes.c_void_p)
        for name in ("strain_increment", "stress_wanted", "stress_old", "state_old", "strain_taken", "stress", "state_new", "status")
    ]


_SIGNATURES = {
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
    "material_update": (ctypes.c_int, [ctypes.c_void_p, ctypes.POINTER(_Batch)]),
    "material_follow": (ctypes.c_int, [ctypes.c_void_p, ctypes.POINTER(_Path)]),
}


def find_library():
    """libBARRENO.so of the environment variable BARRENO_LIBRARY, or of the installation or tree that the package belongs to."""
    found = places.library()
    if found is None:
        raise FileNotFoundError(
            "libBARRENO.so was not found above this file; set BARRENO_LIBRARY to its path, or pass the library to Material()."
        )
    return found


def load(path=None):
    """The library with the types of its functions; without a path the one of find_library()."""
    path = path or find_library()
    library = ctypes.CDLL(str(path))
    for name, (result, arguments) in _SIGNATURES.items():
        function = getattr(library, "barreno_" + name)
        function.restype, function.argtypes = result, arguments
    version = library.barreno_abi_version()
    if version != ABI_VERSION:
        raise ImportError(f"{path} has interface version {version}, this module is for version {ABI_VERSION}; install both together.")
    return library


def _pointer(array):
    return array.__array_interface__["data"][0]  # a tenth of the time of array.ctypes


class MaterialFault(Fault, ValueError):
    """The library's sentence on a card or on arrays that it cannot use."""


class Material:
    """A card, by name or path, and the update of arrays of points.

    Strain increments and stresses are (n, 6), states (n, state_count), tangents (n, 6, 6). All zeros are virgin rock.

    Parameters
    ----------
    card : str or path
        "berea_sandstone", or a file (docs/materials).
    library : path, optional
        libBARRENO.so; that of the tree or installation if it is not given.

    Attributes
    ----------
    model, file : str
        The constitutive model, and the file of the card.
    density : float
        [kg/m3]
    state_names : list of str
        Of the columns of states.

    Raises
    ------
    barreno.Fault
        If the card cannot be used; it is a ValueError too.

    Examples
    --------
    >>> rock = barreno.Material("berea_sandstone")
    >>> rock.drive({"time": [0.0, 1.0], "strain_xx": [0.0, -0.01]})["stress_xx"]
    """

    def __init__(self, card, library=None):
        self.library = library if isinstance(library, ctypes.CDLL) else load(library)
        self.handle = self.library.barreno_material_open(str(card).encode())
        if not self.handle:
            raise MaterialFault(self.library.barreno_last_error().decode())
        self.model = self.library.barreno_material_model(self.handle).decode()
        self.file = self.library.barreno_material_file(self.handle).decode()
        self.density = self.library.barreno_material_density(self.handle)
        self.state_count = self.library.barreno_material_state_count(self.handle)
        self.state_names = [self.library.barreno_material_state_name(self.handle, i).decode() for i in range(self.state_count)]

    def close(self):
        """Gives the card back to the library; the end of a `with` block does so too."""
        if self.handle:
            self.library.barreno_material_close(self.handle)
        self.handle = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def state_index(self, name):
        """Column of a state variable.

        Parameters
        ----------
        name : str
            One of `state_names`.

        Returns
        -------
        int
        """
        return self.state_names.index(name)

    def virgin(self, count):
        """Stress and state of points that a host has not touched.

        Parameters
        ----------
        count : int
            Of points.

        Returns
        -------
        stress, state : numpy.ndarray
            (count, 6) and (count, state_count).
        """
        return numpy.zeros((count, 6)), numpy.zeros((count, self.state_count))

    def why(self):
        """The library's sentence on the first point that failed in the last update of this thread; "" if none did in any."""
        return self.library.barreno_last_error().decode()

    def drive(self, path, steps_per_row=1, every_step=False, set=None):
        """Stress and state of one point along a path of deformation, strain or stress, as `barreno drive` computes them (docs/drive.md).

        Parameters
        ----------
        path : path, dict or pandas.DataFrame
            A CSV file, or its columns by their names: time and F11 to F33, or strain_xx, stress_xx and so on; a nan leaves a cell empty.
        steps_per_row : int
            Equal steps between two rows of the path.
        every_step : bool
            Whether there is a row for every step.
        set : dict, optional
            {parameter: value}, in place of values of the card.

        Returns
        -------
        pandas.DataFrame
            In SI, tension positive; `attrs["units"]` has the units of time, strain, stress and pressure.

        Raises
        ------
        barreno.Fault
            With the sentence of `barreno drive`.
        """
        from barreno.materials.drive import drive  # slow to load

        return drive(self.file, path, steps_per_row, every_step, set)

    def update(self, strain, stress, state, dt=1.0, want=CONSISTENT):
        """One increment of each point: new stress, new state, tangent (zeros if it is not wanted) and status.

        A point whose status is not OK (0) has failed, and its stress and state are the old ones: SUBSTEP_LIMIT (1) and NOT_CONVERGED (2)
        may succeed with a smaller step, BAD_INPUT (3) will not. STATUS has words for each; why() says it of the first that failed.

        Parameters
        ----------
        strain : numpy.ndarray
            Increments (n, 6): xx, yy, zz, xy, yz, zx, tensor components, tension positive.
        stress, state : numpy.ndarray
            At the start of the step: (n, 6) [Pa], and (n, state_count).
        dt : float
            Length of the step [s].
        want : int
            STRESS, or which tangent: CONSISTENT, ELASTIC.

        Returns
        -------
        Answer
            `stress`, `state`, `tangent` (n, 6, 6) [Pa] and `status` (n).

        Raises
        ------
        barreno.Fault
            If a shape is not that; it is a ValueError too.
        """
        strain, stress, state = (numpy.ascontiguousarray(a, dtype=float) for a in (strain, stress, state))
        count = len(strain)
        for name, array, width in (("strain", strain, 6), ("stress", stress, 6), ("state", state, self.state_count)):
            if array.shape != (count, width):
                raise MaterialFault(f"{name} has the shape {array.shape}; ({count}, {width}) is needed.")
        answer = Answer(
            numpy.empty((count, 6)),
            numpy.empty((count, self.state_count)),
            numpy.zeros((count, 6, 6)),
            numpy.empty(count, dtype=numpy.intc),
        )

        pointer = _pointer
        batch = _Batch(
            count, want, dt, pointer(strain), pointer(stress), pointer(answer.stress), pointer(state), pointer(answer.state),
            pointer(answer.tangent) if want != STRESS else None, None, pointer(answer.status),
        )  # fmt: skip
        if self.library.barreno_material_update(self.handle, ctypes.byref(batch)) < 0:
            raise MaterialFault(self.library.barreno_last_error().decode())
        return answer

    def follow(self, strain, wanted, stress, state, dt=1.0):
        """Points along a path of steps in which each component has its strain increment given, or the stress that it reaches.

        Parameters
        ----------
        strain : numpy.ndarray
            Increments (steps, n, 6); a first guess where a stress is wanted.
        wanted : numpy.ndarray
            Stresses at the ends of the steps (steps, n, 6) [Pa], nan where the increment is given.
        stress, state : numpy.ndarray
            At the start: (n, 6) [Pa], and (n, state_count).
        dt : float
            Length of a step [s].

        Returns
        -------
        Followed
            `strain` and `stress` of the steps (steps, n, 6), `state` at the end and `status` of each point: NOT_CONVERGED where no strain
            gives the stress, or the update fails.

        Raises
        ------
        barreno.Fault
            If a shape is not that; it is a ValueError too.
        """
        strain, wanted, stress, state = (numpy.ascontiguousarray(a, dtype=float) for a in (strain, wanted, stress, state))
        steps, count = strain.shape[:2]
        for name, array, shape in (("wanted", wanted, strain.shape), ("stress", stress, (count, 6)),
                ("state", state, (count, self.state_count))):
            if array.shape != shape:
                raise MaterialFault(f"{name} has the shape {array.shape}; {shape} is needed.")
        out = Followed(numpy.empty_like(strain), numpy.empty_like(strain), state.copy(), numpy.zeros(count, dtype=numpy.intc))
        path = _Path(count, steps, dt, *map(_pointer, (strain, wanted, stress, state, out.strain, out.stress, out.state, out.status)))
        if self.library.barreno_material_follow(self.handle, ctypes.byref(path)) < 0:
            raise MaterialFault(self.library.barreno_last_error().decode())
        return out
