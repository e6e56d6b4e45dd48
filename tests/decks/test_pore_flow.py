#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pore flow from a deck: what the planner says and does, a solver that fails, ranks, a body's own pore pressure, and hours of
consolidation with scaled inertia.

    test_pore_flow.py BARRENO
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from tools.runs import DECKS, Run, run_deck

SLOW = 1e6  # times the fluid's viscosity and all times of the deck
LOAD_PRESSURE = 0.3508e6  # that the load of terzaghi.xml leaves in the pores
COLUMN = {"Grid/Cell Size": "0.1 m", "Pore Flow/Diffusion Number": "0.1", "Output/History Interval": "0.5 ms"}


def program(barreno, *arguments):
    return subprocess.run([barreno, *arguments], capture_output=True, text=True)


def settings(more):
    return [word for path, value in more.items() for word in ("--set", f"{path}={value}")]


def plan_line(barreno, more):
    text = program(barreno, "check", str(DECKS / "terzaghi.xml"), *settings(more)).stdout
    return next(line for line in text.splitlines() if line.strip().startswith("pore flow"))


def check_planner(barreno):
    """A permeability with which pressure gets nowhere switches the step off; Drainage decides against that."""
    tight = {"Pore Flow/Rocks/Rock/Permeability": "{1e-19 m2}"}
    for more, state, reason in (
        ({}, "on", "17 cells (limit 0.05)"),
        ({"Pore Flow/Drainage": "off"}, "off", "Drainage is off"),
        (tight, "off", "negligible (Drainage = on forces it)"),
        ({**tight, "Pore Flow/Drainage": "on"}, "on", "Drainage is on nevertheless"),
    ):
        line = plan_line(barreno, more)
        assert line.split()[2] == state and reason in line, line


def check_solver_words(barreno):
    """A solver's word may be set though the deck has no list of it; what does not fit its type is refused by name."""
    for path, value, exit_code, words in (
        ("Belos/Maximum Iterations", "500", 0, "on"),
        ("Belos/Maximum Iterations", "many", 1, "Pore Flow/Belos"),
        ("Ifpack2/relaxation: sweeps", "2", 0, "on"),
        ("MueLu/smoother: type", "RELAXATION", 0, "on"),
        ("MueLu/max levels", "several", 1, "Pore Flow/MueLu"),
    ):
        result = program(barreno, "check", str(DECKS / "terzaghi.xml"), *settings({f"Pore Flow/{path}": value}))
        assert result.returncode == exit_code, f"{path}={value}: exit {result.returncode}: {result.stderr}"
        said = result.stdout + result.stderr
        assert words in said and (exit_code == 0 or len(result.stderr.strip().splitlines()) == 1), said


def check_failure(barreno, folder):
    """A solver that gives up ends the run: exit 3, a sentence that helps, and the state before it, undrained."""
    more = {"Pore Flow/Belos/Maximum Iterations": "1", "Time/End Time": "1 ms"}
    deck = (DECKS / "terzaghi.xml").read_text()
    deck = deck.replace(
        '    <ParameterList name="Rocks">',
        '    <ParameterList name="Belos">\n      <Parameter name="Maximum Iterations" type="int" value="1"/>\n'
        '    </ParameterList>\n    <ParameterList name="Rocks">',
        1,
    )
    (folder / "failing.xml").write_text(deck)
    result = program(barreno, "run", str(folder / "failing.xml"), "--out", str(folder / "failing"), "--set", "Time/End Time=1 ms")
    assert result.returncode == 3, f"exit {result.returncode}: {result.stderr}"
    run = Run(folder / "failing")
    reason = run.summary["reason"]
    assert not run.summary["finished"] and "Raise Belos/Maximum Iterations" in reason, reason
    undrained = run_deck(barreno, "terzaghi.xml", {**{k: v for k, v in more.items() if "Belos" not in k}, "Pore Flow/Drainage": "off",
                         "Output/Field Interval": f"{run.summary['time']!r} s"}, folder=folder / "undrained")  # fmt: skip
    assert run.table("history.csv")["pore_solves"][-1] == 1  # the first, of rock without pressure
    at = run.particles()["time"]
    assert at == undrained.particles(1)["time"]
    # The first solve found next to no pressure; the one that failed would have taken a good part of it from the top.
    failed, other = run.particles()["pore_pressure"], undrained.particles(1)["pore_pressure"]
    off = np.max(np.abs(failed - other)) / np.max(other)
    assert off < 5e-3, f"the pore pressure is off by {off:g} from the undrained one"
    drained = run_deck(barreno, "terzaghi.xml", {"Time/End Time": f"{1.001 * run.summary['time']!r} s"}, folder=folder / "drained")
    gone = np.max(np.abs(drained.particles()["pore_pressure"] - other)) / np.max(other)
    assert gone > 0.05, f"a solve would have changed the pore pressure by {gone:g} only"


def check_pore_pressure(barreno, folder):
    """Fluid of 35 MPa in rock under 69 MPa, everything at rest: it stays so. The same of Poroelastic."""
    more = {"Time/End Time": "1 us", "Pore Flow/Conditions/Channel/Pressure": "35 MPa"}
    first = run_deck(barreno, "perforation_drainage.xml", more, folder=folder / "arenisca").particles(0)
    rock = np.isfinite(first["pore_pressure"])
    assert rock.sum() > 1000
    assert np.max(np.abs(first["pore_pressure"][rock] - 35e6)) < 1.0, first["pore_pressure"][rock]
    assert np.max(np.abs(first["pressure"][rock] - 69e6)) < 1e-3
    column = run_deck(
        barreno,
        "terzaghi.xml",
        {
            "Bodies/Column/Pore Pressure": "2 MPa",
            "Loads/Piston/Pressures": "{0 MPa, 0 MPa}",
            "Pore Flow/Conditions/Top/Pressure": "2 MPa",
            "Time/End Time": "1 ms",
        },
        folder=folder / "poroelastic",
    )
    for step in (0, -1):
        state = column.particles(step)
        assert np.max(np.abs(state["pore_pressure"] - 2e6)) < 1e-3 and np.max(np.abs(state["pressure"])) < 1e-3
    assert abs(column.table("history.csv")["fluid_inflow"][-1]) < 1e-15


def check_slow(barreno, folder):
    """Hours instead of milliseconds, the same curve: time only enters as c t / height^2."""
    fast = run_deck(barreno, "terzaghi.xml", COLUMN, folder=folder / "fast")
    slow = run_deck(
        barreno,
        "terzaghi.xml",
        {
            **COLUMN,
            "Pore Flow/Rocks/Rock/Permeability": f"{{{1.38580246914e-12 / SLOW!r} m2}}",
            "Loads/Piston/Times": f"{{0 s, {1e-3 * SLOW!r} s}}",
            "Step/Damping": "0 1/s",
            "Quasi-Static/Transit Ratio": "0.001",
            "Time/End Time": f"{0.05 * SLOW!r} s",
            "Output/Field Interval": f"{0.005 * SLOW!r} s",
            "Output/History Interval": f"{0.0005 * SLOW!r} s",
        },
        folder=folder / "slow",
    )
    assert slow.summary["inertia_factor"] > 1e9
    worst = 0.0
    for step in range(1, fast.instants()):
        a, b = fast.particles(step), slow.particles(step)
        assert abs(b["time"] / (SLOW * a["time"]) - 1.0) < 1e-9
        worst = max(worst, np.max(np.abs(a["pore_pressure"] - b["pore_pressure"])) / LOAD_PRESSURE)
    print(f"hours against milliseconds: {100 * worst:.2f} % of the first pressure, {slow.summary['steps']} steps")
    assert worst < 5e-3
    settled = slow.table("history.csv")
    assert settled["kinetic"][-1] < 1e-4 * settled["elastic"][-1]


def same_on_ranks(barreno, folder):
    more = {**COLUMN, "Time/End Time": "5 ms"}
    one, two = (run_deck(barreno, "terzaghi.xml", more, ranks=n, folder=folder / f"ranks{n}") for n in (1, 2))
    off = np.max(np.abs(one.particles()["pore_pressure"] - two.particles()["pore_pressure"])) / LOAD_PRESSURE
    assert off < 1e-8, f"pore pressure differs by {off:g} on two ranks"


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_planner(barreno)
        check_solver_words(barreno)
        for check in (check_failure, check_pore_pressure, same_on_ranks, check_slow):
            check(barreno, folder)


if __name__ == "__main__":
    main()
