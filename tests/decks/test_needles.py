#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Needles of a spray that have their nodes alone, as contact and CPDI leave them, take steps that their viscosity bears: the run ends with
small numerical energies, with its losses returned or not, with the largest Courant Fraction, with friction or without.

    test_needles.py BARRENO
"""
import pathlib
import sys
import tempfile

from tools.runs import run_deck

DECK = pathlib.Path(__file__).resolve().parent / "energy" / "needles.xml"
LARGEST_SHARE = 0.05  # of the energy put in; runs without needles lose 2 to 4 % to the transfer
VARIANTS = [
    {},
    {"Step/Return Losses": "false"},
    {"Step/Courant Fraction": 1.0, "Bodies/Disk/Velocity": "{200 m/s, 1550 m/s}", "Contact/a/Friction Coefficient": 0.0},
]


def check(settings):
    with tempfile.TemporaryDirectory() as name:
        run = run_deck(sys.argv[1], DECK, settings, folder=pathlib.Path(name) / "run")
        energy = run.summary["numerical_energy"]
        shares = energy["largest_stress_integration_share"], energy["largest_transfer_share"]
        print(settings, f"{run.summary['steps']} steps, stress integration {shares[0]:+.3f}, transfer {shares[1]:+.3f}")
        assert run.summary["time"] > 5.4999e-6, run.summary["time"]
        assert max(map(abs, shares)) < LARGEST_SHARE, shares


def main():
    for settings in VARIANTS:
        check(settings)


if __name__ == "__main__":
    main()
