#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The surface that a report draws is that of the material: its curves against those of `barreno drive`, which come from the material's own
functions, for every form of the shear limit and every shape of the third invariant.

    test_report_surface.py BARRENO
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from barreno.report.strength import Strength, lode_shape
from barreno.runs.csv_table import MIXED, read_csv

ROCK = {  # SI
    "PEAKI1": 9.36e6, "FSLOPE": 0.549, "STREN": 128.5e6, "YSLOPE": 0.0724, "CR": 0.593, "B0": 6.74e9, "B1": 2.86e10, "B2": 2.64e8,
    "G0": 5.703e9, "G1": 0.17, "G2": 0.03, "p0_crush_curve": -1.2244e9, "p1_crush_curve": 5.95e-10, "p3_crush_curve": 0.2231,
    "BETA_nonassociativity": 1,
}  # fmt: skip
FORMS = {  # name: what its card has instead
    "published": {},
    "linear": {"STREN": 0, "YSLOPE": 0},
    "strength limit": {"Strength limit": 400e6},
    "linear, strength limit": {"STREN": 0, "YSLOPE": 0, "Strength limit": 300e6},
    "von Mises": {"PEAKI1": 0, "FSLOPE": 0, "YSLOPE": 0},
    "zero vertex": {"PEAKI1": 0, "YSLOPE": 0},
    "no pores": {"p3_crush_curve": 0, "B3": 1e9, "B4": 0.02},
    "Gudehus": {"J3_type": "Gudehus", "J3_psi": 0.85},
    "Willam-Warnke": {"J3_type": "Willam-Warnke", "J3_psi": 0.7},
    "wide Willam-Warnke": {"J3_type": "Willam-Warnke", "J3_psi": 1.4},
    "Mohr-Coulomb": {"J3_type": "Mohr-Coulomb", "J3_psi": 0.75},
}
PATH = "time,strain_xx,stress_yy,stress_zz\n0,0,0,0\n1,0,-50 MPa,-50 MPa\n2,-0.004,-50 MPa,-50 MPa\n"
WITHIN = 1e-6  # of the largest strength: the tables' digits


def write_card(file, values):
    rows = "\n".join(f'  <Parameter name="{name}" type="{"string" if isinstance(value, str) else "double"}" value="{value}"/>'
        for name, value in values.items())
    file.write_text('<ParameterList name="Rock">\n  <Parameter name="Model" type="string" value="Arenisca"/>\n'
        f'  <Parameter name="Density" type="double" value="2120"/>\n{rows}\n</ParameterList>\n')


def curves(file):
    """{(section, lode angle): (I1, sqrt(J2))} of the virgin rock's surface."""
    table = read_csv(file, cells=MIXED)
    groups = table[table["state"] == "initial"].groupby(["section", "lode_angle"])
    return {key: rows[["I1", "sqrt_J2"]].to_numpy(float).T for key, rows in groups}


def check_form(barreno, folder, name, changes):
    card = {**ROCK, **changes}
    write_card(folder / "rock.xml", card)
    (folder / "path.csv").write_text(PATH)
    result = subprocess.run([barreno, "drive", "--material", "rock.xml", "--path", "path.csv", "--out", "answer.csv", "--plot",
        "answer.png"], cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        yield f"{name}: {result.stderr}"
        return
    shape = lode_shape(card.get("J3_type", "none"), card.get("J3_psi", 1.0))
    strength = Strength(lambda parameter: float(card.get(parameter, "nan")), shape)
    found = curves(folder / "answer_surface.csv")
    if strength.angled != (("extension", 0.0) in found):
        yield f"{name}: sections {sorted(found)}, but the report says {'one' if strength.angled else 'none'} in extension"
    size = max(float(shear.max()) for _, shear in found.values())
    for (section, angle), (I1, shear) in found.items():
        drawn = strength.shear_at(-I1 / 3.0, 0.0) * shape(60.0 - angle)  # 0 in compression in the report
        away = np.abs(drawn - shear)
        if not away.max() <= WITHIN * size:
            worst = away.argmax()
            yield (f"{name}, {section} at {angle} degrees: the report draws {drawn[worst]}, the rock bears {shear[worst]} at "
                f"I1 = {I1[worst]}")


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        faults = [fault for name, changes in FORMS.items() for fault in check_form(barreno, folder, name, changes)]
    for fault in faults:
        print(fault, file=sys.stderr)
    if not faults:
        print(f"{len(FORMS)} surfaces of the report are those of the material")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
