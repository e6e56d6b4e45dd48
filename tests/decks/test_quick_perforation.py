#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The quick perforation on one and two ranks: same file, readable by ParaView's reader, a report with pictures, and the depths, radii
and energies that it had before.

    test_quick_perforation.py BARRENO
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from tools.penetration import pinned
from tools.runs import run_deck

TESTS = pathlib.Path(__file__).resolve().parents[1]
TOOLS = TESTS.parent / "verification" / "tools"
DECK = "perforation_quick.xml"


def script(path, *arguments):
    result = subprocess.run([sys.executable, path, *arguments], capture_output=True, text=True)
    assert result.returncode == 0, f"{path.name}: {result.stdout}{result.stderr}"
    return result.stdout


def read_with_vtk(path):
    """What ParaView shows: points as moved, and all particle variables, at the last time."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.SetApplyDisplacements(True)
    reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
    first, last = reader.GetTimeStepRange()
    reader.SetTimeStep(last)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    out = {}
    for i in range(blocks.GetNumberOfBlocks()):
        block = blocks.GetBlock(i)
        data = block.GetCellData()
        arrays = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
        name = blocks.GetMetaData(i).Get(blocks.NAME())
        out[name] = (vtk_to_numpy(block.GetPoints().GetData()), block.GetNumberOfCells(), arrays)
    return last - first + 1, out


def check_picture_data(run):
    steps, blocks = read_with_vtk(run.folder / "particles.e")
    assert steps >= 3, f"VTK sees {steps} time steps"
    assert len(blocks) == 3, f"VTK sees the blocks {sorted(blocks)}"
    alive = 0
    for name, (points, cells, arrays) in blocks.items():
        assert cells > 0 and len(points) == 4 * cells, f"block {name} has {cells} cells and {len(points)} points"
        for key in ("status", "pressure", "shear_stress", "density", "velocity"):
            # VTK joins velocity_x and velocity_y into one vector.
            assert any(key in array for array in arrays), f"block {name} has no {key}: {sorted(arrays)}"
        there = np.repeat(arrays["status"] > 0.5, 4)
        assert np.all(np.isfinite(points[there])), f"block {name} has points that are not finite"
        assert np.all(np.abs(points[there]) < 1.0), f"block {name} has points outside the grid"
        alive += int((arrays["status"] > 0.5).sum())
    assert alive == run.summary["particles"], f"VTK sees {alive} particles, the summary {run.summary['particles']}"


def check_report(run):
    script(TOOLS / "report.py", run.folder)
    page = run.folder / "report" / "index.md"
    pictures = list((run.folder / "report").glob("*.png"))
    assert page.exists() and len(pictures) >= 3, f"the report has {len(pictures)} pictures"
    for picture in pictures:
        assert picture.stat().st_size > 5000, f"{picture.name} is empty"
        assert picture.name in page.read_text(), f"{picture.name} is not shown"


def check_last_lines(run):
    """The hole and the rock around it, as summary.json has them."""
    text, found = (run.folder / "run.log").read_text(), run.summary["penetration"]
    entrance, rock = found["entrance_diameter_in_body"], found["zones_in_body"]["Rock"]
    assert f"hole: {1e6 * found['channel_volume']:.3g} cm3" in text, text[-2000:]
    for body, width in entrance.items():
        assert f" {1e3 * width:.2f} mm in {body}" in text, text[-2000:]
    assert f"crushed from {1e3 * rock['crushed_from']:.2f} to {1e3 * rock['crushed_to']:.2f} mm from the axis" in text, text[-2000:]
    assert f"; skin {rock['skin']:.2g} by its porosity" in text, text[-2000:]


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        one, two = (run_deck(sys.argv[1], DECK, ranks=ranks, folder=folder / str(ranks)) for ranks in (1, 2))
        for what, off, tolerance in pinned(one, DECK):
            assert abs(off) <= tolerance, f"{what}: {off:+.2%}, more than {tolerance:.2%}"
        for run in (one, two):
            script(TESTS / "scripts" / "check_exodus.py", run.folder / "particles.e")
        same = TESTS / "scripts" / "same.exodiff"
        script(TESTS / "scripts" / "exodiff_lite.py", "-f", same, one.folder / "particles.e", two.folder / "particles.e")
        for table in ("depth.csv",):
            assert (one.folder / table).read_text() == (two.folder / table).read_text(), f"{table} differs between rank counts"
        check_last_lines(one)
        check_picture_data(two)
        check_report(two)


if __name__ == "__main__":
    main()
