#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno flow --surge` on rock laid by hand: where the clean-up of a ring without cohesion ends, in closed form.

    test_surge.py BARRENO
"""
import json
import math
import os
import pathlib
import sys
import tempfile

import numpy as np
import synthetic_run
from barreno.flow.rings import Rings
from barreno.flow.solve import Flow
from barreno.flow.surge import gradient_of
from python_commands import said_by

INNER, EDGE, OUTER, LENGTH, VIRGIN, DENSITY = 0.002, 0.008, 0.028, 0.010, 1.0 - math.exp(-0.2231), 2120.0
SURGE = 10e6  # Pa


def ring_run(folder, damage=1.0, strain=0.0, edge=EDGE, length=LENGTH, lump=False, pore_pressure=None, name="Sandstone"):
    """A hole through rock of a permeability, or down to a length, whose ring from INNER to an edge has no cohesion.

    @param damage  of the ring; None: the rock has no history of it  @param lump  whether there is a lump of sound rock in the ring
    """
    centres = synthetic_run.lattice(0.0, OUTER, 0.0, LENGTH)
    end = synthetic_run.squares(centres, 0.25 * synthetic_run.CELL)
    r, y = centres[:, 0], centres[:, 1]
    end[(r < INNER) & (y < length)] += np.array([0.0, -0.5])  # thrown out
    ring = (r < edge) & (y < length)
    if lump:
        ring &= ~((r > 0.004) & (r < 0.005) & (y > 0.002) & (y < 0.003))
    block = synthetic_run.rock(centres, end, np.where(ring, strain, 0.0))
    block.name = name
    if damage is not None:
        block.fields["damage"] = np.where(ring, damage, 0.0)
    if pore_pressure is not None:
        block.fields["pore_pressure"] = np.full(len(centres), pore_pressure)
    jet = synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, -0.005, -0.003), 3000.0)
    return synthetic_run.write_run(folder, [block, jet], depth=length)


def flow(run, *words, code=0):
    said = said_by("barreno.flow", run, *words, code=code)
    return said, (json.loads((pathlib.Path(run) / "flow" / "flow.json").read_text()) if code == 0 else None)


def surge(run, limit, *words):
    return flow(run, "--surge", "10 MPa", "--surge-limit", f"{limit:.17g} Pa/m", *words)[1]


def permeability_of(strain):
    """After Kozeny and Carman."""
    porosity = 1.0 - (1.0 - VIRGIN) * math.exp(-strain)
    return (porosity / VIRGIN) ** 3 * ((1.0 - VIRGIN) / (1.0 - porosity)) ** 2


def gradient(r, k=1.0):
    """At the wall of a hole of radius r in a ring of permeability k (over that of the rock outside) to EDGE, for a drawdown of SURGE."""
    return SURGE / (r * k * (math.log(EDGE / r) / k + math.log(OUTER / EDGE)))


def end_of(limit, k=1.0):
    """Radius at which the gradient has fallen to the limit, by bisection; EDGE if it does not."""
    low, high = INNER, EDGE
    if gradient(high, k) > limit:
        return EDGE
    for _ in range(100):
        low, high = (0.5 * (low + high), high) if gradient(0.5 * (low + high), k) > limit else (low, 0.5 * (low + high))
    return high


def check_end(found, end, cell):
    """The wall is the first edge of cells at or beyond the exact radius; mass and flow are those of this wall."""
    before, after = found["surge"]["before"], found["surge"]["after"]
    radii = [one["radius"] for one in after["radii"]]
    error = max(abs(radius - end) for radius in radii)
    assert error <= cell + 2e-5 and min(radii) >= end - 2e-5, (radii, end, cell)
    volume = math.pi * (radii[1] ** 2 - before["radii"][1]["radius"] ** 2) * LENGTH
    assert abs((after["hole_volume"] - before["hole_volume"]) / volume - 1.0) < 1e-6, (found["surge"], volume)
    # A particle that is wider than a cell has its mass spread evenly over its width.
    assert abs(found["surge"]["removed_mass"] / (DENSITY * volume) - 1.0) < (1e-6 if cell >= 5e-4 else 0.02), (found["surge"], volume)
    return error


def check_radius(folder):
    """Of one permeability: the end for several limits, and a smaller error with smaller cells."""
    run = ring_run(folder / "radius")
    errors = {}
    for cell, radii in ((0.5, (0.0031, 0.0044, 0.0057)), (0.25, (0.0031,)), (0.125, (0.0031,))):
        errors[cell] = []
        for r in radii:
            limit = gradient(r)
            found = surge(run, limit, "--cell", f"{cell} mm")
            assert abs(end_of(limit) / r - 1.0) < 1e-12
            errors[cell].append(check_end(found, r, 1e-3 * cell))
            ratio = math.log(OUTER / INNER) / math.log(OUTER / found["surge"]["after"]["radii"][1]["radius"])
            assert abs(found["surge"]["flow_ratio"] / ratio - 1.0) < 0.01, (found["surge"], ratio)
            assert abs(found["core_flow_efficiency"] - 1.0) < 1e-9, found
        print(f"cells of {cell} mm: largest error of the radius {1e3 * max(errors[cell]):.3f} mm")
    assert max(errors[0.5]) > max(errors[0.25]) > max(errors[0.125]), errors


def check_edge(folder):
    """A crushed ring goes as far as its edge, and its skin with it; so it does on two ranks."""
    strain = -0.06
    k = permeability_of(strain)
    run = ring_run(folder / "edge", strain=strain)
    far, near = math.log(OUTER / EDGE), math.log(EDGE / INNER)
    for ranks in (1, 2):
        said, found = flow(run, "--surge", "10 MPa", "--ranks", ranks)
        before, after = found["surge"]["before"], found["surge"]["after"]
        check_end(found, EDGE, 2e-5)
        assert abs(before["core_flow_efficiency"] / ((far + near) / (far + near / k)) - 1.0) < 0.01, (before, k)
        assert abs(before["skin"] / (near * (1.0 / k - 1.0)) - 1.0) < 0.03, (before, k)
        assert abs(after["core_flow_efficiency"] - 1.0) < 1e-6 and abs(after["skin"]) < 1e-5, after
        assert abs(found["surge"]["flow_ratio"] / ((far + near / k) / far) - 1.0) < 0.01, found["surge"]
        assert found["surge"]["limit"] == 1e8 and "damage of at least 0.9" in said and "without cohesion removed" in said, said
    for key in ("core_flow_efficiency", "skin", "shape_factor", "hole_radius"):
        assert found[key] == after[key], key
    assert (run / "flow" / "flow.png").read_bytes()[:4] == b"\x89PNG"


def check_dilated(folder):
    """Rock whose card has no damage: pores opened by dilation count; crushed rock and little dilation do not."""
    strain = 0.05
    k = permeability_of(strain)
    run = ring_run(folder / "dilated", damage=None, strain=strain)
    limit = gradient(0.0044, k)
    found = surge(run, limit)
    check_end(found, end_of(limit, k), 5e-4)
    assert "porosity more than 5% above" in found["surge"]["lost_cohesion"], found
    for name, strain in (("crushed", -0.05), ("little", 0.005)):
        said, _ = flow(ring_run(folder / name, damage=None, strain=strain), "--surge", "10 MPa", code=1)
        assert "has lost its cohesion: its card has no damage, and none has dilated" in said, said


def check_nothing(folder):
    """No surge, one of 0, one below the limit, and rock that is nearly broken leave the former answer, to the bit."""
    run = ring_run(folder / "nothing", strain=-0.06)
    steepest = surge(run, 1e12)["surge"]["steepest_gradient"]
    _, former = flow(run)
    assert "surge" not in former
    for words in (("--surge", "0 MPa"), ("--surge", "10 MPa", "--surge-limit", f"{1.0001 * steepest:.17g} Pa/m")):
        _, found = flow(run, *words)
        one = found.pop("surge")
        assert found == former and one["removed_mass"] == 0.0 and one["passes"] == 0 and one["before"] == one["after"], (found, former)
    assert surge(run, 0.9999 * steepest)["surge"]["removed_mass"] > 0.0
    firm = ring_run(folder / "firm", damage=0.89, strain=-0.06)
    _, former = flow(firm)
    _, found = flow(firm, "--surge", "10 MPa")
    assert found.pop("surge")["removed_mass"] == 0.0 and found["shape_factor"] == former["shape_factor"], found
    # Of the ring in closed form: permeability k next to the wall.
    assert abs(steepest / gradient(INNER, permeability_of(-0.06)) - 1.0) < 1e-6, steepest


def check_tip(folder):
    """Half-way through: the ring ends where the hole does, so the surge leaves its length. A lump of sound rock in the ring goes when the
    ring is gone."""
    volume = math.pi * (EDGE**2 - INNER**2) * 0.005
    for boundary, lump in (("axial", False), ("both", True)):
        run = ring_run(folder / boundary, length=0.005, lump=lump)
        found = surge(run, 0.0, "--boundary", boundary)["surge"]
        assert found["after"]["hole_length"] == found["before"]["hole_length"], found
        assert abs(found["removed_mass"] / (DENSITY * volume) - 1.0) < 1e-6, (found, volume)
        assert abs((found["after"]["hole_volume"] - found["before"]["hole_volume"]) / volume - 1.0) < 1e-6, found


def check_gradient(_):
    """Of pressures in closed form: linear along the axis, ln r across it, at a corner the root of both squares."""
    radii, depths = np.linspace(0.0, 0.02, 21), np.linspace(0.0, 0.01, 21)
    hole = np.zeros((20, 20), bool)
    hole[:4, :7] = True
    porosity, breakage = np.where(hole, np.nan, VIRGIN), np.where(hole, np.nan, 0.0)
    rings = Rings(radii, depths, porosity, breakage, np.where(hole, 0.0, 1.0), hole, VIRGIN, np.zeros(20), 0.002, None)
    r, z = rings.middles
    across, along = np.log(r / 0.007)[None, :] + 0.0 * z[:, None], 50.0 * (z - 0.002)[:, None] + 0.0 * r[None, :]
    found = {name: gradient_of(rings, Flow(p, None, 0.0, "", 0)) for name, p in (("across", across), ("along", along))}
    assert np.allclose(found["across"][:4, 7], 1.0 / 0.007, rtol=1e-12, atol=0.0), found["across"][:4, 7]
    assert np.allclose(found["along"][4, :7], 50.0, rtol=1e-12, atol=0.0), found["along"][4]
    assert (found["along"][5:] == 0.0).all() and (found["across"][:, 8:] == 0.0).all() and (found["across"][hole] == 0.0).all()
    hole[4, 6] = True  # below the hole and beside it: cell (4, 7) has one face, (5, 6) one, (4, 5) two
    both = gradient_of(rings, Flow(0.0 * across + 1.0, None, 0.0, "", 0))[4, 5]
    assert abs(both / math.hypot(1.0 / (0.006 * math.log(0.006 / r[5])), 1.0 / 0.00025) - 1.0) < 1e-12, both


def check_faults(folder):
    run = ring_run(folder / "faults", pore_pressure=8e6)
    for words, sentence in (
        (("--surge", "-1 MPa"), '--surge "-1 MPa" is not a quantity of 0 or more with its unit; write for example --surge "7 MPa".'),
        (("--surge", "much"), '--surge "much" is not a quantity of 0 or more'),
        (("--surge", "7"), '--surge "7" is not a quantity of 0 or more'),
        (("--surge", "nan MPa"), '--surge "nan MPa" is not a quantity of 0 or more'),
        (("--surge", "7 MPa", "--surge-limit", "-1 Pa/m"), '--surge-limit "-1 Pa/m" is not a quantity of 0 or more'),
        (("--surge", "7 MPa", "--surge-limit", "1 MPa"), '--surge-limit "1 MPa" is not a quantity of 0 or more'),
        (("--surge-limit", "1 MPa/mm"), "--surge-limit says nothing without --surge"),
        (("--surge", "9 MPa"), "more than the pore pressure of"),
    ):
        said, _ = flow(run, *words, code=1)
        assert sentence in said and said.strip().count("\n") == 0, said
    flow(run, "--surge", "8 MPa")
    whole = ring_run(folder / "whole", edge=OUTER)
    said, _ = flow(whole, "--surge", "10 MPa", "--surge-limit", "0 Pa/m", "--cell", "2 mm", code=1)
    assert "would remove the rock of" in said and "as far as the face that the fluid comes from" in said, said
    tight = ring_run(folder / "tight", name="Granite")
    said, _ = flow(tight, "--surge", "10 MPa", code=1)
    assert "has no rock with pores, so nothing flows" in said, said


def main():
    os.environ["BARRENO_PROGRAM"] = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_radius, check_edge, check_dilated, check_nothing, check_tip, check_gradient, check_faults):
            check(pathlib.Path(folder))


if __name__ == "__main__":
    main()
