# SPDX-License-Identifier: BSD-3-Clause
"""Depths of penetration by theory, of a jet that is a table of slugs, into layers along its path.

A slug of velocity v, local length l and digging density rho_j meets the bottom at the depth P. It digs at u,

    rho_j (v - u)^2 / 2 + Y = rho_t u^2 / 2 + R,      dP = l u / (v - u),

with the target's resistance R and the jet's strength Y (Alekseevskii 1966, Tate 1967); without both this is the hydrodynamic
theory of Birkhoff, MacDougall, Pugh and Taylor (1948). Whole metal goes on stretching in flight: at the distance X from the launch
plane its length is l (S + X) / S, S the distance of the virtual origin (Allison and Vitali 1963; DiPersio and Simon 1964), until it
breaks up. Pieces keep their length. Digging density of full metal rho, and of metal of mean density r, r (2 - r / rho): the shock
that closes its voids takes the rest (docs/jets.md).
"""

import dataclasses
import math


@dataclasses.dataclass
class Slug:
    time: float  # its centre crosses the launch plane [s]
    velocity: float
    radius: float
    length: float
    density: float  # mean
    piece: bool

    @property
    def mass(self):
        return self.density * math.pi * self.radius**2 * self.length


@dataclasses.dataclass
class Layer:
    """Of the target: where it ends below the face [m], density, resistance [Pa]."""

    end: float
    density: float
    resistance: float = 0.0


def totals(slugs):
    """Mass, momentum, kinetic energy."""
    return tuple(sum(slug.mass * slug.velocity**power / (2.0 if power == 2 else 1.0) for slug in slugs) for power in range(3))


def virtual_origin(slugs):
    """(distance S before the launch plane, rms of the launch times about t = S / v + const [s]), by least squares weighted with
    mass; S is 0 where the jet does not stretch."""
    mass = [slug.mass for slug in slugs]
    slowness = [1.0 / slug.velocity for slug in slugs]
    whole = sum(mass)
    mean = sum(m * s for m, s in zip(mass, slowness)) / whole
    time = sum(m * slug.time for m, slug in zip(mass, slugs)) / whole
    spread = sum(m * (s - mean) ** 2 for m, s in zip(mass, slowness))
    if not spread > 0.0:
        return 0.0, 0.0
    distance = sum(m * (s - mean) * (slug.time - time) for m, s, slug in zip(mass, slowness, slugs)) / spread
    left = sum(m * (slug.time - time - distance * (s - mean)) ** 2 for m, s, slug in zip(mass, slowness, slugs))
    return max(0.0, distance), math.sqrt(left / whole)


def digging_speed(velocity, jet_density, target_density, strength, resistance):
    """u of the theory above; 0 where the slug is too slow to dig."""
    k = target_density / jet_density
    more = 2.0 * (resistance - strength) / jet_density
    # (v - u)^2 = k u^2 + more
    if velocity**2 <= more:
        return 0.0
    if abs(1.0 - k) < 1e-12:
        return (velocity**2 - more) / (2.0 * velocity)
    root = math.sqrt(k * velocity**2 + more * (1.0 - k))
    return (velocity - root) / (1.0 - k) if k < 1.0 else (root - velocity) / (k - 1.0)


def stretched(slug, travelled, origin, break_up):
    """Length of a slug at a distance from the launch plane; it breaks up at a time since the virtual origin."""
    if slug.piece or not origin > 0.0:
        return slug.length
    broken = break_up * slug.velocity - origin  # travelled until then
    return slug.length * (origin + min(travelled, max(0.0, broken))) / origin


def depth(slugs, layers, start, *, metal_density, origin=0.0, break_up=math.inf, cut_off=0.0, strength=0.0):
    """Depth below the face, which is `start` from the launch plane [m]; the whole target where the jet comes through."""
    bottom, layer, most_pieces = 0.0, 0, 64
    for slug in slugs:
        if slug.velocity < cut_off:
            continue
        for _ in range(most_pieces):  # parts of a slug: the bottom moves on while it digs
            share = 1.0 / most_pieces
            length = share * stretched(slug, start + bottom, origin, break_up)
            growth = length / (slug.length * share)
            mean = slug.density if slug.density > 0.999 * metal_density else slug.density / growth
            if slug.density > 0.999 * metal_density:
                dense = slug.density
            else:
                dense = mean * (2.0 - mean / metal_density)
            while length > 0.0:
                here = layers[layer]
                u = digging_speed(slug.velocity, dense, here.density, strength, here.resistance)
                if not u > 0.0:
                    break
                dug = length * u / (slug.velocity - u) if u < slug.velocity else math.inf
                left = here.end - bottom
                if dug < left:
                    bottom += dug
                    break
                length *= 1.0 - left / dug
                bottom = here.end
                layer += 1
                if layer == len(layers):
                    return bottom
    return bottom
