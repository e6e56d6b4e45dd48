#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run in which numerical errors move more than a tenth of the energy put in ends with a warning: on the screen, in summary.json and in
the report, the same on one and two ranks and after a resume, also where the errors cancel in their sum.

    test_numerical_energy.py BARRENO
"""
import pathlib
import subprocess
import sys
import tempfile

from barreno.report.numbers import energy_rows
from tools.runs import Run, mpi_environment, run_deck

DECK = pathlib.Path(__file__).resolve().parent / "energy" / "thin_jet.xml"
KIND = "numerical errors above 10 % of the energy"


def call(*words):
    out = subprocess.run([sys.argv[1], *map(str, words)], capture_output=True, text=True, env=mpi_environment(), check=False)
    assert out.returncode == 0, out.stderr
    return out


def warning_of(run):
    assert run.summary["warnings"] == {KIND: 1}, run.summary["warnings"]
    energy = run.summary["numerical_energy"]
    assert energy["largest_stress_integration_share"] > 0.5 and energy["largest_transfer_share"] < -0.9, energy
    assert 0.0 < energy["since"] < 5e-6, energy
    assert ("warning", energy["warning"]) in energy_rows(run.summary)
    return energy["warning"]


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out = call("run", DECK, "--out", folder / "one")
        text = warning_of(Run(folder / "one"))
        assert out.stderr.splitlines()[-1] == "warning: " + text, out.stderr
        assert "'Tungsten'" in text and "which cancel in the sum" in text, text
        two = run_deck(sys.argv[1], DECK, ranks=2, folder=folder / "two")
        assert warning_of(two) == text, "two ranks say something else"
        call("run", DECK, "--set", "Time/End Time=9 us", "--out", folder / "part")
        call("resume", folder / "part", "--until", "15 us")
        resumed = Run(folder / "part").summary["numerical_energy"]
        whole = Run(folder / "one").summary["numerical_energy"]
        assert abs(resumed["since"] - whole["since"]) < 0.5e-6 and resumed["since"] < 9e-6, (resumed, whole)
        quiet = run_deck(sys.argv[1], "colliding_disks.xml", {"Time/End Time": "1e-5 s"}, folder=folder / "quiet")
        assert quiet.summary["warnings"] == {} and quiet.summary["numerical_energy"]["since"] is None
        assert quiet.summary["numerical_energy"]["warning"] == ""
        print(text)


if __name__ == "__main__":
    main()
