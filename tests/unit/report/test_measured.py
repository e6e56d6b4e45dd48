#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measured holes: volumes and differences of holes whose measures are known exactly, CT slices of a cone, a page that has them, and the
sentence of every file that is none."""
import contextlib
import io
import json
import pathlib
import tempfile

import numpy as np
from PIL import Image

from barreno.report import command
from barreno.report.hole import Hole
from barreno.report.measured_file import read_measured
from barreno.report.measured_section import differences, volume_below
from synthetic_run import CELL, jet, lattice, rock, write_run

MM = 1e-3
CYLINDER, CONE, WIDE = 40.0, 24.0, 6.0  # mm
VOLUME = np.pi * WIDE**2 * (CYLINDER + CONE / 3.0) * MM**3
NOTE = {"pixel": "0.2 mm", "spacing": "0.5 mm", "first": "3 mm", "threshold": 100, "hole": "dark"}


def close(one, other, share=1e-12):
    assert abs(one - other) <= share * max(abs(one), abs(other), 1e-30), (one, other)


def written(folder, name, content):
    file = folder / name
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return str(file)


def check_exact_volume(folder):
    """A cylinder with a cone below it, in three units, as radius or diameter, with commas or semicolons."""
    rows = [(0.0, WIDE), (CYLINDER, WIDE), (CYLINDER + CONE, 0.0)]
    for name, head, depth, radius, sign in (
        ("a.csv", "depth [mm], radius [mm]", 1.0, 1.0, ","), ("b.csv", "Depth (in);Diameter (mm)", 1.0 / 25.4, 2.0, ";"),
        ("c.csv", "radius [m],depth [m]", MM, MM, ","),
    ):  # fmt: skip
        cells = [(d * depth, r * radius) for d, r in rows]
        text = "\n".join([head, *(sign.join(repr(x) for x in (pair if name != "c.csv" else pair[::-1])) for pair in cells)]) + "\n"
        measured = read_measured(written(folder, name, text))
        close(measured.volume_below(0.0), VOLUME)
        close(measured.volume_below(CYLINDER * MM), np.pi * WIDE**2 * CONE / 3.0 * MM**3)
        close(measured.volume_below(0.5 * CYLINDER * MM), VOLUME - np.pi * WIDE**2 * 0.5 * CYLINDER * MM**3)
        close(measured.end, (CYLINDER + CONE) * MM)
        close(float(measured.radius_at((CYLINDER + 0.25 * CONE) * MM)), 0.75 * WIDE * MM)


def straight_hole(radius, length, cell=0.5 * MM, plane=False):
    depth = 0.5 * cell * np.arange(1, 400)
    return Hole(cell, 0.0, depth, np.where(depth < length - 0.3 * cell, radius, 0.0), plane)


def check_differences(folder):
    """A straight hole of the run against one that is 1 mm wider and 5 mm shorter: every number by hand."""
    hole = straight_hole(5.0 * MM, 60.0 * MM)
    close(volume_below(hole, 0.0), hole.volume)
    measured = read_measured(written(folder, "wider.csv", "depth [mm],radius [mm]\n10,6\n55,6\n"))
    found = differences(hole, measured)
    close(found["depth_difference"], hole.length - 55.0 * MM)
    close(found["radius_rms_difference"], MM, 1e-9)
    close(found["radius_largest_difference"], -MM, 1e-9)
    close(found["radius_mean_difference"], -MM, 1e-9)
    close(found["measured_volume"], np.pi * (6 * MM) ** 2 * 45.0 * MM)
    close(found["run_volume"], np.pi * (5 * MM) ** 2 * (hole.length - 10.0 * MM), 1e-9)
    assert abs(found["compared_from"] - 10.0 * MM) < 1e-9 and abs(found["compared_to"] - 55.0 * MM) < 1e-9, found
    slot = differences(straight_hole(5.0 * MM, 60.0 * MM, plane=True), measured)
    close(slot["measured_volume"], 2.0 * 6 * MM * 45.0 * MM)
    sloped = read_measured(written(folder, "sloped.csv", "depth [mm],radius [mm]\n0,5\n50,10\n"))
    found = differences(hole, sloped)
    close(found["radius_largest_difference"], -5.0 * MM, 1e-9)
    close(found["radius_largest_difference_at"], 50.0 * MM, 1e-9)
    below = differences(hole, read_measured(written(folder, "below.csv", "depth [mm],radius [mm]\n90,5\n95,5\n")))
    assert below["compared_rows"] == 0 and below["radius_rms_difference"] is None and below["run_volume"] == 0.0, below


def cone_slices(count, radius_of, pixels=120, pixel=0.2, grain=3):
    """Slices of a core with air around it and a conical hole beside its middle; grains and pores scatter."""
    random = np.random.default_rng(1)
    y, x = (np.indices((pixels, pixels)) + 0.5 - 0.5 * pixels) * pixel
    for number in range(count):
        picture = np.where(np.hypot(x, y) < 0.48 * pixels * pixel, 180.0, 10.0)
        picture[np.hypot(x - 1.3, y + 0.7) < radius_of(number)] = 20.0
        picture += random.normal(0.0, grain, picture.shape)
        picture[100, 60] = 15.0  # a pore
        yield Image.fromarray(np.clip(picture, 0, 255).astype(np.uint8))


def check_slices(folder):
    """Radii of a cone to less than a pixel, from a TIFF file and from a folder of PNG files; the hole ends where the cone does."""
    radius_of = lambda number: max(6.0 - 0.15 * number, 0.0)  # noqa: E731
    pictures = list(cone_slices(50, radius_of))
    pictures[0].save(folder / "ct.tif", save_all=True, append_images=pictures[1:])
    (folder / "ct.json").write_text(json.dumps(NOTE))
    stack = folder / "stack"
    stack.mkdir()
    for number, picture in enumerate(pictures):
        picture.save(stack / f"slice{number:03d}.png")
    (stack / "stack.json").write_text(json.dumps(NOTE))
    for path in (folder / "ct.tif", stack):
        measured = read_measured(str(path))
        exact = np.array([radius_of(number) for number in range(50)])
        exact = exact[: len(measured.depth)] * MM
        errors = np.abs(measured.radius - exact)
        assert errors.max() < 0.2 * MM and np.sqrt(np.mean(errors**2)) < 0.05 * MM, errors / MM
        assert 39 <= len(measured.depth) <= 41 and abs(measured.start - 3.0 * MM) < 1e-12, measured.depth
        assert abs(measured.volume_below(0.0) / (np.pi * (6.0 * MM) ** 2 * 20.0 * MM / 3.0) - 1.0) < 0.01
        assert abs(measured.end - 23.0 * MM) < 0.8 * MM, measured.end
    inverted = folder / "light.tif"
    light = [Image.fromarray(255 - np.asarray(picture)) for picture in pictures]
    light[0].save(inverted, save_all=True, append_images=light[1:])
    inverted.with_suffix(".json").write_text(json.dumps({**NOTE, "threshold": 155, "hole": "light"}))
    assert np.array_equal(read_measured(str(inverted)).radius, read_measured(str(folder / "ct.tif")).radius)
    deep = [Image.fromarray(np.asarray(picture).astype(np.uint16) * 200) for picture in pictures[:5]]
    deep[0].save(folder / "deep.tif", save_all=True, append_images=deep[1:])
    (folder / "deep.json").write_text(json.dumps({**NOTE, "threshold": 20000}))
    assert np.allclose(read_measured(str(folder / "deep.tif")).radius, read_measured(str(folder / "ct.tif")).radius[:5])


def bored_rock(radius, length):
    wide = radius + 12 * CELL
    return rock(np.concatenate([lattice(radius, wide, 0.0, length), lattice(0.0, wide, length, length + 8 * CELL)]))


def said(*words):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = command.main(["report", *map(str, words)])
    return code, out.getvalue() + err.getvalue()


def check_page(folder):
    """The page has the numbers and the picture; its file of numbers says what they are."""
    run = write_run(folder / "run", [jet(np.array([[0.25 * CELL, 19.0 * CELL]]), np.array([1000.0])), bored_rock(4 * CELL, 20 * CELL)])
    code, words = said(run, "--measured", written(folder, "hole.csv", "depth [mm],radius [mm]\n1,4.5\n21,4.5\n"))
    assert code == 0 and "measured.json" in words, words
    found = json.loads((run / "report" / "measured.json").read_text())
    assert abs(found["radius_mean_difference"] + 0.5 * MM) < 0.1 * CELL and abs(found["depth_difference"] + MM) < 0.5 * CELL, found
    page = (run / "report" / "index.html").read_text()
    assert "Measured hole" in page and "hole.csv" in page and (run / "report" / "measured.png").exists()
    coming, whole = jet(np.array([[0.25 * CELL, -3 * CELL]]), np.array([7000.0])), rock(lattice(0.0, 9 * CELL, 0.0, 9 * CELL))
    early = write_run(folder / "early", [coming, whole])
    code, words = said(early, "--measured", folder / "hole.csv")
    assert (code == 1 and "has no hole in its target" in words) and words.count("\n") == 1, (code, words)
    return run


PROFILES = [
    (b"", "is empty"), (b"\n\n", "is empty"), (b"1,2\n3,4\n", "has no header, but begins with numbers"),
    ("deep [mm],radius [mm]\n1,2\n2,2\n", "has no column depth"), ("depth [mm],width [mm]\n1,2\n2,2\n", "has no column radius or diameter"),
    ("depth,radius [mm]\n1,2\n2,2\n", "gives its column depth no unit"),
    ("depth [mm],radius [furlong]\n1,2\n2,2\n", "the unit 'furlong', which is no length"),
    ("depth [mm],radius [mm]\n1,2\n", "a profile needs at least two"),
    ("depth [mm],radius [mm]\n1,2\n0.5,2\n", "in line 3 that is not larger"),
    ("depth [mm],radius [mm]\n1,2\n1,2\n", "in line 3 that is not larger"),
    ("depth [mm],radius [mm]\n1,2\n2,-2\n", "has a negative radius in line 3"),
    ("depth [mm],radius [mm]\n-1,2\n2,2\n", "has a negative depth in line 2"), ("depth [mm],radius [mm]\n1,0\n2,0\n", "contains no hole"),
    ("depth [mm],radius [mm]\n1,two\n2,2\n", "has 'two' for a number in line 2"),
    ("depth [mm],radius [mm]\n1\n2,2\n", "has '' for a number in line 2"),
    ("depth [m],radius [m]\n1,2\n200,2\n", "above 100 m in line 3"), (b"\x89\x00\x01\x00", "is no text"),
]  # fmt: skip
NOTES = [
    (None, "is missing: slices have no lengths"), (b"{", "is no JSON"), (b"[1]", "has a list or a number"), (b"\xff\xfe", "is no JSON"),
    (json.dumps({**NOTE, "depth": 3}), "has depth, which is none of pixel"),
    (json.dumps({**NOTE, "pixel": "0 mm"}), "has the pixel '0 mm'"),
    (json.dumps({"threshold": 100}), "has no pixel"), (json.dumps({**NOTE, "spacing": 0.5}), "has the spacing '0.5'"),
    (json.dumps({**NOTE, "first": "-1 mm"}), "has the first '-1 mm'"),
    (json.dumps({**NOTE, "threshold": "100"}), "has no number as threshold"),
    (json.dumps({**NOTE, "hole": "black"}), 'has the hole "black"'), (json.dumps({**NOTE, "threshold": 0}), "contains no hole: no slice"),
]  # fmt: skip


def check_refusals(folder, run):
    """One sentence for every file that is none, and nothing is written."""
    before = (run / "report" / "measured.json").read_bytes()
    cases = [(written(folder, f"bad{i}.csv", content), part) for i, (content, part) in enumerate(PROFILES)]
    pictures = list(cone_slices(3, lambda _: 4.0))
    for i, (content, part) in enumerate(NOTES):
        pictures[0].save(folder / f"n{i}.tif", save_all=True, append_images=pictures[1:])
        if content is not None:
            written(folder, f"n{i}.json", content)
        cases.append((folder / f"n{i}.tif", part))
    (folder / "none").mkdir()
    odd = folder / "odd"
    odd.mkdir()
    pictures[0].save(odd / "0.png")
    Image.new("L", (30, 30)).save(odd / "1.png")
    written(odd, "stack.json", json.dumps(NOTE))
    written(folder, "text.json", json.dumps(NOTE))
    cases += [(folder / "none", "is a folder without PNG or TIFF"), (odd, "unlike the first of the stack"),
        (written(folder, "text.png", "no picture"), "is no picture that can be read"), (folder / "lost.csv", "does not exist"),
        (folder / "lost", "does not exist")]
    for path, part in cases:
        code, words = said(run, "--measured", path)
        assert code == 2 and part in words and words.count("\n") == 1 and words.startswith("barreno: --measured"), (path, part, code, words)
    assert (run / "report" / "measured.json").read_bytes() == before


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for number, check in enumerate((check_exact_volume, check_differences, check_slices)):
            own = folder / str(number)
            own.mkdir()
            check(own)
        check_refusals(folder, check_page(folder))
    print("measured holes have the volumes, radii and differences that they were made with; each bad file has a sentence")


if __name__ == "__main__":
    main()
