#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Jet Monitor: a rod that flies through the plane, its table, the same on two ranks and after a resume, and launched again:
test_jet_monitor.py BARRENO."""
import math
import pathlib
import sys
import tempfile

import numpy as np

from barreno.report.deck import read_deck
from barreno.report.hole import jet_particles
from barreno.report.particles import ParticleFile
from tools.resumed import at_previous, must_work, program
from tools.runs import Run

HEAD = """<ParameterList name="Barreno">
  <Parameter name="Schema Version" type="int" value="1"/>
  <ParameterList name="Grid">
    <Parameter name="Mode" type="string" value="axisymmetric"/>
    <Parameter name="Lower" type="string" value="{0 mm, 0 mm}"/>
    <Parameter name="Upper" type="string" value="{8 mm, 60 mm}"/>
    <Parameter name="Cell Size" type="string" value="1 mm"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Copper"><Parameter name="Card" type="string" value="copper.xml"/></ParameterList>
  </ParameterList>
  <ParameterList name="Conditions">
    <ParameterList name="Axis">
      <Parameter name="Face" type="string" value="x_lower"/>
      <Parameter name="Kind" type="string" value="symmetry"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="End Time" type="string" value="16 us"/></ParameterList>
  <ParameterList name="Output"><Parameter name="Checkpoint Steps" type="int" value="60"/></ParameterList>
"""
# A rod of 10 mm, front at 12 mm: its ends cross the plane at 9 and 14 us.
ROD = """  <ParameterList name="Bodies">
    <ParameterList name="Rod">
      <Parameter name="Material" type="string" value="Copper"/>
      <Parameter name="Lower" type="string" value="{0 mm, 2 mm}"/>
      <Parameter name="Upper" type="string" value="{3 mm, 12 mm}"/>
      <Parameter name="Velocity" type="string" value="{0 m/s, 2000 m/s}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Jet Monitor">
    <Parameter name="Bodies" type="string" value="{Rod}"/>
    <Parameter name="Position" type="string" value="30 mm"/>
    <Parameter name="Direction" type="string" value="+y"/>
    <Parameter name="Interval" type="string" value="0.5 us"/>
  </ParameterList>
</ParameterList>
"""
JET = """  <ParameterList name="Jet">
    <Parameter name="Material" type="string" value="Copper"/>
    <Parameter name="Table" type="string" value="straight/jet_table.csv"/>
    <Parameter name="Launch Position" type="string" value="30 mm"/>
    <Parameter name="Direction" type="string" value="+y"/>
  </ParameterList>
</ParameterList>
"""
# 4 mm ahead of the plane: the rod meets it at 11 us, and digs until 16 us at about half of its speed.
BLOCK = """    <ParameterList name="Block">
      <Parameter name="Material" type="string" value="Copper"/>
      <Parameter name="Lower" type="string" value="{0 mm, 34 mm}"/>
      <Parameter name="Upper" type="string" value="{8 mm, 46 mm}"/>
    </ParameterList>
  </ParameterList>
"""
DENSITY, SPEED, RADIUS, LENGTH = 8930.0, 2000.0, 3e-3, 10e-3  # of copper.xml and the rod


def near(found, expected, share):
    assert abs(found / expected - 1.0) < share, (found, expected)


def check_table(run):
    """Ten slugs of 1 mm that are the rod, and an audit that closes."""
    table = run.table("jet_table.csv")
    assert len(table["time"]) == 10, table
    assert np.allclose(table["time"], 9.25e-6 + 0.5e-6 * np.arange(10), rtol=0.0, atol=1e-12), table["time"]
    for name, exact in (("velocity", SPEED), ("radius", RADIUS), ("length", 1e-3), ("density", DENSITY)):
        assert np.allclose(table[name], exact, rtol=1e-6, atol=0.0), (name, table[name])
    jet = run.summary["formed_jet"]
    mass = DENSITY * math.pi * RADIUS**2 * LENGTH
    for part in ("crossed", "table"):
        near(jet[part]["mass"], mass, 1e-12)
        near(jet[part]["momentum"], mass * SPEED, 1e-9)
        near(jet[part]["kinetic"], 0.5 * mass * SPEED**2, 1e-9)
    near(jet["mass_beyond"], mass, 1e-12)
    assert jet["crossed"]["count"] == run.summary["particles"] and abs(jet["slice_loss"]) < 1e-9, jet
    assert jet["slow"]["count"] == jet["wide"]["count"] == 0


def check_short_grid(barreno, folder):
    """A grid that ends 4 mm beyond the plane and an interval longer than the run: what leaves the grid has been counted before."""
    words = [x for one in ("Grid/Upper={8 mm, 34 mm}", "Jet Monitor/Interval=40 us", "Time/End Time=20 us") for x in ("--set", one)]
    must_work(program(barreno, 1, "run", folder / "rod.xml", "--out", folder / "short", *words))
    run = Run(folder / "short")
    assert (
        run.summary["removed_particles"]["left_grid"]["mass"] > 0.99 * DENSITY * math.pi * RADIUS**2 * LENGTH
    ), run.summary["removed_particles"]
    near(run.summary["formed_jet"]["crossed"]["mass"], DENSITY * math.pi * RADIUS**2 * LENGTH, 1e-12)


def check_target(barreno, folder):
    """A body ahead of the plane: depth.csv, the same bytes on two ranks and after a resume, and much that of the table launched into it."""
    (folder / "dig.xml").write_text(HEAD + ROD.replace("\n  </ParameterList>\n", "\n" + BLOCK, 1))
    bodies = '  <ParameterList name="Bodies">\n' + BLOCK
    (folder / "dig_again.xml").write_text(HEAD + bodies + JET.replace("straight", "dig"))
    for name, ranks in (("dig", 1), ("dig_two", 2), ("dig_killed", 1)):
        must_work(program(barreno, ranks, "run", folder / "dig.xml", "--out", folder / name))
    at_previous(folder / "dig_killed")
    must_work(program(barreno, 2, "resume", folder / "dig_killed"))
    first = (folder / "dig" / "depth.csv").read_bytes()
    for name in ("dig_two", "dig_killed"):
        assert (folder / name / "depth.csv").read_bytes() == first, name
    must_work(program(barreno, 1, "run", folder / "dig_again.xml", "--out", folder / "dig_again"))
    # The report takes what starts behind the plane for the jet, though the block is of copper too.
    file = ParticleFile(folder / "dig" / "particles.e")
    of_jet = jet_particles(file.frame(0), read_deck(folder / "dig" / "deck.xml"))
    assert of_jet.sum() == Run(folder / "straight").summary["particles"] < len(of_jet), (of_jet.sum(), len(of_jet))
    one, other = (Run(folder / name).summary["penetration"] for name in ("dig", "dig_again"))
    assert one["met_target"] and 3e-3 < one["depth"] < 6e-3, one
    assert abs(one["depth"] - other["depth"]) < 0.5e-3, (one, other)  # half a cell
    assert abs(one["channel_depth"] - other["channel_depth"]) < 1.1e-3, (one, other)


def main(barreno):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "rod.xml").write_text(HEAD + ROD)
        (folder / "again.xml").write_text(HEAD + JET)
        for name, ranks in (("straight", 1), ("two", 2), ("killed", 1)):
            must_work(program(barreno, ranks, "run", folder / "rod.xml", "--out", folder / name))
        check_table(Run(folder / "straight"))
        check_short_grid(barreno, folder)
        assert not (folder / "straight" / "depth.csv").exists()  # it meets nothing
        check_target(barreno, folder)
        at_previous(folder / "killed")
        (folder / "killed" / "jet_table.csv").unlink()
        must_work(program(barreno, 3, "resume", folder / "killed"))
        first = (folder / "straight" / "jet_table.csv").read_bytes()
        jet = Run(folder / "straight").summary["formed_jet"]
        for name in ("two", "killed"):
            assert (folder / name / "jet_table.csv").read_bytes() == first, name
            assert Run(folder / name).summary["formed_jet"] == jet, name
        must_work(program(barreno, 1, "run", folder / "again.xml", "--out", folder / "again", "--set", "Time/End Time=14 us"))
        launched = Run(folder / "again").summary["jet"]
        for what in ("mass", "momentum", "kinetic"):
            near(launched[what]["launched"], jet["crossed"][what], 1e-6)
    print("jet monitor: table, ranks, resume and import agree")


if __name__ == "__main__":
    main(sys.argv[1])
