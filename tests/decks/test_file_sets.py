#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Particle Files = "one per rank": the set is one data set for readers, and holds what the one file holds, bit for bit.

    test_file_sets.py BARRENO
"""
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import numpy as np

TESTS = pathlib.Path(__file__).resolve().parents[1]
TOOLS = TESTS.parent / "verification" / "tools"
sys.path[:0] = [str(TOOLS)]

from join_exodus import files_of, join  # noqa: E402
from netCDF4 import Dataset  # noqa: E402
from resumed import at_previous, different_fields, lines_of, must_work, program, stopped_run  # noqa: E402
from runs import DECKS, mpi_environment  # noqa: E402
from small_decks import write_deck  # noqa: E402

DECK = str(DECKS / "perforation_quick.xml")
SHORT = ("--set", "Time/End Time=15 us", "--set", "Output/Field Interval=5 us", "--set", "Output/Checkpoint Steps=150")
PER_RANK = ("--set", "Output/Particle Files=one per rank")


def run(barreno, ranks, folder, *words, deck=DECK):
    must_work(program(barreno, ranks, "run", deck, "--out", folder, *words))
    return folder


def set_names(folder):
    return sorted(path.name for path in folder.glob("particles.e*"))


def check_same(one, folder, ranks):
    """The set has its names and no others, and joined it is the one file, bit for bit."""
    assert set_names(folder) == [f"particles.e.{ranks}.{r}" for r in range(ranks)], set_names(folder)
    whole = folder / "joined"
    whole.mkdir()
    join(files_of(folder / "particles.e"), whole / "particles.e")
    different = different_fields(one, whole)
    assert not different, f"{folder.name}: {different} differ from the one file"
    with Dataset(one / "particles.e") as a, Dataset(whole / "particles.e") as b:
        assert set(a.variables) == set(b.variables), set(a.variables) ^ set(b.variables)
        assert all(len(a.dimensions[name]) == len(b.dimensions[name]) for name in a.dimensions)


def check_nemesis(folder, ranks):
    """What the files say of the set adds up, and their ids are the set's, each once."""
    ids, elements = [], 0
    for number, file in enumerate(files_of(folder / "particles.e")):
        with Dataset(file) as data:
            mine = len(data.dimensions["num_elem"]) if "num_elem" in data.dimensions else 0
            assert len(data.dimensions["num_processors"]) == ranks
            assert len(data.dimensions["num_procs_file"]) == 1
            total = len(data.dimensions["num_elems_global"])
            assert total == data["el_blk_cnt_global"][:].sum()
            if mine:
                assert np.array_equal(data[f"elem_mapi"][:], np.arange(1, mine + 1)), "inner elements are not all"
                ids.append(np.asarray(data["elem_num_map"][:]))
            elements += mine
    ids = np.concatenate(ids)
    assert elements == total == len(np.unique(ids)) == len(ids)


def values_of(blocks, name):
    """By id the values of one variable, and of all corners, of a VTK data set of blocks."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    found = {}
    for block in blocks:
        cells, ids = block.GetCellData(), block.GetCellData().GetArray("object_id") or block.GetCellData().GetArray("ids")
        ids = cells.GetArray("ids") or cells.GetArray("GlobalElementId") or ids
        corners = vtk_to_numpy(block.GetPoints().GetData()).reshape(block.GetNumberOfCells(), -1)
        for number, value, place in zip(vtk_to_numpy(ids), vtk_to_numpy(cells.GetArray(name)), corners):
            assert number not in found, f"{number} is there twice"
            found[int(number)] = (float(value), *map(float, place))
    return found


def leaves(data):
    """The grids of a data set, whatever groups hold them, those without cells left out."""
    if data is None:
        return []
    if data.IsA("vtkPartitionedDataSetCollection"):
        parts = [data.GetPartitionedDataSet(i) for i in range(data.GetNumberOfPartitionedDataSets())]
        return [grid for part in parts for grid in leaves(part)]
    if data.IsA("vtkPartitionedDataSet"):
        return [grid for i in range(data.GetNumberOfPartitions()) for grid in leaves(data.GetPartition(i))]
    if data.IsA("vtkMultiBlockDataSet"):
        return [grid for i in range(data.GetNumberOfBlocks()) for grid in leaves(data.GetBlock(i))]
    return [data] if data.GetNumberOfCells() > 0 else []


def read_whole(files):
    """The last time step by ParaView's reader of .e files, given the whole set."""
    from vtkmodules.vtkIOIOSS import vtkIOSSReader

    reader = vtkIOSSReader()
    for file in files:
        reader.AddFileName(str(file))
    reader.UpdateInformation()
    return reader
