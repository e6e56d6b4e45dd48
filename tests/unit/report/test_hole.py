#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The hole profile of a report against holes whose radius is known: to less than a tenth of a cell wherever the wall lies in its cell, with
deformed particles, debris and a jet inside; zones around it against porosities that were laid there."""
import pathlib
import tempfile

import numpy as np

from barreno.report import hole as holes
from barreno.report import hole_section, porosity, zones
from barreno.report.deck import read_deck
from barreno.report.particles import ParticleFile
from synthetic_run import CELL, jet, lattice, moved, rock, squares, write_run

LENGTH, WIDTH, END = 20 * CELL, 20 * CELL, 30 * CELL
TENTH = 0.1 * CELL


def measured(folder, blocks, **words):
    """(hole, frame, deck) of a run with these blocks."""
    run = write_run(folder, blocks, **words)
    deck, frame = read_deck(run / "deck.xml"), ParticleFile(run / "particles.e").frame()
    return holes.measure_hole(frame, deck, 0.0), frame, deck


def bored(radius, e=0.0):
    """Rock with a straight hole down to LENGTH, and whole below."""
    side = lattice(radius, radius + WIDTH, 0.0, LENGTH)
    below = lattice(0.0, WIDTH, LENGTH, END)
    return rock(np.concatenate([side, below]), e=e)


def worst(hole, radius_at, first=1.0, last=18.0):
    """Largest error of the radius in rows between two depths in cells."""
    rows = (hole.depth >= first * CELL) & (hole.depth <= last * CELL)
    return float(np.abs(hole.radius[rows] - radius_at(hole.depth[rows])).max())


def check_straight(folder):
    """Wherever the wall lies in its cell; then the measures that follow from it."""
    for cells in (0.6, 1.0, 2.25, 3.37, 3.5, 5.71):
        radius = cells * CELL
        hole, _, _ = measured(folder / "straight", [bored(radius)])
        assert hole.cell == CELL and worst(hole,
            lambda y: radius) < TENTH, f"{cells}: {worst(hole, lambda y: radius) / CELL:.3f} cells"  # noqa: B023
        assert abs(hole.length - LENGTH) <= 0.25 * CELL + 1e-12 and abs(hole.entrance_diameter - 2.0 * radius) < 2.0 * TENTH, (hole.length,
            hole.entrance_diameter)
        assert abs(hole.volume / (np.pi * radius**2 * LENGTH) - 1.0) < 0.03, hole.volume


def opening(radius_at):
    """The motion that opens a hole in rock that keeps its volume: r^2 grows by R^2."""
    return lambda x: np.stack([np.sqrt(x[:, 0] ** 2 + radius_at(x[:, 1]) ** 2), x[:, 1]], axis=1)


def check_deformed(folder):
    """Particles that were stretched and sheared as rock is around a hole: a straight one, a cone, a bulge."""
    shapes = {
        "straight": lambda y: 4.3 * CELL + 0.0 * y,
        "cone": lambda y: 6.0 * CELL - 0.15 * y,
        "bulge": lambda y: 3.5 * CELL + CELL * np.sin(y / (4.0 * CELL)),
    }
    for name, radius_at in shapes.items():
        centres = lattice(0.0, WIDTH, 0.0, END)
        hole, _, _ = measured(folder / name, [rock(centres, moved(centres, opening(radius_at)))])
        error = worst(hole, radius_at, 1.0, 28.0)
        assert error < TENTH, f"{name}: {error / CELL:.3f} cells"


def check_debris(folder):
    """Single particles that fly clear of the wall by half a cell, expanded ones too, and the jet that fills the end do not move it."""
    radius, rng = 4.3 * CELL, np.random.default_rng(1)
    block = bored(radius)
    centres = np.stack([rng.uniform(0.3 * CELL, radius - 0.8 * CELL, 25), np.linspace(2.0, 17.0, 25) * CELL], axis=1)
    crumbs = rock(centres, squares(centres, 0.5 * CELL), ratio=4.0)
    for name in ("start", "end"):
        setattr(block, name, np.concatenate([getattr(block, name), getattr(crumbs, name)]))
    block.fields = {name: np.concatenate([values, crumbs.fields[name]]) for name, values in block.fields.items()}
    hole, frame, deck = measured(folder / "debris", [jet(lattice(0.0, 3.0 * CELL, 15.0 * CELL, LENGTH), 1000.0), block])
    assert holes.jet_particles(frame, deck).sum() == 6 * 10
    error = worst(hole, lambda y: radius)
    assert error < TENTH, f"debris: {error / CELL:.3f} cells"


def check_slot(folder):
    """A slot in plane strain with both its sides, moved off the middle: half of its width."""
    side = lattice(2.5 * CELL, WIDTH, 0.0, LENGTH)
    centres = np.concatenate([side, side * [-1.0, 1.0] + [0.2 * CELL, 0.0]])
    hole, _, _ = measured(folder / "slot", [rock(centres)], mode="plane strain", lower="-0.03")
    assert hole.plane and worst(hole, lambda y: 2.4 * CELL) < TENTH, hole.radius / CELL


def check_closed(folder):
    """Whole rock has no hole."""
    hole, _, _ = measured(folder / "whole", [rock(lattice(0.0, WIDTH, 0.0, END))])
    assert hole.open_rows == 0 and hole.length == hole.volume == hole.entrance_diameter == 0.0, hole


def check_through(folder):
    """A hole that leaves the target at its back, and whose crater has eaten all of the first cell."""
    radius = 3.37 * CELL
    hole, _, _ = measured(folder / "through", [rock(lattice(radius, radius + WIDTH, CELL, LENGTH))])
    assert abs(hole.length - LENGTH) < CELL and worst(hole, lambda y: radius, 2.0) < TENTH, (hole.length, hole.radius)
    assert abs(hole.volume / (np.pi * radius**2 * 19.0 * CELL) - 1.0) < 0.05 and abs(hole.entrance_diameter
        - 2.0 * radius) < 2.0 * TENTH, (hole.volume, hole.entrance_diameter)
    assert abs(hole.radius_at(0.0) - radius) < TENTH


def check_gap(folder):
    """A gap between two bodies has no wall: the hole goes on behind it, and each body has its entrance."""
    near, far = 3.37 * CELL, 2.43 * CELL
    bodies = np.concatenate([lattice(near, near + WIDTH, 0.0, 4.0 * CELL), lattice(far, far + WIDTH, 9.0 * CELL, LENGTH)])
    hole, _, _ = measured(folder / "gap", [rock(bodies)])
    assert abs(hole.length - LENGTH) < CELL and not np.isfinite(hole.radius[12]), (hole.length, hole.radius)
    assert abs(hole.diameter_below(0.0) - 2.0 * near) < 2.0 * TENTH and abs(hole.diameter_below(9.0 * CELL)
        - 2.0 * far) < 2.0 * TENTH, hole.radius / CELL
    assert hole.diameter_below(LENGTH + CELL) == 0.0
    rows = dict(hole_section.rows_in_rock(hole, 9.0 * CELL, "diameter"))
    assert rows["length in rock"].startswith(
        f"{(hole.length - 9.0 * CELL) / 1e-3:.1f} mm") and rows["entrance diameter in rock"].startswith(f"{2.0 * far / 1e-3:.2f}"[:3]), rows
    assert hole_section.rows_in_rock(hole, None, "diameter") == [] == hole_section.rows_in_rock(hole, 2.0 * LENGTH, "diameter")


def check_zones(folder):
    """Two rings of crushed rock, then one that is dilated: porosity, permeability and skin by hand."""
    radius, e, virgin = 3.25 * CELL, -0.1, 1.0 - np.exp(-0.2231)
    block = bored(radius)
    ring = np.floor((block.start.mean(axis=1)[:, 0] - radius) / CELL + 1e-9)
    block.fields["plastic_volume_strain"] = np.select([ring < 2, ring < 3], [e, 0.05], 0.0)
    hole, frame, deck = measured(folder / "zones", [block])
    rings = zones.rings_at(zones.Rock(frame, deck, 0.0), hole, 10.0 * CELL)
    crushed, dilated = 1.0 - (1.0 - virgin) * np.exp(-e), 1.0 - (1.0 - virgin) * np.exp(-0.05)
    assert np.allclose(rings.porosity[:4], [crushed, crushed, dilated, virgin],
        atol=2e-3) and abs(rings.virgin - virgin) < 1e-12, rings.porosity[:4]
    assert np.allclose(rings.crushed, [radius, radius + 2.0 * CELL],
        atol=TENTH) and abs(rings.dilated[1] - radius - 3.0 * CELL) < TENTH, (rings.crushed, rings.dilated)
    k = [(p / virgin) ** 3 * ((1.0 - virgin) / (1.0 - p)) ** 2 for p in (crushed, dilated)]
    by_hand = (1.0 / k[0] - 1.0) * np.log(5.25 / 3.25) + (1.0 / k[1] - 1.0) * np.log(6.25 / 5.25)
    assert abs(rings.skin - by_hand) < 0.03 * abs(by_hand), (rings.skin, by_hand)


def check_wide_particles(folder):
    """Particles four cells wide around a layer of small ones: every ring that they cover has their porosity."""
    radius, e, virgin = 3.25 * CELL, -0.1, 1.0 - np.exp(-0.2231)
    small = lattice(radius, radius + 4.0 * CELL, 0.0, LENGTH)
    middle = CELL * (np.arange(4, 20, 4) + 2.0)
    wide = np.stack([m.ravel() for m in np.meshgrid(radius + middle, np.arange(2.0, 20.0, 4.0) * CELL)], axis=1)
    shapes = np.concatenate([squares(small, 0.25 * CELL), squares(wide, 2.0 * CELL)])
    block = rock(np.concatenate([small, wide]), e=np.repeat([0.0, e], [len(small), len(wide)]))
    block.start, block.end = shapes, shapes
    hole, frame, deck = measured(folder / "wide", [block])
    rings = zones.rings_at(zones.Rock(frame, deck, 0.0), hole, 10.0 * CELL)
    crushed = 1.0 - (1.0 - virgin) * np.exp(-e)
    assert np.allclose(rings.porosity[:4], virgin, atol=2e-3) and len(rings.porosity) >= 16, rings.porosity
    assert np.allclose(rings.porosity[5:16], crushed, atol=1e-12), rings.porosity


def check_porosity():
    """Hawkins' formula for one zone; closed pores let next to nothing through."""
    assert abs(porosity.skin(np.array([1.0, 2.0, 9.0]), np.array([0.1, 1.0])) - 9.0 * np.log(2.0)) < 1e-12
    assert porosity.relative_permeability(np.array([0.2]), 0.2) == 1.0 and porosity.relative_permeability(np.array([0.0]), 0.2) == 0.0
    # As tests/unit/jet/test_rock_zones.cpp has it of the program.
    assert porosity.relative_permeability(0.36, 0.2) == 3.0 and abs(porosity.relative_permeability(0.36, 0.2, 1.0) - 0.9) < 1e-15
    assert abs(porosity.relative_permeability(0.2, 0.2, 0.5) - 4.0 / (1.0 + 0.3 ** -0.5) ** 2) < 1e-15
    assert abs(porosity.skin(np.array([1.0, 2.0]), np.array([0.0])) - (1e4 - 1.0) * np.log(2.0)) < 1e-8


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for check in (check_straight, check_deformed, check_debris, check_slot, check_closed, check_through, check_gap, check_zones,
                check_wide_particles):
            check(folder)
    check_porosity()
    print("holes and their zones are measured as they were laid")


if __name__ == "__main__":
    main()
