#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a report: which colours mean what, how a picture lies, what legends leave free, and the same colours in ParaView."""
import pathlib
import tempfile
import types
import xml.etree.ElementTree as xml

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb

from barreno.compare.channels import Channel, Layout, box_of, draw_one, layout_of, pieces_in, share_colours, title_of
from barreno.report import channel, depth_picture, fields, paraview, pieces, scales, tones
from barreno.report.deck import Deck, read_deck
from barreno.report.hole import measure_hole
from barreno.report.legends import covers, place_legends
from barreno.report.outline import border_of, smoothed
from barreno.report.particles import ParticleFile
from barreno.report.view import STRETCH, View, hole_view, is_long, placed
from barreno.report.wall import smooth_wall
from synthetic_run import CELL, jet, lattice, rock, squares, write_run


RADIUS, LENGTH, END = 4 * CELL, 60 * CELL, 70 * CELL
LOOSE = np.array([[1.5, 10.3], [2.5, 20.3], [1.5, 40.3]]) * CELL
JET = np.array([[0.25, 58.0], [0.25, 50.0]]) * CELL
WHITE = 0.93  # least red, green and blue of a neutral colour


def long_run(folder):
    """A long straight hole with three loose pieces and two of the jet; porosity is virgin but beside the hole."""
    solid = np.concatenate([lattice(RADIUS, 12 * CELL, 0.0, LENGTH), lattice(0.0, 12 * CELL, LENGTH, END)])
    block = rock(np.concatenate([solid, LOOSE]))
    block.fields["plastic_volume_strain"] = np.where(block.start.mean(axis=1)[:, 0] < RADIUS + 2 * CELL, -0.1, 0.0)
    return opened(write_run(folder / "run", [jet(JET, np.array([1000.0, 6000.0])), block], depth=LENGTH))


def opened(run):
    file, deck = ParticleFile(run / "particles.e"), read_deck(run / "deck.xml")
    return types.SimpleNamespace(folder=run, file=file, deck=deck, frame=file.frame(), hole=measure_hole(file.frame(), deck, 0.0),
        particle_path=run / "particles.e")


def deck_of(materials, jet_of=""):
    root = xml.Element("ParameterList")
    for name, model in materials.items():
        lists = next((one for one in root if one.get("name") == "Materials"), None)
        lists = xml.SubElement(root, "ParameterList", name="Materials") if lists is None else lists
        xml.SubElement(xml.SubElement(lists, "ParameterList", name=name), "Parameter", name="Model", value=model)
    xml.SubElement(xml.SubElement(root, "ParameterList", name="Jet"), "Parameter", name="Material", value=jet_of)
    return Deck(root)


def check_tones():
    """A material has one colour, whatever else is in the deck and in which order; two of a deck differ; a launched jet is red."""
    alone = tones.tones_of(deck_of({"Sandstone": "Arenisca"}), ["Sandstone"])
    more = {"Steel": "Johnson-Cook", "Sandstone": "Arenisca", "Water": "Liquid", "Explosive": "JWL Explosive", "Block": "Linear Elastic"}
    together = tones.tones_of(deck_of(more), list(more))
    assert alone["Sandstone"] == together["Sandstone"] and len(set(together.values())) == len(more), together
    assert together == tones.tones_of(deck_of(more), list(more)[::-1])
    metals = {f"Metal {number}": "Johnson-Cook" for number in range(3)}
    assert len(set(tones.tones_of(deck_of(metals), list(metals)).values())) == 3
    assert tones.tones_of(deck_of(more, "Steel"), list(more))["Steel"] == tones.JET not in together.values()
    kept = {*(tone for family in tones.KINDS.values() for tone in family), tones.JET, tones.RUBBLE, tones.VOID}
    assert len(kept) == 3 * len(tones.KINDS) + 3


def check_neutral(run):
    """The virgin porosity and a volume strain of nothing have the neutral colour; less is red, more is blue, in both."""
    virgin = fields.virgin_of(run.file, run.deck)
    assert abs(virgin - (1.0 - np.exp(-0.2231))) < 1e-12, virgin
    for name, neutral, step in (("porosity", virgin, 0.03), ("plastic_volume_strain", 0.0, 0.03)):
        look = fields.look_in(run.file, run.deck, name)
        for values in (np.linspace(neutral - 0.1, neutral + 0.02, 50), np.linspace(neutral, neutral + 0.3, 50), np.full(9, neutral)):
            low, high = limits = fields.range_of(values, np.ones(len(values)), look)
            assert low < neutral < high and (name != "porosity" or low >= 0.0), (name, limits)
            shade = lambda value: np.array(plt.get_cmap(look.colours)(fields.norm_of(look, limits)(value))[:3])  # noqa: B023, E731
            assert shade(neutral).min() > WHITE, (name, limits, shade(neutral))
        crushed, dilated = shade(neutral - step), shade(neutral + step)
        assert crushed[0] > crushed[2] and dilated[2] > dilated[0], (name, crushed, dilated)


def check_marks(run):
    """Scales have the initial value of the rock, without the jet; none where a body had many."""
    value, spread, name = scales.initial_value(run.file, run.deck, "pressure")
    assert (value, spread, name) == (1e8, 0.0, "Sandstone")
    figure = channel.draw_channel(run.frame, run.deck, "pressure", "porosity", View(hole=run.hole))
    labels = [one.get_xlabel() for one in figure.axes]
    assert any("initial value 100)" in label for label in labels), labels
    quads = types.SimpleNamespace(get_clim=lambda: (0.0, 90.0))
    assert scales.mark_of(run.file, run.deck, "pressure", quads, fields.look_of("pressure")) is None
    quads = types.SimpleNamespace(get_clim=lambda: (-0.2, 0.2))  # crushed already at the start beside the hole
    assert scales.mark_of(run.file, run.deck, "plastic_volume_strain", quads, fields.look_of("plastic_volume_strain")) is None
    plt.close(figure)


def colours_of(axes):
    """{colour: quadrangles} of those in one colour."""
    found = {}
    for one in axes.collections:
        if one.get_array() is None and len(one.get_facecolor()):
            key = tuple(np.round(one.get_facecolor()[0][:3], 6))
            found[key] = found.get(key, 0) + len(one.get_paths())
    return {key: count for key, count in found.items() if count}


def check_pieces(run):
    """Jet and rubble have their own colours where the field is one of the rock, and the field's where one looks for the jet's."""
    own = pieces.pieces_of(run.frame, run.deck, run.hole)
    assert own.jet.sum() == len(JET) and own.rubble.sum() == len(LOOSE) and not (own.jet & own.rubble).any(), (own.jet.sum(),
        own.rubble.sum())
    found = {}
    for field in ("pressure", "speed"):
        figure = channel.draw_channel(run.frame, run.deck, field, field, View(hole=run.hole))
        found[field] = colours_of(figure.axes[0])
        plt.close(figure)
    key = lambda tone: tuple(np.round(to_rgb(tone), 6))  # noqa: E731
    assert found["pressure"] == {key(tones.JET): 2 * len(JET), key(tones.RUBBLE): 2 * len(LOOSE)}, found
    assert not found["speed"], found
    none = pieces.pieces_of(run.frame, run.deck)
    assert not none.rubble.any() and none.jet.sum() == len(JET)


def check_lying(run):
    """A long picture lies, with the left field above; the hole alone is larger; a narrow one has its radii stretched."""
    assert is_long(run.frame, True) and not is_long(run.frame, True, (-30.0, 30.0, 0.0, 60.0))
    point = np.array([[2.0, 50.0]])
    assert placed(point, -1.0, True).tolist() == [[50.0, -2.0]] and placed(point, -1.0).tolist() == [[-2.0, 50.0]]
    figure = channel.draw_channel(run.frame, run.deck, "pressure", "porosity", View(hole=run.hole))
    axes = figure.axes[0]
    assert axes.get_xlabel() == "y [mm]" and axes.get_ylabel() == "r [mm]" and axes.yaxis_inverted() and not axes.xaxis_inverted()
    view = hole_view(View(hole=run.hole), run.deck)
    assert view.stretch == 1.0 and view.box[1] == 14.0 and view.box[2] < 0.0 < LENGTH / 1e-3 < view.box[3], view.box
    narrow = types.SimpleNamespace(**{**vars(run.hole), "radius": 0.25 * run.hole.radius, "open_rows": run.hole.open_rows,
        "length": run.hole.length})
    view = hole_view(View(hole=narrow), run.deck)
    assert view.stretch == 1.0, view  # eight cells on each side are wide enough
    narrow.cell, narrow.length = 0.25 * CELL, 0.2
    view = hole_view(View(hole=narrow), run.deck)
    assert view.stretch == STRETCH and "3 times" in view.title, view
    stretched = channel.draw_channel(run.frame, run.deck, "pressure", "porosity", View(box=(-5.0, 5.0, 0.0, 70.0), stretch=3.0))
    stretched.canvas.draw()
    (left, low), (right, high) = stretched.axes[0].transData.transform([(0.0, 0.0), (10.0, -10.0)])
    assert abs((high - low) / (right - left) - 3.0) < 0.05, (left, low, right, high)
    upright = channel.draw_channel(run.frame, run.deck, "pressure", "porosity", View(box=(-30.0, 30.0, 0.0, 60.0)))
    assert upright.axes[0].get_xlabel() == "r [mm]"
    plt.close("all")


def check_lines(run):
    """The wall is where it was laid, one torn piece makes no spike in it, and the border of a body has no steps of pixels."""
    depth, radius = smooth_wall(run.hole)
    assert abs(radius[3:-4] - RADIUS).max() < 0.15 * CELL and radius[-1] == 0.0 and depth[-1] == run.hole.length, radius
    torn = types.SimpleNamespace(radius=run.hole.radius.copy(), depth=run.hole.depth, length=run.hole.length, open_rows=run.hole.open_rows)
    torn.radius[40] = 0.3 * RADIUS
    assert abs(smooth_wall(torn)[1][40] - RADIUS) < 0.15 * CELL
    share = smoothed(np.tri(40, dtype=bool), 2)
    assert share.shape == (40, 40) and share.min() == 0.0 and share.max() == 1.0 and abs(share[20, 20] - 0.6) < 0.05, share[20, 20]
    x, y, share = border_of(squares(lattice(0.0, 6 * CELL, 0.0, 6 * CELL), 0.25 * CELL), False, True)
    across = np.interp(0.5, share[len(y) // 2, : len(x) // 2], x[: len(x) // 2])
    assert abs(across) < 0.05 * CELL, across


def check_legends():
    """A legend is in the corner that curves leave free, and below the axes where they leave none."""
    line = np.linspace(0.0, 1.0, 200)
    for curves, place in (
        ([line], "inside"), ([1.0 - line], "inside"), ([line, 1.0 - line, 0.02 + 0.0 * line, 0.98 + 0.0 * line], "below"),
    ):  # fmt: skip
        figure, axes = plt.subplots(layout="constrained")
        for number, curve in enumerate(curves):
            axes.plot(line, curve, label=f"curve number {number}, with a long name that fills the corner")
        place_legends(axes, fontsize=8)
        figure.draw_without_rendering()
        inside = axes.get_window_extent().contains(*axes.get_legend().get_window_extent().get_points().mean(axis=0))
        assert not covers(axes) and inside == (place == "inside"), (place, inside)
        plt.close(figure)
    time = np.linspace(0.0, 1e-4, 50)
    table = {"time": time, "depth": 1e3 * time, "channel_depth": 1e3 * time}
    shares = [(when, 0.5 + 0.4 * (-1) ** number, 0.5 * when / 1e-4) for number, when in enumerate(time)]
    figure = depth_picture.depth_figure(table, (0.08, 0.12, "interval"), time, 1000.0 + 3e3 * np.sin(2e5 * time), 1e-5, shares)
    figure.draw_without_rendering()
    assert not any(covers(axes) for axes in figure.axes) and sum(axes.get_legend() is not None for axes in figure.axes) == 2
    plt.close(figure)


def check_titles():
    """Titles are broken between words, never in one."""
    row = types.SimpleNamespace(label="Materials/Sandstone_of_the_north/p0_crush_curve = -1.2e9, another one of many words that wraps",
        depth=lambda: 0.1)
    stands = Layout(False, 1, 2.0, 5.0, 1)
    lines = title_of(row, types.SimpleNamespace(time=1e-4), stands).split("\n")
    words = set(row.label.replace(",", "").split())
    assert all(word in words for line in lines[:-1] for word in line.split()) and len(lines) > 3, lines


def check_arrows(run):
    """A bar has an arrow where values go on beyond its end: plastic strain has none below zero."""
    quads = lambda values, limits: types.SimpleNamespace(get_clim=lambda: limits, get_array=lambda: np.array(values))  # noqa: E731
    for values, expected in (([0.0, 0.3], "neither"), ([0.0, 2.0], "max"), ([-1.0, 0.5], "min"), ([-1.0, 2.0], "both")):
        assert scales.arrows_of(quads(values, (0.0, 1.0))) == expected, (values, expected)
    assert scales.arrows_of(quads([0.0, 0.3], (0.0, 1.0)), quads([0.0, 3.0], (0.0, 1.0))) == "max"
    figure = channel.draw_channel(run.frame, run.deck, "pressure", "equivalent_plastic_strain", View(hole=run.hole))
    figure.canvas.draw()
    bars = [one._colorbar for one in figure.axes if hasattr(one, "_colorbar")]
    assert len(bars) == 2 and all(bar.extend in ("neither", "max") for bar in bars), [bar.extend for bar in bars]
    plt.close(figure)


def check_matrix(run):
    """Long channels of a sweep lie below each other, the field of the left above the axis; a long narrow one is stretched and says so."""
    own = Channel(run.frame, run.deck, pieces.pieces_of(run.frame, run.deck, run.hole))
    box = box_of([own], True)
    layout = layout_of([own, own], True, box, None)
    assert layout.lying and layout.columns == 1 and layout.stretch == 1.0 and layout.lines(2) == 2, layout
    assert [one.get_label() for one in pieces_in([own, None])] == ["jet", "loose pieces in the hole"]
    figure, axes, places = layout.figure(2)
    row = types.SimpleNamespace(label="Pressure = 34 MPa", depth=lambda: 0.06)
    halves = [draw_one(place, row, own, layout, box) for place in places]
    for side, of_side in zip(("top", "bottom"), zip(*halves)):
        share_colours(figure, axes, of_side, side)
    figure.canvas.draw()
    (upper,), (lower,) = places
    assert upper.get_position().y0 > lower.get_position().y1 and upper.yaxis_inverted() and lower.get_xlabel() == "y [mm]"
    pressure = halves[0][0][0].get_paths()
    assert max(path.vertices[:, 1].max() for path in pressure) <= 1e-9, "pressure is not above the axis"
    plt.close(figure)
    narrow = layout_of([own], True, (-4.0, 4.0, 0.0, 70.0), None)
    assert narrow.stretch == 3.0 and "radii 3 times larger than depths" in title_of(row, run.frame, narrow), narrow
    assert not layout_of([own], True, (-30.0, 30.0, 0.0, 60.0), None).lying


def check_paraview(run):
    """Between its points ParaView has the colours of the report, at values in SI."""
    for name, limits in (
        ("pressure", (0.0, 400.0)), ("porosity", (0.0, 0.5)), ("cell_size", (0.25, 4.0)), ("plastic_volume_strain", (-0.2, 0.2)),
    ):  # fmt: skip
        look = fields.look_in(run.file, run.deck, name)
        points = np.array(paraview.colour_points(look, limits)).reshape(-1, 4)
        assert (np.diff(points[:, 0]) > 0.0).all() and np.allclose(points[[0, -1], 0], np.array(limits) * look.scale), points[:, 0]
        values = np.geomspace(max(limits[0], 0.02), limits[1], 50) if look.doubling else np.linspace(*limits, 50)
        shown = np.stack([np.interp(values * look.scale, points[:, 0], points[:, axis]) for axis in (1, 2, 3)], axis=1)
        own = plt.get_cmap(look.colours)(fields.norm_of(look, limits)(values))[:, :3]
        assert np.abs(shown - own).max() < 0.03, (name, np.abs(shown - own).max())


def main():
    with tempfile.TemporaryDirectory() as scratch:
        run = long_run(pathlib.Path(scratch))
        check_tones()
        for check in (check_neutral, check_marks, check_pieces, check_lying, check_lines, check_arrows, check_matrix, check_paraview):
            check(run)
        check_legends()
        check_titles()
    print("colours, places and legends of pictures are what they say")


if __name__ == "__main__":
    main()
