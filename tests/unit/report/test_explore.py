#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The data of the explorable view: codes are as exact as the page says, packed tables come back, a run of 2,000 outputs stays below the
size of a page, and markup in names stays text."""
import base64
import contextlib
import hashlib
import html
import io
import json
import pathlib
import re
import tempfile
import unittest.mock
import zlib

import numpy as np
import synthetic_run
from netCDF4 import Dataset

from barreno.report import explore
from barreno.report.command import main as command
from barreno.report.explore.codes import TYPES, codes_of, packed, scale_of, values_of_codes
from barreno.report.explore.fields import starts
from barreno.report.explore.stack import Stack, edges_of, steps_between
from barreno.report.hole import holes_of
from barreno.report.particles import ParticleFile
from barreno.report.run import opened

HERE = pathlib.Path(explore.__file__).parent.parent
BAD = "<script>alert(1)</script>&lt;b"
OUTPUTS, SIDE = 2000, 26  # of the forged run: outputs, and particles along an edge
RANDOM = np.random.default_rng(7)


def check_codes():
    """Of values over many powers of ten: none is further from the value of its code than from half a code on, the middle is exact, and what
    is no number stays none. Twelve bits over colours of 0 to 300 MPa tell 0.2 MPa near the middle."""
    values = np.concatenate([RANDOM.standard_cauchy(20000) * 1e7, [0.0, np.nan, np.inf, -1e12, 3e11]])
    for levels in (4095, 255):
        scale = scale_of(values, 0.0, 3e8, levels)
        codes = codes_of(values, scale, levels)
        finite = np.isfinite(values)
        assert (codes[~finite] == 0).all() and codes[finite].min() >= 1 and codes[finite].max() <= levels, (codes.min(), codes.max())
        whole = codes[finite].astype(float)
        found = values_of_codes(whole, scale)
        slack = np.maximum(values_of_codes(whole + 0.5, scale) - found, found - values_of_codes(whole - 0.5, scale))
        assert (np.abs(found - values[finite]) <= slack * (1.0 + 1e-9) + 1e-6).all()
        assert values_of_codes(codes_of(np.zeros(1), scale, levels), scale)[0] == 0.0
    fine = scale_of(values, 0.0, 3e8, 4095)
    assert fine["width"] * np.sinh(0.5 * fine["step"]) < 2e5, fine
    few = np.array([0.5, 0.25, np.nan, 0.5])
    table = scale_of(few, 0.0, 1.0, 255)
    assert table == {"table": [0.25, 0.5]}, table
    assert np.array_equal(values_of_codes(codes_of(few, table, 255), table), few, equal_nan=True)


def unpacked(text):
    """As page/numbers.js does it, written anew."""
    raw = np.frombuffer(zlib.decompress(base64.b64decode(text["data"])), np.uint8)
    rows, columns, count, wide = text["rows"], text["columns"], text["changed"], np.dtype(TYPES[text["type"]]).itemsize
    mask = -(-columns // 8)
    changed = np.unpackbits(raw[:mask], bitorder="little")[:columns].astype(bool)
    assert changed.sum() == count
    numbers = lambda part, size: sum(part[plane * size : (plane + 1) * size].astype(np.int64) << (8 * plane)  # noqa: E731
        for plane in range(wide))
    found = np.tile(numbers(raw[mask:], columns), (rows, 1))
    later = numbers(raw[mask + wide * columns :], (rows - 1) * count).reshape(rows - 1, count)
    found[1:, changed] = (found[0, changed] + np.cumsum(later, axis=0)) % (1 << (8 * wide))
    return found.astype(f"u{wide}").view(TYPES[text["type"]])


def check_packed():
    for dtype in TYPES.values():
        info = np.iinfo(dtype)
        rows = RANDOM.integers(info.min, info.max, (5, 37), dtype, endpoint=True)
        rows[:, 3:20] = rows[0, 3:20]
        text = packed(rows)
        assert text["changed"] == 20 and np.array_equal(unpacked(text), rows), text
    one = np.arange(9, dtype=np.uint32)
    assert packed(one)["changed"] == 0 and np.array_equal(unpacked(packed(one))[0], one)


def check_steps():
    assert list(steps_between(25, 100)) == list(range(25)) and list(steps_between(2000, 2)) == [0, 1999]
    found = steps_between(2000, 100)
    assert len(found) == 100 and set(np.diff(found)) <= {20, 21} and found[-1] == 1999, found


def check_starts():
    first, blocks = np.array([68.9, 68.9, 68.9000001, 5.0, 7.0, np.nan]), np.array([0, 0, 1, 2, 2, 3])
    assert [one["materials"] for one in starts(first, blocks, list("abcd"))] == [["a", "b"]], starts(first, blocks, list("abcd"))


def small_run(folder, name="Sandstone"):
    centres = synthetic_run.lattice(0.003, 0.01, 0.0, 0.02)
    rock = synthetic_run.rock(centres)
    rock.name = name
    jet = synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, 0.015, 0.019), 3000.0)
    return synthetic_run.write_run(folder, [rock, jet])


def check_stack(folder):
    """Places and shapes come back to half a step; a jet that is launched later is not there before."""
    file = ParticleFile(small_run(folder) / "particles.e")
    stack = Stack(file, np.array([0, 1]))
    places, shapes, sizes, largest, _ = stack.places()
    frame = file.frame(1)
    found = stack.low + places[1].reshape(-1, 2) * stack.quantum
    assert np.abs(found - frame.centres).max() <= 0.5001 * stack.quantum < 2e-7, stack.quantum
    half = sizes / explore.PLACES * largest
    assert np.abs(shapes[1].reshape(-1, 4) / explore.SHAPE * half[:, None] - edges_of(frame.corners)).max() < 0.03 * largest
    assert list(stack.there().sum(axis=1)) == [int(file.frame(0).alive.sum()), len(frame.alive)]
    file.close()


def check_lies(folder):
    """A long hole lies, with its box; rubble is what the pictures call loose, at the output where there is a hole."""
    radius, length = 4 * synthetic_run.CELL, 60 * synthetic_run.CELL
    solid = synthetic_run.lattice(radius, 12 * synthetic_run.CELL, 0.0, length)
    loose = np.array([[1.5, 10.3], [2.5, 20.3]]) * synthetic_run.CELL
    run = synthetic_run.write_run(folder / "hole", [synthetic_run.rock(np.concatenate([solid, loose])),
        synthetic_run.jet(np.array([[0.25, 58.0]]) * synthetic_run.CELL, 1000.0)], depth=length)
    with opened(run) as known:
        hole_of = holes_of(known, known.depth_table())
        assert hole_of(0) is None
        lying, box = explore.how_it_lies(known, hole_of)
        assert lying and box[0][1] > radius and box[0][0] == -box[0][1] and box[1][0] < 0.0 < length < box[1][1], (lying, box)
        stack = Stack(known.file, np.array([0, 1]))
        found = explore.rubble_of(known, stack, hole_of)
        assert list(found.sum(axis=1)) == [0, len(loose)], found.sum(axis=1)
        places = stack.low + stack.places()[0][1].reshape(-1, 2) * stack.quantum
        assert np.abs(np.sort(places[found[1] > 0], axis=0) - loose).max() < 1e-6, places[found[1] > 0]
    with opened(small_run(folder / "wide")) as known:
        assert not explore.how_it_lies(known, holes_of(known, known.depth_table()))[0]


def page_of(run, *words):
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        code = command(["report", str(run), *words])
    assert code == 0, said.getvalue()
    return (run / "report" / "index.html").read_text()


def scene_in(page):
    return json.loads(re.search(r'id="explore-data">(.*?)</script>', page, re.DOTALL).group(1))


def check_text(folder):
    """Markup in the title and in the name of a material is text in the page, and in the data too."""
    run = small_run(folder, BAD)
    summary = json.loads((run / "summary.json").read_text())
    (run / "summary.json").write_text(json.dumps({**summary, "title": f"</title></h1>{BAD}"}))
    page = page_of(run)
    assert "<script>alert" not in page and len(re.findall("<script", page)) == 3 and page.count("</h1>") == 1, re.findall("<script.*", page)
    scene = scene_in(page)
    assert BAD in next(one for one in scene["fields"] if one["name"] == "material")["classes"]
    assert page.count('<figure><img alt="') >= 3 and page.index('id="explore"') < page.index("<figure>") < page.index("explore-data")
    assert not re.search(r"""(src|href)=["'](?!data:)""", page.split("<script")[0]), "the page takes something from elsewhere"


def check_too_large(folder):
    """A run that does not fit has the still page and a sentence."""
    run = small_run(folder)
    with unittest.mock.patch.object(explore, "MOST_BYTES", 500_000):
        page = page_of(run)
    assert "particles do not fit into a page of 15 MB" in page and "explore-data" not in page and "<figure>" in page


def forged(folder):
    """Particles of noise at many outputs, which no compression makes smaller."""
    centres = synthetic_run.lattice(0.0, SIDE * 5e-4, 0.0, SIDE * 5e-4)
    run = synthetic_run.write_run(folder, [synthetic_run.rock(centres)])
    (run / "depth.csv").unlink()
    with Dataset(run / "particles.e", "a") as data:
        data.variables["time_whole"][:] = 1e-5 * np.arange(OUTPUTS)
        for name, variable in data.variables.items():
            if variable.dimensions[:1] != ("time_step",) or name == "time_whole":
                continue
            size = 1e-4 if name.startswith("vals_nod") else float(np.abs(variable[1]).max()) or 1.0
            status = name == "vals_elem_var1eb1"
            variable[:] = np.ones(variable.shape) if status else size * RANDOM.random((OUTPUTS, variable.shape[1]))
    return run


def check_many_outputs(folder):
    run = forged(folder)
    page = page_of(run)
    assert 10_000_000 < len(page.encode()) <= explore.MOST_BYTES, len(page.encode())
    scene = scene_in(page)
    steps = np.array(scene["steps"])
    assert scene["outputs"] == OUTPUTS and 10 < len(steps) < OUTPUTS and steps[0] == 0 and steps[-1] == OUTPUTS - 1, len(steps)
    assert np.ptp(np.diff(steps)) <= 1, "outputs are not evenly spaced"
    assert f"The view has {len(steps)} of the run's {OUTPUTS} outputs" in html.unescape(page)
    print(f"a page of {OUTPUTS} outputs of {SIDE * SIDE} particles of noise: {len(page.encode()) / 1e6:.1f} MB with {len(steps)} of them")


def check_third_party():
    """Files of others are the ones that their list names."""
    listed = re.findall(r"^    ([0-9a-f]{64})  (\S+)$", (HERE / "third_party" / "README.md").read_text(), re.MULTILINE)
    assert len(listed) == 2
    for known, name in listed:
        assert hashlib.sha256((HERE / "third_party" / name).read_bytes()).hexdigest() == known, name
        assert (HERE / "third_party" / f"{name.split('.')[0]}.LICENSE").exists()


def main():
    check_codes()
    check_packed()
    check_steps()
    check_starts()
    check_third_party()
    with tempfile.TemporaryDirectory() as scratch:
        for check in (check_stack, check_lies, check_text, check_too_large, check_many_outputs):
            check(pathlib.Path(scratch) / check.__name__)
    print("the view to explore holds what it says")


if __name__ == "__main__":
    main()
