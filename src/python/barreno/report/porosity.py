# SPDX-License-Identifier: BSD-3-Clause
"""Porosity that crushing and dilation have left, broken grains, the permeability of such rock, and the skin of a hole in it."""

import numpy as np

from barreno.report.run_tables import TABLES

LAW = TABLES["permeability"]  # of src/jet/rock_permeability.hpp
LEAST_PERMEABILITY = LAW["least"]  # of the virgin one: of rock whose pores are closed, so that a skin stays a number
IMPAIRED = LAW["impaired"]  # of the virgin permeability: rock below it counts as impaired


def virgin_porosity(deck, material):
    """1 - exp(-p3) of a card of Arenisca; nan of other materials."""
    if not deck.text(f"Materials/{material}/Model").startswith("Arenisca"):
        return float("nan")
    return -np.expm1(-deck.number(f"Materials/{material}/p3_crush_curve"))


def permanent_porosity(frame, deck):
    """phi = 1 - (1 - phi_0) exp(-e) of the volumetric plastic strain e: grains keep their volume in plastic flow, and what elastic strain
    does to the pores is left out. nan where the material has no pores."""
    virgin = np.array([virgin_porosity(deck, name) for name in frame.file.block_names])[frame.block]
    with np.errstate(over="ignore", invalid="ignore"):
        return np.clip(1.0 - (1.0 - virgin) * np.exp(-frame.of_alive(["plastic_volume_strain"])), 0.0, 1.0)


def breakage_of(frame):
    """Breakage of the grains; 0 where the material has no such history."""
    return np.nan_to_num(frame.of_alive(["breakage"]))


def relative_permeability(porosity, virgin, breakage=0.0):
    """k/k_0 = min((phi/phi_0)^3 ((1 - phi_0)/(1 - phi))^2, 3) / (1 + s B)^2 as rock_permeability() of src/jet/rock_permeability.hpp, which
    explains it."""
    solid = np.maximum(1.0 - porosity, 1e-12)
    of_pores = np.minimum((porosity / virgin) ** 3 * ((1.0 - virgin) / solid) ** 2, LAW["most"])
    return of_pores / (1.0 + breakage * (LAW["of_broken"] ** -0.5 - 1.0)) ** 2


def skin(edges, permeability):
    """Hawkins' skin (Trans. AIME 207, 356, 1956) of rings of rock one around the other, s = sum (k_0/k - 1) ln(r_outer/r_inner).

    @param edges         radii of the rings, one more than there are rings, from the wall of the hole outwards
    @param permeability  k/k_0 of every ring
    """
    return float(np.sum((1.0 / np.maximum(permeability, LEAST_PERMEABILITY) - 1.0) * np.log(edges[1:] / edges[:-1])))
