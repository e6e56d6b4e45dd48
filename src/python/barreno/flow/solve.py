# SPDX-License-Identifier: BSD-3-Clause
"""Steady flow through rings of rock, by the program (`barreno solve-flow`: Belos with MueLu)."""

import dataclasses
import json
import pathlib
import tempfile

import numpy as np

from barreno.runs.faults import Fault
from barreno.runs.program import found_program
from barreno.runs.regular_file import read_text

BOUNDARIES = ("radial", "axial", "both")


@dataclasses.dataclass
class Flow:
    """For a mobility and a pressure drop of 1; both are factors of the rates."""

    pressure: np.ndarray  # (rows, columns), 0 in the hole and 1 outside; nan where nothing flows
    into_hole: np.ndarray  # of every row [m3]
    leak: float  # what flows in and not out, over what flows in
    method: str
    iterations: int

    @property
    def rate(self):
        return float(self.into_hole.sum())


def problem_of(rings, mobility, boundary):
    rows, columns = mobility.shape
    problem = {"radii": rings.radii.tolist(), "depths": rings.depths.tolist(), "mobility": mobility.ravel().tolist(),
        "hole": rings.hole.ravel().astype(int).tolist(), "hole_pressure": 0.0}  # fmt: skip
    if boundary in ("radial", "both"):
        problem["outside"] = [1.0] * rows
    if boundary in ("axial", "both"):
        problem["below"] = [1.0] * columns
    return problem


def solve(rings, mobility, boundary, ranks=1):
    """@param boundary  where the pressure outside is: radial, axial (the rear face) or both"""
    with tempfile.TemporaryDirectory(prefix="barreno-flow-") as folder:
        problem, answer = (pathlib.Path(folder) / name for name in ("problem.json", "answer.json"))
        problem.write_text(json.dumps(problem_of(rings, mobility, boundary)))
        child = found_program("flow", ranks).start(["solve-flow", str(problem), "--out", str(answer)])
        code = child.process.wait()
        if code:
            raise Fault(child.said() or "the flow was not found.", code)
        found = json.loads(read_text(answer))
    pressure = np.array([np.nan if p is None else p for p in found["pressure"]], float).reshape(mobility.shape)
    into_hole = np.array(found["into_hole"])
    fed = found["from_outside"] + found["from_above"] + found["from_below"]
    if not fed > 0.0:
        raise Fault("no rock leads from the outside to the hole, so nothing flows; look at the rock in barreno report, or take another "
            "--boundary.")
    return Flow(pressure, into_hole, abs(fed - float(into_hole.sum())) / fed, found["method"], found["iterations"])
