#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that a particles.e is what docs promise: blocks, ids, status, names and displacements.

    check_exodus.py FILE [--blocks NAME,NAME,...] [--steps N]    exit code 1 with a sentence if not
"""
import argparse
import sys

import numpy as np
from netCDF4 import Dataset, chartostring

COMMON = (
    "status velocity_x velocity_y stress_xx stress_yy stress_zz stress_xy pressure shear_stress "
    "density volume_ratio viscous_pressure"
).split()
IN_SPACE = "velocity_z stress_yz stress_zx".split()


class Wrong(Exception):
    """What is wrong, as a sentence."""


def require(condition, sentence):
    if not condition:
        raise Wrong(sentence)


def names(data, key):
    if key not in data.variables:
        return []
    texts = np.atleast_1d(chartostring(data.variables[key][:]))
    return [str(text).split("\0")[0].strip() for text in texts]


def size(data, dimension):
    return len(data.dimensions[dimension]) if dimension in data.dimensions else 0


def axes(data):
    return "xyz"[: size(data, "num_dim")]


def check_layout(data, blocks):
    require(data.data_model == "NETCDF3_64BIT_OFFSET", f"The format is {data.data_model}.")
    require(data.floating_point_word_size == 8, "Reals are not stored in 8 bytes.")
    found = names(data, "eb_names")
    if blocks:
        require(found == blocks, f"Blocks are {found}, not {blocks}.")
    ids = data.variables["elem_num_map"][:]
    require(len(np.unique(ids)) == len(ids), "Element ids are not unique.")
    require(np.all(ids > 0), "Element ids are not positive.")
    per_element = size(data, "num_nodes") // max(1, len(ids))
    require(per_element in (1, 4, 8), f"There are {per_element} nodes per element.")
    nodes = data.variables["node_num_map"][:]
    corners = per_element * (np.repeat(ids, per_element).astype(np.int64) - 1)
    corners += np.tile(np.arange(per_element), len(ids)) + 1
    require(np.array_equal(nodes, corners), "Node ids do not follow from the element ids.")
    begin = 0
    for b in range(size(data, "num_el_blk")):
        count = size(data, f"num_el_in_blk{b + 1}")
        part = ids[begin : begin + count]
        require(np.all(np.diff(part) > 0), f"Ids in block {b + 1} do not ascend.")
        begin += count
    require("info_records" in data.variables, "The deck is not in the information records.")
    require("qa_records" in data.variables, "There is no QA record.")
    require(
        names(data, "name_nod_var") == [f"displacement_{axis}" for axis in axes(data)],
        "Nodal variables are not the displacements.",
    )


def check_step(data, step):
    """Returns the status of all elements at this step."""
    variables = names(data, "name_elem_var")
    status = []
    for b in range(size(data, "num_el_blk")):
        count = size(data, f"num_el_in_blk{b + 1}")
        if count == 0:
            continue
        values = {
            name: data.variables[f"vals_elem_var{i + 1}eb{b + 1}"][step]
            for i, name in enumerate(variables)
            if f"vals_elem_var{i + 1}eb{b + 1}" in data.variables
        }
        where = f"in block {b + 1} at step {step + 1}"
        for name in COMMON + (IN_SPACE if len(axes(data)) == 3 else []):
            require(name in values, f"Variable {name} is missing {where}.")
        for name, array in values.items():
            require(np.all(np.isfinite(array)), f"{name} is not finite {where}.")
        alive = values["status"] == 1.0
        require(np.all(alive | (values["status"] == 0.0)), f"status is not 0 or 1 {where}.")
        require(np.all(values["density"][alive] > 0.0), f"density is not positive {where}.")
        require(np.all(values["density"][~alive] == 0.0), f"an absent particle has values {where}.")
        mean = -(values["stress_xx"] + values["stress_yy"] + values["stress_zz"]) / 3.0
        scale = np.abs(values["pressure"]).max() + 1e-300
        require(
            np.all(np.abs(mean - values["pressure"]) <= 1e-9 * scale),
            f"pressure is not minus the mean stress {where}.",
        )
        status.append(alive)
    status = np.concatenate(status)
    check_displacement(data, step, status)
    return status


def check_displacement(data, step, status):
    """What has not moved yet is where it began; what is alive has an area or a volume."""
    elements = len(status)
    corners = []
    for index, axis in enumerate(axes(data), 1):
        start = data.variables["coord" + axis][:].reshape(elements, -1)
        moved = data.variables[f"vals_nod_var{index}"][step].reshape(elements, -1)
        require(np.all(np.isfinite(moved)), f"Displacements are not finite at step {step + 1}.")
        if step == 0:
            absent = ~status
            require(np.all(moved[absent] == 0.0), "A particle that does not exist yet has moved.")
            size_of_start = np.ptp(start[absent], axis=1) if absent.any() else np.zeros(1)
            require(np.all(size_of_start == 0.0), "A particle that does not exist yet has a size.")
        corners.append(start + moved)
    if corners[0].shape[1] == 4:
        x, y = corners
        area = 0.5 * ((x[:, 2] - x[:, 0]) * (y[:, 3] - y[:, 1]))
        area -= 0.5 * ((x[:, 3] - x[:, 1]) * (y[:, 2] - y[:, 0]))
        require(np.all(area[status] > 0.0), f"Corners are not counter-clockwise at step {step + 1}.")
    if corners[0].shape[1] == 8:
        x = np.stack(corners, axis=-1)
        edges = [x[:, corner] - x[:, 0] for corner in (1, 3, 4)]
        volume = np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])
        require(np.all(volume[status] > 0.0), f"Hexahedra are turned inside out at step {step + 1}.")


def check(file, blocks=None, steps=None):
    """@return a sentence on what is in the file; Wrong says what is not as it should be"""
    try:
        data = Dataset(file)
    except OSError as error:
        raise Wrong(f"It cannot be opened ({error}).") from error
    data.set_auto_mask(False)
    check_layout(data, blocks)
    times = data.variables["time_whole"][:]
    require(len(times) > 0, "There is no time step.")
    require(np.all(np.diff(times) > 0.0), "Times do not ascend.")
    if steps is not None:
        require(len(times) == steps, f"There are {len(times)} time steps.")
    status = check_step(data, 0)
    gone = np.zeros_like(status)
    for step in range(1, len(times)):
        before, status = status, check_step(data, step)
        gone |= before & ~status
        require(not np.any(gone & status), f"A removed particle is back at step {step + 1}.")
    return f"{file}: {len(times)} steps, {int(status.sum())} of {len(status)} particles alive"


def main():
    parser = argparse.ArgumentParser(description="Check a particles.e.")
    parser.add_argument("file")
    parser.add_argument("--blocks", help="expected block names, in order")
    parser.add_argument("--steps", type=int, help="expected number of time steps")
    options = parser.parse_args()
    try:
        print(check(options.file, options.blocks.split(",") if options.blocks else None, options.steps))
    except Wrong as wrong:
        print(f"{options.file}: {wrong}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
