# SPDX-License-Identifier: BSD-3-Clause
"""The plug of plug.py in CalculiX."""

import tempfile

import numpy

import calculix
import plug


def deck(state_count):
    box = calculix.Box(plug.CELLS, plug.LENGTHS)
    text = box.deck() + calculix.material(plug.CARD, state_count)
    text += "*BOUNDARY\nXM,1,1\nYM,2,2\nZM,3,3\nZP,1,2\n"
    for count, platen, pressure in plug.STEPS:
        text += f"*STEP,INC=1000\n*STATIC,DIRECT\n{1.0 / count:.12g},1.0\n{calculix.TIGHT}*BOUNDARY\nZP,3,3,{platen:.12g}\n*DLOAD\n"
        # Faces 4 and 5 of a brick are its upper ones along x and y.
        for axis, face in ((0, "P4"), (1, "P5")):
            text += "".join(f"{e},{face},{pressure:.12g}\n" for e in box.bricks_at(axis))
        text += "*NODE PRINT,NSET=ZM,TOTALS=ONLY\nRF\n*EL PRINT,ELSET=EALL\nS,SDV\n*END STEP\n"
    return text


def solve(ccx, library, state_count, threads=1):
    """Force on the platen [N] and the stresses (points, 6) and states after each increment."""
    with tempfile.TemporaryDirectory() as folder:
        plug.write_card(folder)
        code, said, printed = calculix.run(ccx, library, folder, deck(state_count), threads, "plug")
    calculix.assert_job(code, said, plug.CARD)
    times = sorted(printed["stresses"])
    force = numpy.array([-printed["total force"][t][0][2] for t in times])
    return force, [printed["stresses"][t] for t in times], [printed["internal state variables"][t] for t in times]
