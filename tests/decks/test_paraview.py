#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The script that a report has for ParaView, in ParaView itself, off-screen: both sides are there, the colours are those of the report, the
map is the same on both sides, balls cover what they should, and a state file brings back the time. Skipped where there is no pvpython;
without a display by Xvfb.

    test_paraview.py BARRENO
"""
import ast
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
SHORT = {"Time/End Time": "12 us", "Output/Field Interval": "4 us", "Output/Checkpoint Wall Interval": "0 s"}
PRESSURE = 10.0 * 6.894757e6  # Pa, of the deck
COVERED = 0.7, 1.05  # of what shapes cover: ParaView's balls are octagons, 2 sqrt(2) / 4 = 0.707 of the square that they are as wide as
ALIKE = 0.02  # share of pixels in which the halves of a map may differ: outlines do not fall on the same pixels
LOAD = """
from paraview.simple import GetActiveView, GetAnimationScene, LoadState, Render, SaveScreenshot, _DisableFirstRenderCameraReset
_DisableFirstRenderCameraReset()  # as scripts of ParaView itself begin, which keeps the state's camera
LoadState("a.pvsm")
view = GetActiveView()
Render(view)
SaveScreenshot("loaded.png", view, ImageResolution=SHAPE)
print("time", GetAnimationScene().AnimationTime)
"""


def pvpython(folder, *words):
    display = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a", "-s", "-screen 0 1600x1400x24 -noreset"]
    result = subprocess.run([*display, "pvpython", "--force-offscreen-rendering", *map(str, words)], cwd=folder, capture_output=True,
        text=True, timeout=600, check=False)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stdout}{result.stderr}"
    return result.stdout


def pixels(file):
    with Image.open(file) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def covered_by(picture):
    """Whether a pixel differs from the background, which the first one has."""
    return (np.abs(picture - picture[0, 0]) > 2).any(axis=2)


def rock_of(picture):
    """(rows, columns) of the largest block of coloured pixels: the particles, without the bars above and below them."""
    covered = covered_by(picture)
    rows = np.flatnonzero(covered.mean(axis=1) > 0.5)
    rows = slice(rows[0], rows[-1] + 1)
    columns = np.flatnonzero(covered[rows].mean(axis=0) > 0.5)
    return rows, slice(columns[0], columns[-1] + 1)


def halves(picture):
    """The picture lies: the left half is the upper one, and the lower one is mirrored here."""
    rows, columns = rock_of(picture)
    upper, lower = np.array_split(picture[rows, columns], 2, axis=0)
    height = min(len(upper), len(lower))
    return upper[-height:], lower[:height][::-1]


def constants_of(script):
    """The values at the head of the script."""
    return {name.strip(): ast.literal_eval(value.strip()) for name, equals, value in (line.partition("=") for line in
        script.read_text().partition("\n# Of a run that was moved")[0].splitlines()) if equals and name.strip().isupper()}


def check_colours(picture, found):
    """Rock that no wave has reached has the report's colours of the initial values, the jet is red, and loose pieces in the hole have the
    colour of rubble; no light changes them."""
    upper, lower = halves(picture)
    for part, field, value in ((upper, "LEFT", PRESSURE), (lower, "RIGHT", 0.0)):
        points = np.array(found[field][2]).reshape(-1, 4)
        own = [255.0 * np.interp(value, points[:, 0], points[:, axis]) for axis in (1, 2, 3)]
        shown = part[len(part) // 2, int(0.95 * part.shape[1])]
        assert np.abs(shown - own).max() <= 6.0, f"{field}: {shown} in the picture, {own} in the report"
    for colour, least in ((found["JET_COLOUR"], 100), (found["WITHOUT"], 100), (found["RUBBLE_COLOUR"], 10)):
        alike = (np.abs(picture - 255.0 * np.array(colour)).max(axis=2) <= 2.0).sum()
        assert alike > least, f"{alike} pixels have the colour {colour}"


def check_fields(folder, script):
    """Other colours at the left than at the right. @return pixels that the particles cover"""
    pvpython(folder, script, "--save", "fields.png")
    picture, found = pixels(folder / "fields.png"), constants_of(script)
    assert found["LYING"] and list(picture.shape[1::-1]) == found["SHAPE"], (picture.shape, found["SHAPE"])
    left, right = halves(picture)
    unlike = (np.abs(left - right).max(axis=2) > 30).mean()
    assert unlike > 0.5, f"two fields are alike in {1.0 - unlike:.2f} of the pixels"
    check_colours(picture, found)
    return int(covered_by(picture)[rock_of(picture)].sum())


def check_map(folder, script):
    pvpython(folder, script, "--map", "--save", "map.png")
    picture = pixels(folder / "map.png")
    left, right = halves(picture)
    unlike = (np.abs(left - right).max(axis=2) > 60).mean()
    assert unlike < ALIKE, f"the halves of the map differ in {unlike:.3f} of the pixels"
    assert len(np.unique(left.reshape(-1, 3), axis=0)) > 100, "the map has hardly any colour"


def check_balls(folder, script, covered):
    pvpython(folder, script, "--glyphs", "--save", "balls.png")
    picture = pixels(folder / "balls.png")
    share = int(covered_by(picture)[rock_of(picture)].sum()) / covered
    assert COVERED[0] < share < COVERED[1], f"balls cover {share:.2f} of what shapes cover"


def check_state(folder, script):
    """A state file shows the same picture at the same time."""
    pvpython(folder, script, "--time", "4e-6", "--state", "a.pvsm", "--save", "saved.png")
    (folder / "load.py").write_text(LOAD.replace("SHAPE", repr(constants_of(script)["SHAPE"])))
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
