# SPDX-License-Identifier: BSD-3-Clause
"""Stress paths of chosen particles: which ones --particles means, and what particles.e has of them."""

import dataclasses

import numpy as np

from barreno.report.hole import target_particles
from barreno.report.numbers import MICRO
from barreno.report.particles import offsets
from barreno.report.principal import along_path, lode_angle, pressure_and_shear, tensors
from barreno.runs.faults import Fault

NEAR_TIP = "near tip"
MOST = 8  # particles whose colours can be told apart
EXAMPLE = 'write for example --particles "near tip" or --particles 120,340'
STRESSES = ("stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx")
APART = 0.2  # of the distance within which particles are near the tip: those that are closer are all under the same blow
SECTORS = (30.0, 75.0, 120.0)  # degrees from the direction of the flight: ahead of the tip, obliquely ahead, beside it
COARSE = 0.1  # of the extent of a path: a larger change from one time to the next is no path any more


@dataclasses.dataclass
class StressPath:
    """A particle while it exists. Stresses are effective where there is a pore pressure, compression positive."""

    number: int  # of its element
    material: str
    times: np.ndarray
    places: np.ndarray  # (time, axis) [m]
    stress: np.ndarray  # (time, 3): principal stresses that begin along y, x and z [Pa]
    strain: np.ndarray  # plastic volume strain; nan of a material without
    coherence: np.ndarray  # strength at the vertex over that of the card, before damage
    damage: np.ndarray  # 0 of rock without damage

    @property
    def pressure(self):
        return pressure_and_shear(self.stress)[0]

    @property
    def shear(self):
        return pressure_and_shear(self.stress)[1]

    @property
    def lode(self):
        return lode_angle(-np.sort(-self.stress, axis=-1))

    @property
    def largest_step(self):
        """(share, interval): the largest change from one time to the next, over the extent of the path."""
        if len(self.times) < 2:
            return 0.0, 0.0
        extent = np.linalg.norm(np.ptp(self.stress, axis=0))
        steps = np.linalg.norm(np.diff(self.stress, axis=0), axis=1)
        return float(steps.max() / extent) if extent > 0.0 else 0.0, float(np.diff(self.times)[steps.argmax()])

    def at(self, time):
        """Index of the time that is nearest."""
        return int(np.abs(self.times - time).argmin())


def numbers_of(text):
    """Numbers of elements among the words of --particles, none for "near tip"; each once, in their order."""
    if " ".join(text.split()) == NEAR_TIP:
        return []
    parts = [part.strip() for part in text.split(",")]
    if not all(part.isascii() and part.isdigit() for part in parts):
        raise Fault(f'--particles "{text.strip()}" is neither "{NEAR_TIP}" nor numbers of particles; {EXAMPLE}.')
    if len(set(parts)) > MOST:
        raise Fault(f"--particles has {len(set(parts))} particles, of which no more than {MOST} can be told apart; choose fewer.")
    return [int(part) for part in dict.fromkeys(parts)]


def elements_of(file, numbers):
    """Places of elements in the file by their numbers."""
    places = {int(number): element for element, number in enumerate(file.numbers)}
    for number in numbers:
        if number not in places:
            raise Fault(f"--particles has {number}, but the particles of this run are {min(places)} to {max(places)}; choose among these.")
    return [places[number] for number in numbers]


def nearest_in_sectors(centres, tip, direction, least):
    """Rows that are nearest to the tip, but no nearer than `least`: ahead of it, obliquely ahead, beside it; fewer where there is
    nothing."""
    across, along = offsets(centres, tip)
    distance, angle = np.hypot(across, along), np.degrees(np.arctan2(across, direction * along))
    rows = []
    for low, high in zip((0.0, *SECTORS), SECTORS):
        inside = np.flatnonzero((low <= angle) & (angle < high) & (distance >= least))
        if len(inside):
            rows.append(int(inside[distance[inside].argmin()]))
    return rows


def elements_near(frame, deck, tip, distance):
    """Elements of target particles at the tip of the hole, those of rock with pores before others."""
    if tip is None:
        why = f"the jet has not hit the target at {frame.time / MICRO:.4g} us" if deck.has_jet else "this run has no jet"
        raise Fault(f'--particles "{NEAR_TIP}" finds no tip ({why}); name particles by their numbers, for example --particles 120,340.')
    away = np.hypot(*offsets(frame.centres, tip))
    near = (away <= distance) & target_particles(frame, deck)
    porous = near & np.isfinite(frame.of_alive(["plastic_volume_strain"]))
    rows = np.flatnonzero(porous if porous.any() else near)
    if not len(rows):
        raise Fault(f'--particles "{NEAR_TIP}" finds no particle of the target within {1e3 * distance:.3g} mm of the tip; name particles '
            'by their numbers, for example --particles 120,340.')
    kept = rows[nearest_in_sectors(frame.centres[rows], tip, deck.direction, APART * distance)]
    if not len(kept):
        kept = rows[[int(away[rows].argmin())]]
    return [int(element) for element in np.flatnonzero(frame.alive)[kept]]


def path_of(file, element):
    """@raises Fault  for a particle that exists at no time of the file"""
    alive = file.series("status", element) > 0.5
    if not alive.any():
        raise Fault(f"--particles has {file.numbers[element]}, which exists at no time of particles.e; choose another.")
    parts = [file.series(name, element)[alive] for name in STRESSES[: 4 if file.dimensions == 2 else 6]]
    if not np.isfinite(parts).all():
        raise ValueError(f"it has no stresses of particle {file.numbers[element]}")
    pores = np.nan_to_num(file.series("pore_pressure", element)[alive])
    stress = along_path(tensors(*parts)) - pores[:, None]
    coherence = np.nan_to_num(file.series("coherence", element)[alive], nan=1.0)
    damage = np.nan_to_num(file.series("damage", element)[alive])
    strain = file.series("plastic_volume_strain", element)[alive]
    return StressPath(int(file.numbers[element]), file.block_names[file.block[element]], file.times[alive], file.track(element)[alive],
        stress[:, [1, 0, 2]], strain, coherence, damage)


def surface_now(path, strength, at):
    """(Strength, plastic volume strain) of a particle at a time of its path."""
    return strength.scaled(float(path.coherence[at]), float(path.damage[at])), float(np.nan_to_num(path.strain[at]))


def share_of_strength(path, strength, at):
    """sqrt(J2) over that of the particle's surface at its pressure and Lode angle; nan beyond vertex and cap."""
    own, e = surface_now(path, strength, at)
    limit = own.shear_at(path.pressure[at], e) * own.shape(path.lode[at])
    return float(path.shear[at] / limit) if limit > 0.0 else float("nan")
