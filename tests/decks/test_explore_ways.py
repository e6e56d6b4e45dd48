#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The explorable view of runs laid by hand, in Chromium without a screen: a jet that flies along -y, a plane that has no mirror, a measured
hole, and a piece of a jet that is thinner than a pixel.

    test_explore_ways.py BARRENO [--pictures FOLDER]

Skipped without Chromium, its driver or Selenium, as test_explore.py.
"""
import pathlib
import sys
import tempfile

import numpy as np
import synthetic_run
from explore_page import View, browser
from matplotlib.colors import to_rgb

from barreno.report.tones import JET
from python_commands import said_by

HOLE, LENGTH = 0.004, 0.03  # radius and depth [m]
OUTER, END = 0.012, 0.05  # of the rock [m]
PROFILE = "depth [mm], radius [mm]\n0, 6\n20, 6\n25, 2\n"
MEASURED = (255, 0, 170)
FEW = 0.01  # of the pixels of two pictures that are the same but for rounding


def turned(block, sign):
    """The same with y in the other direction; corners go around a particle in the same sense."""
    for when in ("start", "end"):
        corners = getattr(block, when) * np.array([1.0, sign])
        setattr(block, when, corners if sign > 0.0 else corners[:, ::-1])
    return block


def rock_with_hole(columns, sign):
    """@param columns  ranges of x beside the hole and below it [m]"""
    beside, below = columns
    places = [synthetic_run.lattice(*ends, 0.0, END) for ends in beside] + [synthetic_run.lattice(*below, LENGTH, END)]
    centres = np.concatenate(places)
    block = synthetic_run.rock(centres)
    block.fields["pressure"] = 1e9 * (centres[:, 1] + 3.0 * np.abs(centres[:, 0]))
    return turned(block, sign)


def laid(folder, sign=1.0, mirrored=True):
    """Run folder with its report."""
    direction = "+y" if sign > 0.0 else "-y"
    if mirrored:
        columns, jet, kind = ([(HOLE, OUTER)], (0.0, HOLE)), (0.0, 0.001), {}
    else:
        columns = [(-OUTER, -HOLE), (HOLE, OUTER)], (-HOLE, HOLE)
        jet, kind = (-0.001, 0.001), {"mode": "plane strain", "lower": "-0.03"}
    blocks = [rock_with_hole(columns, sign), turned(synthetic_run.jet(synthetic_run.lattice(*jet, 0.01, LENGTH), sign * 3000.0), sign)]
    run = synthetic_run.write_run(folder, blocks, depth=LENGTH, direction=direction, **kind)
    profile = folder / "ct.csv"
    profile.write_text(PROFILE)
    said_by("barreno.report", "report", run, "--measured", profile)
    return run


def picture(view, canvas="particles"):
    """(height, width, red green blue)"""
    wide, high, values = view.driver.execute_script("""
        const canvas = document.getElementById(arguments[0]), copy = document.createElement('canvas');
        [copy.width, copy.height] = [canvas.width, canvas.height];
        const pen = copy.getContext('2d', {willReadFrequently: true});
        pen.drawImage(canvas, 0, 0);
        return [copy.width, copy.height, Array.from(pen.getImageData(0, 0, copy.width, copy.height).data)];""", f"explore-{canvas}")
    return np.reshape(values, (high, wide, 4))[..., :3]


def different(one, other):
    """Share of the pixels."""
    assert one.shape == other.shape, (one.shape, other.shape)
    return float((np.abs(one - other).max(axis=-1) > 8).mean())


def scale_of(view):
    """(mm per pixel along, across; y [mm] in the middle) of a view that lies, from what is under the mouse."""
    size, found = view.part("stage").size, []
    for across in (-0.35, -0.25, 0.25, 0.35):
        for along in (-0.1, 0.0, 0.1, 0.25):
            lines = view.hover(across, along)
            if lines["particle"].isdigit():
                value = {line: float(lines[line].split(" ")[0]) for line in ("r", "y")}
                found.append((int(along * size["width"]), abs(int(across * size["height"])), value["y"], value["r"]))
    along, across, y, r = np.transpose(found)
    assert len(found) > 8, found
    line = np.polyfit(along, y, 1)
    return line[0], np.polyfit(across, r, 1)[0], line[1]


def check_measured(view, sign):
    """Its dashes lie at 6 mm on both sides of the axis, down to 20 mm, and end on the axis at 25 mm; a switch takes them away."""
    colour = np.array(MEASURED)
    drawn = lambda: np.abs(picture(view, "marks") - colour).max(axis=-1) < 30  # noqa: E731
    along, across, middle = scale_of(view)
    shown = drawn()
    rows, columns = np.nonzero(shown)
    ratio = shown.shape[1] / view.part("stage").size["width"]  # of the canvas to the window
    y = sign * (middle + along * (columns / ratio - 0.5 * shown.shape[1] / ratio))
    r = across * (rows / ratio - 0.5 * shown.shape[0] / ratio)
    flat = (y > 1.0) & (y < 19.0)
    assert (r[flat] > 0.0).sum() > 50 and (r[flat] < 0.0).sum() > 50, "the dashes are not on both sides"
    assert np.abs(np.abs(r[flat]) - 6.0).max() < 0.5, (r[flat].min(), r[flat].max())
    assert abs(y.max() - 25.0) < 0.5 and abs(y.min()) < 0.5, (y.min(), y.max())
    view.switch("measured (ct.csv)")
    assert drawn().sum() == 0
    view.switch("measured (ct.csv)")
    assert np.array_equal(drawn(), shown)


def check_directions(driver, folder, keep):
    """A jet along -y looks as the same jet along +y: its hole opens at the left."""
    pictures = []
    for name, sign in (("down", 1.0), ("up", -1.0)):
        view = View(driver, laid(folder / name, sign) / "report" / "index.html")
        assert view.lying
        keep(name)
        pictures.append(picture(view))
        lines = [view.hover(0.3, along) for along in (-0.1, 0.25)]
        y = [float(one["y"].split(" ")[0]) for one in lines]
        assert sign * (y[1] - y[0]) > 5.0 and sign * y[0] > 0.0, (sign, y)
        view.click("tip")
        near = view.hover(0.1, 0.2)
        assert near["material"] == "Sandstone" and sign * float(near["y"].split(" ")[0]) > 1e3 * LENGTH, near
        view.click("hole")
        check_measured(view, sign)
    assert different(*pictures) < FEW, different(*pictures)
    assert different(pictures[0], pictures[0][:, ::-1]) > 10.0 * FEW, "the picture is the same in a mirror: the test says nothing"


def check_panels(driver, folder, keep):
    """A plane without a mirror has a panel for each field, with the same particle at the same place of both."""
    view = View(driver, laid(folder / "plane", mirrored=False) / "report" / "index.html")
    keep("plane")
    assert view.lying and view.names()[0].startswith("x [mm]"), view.names()
    view.choose("right", "pressure")
    both = picture(view)
    half = both.shape[0] // 2
    assert different(both[2 : half - 2], both[half + 2 : 2 * half - 2]) < FEW
    found = set()
    for across in (-0.15, 0.15):
        one, other = view.hover(across - 0.25, 0.1), view.hover(across + 0.25, 0.1)
        assert one["particle"].isdigit() and one == other, (one, other)
        found.add(float(one["x"].split(" ")[0]) > 0.0)
    assert found == {True, False}, "both halves of the plane are not there"
    view.choose("right", "density")
    changed = picture(view)
    assert different(changed[: half - 2], both[: half - 2]) == 0.0 and different(changed[half + 2 :], both[half + 2 :]) > FEW


def check_sliver(driver, folder):
    """A piece of the jet that is far thinner than a pixel is a line without gaps, on both sides of the axis."""
    jet = synthetic_run.jet(np.array([[0.002, 0.018]]), 3000.0)
    along, across = np.array([0.0009, 0.005]), np.array([1e-6, 0.0])
    jet.end = jet.end.mean(axis=1) + synthetic_run.SQUARE[None] @ np.array([across, along])
    run = synthetic_run.write_run(folder / "sliver", [rock_with_hole(([(HOLE, OUTER)], (0.0, HOLE)), 1.0), jet], depth=LENGTH)
    said_by("barreno.report", "report", run)
    view = View(driver, run / "report" / "index.html")
    red = np.abs(picture(view) - 255.0 * np.array(to_rgb(JET))).max(axis=-1) < 2.0
    middle = red.shape[0] // 2
    for half in (red[:middle], red[middle:]):
        columns = np.flatnonzero(half.any(axis=0))
        assert len(columns) > 100 and len(columns) == np.ptp(columns) + 1, f"{len(columns)} columns in {columns.min()} to {columns.max()}"
        assert half.sum() < 3 * len(columns), "the line is thick"


def main():
    pictures = pathlib.Path(sys.argv[3]) if sys.argv[2:3] == ["--pictures"] else None
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        with browser(folder / "profile") as driver:
            keep = lambda name: pictures and driver.save_screenshot(str(pictures / f"{name}.png"))  # noqa: E731
            check_directions(driver, folder, keep)
            check_panels(driver, folder, keep)
            check_sliver(driver, folder)
    print("views of jets along -y, of planes without a mirror, of measured holes and of thin pieces are as they should be")


if __name__ == "__main__":
    main()
