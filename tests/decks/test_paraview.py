#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The script that a report has for ParaView, in ParaView itself, off-screen: both sides are there, the map is the same on both, balls cover
what shapes cover, and a state file brings back the time. Skipped where there is no pvpython; without a display by Xvfb.

    test_paraview.py BARRENO
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

from tools.runs import run_deck

SKIPPED = 77  # what ctest counts as skipped
SHORT = {"Time/End Time": "8 us", "Output/Field Interval": "4 us", "Output/Checkpoint Wall Interval": "0 s"}
COVERED = 0.95  # of what shapes cover
ALIKE = 0.02  # share of pixels in which the halves of a map may differ: outlines do not fall on the same pixels
LOAD = """
from paraview.simple import GetActiveView, GetAnimationScene, LoadState, Render, SaveScreenshot
LoadState("a.pvsm")
view = GetActiveView()
Render(view)
SaveScreenshot("loaded.png", view, ImageResolution=[900, 1200])
print("time", GetAnimationScene().AnimationTime)
"""


def pvpython(folder, *words):
    display = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]
    result = subprocess.run([*display, "pvpython", "--force-offscreen-rendering", *map(str, words)], cwd=folder, capture_output=True,
        text=True, timeout=600, check=False)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stdout}{result.stderr}"
    return result.stdout


def pixels(file):
    with Image.open(file) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def rock_of(picture):
    """(rows, columns) of the largest block of coloured pixels: the particles, without the bars at the right of them."""
    covered = (picture < 250).any(axis=2)
    columns = covered.mean(axis=0) > 0.5
    first = int(np.argmax(columns))
    last = first + int(np.argmin(columns[first:])) if not columns[first:].all() else len(columns)
    rows = np.flatnonzero(covered[:, first:last].mean(axis=1) > 0.5)
    return slice(rows[0], rows[-1] + 1), slice(first, last)


def check_fields(folder, script):
    """Other colours at the left than at the right."""
    pvpython(folder, script, "--save", "fields.png")
    picture = pixels(folder / "fields.png")
    rows, columns = rock_of(picture)
    left, right = np.array_split(picture[rows, columns], 2, axis=1)
    width = min(left.shape[1], right.shape[1])
    unlike = (np.abs(left[:, -width:] - right[:, :width][:, ::-1]).max(axis=2) > 30).mean()
    assert unlike > 0.5, f"two fields are alike in {1.0 - unlike:.2f} of the pixels"
    return int((picture[rows, columns] < 250).any(axis=2).sum())


def check_map(folder, script):
    pvpython(folder, script, "--map", "--save", "map.png")
    picture = pixels(folder / "map.png")
    rows, columns = rock_of(picture)
    left, right = np.array_split(picture[rows, columns], 2, axis=1)
    width = min(left.shape[1], right.shape[1])
    unlike = (np.abs(left[:, -width:] - right[:, :width][:, ::-1]).max(axis=2) > 60).mean()
    assert unlike < ALIKE, f"the halves of the map differ in {unlike:.3f} of the pixels"
    assert len(np.unique(picture[rows, columns].reshape(-1, 3), axis=0)) > 100, "the map has hardly any colour"


def check_balls(folder, script, covered):
    pvpython(folder, script, "--glyphs", "--save", "balls.png")
    picture = pixels(folder / "balls.png")
    rows, columns = rock_of(picture)
    share = int((picture[rows, columns] < 250).any(axis=2).sum()) / covered
    assert share > COVERED, f"balls cover {share:.2f} of what shapes cover"


def check_state(folder, script):
    """A state file shows the same picture at the same time."""
    pvpython(folder, script, "--time", "4e-6", "--state", "a.pvsm", "--save", "saved.png")
    (folder / "load.py").write_text(LOAD)
    said = pvpython(folder, "load.py")
    time = float(said.split("time")[1].split()[0])
    assert abs(time - 4e-6) < 2e-7, said
    unlike = (np.abs(pixels(folder / "saved.png") - pixels(folder / "loaded.png")).max(axis=2) > 30).mean()
    assert unlike < ALIKE, f"the picture of the state differs in {unlike:.3f} of the pixels"


def main():
    missing = [name for name in ("pvpython", *([] if os.environ.get("DISPLAY") else ["xvfb-run"])) if shutil.which(name) is None]
    if missing:
        print(f"skipped: there is no {missing[0]} (Debian packages paraview, python3-paraview and xvfb)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        run = run_deck(str(pathlib.Path(sys.argv[1]).resolve()), "perforation_quick.xml", SHORT, folder=folder / "run")
        words = [sys.executable, "-m", "barreno.report", "report", str(run.folder), "--right", "plastic_volume_strain"]
        subprocess.run(words, check=True, capture_output=True)
        script = run.folder / "report" / "paraview" / "view.py"
        covered = check_fields(folder, script)
        check_map(folder, script)
        check_balls(folder, script, covered)
        check_state(folder, script)
    print("the report's script does in ParaView what docs/report.md says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
