#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be computed in CalculiX says so by name and fails; a point that fails asks for a smaller step.

    test_ccx_refusals.py LIBRARY FOLDER_OF_CCX
"""

import sys
import tempfile

import numpy

import barreno_library
import calculix

CARD = "BEREA_SANDSTONE"
STATE_COUNT = 4
STOPPED = 201  # what CalculiX and the library end a failed job with


def deck(material, squeeze=-0.001, first=0.5, before=""):
    return (
        calculix.Box((1, 1, 1), (1.0, 1.0, 1.0)).deck()
        + material
        + before
        + "*BOUNDARY\nXM,1,1\nXP,1,1\nYM,2,2\nYP,2,2\nZM,3,3\n*STEP,INC=1000\n*STATIC\n"
        + f"{first},1.0,1e-6\n*BOUNDARY\nZP,3,3,{squeeze}\n*EL PRINT,ELSET=EALL\nS,SDV\n*END STEP\n"
    )


def good(**changes):
    return calculix.material(CARD, STATE_COUNT, **changes)


# name: deck, exit code, what the screen must say
REFUSED = {
    "no_such_card": (
        deck(good().replace(CARD, "BERA_SANDSTONE")),
        STOPPED,
        ['"BERA_SANDSTONE" names no card', "did you mean 'berea_sandstone'?"],
    ),
    "too_few_state_variables": (
        deck(good().replace("*DEPVAR\n4", "*DEPVAR\n3")),
        STOPPED,
        ["3 state variables, but it has 4 (initialized, volume_ratio,", "*DEPVAR with 4"],
    ),
    "constants": (
        deck(good().replace("CONSTANTS=0\n", "CONSTANTS=2\n20.E9,0.2\n")),
        STOPPED,
        ["gives 2 material constants", "CONSTANTS=0"],
    ),
    "no_such_library": (
        deck(good(function="@ABAQUS_NOSUCHLIB_UMAT@")), 255, ["libNOSUCHLIB.so: cannot open shared object file"]
    ),
    "no_such_function": (deck(good(function="@ABAQUS_BARRENO_NOSUCH@")), 255, ["unable to load function"]),
    "large_strains_without_their_interface": (
        deck(good()).replace("*STEP,", "*STEP,NLGEOM,"), STOPPED, ["NLGEOM", "write @ABAQUSNL_ in *MATERIAL"]
    ),
    "small_strains_with_the_other_interface": (
        deck(good(function="@ABAQUSNL_BARRENO_UMAT@")), STOPPED, ["the step has no NLGEOM", "write *STEP,NLGEOM"]
    ),
    # A state that no step size cures: said at once, instead of cutbacks until CalculiX gives up.
    "impossible_state": (
        deck(good(), before="*INITIAL CONDITIONS,TYPE=SOLUTION\n" + "".join(f"1,{p},0.5,1.,0.,0.\n" for p in range(1, 9))),
        STOPPED,
        ["point 0 of the batch has an impossible step or state", "`initialized` or initial stress out of range"],
    ),
}


def check_refusals(ccx, library):
    for name, (text, expected, sentences) in REFUSED.items():
        with tempfile.TemporaryDirectory() as folder:
            code, said, printed = calculix.run(ccx, library, folder, text, name=name)
        assert code == expected, f"{name}: exit code {code}, not {expected}:\n{said[-1500:]}"
        for sentence in sentences:
            assert sentence in said, f"{name}: '{sentence}' is not in:\n{said[-1500:]}"
        assert "Job finished" not in said, name
        print(f"{name}: exit code {code}, {sentences[0]}")


def check_cutback(ccx, library):
    """A strain increment beyond 10 is refused; CalculiX then takes a quarter of the step and goes on."""
    squeeze = -12.0
    with tempfile.TemporaryDirectory() as folder:
        code, said, printed = calculix.run(ccx, library, folder, deck(good(), squeeze, first=1.0), name="cutback")
    calculix.assert_job(code, said, CARD)
    assert "requested by a material user routine" in said, said[-2000:]
    material = barreno_library.Material("berea_sandstone", library)
    stress, state = material.virgin(1)
    times = sorted(printed["stresses"])
    assert len(times) > 1, "the step must have been cut"
    for before, now in zip([0.0] + times, times):
        strain = numpy.zeros((1, 6))
        strain[0, 2] = squeeze * (now - before)
        stress, state, _, status = material.update(strain, stress, state)
        assert status[0] == 0
    off = abs(printed["stresses"][times[-1]][0, 2:] - stress[0]).max() / abs(stress).max()
    print(f"cutback: {len(times)} increments instead of 1, stress differs from the library by {off:.1e}")
    assert off < 1e-5  # the times are printed with seven digits


def main():
    ccx = calculix.program(sys.argv[2])
    check_refusals(ccx, sys.argv[1])
    check_cutback(ccx, sys.argv[1])


if __name__ == "__main__":
    main()
