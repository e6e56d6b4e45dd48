# SPDX-License-Identifier: BSD-3-Clause
"""The published single-element benchmarks of Arenisca, driven point by point.

Parameters: verification/oracles/arenisca_paths.py. Paths and answers: arenisca_answers.py. A benchmark is one entry of
BENCHMARKS; one whose model needs a parameter that this build does not have is named as pending and joins by itself when
the parameter appears.
"""
import dataclasses
import typing

import numpy as np
from tools.case import Result
from cases import arenisca_answers as answers
from tools.drive import drive, knows
from tools.runs import order


@dataclasses.dataclass
class Benchmark:
    number: str
    what: str
    path: typing.Callable  # refinement -> [(time, F)], times at which there is an answer
    view: typing.Callable  # columns of the drive, stress in the benchmark's unit -> array (instant, quantity)
    exact: typing.Callable  # refinement -> array (instant, quantity)
    scale: list  # of each quantity: largest stress; of a plastic strain the largest strain of the path
    steps: int  # between two rows of the path, at refinement 1
    tolerance: float  # of the largest |error| / scale
    finest: float = None  # the same at the largest refinement; None: no demand
    order: float = None  # least order of the error in the refinement; None: no demand
    unit: float = 1e6  # of the benchmark's stress [Pa]
    needs: str = None  # parameter of the model
    tight: float = 5e-5  # with TIGHT; the published tables are exact to 1e-6, paths and rotations are cut into steps
    refined: str = "steps"  # what a refinement multiplies: the steps between rows, or the rows


BENCHMARKS = [
    Benchmark("01", "rotation by a turn, elastic", answers.turning_path, answers.in_plane, answers.turning, [60.0] * 4,
              1, 1e-4, 1e-6, 1.9, refined="rows"),
    Benchmark("02", "vertex, half associated", answers.vertex_path, answers.axes, answers.vertex, [300.0] * 2,
              56, 1e-3, 1e-6),
    Benchmark("03", "von Mises, uniaxial", answers.uniaxial_path("T03"), answers.axes, answers.uniaxial("T03"),
              [345.4] * 2, 10, 1e-6),
    Benchmark("04", "curved cap, uniaxial", answers.cap_path("T04"), answers.cap_view, answers.cap("T04"),
              [643.0, 541.0, 1726.0, 91.3, 0.0619], 100, 1e-3),
    Benchmark("05", "fixed cap, hydrostatic", answers.fixed_cap_path, answers.hydrostat, answers.fixed_cap,
              [1837.0, 0.218], 10, 1e-4),
    Benchmark("06", "cap evolution, uniaxial", answers.cap_path("T06"), answers.cap_view, answers.cap("T06"),
              [677.0, 585.0, 1847.0, 91.4, 0.0943], 100, 1e-3),
    Benchmark("07", "hydrostatic crush to total collapse", answers.crush_path, answers.crush_view, answers.crush,
              [47383.0, 0.393], 10, 1e-3),
    Benchmark("08", "hydrostatic load, unload, dilation", answers.hydrostatic_path("T08"), answers.hydrostat,
              answers.hydrostatic("T08"), [6815.0, 0.787], 40, 1e-2),
    Benchmark("09", "the same with pore fluid", answers.hydrostatic_path("T08"), answers.hydrostat,
              answers.saturated, [18764.0, 0.787], 40, 1e-2, needs="fluid_B0", tight=3e-4),
    Benchmark("10", "turning principal axes, von Mises", answers.corner_path, answers.deviator, answers.corner,
              [1.9e8] * 3, 100, 1e-3, unit=1.0),
    Benchmark("11", "von Mises, uniaxial cycle", answers.uniaxial_path("T11"), answers.axes, answers.uniaxial("T11"),
              [6.74e8] * 2, 10, 1e-4, unit=1.0),
    Benchmark("12", "nonlinear elasticity, five loops", answers.loops_path, answers.hydrostat, answers.loops,
              [6.7e8, 0.0293], 40, 1e-2, unit=1.0),
    Benchmark("13", "rate dependence", answers.rate_path, answers.axes, answers.rate, [2.07e9] * 2,
              1, 1e-4, unit=1.0, needs="T1_rate_dependence", refined="rows"),
]  # fmt: skip


TIGHT = {"Tolerance": "1e-6"}  # of the solver; a card's default is for runs of a million points


def error(barreno, benchmark, refinement, settings=None):
    """Largest |difference| / scale over all instants and quantities, and steps in all."""
    steps = benchmark.steps * (refinement if benchmark.refined == "steps" else 1)
    rows, instants = benchmark.path(refinement if benchmark.refined == "rows" else 1)
    card = answers.card(benchmark.number, benchmark.unit)
    table = drive(barreno, "Arenisca", {**card, **(settings or {})}, rows, steps)
    pick = [[t for t, _ in rows].index(instant) for instant in instants]
    at = {name: column[pick] / (benchmark.unit if name.startswith("stress") else 1.0) for name, column in table.items()}
    off = np.abs(benchmark.view(at) - benchmark.exact()) / np.array(benchmark.scale)
    return float(off.max()), steps * (len(rows) - 1)


def run(barreno, full):
    result = Result(
        "Arenisca: published single-element benchmarks",
        "`barreno drive` gives the published answers with the card's own tolerance; errors are the largest over all instants and "
        "quantities, relative to the scale of the quantity.",
        "closed forms, or numerical integrations converged to 1e-6 (verification/oracles).",
        ["benchmark", "what", "steps", "error", "with solver tolerance 1e-6", "of 16 times the steps", "order"],
        [],
    )
    pending = []
    for benchmark in BENCHMARKS:
        if benchmark.needs and not knows(barreno, "Arenisca", benchmark.needs):
            pending.append(f"{benchmark.number} ({benchmark.what}: needs {benchmark.needs})")
            continue
        first, steps = error(barreno, benchmark, 1)
        tight = error(barreno, benchmark, 1, TIGHT)[0]
        row = [benchmark.number, benchmark.what, steps, first, tight, "", ""]
        result.demand(f"{benchmark.number} {benchmark.what}", first, benchmark.tolerance)
        result.demand(f"{benchmark.number} with solver tolerance 1e-6", tight, min(benchmark.tight, benchmark.tolerance))
        if full:
            errors = [first, error(barreno, benchmark, 4)[0], error(barreno, benchmark, 16)[0]]
            row[5:] = [errors[2], order(errors, 4.0)[1] if min(errors) > 1e-8 else ""]
            if benchmark.finest:
                result.demand(f"{benchmark.number} refined 16 times", errors[2], benchmark.finest)
            if benchmark.order:
                result.demand(f"{benchmark.number} order", order(errors, 4.0)[1], benchmark.order, at_least=True)
        result.rows.append(row)
    if pending:
        result.notes = "Not in this version of the model: " + ", ".join(pending) + "."
    return result
