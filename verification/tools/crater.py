# SPDX-License-Identifier: BSD-3-Clause
"""The crater of a sphere in an axisymmetric block whose face is at y = 0: its floor, its wall and the damage below it, of one output.

Rock is there where a row or ring holds at least half of the mass that it had: ejecta that fly through do not fill the crater."""
import dataclasses

import numpy as np
from tools.penetration import share

FULL = 0.5  # of the mass of whole rock
ROW = 0.25e-3  # of the floor and the wall [m]
FLOOR = 4  # rows of whole rock are the floor of the pit
DEEP, WIDE = 40e-3, 30e-3  # deeper and wider than any crater here [m]
BLOCK_END = 50e-3  # below it the rear face reflects waves, which tear the rock [m]


@dataclasses.dataclass
class Crater:
    depth: float  # of the pit that is open to the face [m]
    cracked: float  # depth from which on no crack parts the rock below the pit [m]
    width: float  # of the opening, in the first millimetre below the face [m]
    volume: float  # of the pit below the face [m3]
    damage: float  # depth of the deepest rock that is more than half broken, within 10 mm of the axis [m]
    profile: list  # (radius, y) of the wall in rows from the face to the floor [mm]


@dataclasses.dataclass
class Rock:
    """Particles of the block: centres, half sides of the squares that they are in the section, volumes at the start, damage."""

    x: np.ndarray
    y: np.ndarray
    half: np.ndarray
    volume: np.ndarray
    damage: np.ndarray


def rock_of(run, step, block):
    """@param block  number of the first particle of the block"""
    start, now = run.particles(0), run.particles(step)
    there = now["status"] > 0.5
    there[:block] = False
    box = np.ptp(start["corners"][there], axis=1)
    x, area = now["x"][there], box[:, 0] * box[:, 1]
    volume = 2.0 * np.pi * start["x"][there] * area
    half = 0.5 * np.sqrt(volume * now["volume_ratio"][there] / (2.0 * np.pi * x))
    return Rock(x, now["y"][there], half, volume, now["damage"][there])


def filled(rock, r, y):
    """Share of the mass of whole rock that a ring of radii r and depths y holds."""
    mass = rock.volume * share(rock.x, rock.half, *r) * share(rock.y, rock.half, *y)
    return float(mass.sum()) / (np.pi * (r[1] ** 2 - r[0] ** 2) * (y[1] - y[0]))


def floors_of(rock, radius):
    """Within a radius: depth of the first rock that is whole, and depth from which on all is."""
    rows = int(round(DEEP / ROW))
    whole = np.array([filled(rock, (0.0, radius), (i * ROW, (i + 1) * ROW)) >= FULL for i in range(rows)])
    first = next((i for i in range(rows) if whole[i : i + FLOOR].all()), rows)
    last = rows - next((i for i in range(rows) if not whole[rows - 1 - i]), rows)
    return first * ROW, last * ROW


def wall_of(rock, y):
    """Radius from which on the rock between two depths is whole."""
    rings = int(round(WIDE / ROW))
    for i in reversed(range(rings)):
        if filled(rock, (i * ROW, (i + 1) * ROW), y) < FULL:
            return (i + 1) * ROW
    return 0.0


def crater_of(run, step, block, radius):
    """@param radius  of the sphere, within which the floor is measured [m]"""
    rock = rock_of(run, step, block)
    depth, cracked = floors_of(rock, radius)
    near = (rock.y > -1e-3) & (rock.y < DEEP) & (rock.x < WIDE + 5e-3)
    here = Rock(rock.x[near], rock.y[near], rock.half[near], rock.volume[near], rock.damage[near])
    rows = [(2.0 * i * ROW, 2.0 * (i + 1) * ROW) for i in range(int(np.ceil(0.5 * depth / ROW)))]
    walls = [wall_of(here, row) for row in rows]
    broken = (rock.damage > 0.5) & (rock.x < 10e-3) & (rock.y < BLOCK_END)
    profile = [[1e3 * wall, -0.5e3 * sum(row)] for wall, row in zip(walls, rows)]
    return Crater(depth, cracked, 2.0 * wall_of(here, (0.0, 1e-3)), float(sum(np.pi * wall**2 * 2.0 * ROW for wall in walls)),
        float(rock.y[broken].max(initial=0.0)), [*profile, [0.0, -1e3 * depth]])
