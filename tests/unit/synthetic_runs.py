# SPDX-License-Identifier: BSD-3-Clause
"""Run folders without a run, for the tests of what reads them."""
import json

DECK = """<!-- Effective deck of a.xml -->
<ParameterList name="Barreno">
  <Parameter name="Title" type="string" value="synthetic"/>
  <ParameterList name="Bodies">
    <ParameterList name="Rock"><Parameter name="Material" type="string" value="Sandstone"/></ParameterList>
    <ParameterList name="Casing"><Parameter name="Material" type="string" value="Steel"/></ParameterList>
  </ParameterList>
  <ParameterList name="Confinement"><Parameter name="Pressure" type="double" value="{pressure}"/></ParameterList>
  <ParameterList name="Jet"><Parameter name="Slugs" type="string" value="{slugs}"/></ParameterList>
</ParameterList>
"""


def summary_of(depth, **more):
    return {
        "deck": "a.xml", "version": "0.1.0", "mode": "axisymmetric", "finished": True, "reason": "", "exit_code": 0, "time": 4e-5,
        "steps": 10,
        "penetration": {"met_target": depth is not None, "depth": depth, "channel_depth": 0.02},
        "balances": {"energy": {"error": 1e-6, "kinetic": 0.0}}, **more,
    }  # fmt: skip


def make_run(folder, pressure=0.0, depth=0.03, slugs="1", **more):
    """A folder with deck.xml, summary.json and depth.csv."""
    folder.mkdir(parents=True)
    (folder / "deck.xml").write_text(DECK.format(pressure=pressure, slugs=slugs))
    (folder / "summary.json").write_text(json.dumps(summary_of(depth, **more)))
    (folder / "depth.csv").write_text(f"# SI units\ntime,depth,channel_depth\n0,0,0\n4e-05,{depth or 0.0},0.02\n5e-0")
    return folder
