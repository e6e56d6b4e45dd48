#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of a report on runs that were laid by hand: rate of the depth, spent jet, fields and their ranges, pages, films, and the
sentence of every refusal."""
import contextlib
import io
import pathlib
import re
import tempfile
import zlib

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import Normalize
from PIL import Image

from barreno.report import channel, command, energy_picture, fields, numbers, pages, penetration, scales, section
from barreno.report.deck import read_deck
from barreno.report.files import read_columns
from barreno.report.outline import without_gaps
from barreno.report.particles import ParticleFile, areas_of
from synthetic_run import CELL, jet, lattice, rock, write_run

RADIUS = 3.37 * CELL


def holed_rock(e=-0.05):
    block = rock(np.concatenate([lattice(RADIUS, RADIUS + 12 * CELL, 0.0, 20 * CELL), lattice(0.0, 15 * CELL, 20 * CELL, 30 * CELL)]), e=e)
    block.fields["pressure"] = 1e8 + 1e9 * block.start.mean(axis=1)[:, 0]
    return block


def jet_in_pieces():
    """Four pieces of one mass, of which one is faster than the hole grows, two are slower, and one has stopped."""
    centres = np.repeat([[0.25 * CELL, 1.0 * CELL]], 4, axis=0) + CELL * np.arange(4)[:, None] * [0.0, 4.0]
    return jet(centres, np.array([7000.0, 1000.0, 900.0, 10.0]))


def shared(folder):
    return write_run(folder / "run", [jet_in_pieces(), holed_rock()])


def check_rate():
    """A straight line with blows on it has the slope of the line; a parabola its own in the middle of a window."""
    time = np.linspace(0.0, 1e-4, 201)
    blows = 2e-4 * np.sin(2.0 * np.pi * time / 1e-6)
    rate = penetration.smooth_rate(time, 2000.0 * time + blows, 1e-5)
    assert np.abs(rate[20:-20] - 2000.0).max() < 60.0, rate
    rate = penetration.smooth_rate(time, 1e7 * time**2, 1e-5)
    assert np.allclose(rate[12:-12], 2e7 * time[12:-12], rtol=1e-6), rate
    assert penetration.window_of(time) == 5e-6 and penetration.window_of(time[:3]) > time[2], penetration.window_of(time[:3])


def check_shares(run):
    file, deck = ParticleFile(run / "particles.e"), read_deck(run / "deck.xml")
    ((time, spent, stopped),) = penetration.jet_shares(file, deck, lambda _: 2000.0)
    assert time == 1e-5 and abs(spent - 0.75) < 1e-12 and abs(stopped - 0.25) < 1e-12, (spent, stopped)
    assert penetration.launched_share(deck, 0.5e-6) == 0.5 and penetration.launched_share(deck, 2e-6) == 1.0


def check_fields(run):
    file, deck = ParticleFile(run / "particles.e"), read_deck(run / "deck.xml")
    known = fields.known_fields(file, deck)
    assert {"speed", "porosity", "pressure"} <= set(known) and "status" not in known, known
    frame = file.frame()
    speed, strain = fields.values_of(frame, deck, "speed"), fields.values_of(frame, deck, "equivalent_plastic_strain")
    assert speed.max() == 7000.0 and not np.isnan(strain).any() and np.isnan(fields.values_of(frame, deck,
        "plastic_volume_strain")[:4]).all()
    areas = np.ones(1000)
    assert fields.range_of(np.r_[np.linspace(0, 1, 999), 1e9], areas, fields.look_of("pressure"))[1] < 1.0
    low, high = fields.range_of(np.linspace(-1.0, 3.0, 1000), areas, fields.look_of("velocity_x"))
    assert low == -high and 2.8 < high < 3.0, (low, high)
    assert fields.range_of(np.full(3, np.nan), np.ones(3), fields.look_of("pressure")) == (0.0, 1.0)


def check_doubling():
    """Sizes of cells and steps are all in the scale, with a tick for each; a step of nothing has no colour."""
    look, areas = fields.look_of("cell_size"), np.r_[np.full(999, 1.0), 1e-6]
    assert fields.range_of(np.r_[np.full(999, 4.0), 0.5], areas, look) == (0.5, 4.0) and fields.range_of(np.full(3, 2.0), np.ones(3),
        look) == (1.0, 4.0)
    assert fields.range_of(np.zeros(3), np.ones(3), fields.look_of("step_length"))[0] > 0.0 and not fields.look_of("speed").doubling
    shapes = np.stack([square + np.array([4.0 * i, 0.0])
        for i, square in enumerate([np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])] * 5)])
    figure, axes = plt.subplots()
    quads = channel.draw_quads(axes, shapes, np.array([4.0, 2.0, 0.0, 0.5, np.nan]), look.colours, fields.norm_of(look, (0.5, 4.0)))
    assert scales.doubling_values(quads) == [0.5, 2.0, 4.0] and len(axes.collections[0].get_paths()) == 2, axes.collections
    shades = quads.to_rgba(np.array([0.5, 1.0, 2.0, 4.0]))
    assert np.allclose(shades, plt.get_cmap(look.colours)(np.array([0.0, 1.0, 2.0, 3.0]) / 3.0), atol=0.01), shades
    scales.bar_beside(figure, axes, quads, look.label, "right", 4.0)
    assert [text.get_text() for text in axes.child_axes[-1].get_yticklabels()] == ["0.5", "2", "4"]
    assert scales.doubling_values(channel.draw_quads(axes, shapes, np.ones(5), "viridis", Normalize(0.0, 2.0))) == []
    plt.close(figure)


def check_units():
    """Units are those of the program's table; a field of a model from elsewhere has none."""
    for name, label, scale in (
        ("overstress_xx", "overstress xx [MPa]", 1e6), ("lighting_time", "lighting time [ns]", 1e-9), ("speed", "speed [m/s]", 1.0),
        ("density", "density [kg/m³]", 1.0), ("internal_energy", "internal energy [kJ/kg]", 1e3), ("gas", "gas [-]", 1.0),
        ("of_another_model", "of another model", 1.0),
    ):  # fmt: skip
        look = fields.look_of(name)
        assert (look.label, look.scale) == (label, scale), look


def check_energy():
    """All that went in, the work of pore fluid included, is what the parts of the picture add up to."""
    held = {"kinetic": 3.0, "elastic": 5.0, "plastic": 7.0, "viscous": 0.0, "friction": 2.0}
    ends = {**held, "launched_kinetic": 11.0, "boundary_work": -1.0, "fluid_work": 4.0, "transfer": -1.5, "stress_integration": 0.5}
    table = {name: np.array([0.0, value]) for name, value in ends.items()}
    summary = {"balances": {"energy": {"initial_kinetic": 1.0, "prestress": 3.0}}}
    parts = energy_picture.parts_of(table)
    assert [name for name, _ in parts] == ["kinetic", "elastic", "plastic", "friction", "numerical loss"], parts
    assert energy_picture.put_in(table, summary)[-1] == 18.0 == sum(values[-1] for _, values in parts), parts


def check_points(folder):
    """Plain points are squares of the size that the file gives, grown as their volume has."""
    block = rock(lattice(0.0, 4 * CELL, 0.0, 4 * CELL), ratio=1.21)
    block.start = block.end = block.start.mean(axis=1)[:, None, :]
    block.radius = np.full(len(block.start), 0.25 * CELL)
    shapes, of = ParticleFile(write_run(folder / "points", [block]) / "particles.e").frame().shapes
    assert len(of) == 64 and np.allclose(areas_of(shapes), 1.21 * (0.5 * CELL) ** 2, rtol=1e-9), areas_of(shapes)


def check_outline():
    """Gaps of a pixel are closed, corners stay; a crumb is taken away as a gap of what is around it."""
    mask = np.zeros((20, 20), bool)
    mask[4:16, 4:16] = True
    split = mask.copy()
    split[:, 10] = False
    assert (without_gaps(split, 2) == mask).all()
    crumb = mask.copy()
    crumb[1:3, 17:19] = True
    assert (~without_gaps(~crumb, 2) == mask).all()


def check_interval():
    error = {"value": -0.2, "low": -0.25, "high": -0.2}
    assert numbers.depth_interval(0.08, {"depth_error": error})[:2] == (0.08 / 0.8, 0.08 / 0.75)
    study = {"low": 0.07, "high": 0.09}
    assert numbers.depth_interval(0.08, {"depth_error": error, "convergence": study})[:2] == (0.07,
        0.09) and numbers.depth_interval(0.08, {}) is None


def check_wide_hole():
    depth = {"depth": 0.5, "probed_depth": 0.48}
    known = {"value": -0.07, "low": -0.1, "high": 0.02, "cells_per_radius": 1.2, "source": "measured"}
    cells = {"cells_per_radius": {"tip": 1.2}}
    (words, text), = numbers.probe_rows(depth, {**cells, "probed_depth_error": known})
    assert words == "as wide as the jet's widest slug" and text.startswith("to 480.00 mm; error from the size of the cells -7 %"), text
    assert numbers.probe_rows(depth, cells)[0][1] == "to 480.00 mm"
    assert not numbers.probe_rows({"depth": 0.5}, cells), "a run of another version"
    assert not numbers.probe_rows(depth, {}), "a formed jet, of which no width is known"


def said(*words, code=0):
    """What the command prints, on either stream."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        found = command.main([str(word) for word in words])
    assert found == code, f"{words}: exit {found}, {err.getvalue()}"
    return err.getvalue() if code else out.getvalue()


def words_of_pdf(file):
    """Its letters, all pages one after the other; between them are places and kerning."""
    found = []
    for stream in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", file.read_bytes(), re.DOTALL):
        with contextlib.suppress(zlib.error):
            found += re.findall(rb"\(((?:[^()\\]|\\.)*)\)", zlib.decompress(stream))
    return re.sub(r"\s+|\\", "", b"".join(found).decode("latin-1"))


def check_captions(run):
    """A page of the PDF has the heading and the caption of its picture, which the picture itself does not keep."""
    words = words_of_pdf(run / "report" / "report.pdf")
    for said in ("The colour scale leaves out the extreme 1.5 % of the area", "where the size of particles shows the size of cells",
            "Energy by term, and the remainder of the ledger."):
        assert re.sub(r"\s", "", said) in words, said
    picture = section.Picture("a", plt.figure(), "one caption")
    pages.write_pdf(run / "one.pdf", "title", [section.Section("Heading", pictures=[picture])])
    assert not picture.figure.texts and "Heading" in words_of_pdf(run / "one.pdf") and "onecaption" in words_of_pdf(run / "one.pdf")
    plt.close(picture.figure)


def check_page(run):
    """One page with its pictures inside, as text that came from a title; the same numbers in both forms."""
    printed = said("report", run, "--left", "pressure", "--right", "plastic_volume_strain", "--time", "10 us", "--depths",
        "5 mm, 1 cm", "--pdf")
    page, marked = ((run / "report" / name).read_text() for name in ("index.html", "index.md"))
    assert str(run / "report" / "index.html") in printed and "By &lt;hand&gt;" in page and "# By <hand>" in marked, printed
    pictures = sorted(file.stem for file in (run / "report").glob("*.png"))
    assert pictures == ["depth", "energy", "fields", "hole", "strength", "tip"], pictures
    assert page.count('src="data:image/png;base64,') == len(pictures) and all(f"({name}.png)" in marked for name in pictures)
    assert not re.search(r'(src|href)="(?!data:)', page) and "http" not in page.replace("http-equiv", ""), "the page needs something else"
    assert "<td>5.0</td>" in page and "<td>10.0</td>" in page and "<td>plastic</td><td>20 J, 20 %</td>" in page, page[:3000]
    for words in ("numerically lost: 10 % of the energy put in (stress integration -4 %, transfer -6 %); remainder of the ledger: +0.001 %",
            "slower along its flight than the hole grows"):
        assert words in page.lower() and words in marked.lower(), words
    assert (run / "report" / "report.pdf").read_bytes()[:5] == b"%PDF-" and not list((run / "report").glob(".*"))
    profile = read_columns(run / "report" / "profile.csv")
    inner = (profile["depth"] > CELL) & (profile["depth"] < 18 * CELL)
    assert np.abs(profile["radius"][inner] - RADIUS).max() < 0.1 * CELL, profile["radius"]


def check_film(run):
    for name, kind in (("film.gif", "GIF"), ("film.png", "PNG")):
        said("film", run, "--field", "pressure", "--right", "speed", "--out", run / name)
        with Image.open(run / name) as film:
            assert film.format == kind and film.n_frames == 2, (film.format, film.n_frames)


REFUSED = [  # words, exit code, part of the sentence
    ((), 1, "the first word is report or film"),
    (("report",), 1, "the following arguments are required: RUN; write for example barreno report"),
    (("report", "nowhere"), 2, "'nowhere' is not a folder"),
    (("report", "RUN", "--left", "pressur"), 1,
        '--left "pressur" is not a field of this run, which has density, equivalent_plastic_strain, plastic_strain'),
    (("report", "RUN", "--left", "pressur"), 1, "did you mean pressure?"),
    (("report", "RUN", "--right", "Plastic Volume"), 1, "did you mean plastic_volume_strain?"),
    (("report", "RUN", "--right", "xyzzy"), 1, "choose one of these."),
    (("report", "RUN", "--time", "soon"), 1, '--time "soon" is not a time; write for example --time "30 us"'),
    (("report", "RUN", "--time", "3 weeks"), 1, '--time "3 weeks" is not a time'),
    (("report", "RUN", "--time", "30 us"), 1, "--time 30 us is not in the run's particles.e (0 to 10 us)"),
    (("report", "RUN", "--depths", "5 mm, deep"), 1,
        '--depths has "deep", which is not a length; write for example --depths "30 mm, 60 mm"'),
    (("report", "RUN", "--depths", "5"), 1, '--depths has "5", which is not a length'),
    (("report", "RUN", "--colour"), 1, "unrecognized arguments: --colour"),
    (("film", "RUN"), 1, "the following arguments are required: --field; write for example barreno film"),
    (("film", "RUN", "--field", "spede"), 1, "did you mean speed?"),
    (("film", "RUN", "--field", "speed", "--right", "spede"), 1, '--right "spede" is not a field'),
    (("film", "RUN", "--field", "speed", "--out", "a.avi"), 1, '--out "a.avi" is no film that can be written'),
    (("film", "RUN", "--field", "speed", "--out", "no/where/a.gif"), 2, "is not a folder; make it first"),
    (("film", "RUN", "--field", "speed", "--per-second", "0"), 1, "--per-second 0 is not a number of pictures from 0.1 to 60"),
]  # fmt: skip


def check_refusals(run, folder):
    empty = folder / "empty"
    empty.mkdir()
    before = sorted(run.rglob("*"))
    for words, code, sentence in REFUSED:
        found = said(*(run if word == "RUN" else word for word in words), code=code)
        assert found.startswith("barreno: ") and found.count("\n") == 1 and sentence in found, f"{words}: {found}"
    for name in ("report", "film"):
        found = said(name, empty, *(["--field", "speed"] if name == "film" else []), code=2)
        assert found == f"barreno: cannot report on '{empty}' (it contains no history.csv; give the folder of a run).\n", found
    assert sorted(run.rglob("*")) == before, "a refusal leaves files"
    found = said("report", run, "--depths", "40 mm", code=1)
    assert "--depths has 40 mm, where there is no hole in rock (0.0 to 19.8 mm); choose depths in between." in found, found
    assert not list((run / "report").iterdir()), "a refusal leaves files"


def main():
    check_rate()
    check_outline()
    check_interval()
    check_wide_hole()
    check_doubling()
    check_units()
    check_energy()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        run = shared(folder)
        for check in (check_shares, check_fields):
            check(run)
        check_points(folder)
        check_refusals(run, folder)
        check_page(run)
        check_captions(run)
        check_film(run)
    print("the parts of a report are what they say")


if __name__ == "__main__":
    main()
