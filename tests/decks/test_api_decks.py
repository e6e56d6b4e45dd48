#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The decks after API RP 19B start at rest under their pressures, for cores of 51 and 89 mm radius: without the jet nothing moves, and each
body keeps the pressure that the deck gives it.

    test_api_decks.py BARRENO
"""
import pathlib
import sys

import numpy as np

from tools.runs import DECKS, run_deck

# Every particle is updated, nothing is skipped as dormant; cells that divide the bodies' corners, so that each cell is full.
AWAKE = {"Jet": "", "Fidelity": "", "Grid/Cell Size": "2 mm", "Step/Skip Dormant Tiles": "false", "Step/Rest Motion": "0",
    "Time/End Time": "20 us", "Output/Field Interval": "20 us"}  # fmt: skip
LENGTHS = {"Gap": (8, 18), "Casing": (18, 28), "Cement": (28, 48), "Rock": (48, 648)}  # along y [mm]
KSI = 6.894757293168e6
PRESSURES = {  # of water, of what is confined, in the pores
    "api_section_2.xml": (3.0 * KSI, 3.0 * KSI, None),
    "api_section_4.xml": (17e6, 45e6, 20e6),
}
SLOWEST = 1e-9  # [m/s]: round-off of a sound speed
EXACT = 1e-9  # of a pressure


def wide():
    """Settings of a core of 89 mm radius, as input_xml/README.md has them."""
    return {"Grid/Upper": "{120 mm, 680 mm}", **{f"Bodies/{name}/Upper": f"{{89 mm, {end} mm}}" for name, (_, end) in LENGTHS.items()}}


def check_settings_of_page():
    """The page's command for the wide core has these settings."""
    page = (DECKS / "README.md").read_text()
    for name, value in wide().items():
        assert f'--set "{name}={value}"' in page, f"input_xml/README.md lacks --set {name}={value}"


def check_rest(barreno, deck, settings):
    water, confined, pores = PRESSURES[deck]
    finished = run_deck(barreno, deck, {**AWAKE, **settings})
    first, last = finished.particles(0), finished.particles()
    speed = np.hypot(last["velocity_x"], last["velocity_y"]).max()
    assert finished.summary["steps"] > 50 and speed <= SLOWEST, f"{deck}: {speed} m/s after {finished.summary['steps']} steps"
    width = 1e3 * last["x"].max()
    assert (width > 80.0) == bool(settings), f"{deck}: the core is {width} mm wide"
    y = 1e3 * first["y"]
    for name, (start, end) in LENGTHS.items():
        expected = water if name == "Gap" else confined
        there = (y > start) & (y < end)
        off = np.abs(last["pressure"][there] / expected - 1.0).max()
        assert there.sum() > 10 and off <= EXACT, f"{deck}: {name} is off {expected} Pa by {off}"
        if pores and name == "Rock":
            assert np.abs(last["pore_pressure"][there] / pores - 1.0).max() <= EXACT, f"{deck}: pores"
    assert np.isclose(last["pressure"][(y > 4.0) & (y < 8.0) & (first["x"] < 0.016)], water, rtol=EXACT).all(), f"{deck}: scallop"
    print(f"{deck}, {'89' if settings else '51'} mm: at rest, {speed:.1e} m/s after {finished.summary['steps']} steps", flush=True)


def main():
    barreno = pathlib.Path(sys.argv[1]).resolve()
    check_settings_of_page()
    for deck in PRESSURES:
        for settings in ({}, wide()):
            check_rest(barreno, deck, settings)
    return 0


if __name__ == "__main__":
    sys.exit(main())
