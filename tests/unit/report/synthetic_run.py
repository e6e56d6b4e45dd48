# SPDX-License-Identifier: BSD-3-Clause
"""Run folders of particles that were laid by hand, so that what a report should find is known exactly."""
import dataclasses
import json

import numpy as np
from netCDF4 import Dataset

CELL = 1e-3  # m; two particles per cell and direction
PER_CELL = 2
SQUARE = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])

DECK = """<ParameterList name="Barreno">
  <ParameterList name="Grid"><Parameter name="Mode" value="{mode}"/><Parameter name="Cell Size" value="0.001"/>
    <Parameter name="Lower" value="{{{lower}, {ends[0]}}}"/><Parameter name="Upper" value="{{0.03, {ends[1]}}}"/></ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Tungsten"><Parameter name="Model" value="Johnson-Cook"/></ParameterList>
    <ParameterList name="Sandstone"><Parameter name="Model" value="Arenisca"/><Parameter name="PEAKI1" value="9.36e6"/>
      <Parameter name="FSLOPE" value="0.549"/><Parameter name="STREN" value="128.5e6"/><Parameter name="YSLOPE" value="0.0724"/>
      <Parameter name="CR" value="0.593"/><Parameter name="p0_crush_curve" value="-1.2244e9"/><Parameter name="p1_crush_curve" value="5.95e-10"/>
      <Parameter name="p3_crush_curve" value="0.2231"/></ParameterList>
  </ParameterList>
  <ParameterList name="Bodies"><ParameterList name="Rock"><Parameter name="Material" value="Sandstone"/>
    <Parameter name="Particles Per Cell" value="2"/></ParameterList></ParameterList>
  <ParameterList name="Jet"><Parameter name="Material" value="Tungsten"/><Parameter name="Direction" value="{direction}"/>
    <Parameter name="Slugs" value="2x5:{{0, 8000, 0.001, 0.002, 17600, 1e-6, 6000, 0.001, 0.002, 17600}}"/></ParameterList>
</ParameterList>
"""


@dataclasses.dataclass
class Block:
    """A material: corners at the start and at the end, and fields at the end."""

    name: str
    start: np.ndarray  # (particle, corner, xy)
    end: np.ndarray
    fields: dict
    launched: bool = False  # not there at the start
    radius: np.ndarray = None  # of plain points


def squares(centres, half):
    return centres[:, None, :] + half * SQUARE


def lattice(r_from, r_to, y_from, y_to):
    """Centres of particles in a rectangle, whose edges they fit."""
    size = CELL / PER_CELL
    axis = lambda low, high: low + size * (np.arange(round((high - low) / size)) + 0.5)  # noqa: E731
    r, y = np.meshgrid(axis(r_from, r_to), axis(y_from, y_to))
    return np.stack([r.ravel(), y.ravel()], axis=1)


def moved(centres, motion, step=1e-7):
    """Corners as a run draws them: the centre where the motion takes it, edges by the deformation gradient there."""
    half = 0.5 * CELL / PER_CELL
    at = motion(centres)
    along = [(motion(centres + step * axis) - motion(centres - step * axis)) / (2.0 * step) for axis in np.eye(2)]
    return at[:, None, :] + half * sum(SQUARE[:, i][None, :, None] * along[i][:, None, :] for i in (0, 1))


def stresses(p, q):
    """Fields of rock in triaxial compression along y: a pressure and sqrt(J2)."""
    side, along = q / np.sqrt(3.0) - p, -2.0 * q / np.sqrt(3.0) - p
    return {"pressure": p, "shear_stress": q + 0.0 * p, "stress_xx": side, "stress_yy": along, "stress_zz": side, "stress_xy": 0.0 * p}


def rock(centres, end=None, e=0.0, ratio=1.0):
    ones = np.ones(len(centres))
    fields = {
        **stresses(1e8 * ones, 5e7), "density": 2120.0 * ones, "volume_ratio": ratio * ones, "velocity_x": 0.0 * ones,
        "velocity_y": 0.0 * ones, "plastic_volume_strain": e * ones, "equivalent_plastic_strain": 0.1 * ones,
    }  # fmt: skip
    start = squares(centres, 0.5 * CELL / PER_CELL)
    return Block("Sandstone", start, start if end is None else end, fields)


def jet(centres, speed, half=0.25 * CELL / PER_CELL):
    ones = np.ones(len(centres))
    fields = {
        **stresses(0.0 * ones, 0.0), "density": 17600.0 * ones, "volume_ratio": ones, "velocity_x": 0.0 * ones,
        "velocity_y": speed * ones, "plastic_strain": ones,
    }  # fmt: skip
    return Block("Tungsten", squares(np.zeros_like(centres), 0.0), squares(centres, half), fields, launched=True)


def write_names(data, key, dimension, names):
    variable = data.createVariable(key, "S1", (dimension, "len_name"))
    for i, name in enumerate(names):
        variable[i, : len(name)] = np.array(list(name), "S1")


def write_particles(file, blocks, times=(0.0, 1e-5)):
    """particles.e with two times."""
    names = list(dict.fromkeys(["status", *(name for block in blocks for name in block.fields)]))
    corners = blocks[0].start.shape[1]
    with Dataset(file, "w", format="NETCDF3_64BIT_OFFSET") as data:
        counts = [len(block.start) for block in blocks]
        for name, size in {"time_step": None, "len_name": 65, "num_dim": 2, "num_elem": sum(counts), "num_nodes": corners * sum(counts),
                           "num_el_blk": len(blocks), "num_elem_var": len(names)}.items():  # fmt: skip
            data.createDimension(name, size)
        data.createVariable("time_whole", "f8", ("time_step",))[:] = times
        write_names(data, "name_elem_var", "num_elem_var", names)
        write_names(data, "eb_names", "num_el_blk", [block.name for block in blocks])
        start, end = (np.concatenate([getattr(block, when).reshape(-1, 2) for block in blocks]) for when in ("start", "end"))
        for i, axis in enumerate("xy"):
            data.createVariable(f"coord{axis}", "f8", ("num_nodes",))[:] = start[:, i]
            data.createVariable(f"vals_nod_var{i + 1}", "f8", ("time_step", "num_nodes"))[:] = [0.0 * end[:, i], end[:, i] - start[:, i]]
        for b, block in enumerate(blocks, 1):
            data.createDimension(f"num_el_in_blk{b}", counts[b - 1])
            for i, name in enumerate(names, 1):
                if name != "status" and name not in block.fields:
                    continue
                values = np.ones(counts[b - 1]) if name == "status" else block.fields[name]
                first = 0.0 * values if block.launched else values
                data.createVariable(f"vals_elem_var{i}eb{b}", "f8", ("time_step", f"num_el_in_blk{b}"))[:] = [first, values]
            if block.radius is not None:
                data.createDimension(f"num_att_in_blk{b}", 1)
                data.createVariable(f"attrib{b}", "f8", (f"num_el_in_blk{b}", f"num_att_in_blk{b}"))[:] = block.radius[:, None]


HISTORY = (
    "time,step,particles,kinetic,elastic,plastic,viscous,boundary_work,launched_kinetic,stress_integration,transfer,removed_kinetic,"
    "energy_error,mass_error,momentum_error,removed_left_grid,held"
)


def write_run(folder, blocks, depth=0.02, mode="axisymmetric", lower="0", direction="+y"):
    """A whole run folder. Its hole is half a cell wider in depth.csv, which counts whole cells."""
    ends = (-0.01, 0.06) if direction == "+y" else (-0.06, 0.01)
    folder.mkdir(parents=True, exist_ok=True)
    write_particles(folder / "particles.e", blocks)
    (folder / "deck.xml").write_text(DECK.format(mode=mode, lower=lower, ends=ends, direction=direction))
    (folder / "history.csv").write_text(f"{HISTORY}\n0,0,9,0,1,0,0,0,0,0,0,0,0,0,0,0,0\n1e-5,10,9,60,10,20,0,0,100,-4,-6,0,1e-5,0,0,0,0\n")
    rows = "\n".join(f"{1e-6 * i},{depth * i / 10},{round(depth * i / 10, 3)},0.003,0.001,3000" for i in range(11))
    (folder / "depth.csv").write_text("# depths from the outer face at y = 0 "
        f"along\ntime,depth,channel_depth,channel_radius_mid,jet_mass_inside,tip_velocity\n{rows}\n")
    energy = {"stress_integration_share": -0.04, "transfer_share": -0.06}
    (folder / "summary.json").write_text(json.dumps({"title": "By <hand>", "mode": mode, "finished": True, "balances": {"energy": energy}}))
    return folder
