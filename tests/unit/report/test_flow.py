#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno flow` on runs whose rock was laid by hand: efficiency, skin and shares of a hole with a crushed ring, in closed form.

    test_flow.py BARRENO
"""
import json
import math
import os
import pathlib
import re
import sys
import tempfile

import numpy as np
import synthetic_run
from python_commands import said_by

INNER, CRUSHED, OUTER, LENGTH, VIRGIN = 0.004, 0.008, 0.020, 0.030, 1.0 - math.exp(-0.2231)


def strain_of(permeability):
    """Plastic volume strain that leaves k/k0 after Kozeny and Carman, by bisection."""
    low, high = -0.2, 0.0
    for _ in range(100):
        e = 0.5 * (low + high)
        porosity = 1.0 - (1.0 - VIRGIN) * math.exp(-e)
        k = (porosity / VIRGIN) ** 3 * ((1.0 - VIRGIN) / (1.0 - porosity)) ** 2
        low, high = (e, high) if k < permeability else (low, e)
    return e


def hole_run(folder, permeability, length=LENGTH, breakage=None):
    """A hole of the given length in rock of 30 mm, with a ring of crushed rock along all of it.  @param breakage  of the ring's grains"""
    centres = synthetic_run.lattice(0.0, OUTER, 0.0, LENGTH)
    end = synthetic_run.squares(centres, 0.25 * synthetic_run.CELL)
    r, y = centres[:, 0], centres[:, 1]
    gone = (r < INNER) & (y < length)
    end[gone] += np.array([0.0, -0.5])  # thrown out
    strain = np.where(r < CRUSHED, strain_of(permeability), 0.0)
    block = synthetic_run.rock(centres, end, strain)
    if breakage is not None:
        block.fields["breakage"] = np.where(r < CRUSHED, breakage, 0.0)
    jet = synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, -0.005, -0.003), 3000.0)
    return synthetic_run.write_run(folder, [block, jet], depth=length)


def flow(run, *words, code=0):
    said = said_by("barreno.flow", run, *words, code=code)
    return said, (json.loads((pathlib.Path(run) / "flow" / "flow.json").read_text()) if code == 0 else None)


def check_ring(folder):
    """Through all of the rock: radial flow, the same at every depth."""
    run = hole_run(folder / "through", 0.3)
    for ranks in (1, 2):
        said, found = flow(run, "--ranks", ranks)
        far, near = math.log(OUTER / CRUSHED), math.log(CRUSHED / INNER)
        exact = (far + near) / (far + near / 0.3)
        assert abs(found["core_flow_efficiency"] / exact - 1.0) < 0.01, (found, exact)
        assert abs(found["shape_factor_virgin"] / (2.0 * math.pi * LENGTH / (far + near)) - 1.0) < 0.01, found
        skin = near * (1.0 / 0.3 - 1.0)
        assert abs(found["skin"] / skin - 1.0) < 0.03 and abs(found["hole_radius"] / INNER - 1.0) < 0.02, (found, skin)
        shares = [one["share"] for one in found["shares"]]
        assert abs(sum(shares) - 1.0) < 1e-9 and found["mass_error"] < 1e-10, found
        assert max(shares[1:-1]) / min(shares[1:-1]) < 1.1, shares
        assert "core flow efficiency" in said and "share of the flow by depth" in said, said
    assert (run / "flow" / "flow.png").read_bytes()[:4] == b"\x89PNG"


def check_broken_grains(folder):
    """The same ring with the pores of virgin rock and broken grains, whose surface S/S_0 = 1 + B (sqrt(1/0.3) - 1); and with both."""
    far, near = math.log(OUTER / CRUSHED), math.log(CRUSHED / INNER)
    for breakage, pores in ((1.0, 1.0), (0.5, 1.0), (0.5, 0.6)):
        said, found = flow(hole_run(folder / f"broken{breakage}{pores}", pores, breakage=breakage))
        k = pores / (1.0 + breakage * (math.sqrt(1.0 / 0.3) - 1.0)) ** 2
        exact = (far + near) / (far + near / k)
        assert abs(found["core_flow_efficiency"] / exact - 1.0) < 0.01, (found, exact)
        assert "from the breakage of the grains" in said, said
    whole, unknown = (flow(hole_run(folder / name, 0.6, breakage=b))[1] for name, b in (("whole", 0.0), ("unknown", None)))
    assert {**whole, "run": ""} == {**unknown, "run": ""}, (whole, unknown)


def check_dilated_ring(folder):
    """Pores that dilation has opened let through three times as much as virgin ones, and no more."""
    run = hole_run(folder / "dilated", 1.0)
    centres = synthetic_run.lattice(0.0, OUTER, 0.0, LENGTH)
    end = synthetic_run.squares(centres, 0.25 * synthetic_run.CELL)
    end[centres[:, 0] < INNER] += np.array([0.0, -0.5])
    block = synthetic_run.rock(centres, end, np.where(centres[:, 0] < CRUSHED, 0.3, 0.0))
    jet = synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, -0.005, -0.003), 3000.0)
    _, found = flow(synthetic_run.write_run(run, [block, jet], depth=LENGTH))
    far, near = math.log(OUTER / CRUSHED), math.log(CRUSHED / INNER)
    assert abs(found["core_flow_efficiency"] / ((far + near) / (far + near / 3.0)) - 1.0) < 0.01, found


def check_blind_hole(folder):
    """Half-way through: flow from the rear comes in at the tip most of all; virgin rock has no skin."""
    run = hole_run(folder / "blind", 1.0, 0.015)
    parts = {}
    for boundary in ("radial", "axial", "both"):
        _, found = flow(run, "--boundary", boundary)
        assert abs(found["core_flow_efficiency"] - 1.0) < 1e-9 and abs(found["skin"]) < 1e-8, found
        parts[boundary] = found
    assert parts["both"]["shape_factor"] > parts["radial"]["shape_factor"] > parts["axial"]["shape_factor"], parts
    # From the rear the tip is reached first; nothing comes in below the hole but through its bottom.
    shares = [one["share"] for one in parts["axial"]["shares"][:-1]]
    assert all(above < below for above, below in zip(shares, shares[1:])), shares


def check_cells(folder):
    """Smaller rings change little."""
    run = hole_run(folder / "cells", 0.3, 0.02)
    found = [flow(run, "--cell", f"{size} mm")[1]["core_flow_efficiency"] for size in (1.0, 0.5, 0.25)]
    assert abs(found[1] / found[2] - 1.0) < 0.02, found


def check_error_of_the_cells(folder):
    """The interval of the efficiency is what the summary says of its error, of radial flow at the end of the run."""
    run = hole_run(folder / "error", 0.3)
    _, plain = flow(run)
    assert "core_flow_efficiency_error" not in plain, plain
    file = run / "summary.json"
    error = {"value": 0.25, "low": -0.2, "high": 1.0, "cells_per_radius": 1.8, "source": "measured by hand"}
    file.write_text(json.dumps({**json.loads(file.read_text()), "penetration": {"core_flow_efficiency_error": error}}))
    said, found = flow(run)
    efficiency = plain["core_flow_efficiency"]
    assert found["core_flow_efficiency"] == efficiency and found["core_flow_efficiency_error"] == error, found
    assert f"{efficiency / 2.0:.3f} to {efficiency / 0.8:.3f}; error from the size of the cells +25 % (-20 to +100 %)" in said, said
    for words in (("--boundary", "axial"), ("--time", "10 us")):
        said, found = flow(run, *words)
        assert "unknown (it was measured for radial flow at the end" in said and "unknown" in found["core_flow_efficiency_error"], said


def check_faults(folder):
    run = hole_run(folder / "faults", 0.3)
    for words, sentence in (
        (("--time", "soon"), '--time "soon" is not a quantity above 0 with its unit; write for example --time "200 us".'),
        (("--cell", "-1 mm"), "is not a quantity above 0 with its unit"),
        (("--boundary", "up"), "invalid choice: 'up'"),
        (("--time", "5 ms"), "is not in the run's particles.e"),
        (("--cell", "15 mm"), "is thinner than the cells of"),
    ):
        said, _ = flow(run, *words, code=1)
        assert sentence in said, said
    (folder / "empty").mkdir()
    said = said_by("barreno.flow", folder / "empty", code=2)
    assert "cannot find the flow into the hole of" in said and "it contains no history.csv; give the folder of a run" in said, said
    said = said_by("barreno.flow", folder / "absent", code=2)
    assert "is not a folder" in said, said
    closed = synthetic_run.write_run(folder / "closed", [synthetic_run.rock(synthetic_run.lattice(0.0, OUTER, 0.0, LENGTH)),
        synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, -0.005, -0.003), 3000.0)])
    said, _ = flow(closed, code=1)
    assert "has no hole in its rock" in said, said
    plane = synthetic_run.write_run(folder / "plane", [synthetic_run.rock(synthetic_run.lattice(0.004, OUTER, 0.0, LENGTH))],
        mode="plane strain")
    said, _ = flow(plane, code=1)
    assert "flow is computed through rings of axisymmetric runs alone" in said, said


def check_rock_that_lets_nothing_through(folder):
    run = hole_run(folder / "tight", 0.3)
    deck = run / "deck.xml"
    text = deck.read_text()
    flows = """<ParameterList name="Pore Flow"><ParameterList name="Rocks"><ParameterList name="Sandstone">
        <Parameter name="Permeability" type="string" value="{%s}"/></ParameterList></ParameterList></ParameterList>"""
    head, end = text.rsplit("</ParameterList>", 1)
    for permeability, code in (("1e-13", 0), ("0", 1), ("0, 0, 0", 1)):
        deck.write_text(head + flows % permeability + "</ParameterList>" + end)
        said, _ = flow(run, code=code)
        assert ("has rock of Pore Flow whose Permeability is 0, so nothing flows" in said) == bool(code), said
    entry = re.search(r'name="p3_crush_curve"[^>]*value="([^"]*)"', text)
    deck.write_text(text[: entry.start(1)] + "0" + text[entry.end(1) :])
    said, _ = flow(run, code=1)
    assert "has no rock with pores, so nothing flows" in said and "Warning" not in said, said


def check_what_the_hole_is(folder):
    """A hole that grows on, or has no bottom, is said to be one."""
    run = hole_run(folder / "what", 0.3)
    file = run / "summary.json"
    plain = json.loads(file.read_text())
    rest = {"at_rest": False, "sentence": "The hole is not at rest: it grows."}
    for found, sentence in (
        ({"rest": rest}, "The hole is not at rest: it grows. The flow is that into the hole as it is."),
        ({"rest": rest, "through": True}, "The jet has come out of the rear of the target"),
        ({"rest": {**rest, "at_rest": True}}, ""),
    ):
        file.write_text(json.dumps({**plain, "penetration": found}))
        said, numbers = flow(run)
        assert sentence in said and numbers.get("warning", "").startswith(sentence), said
        assert bool(sentence) == ("warning" in numbers), numbers
        said, numbers = flow(run, "--time", "10 us")
        assert "warning" not in numbers, numbers


def main():
    os.environ["BARRENO_PROGRAM"] = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_ring, check_broken_grains, check_dilated_ring, check_blind_hole, check_cells, check_error_of_the_cells,
                check_faults, check_rock_that_lets_nothing_through, check_what_the_hole_is):  # fmt: skip
            check(pathlib.Path(folder))


if __name__ == "__main__":
    main()
