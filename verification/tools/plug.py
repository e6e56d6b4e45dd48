# SPDX-License-Identifier: BSD-3-Clause
"""A material point as a specimen of the laboratory, and its card."""
import pathlib
import xml.etree.ElementTree as xml

import numpy as np
from barreno.materials import CONSISTENT

HELD = 1e-9  # of the confinement: how well it is kept
# The same where an increment takes one substep more or less at the next strain: its stress jumps there by the error of its substeps.
JUMP = 1e-3


def write_card(folder, card, parameters):
    """A card with parameters added or changed, as a file in a folder."""
    tree = xml.parse(card)
    for there in [there for there in tree.getroot() if there.get("name") in parameters]:
        tree.getroot().remove(there)
    for key, value in parameters.items():
        kind = "string" if isinstance(value, str) and not value[0].isdigit() else "double"
        tree.getroot().append(xml.Element("Parameter", name=key, type=kind, value=str(value)))
    file = pathlib.Path(folder) / "rock.xml"
    tree.write(file)
    return file


def card_numbers(card):
    """{name: number} of a card in SI."""
    numbers = {}
    for entry in xml.parse(card).getroot().iter("Parameter"):
        try:
            numbers[entry.get("name")] = float(entry.get("value"))
        except ValueError:  # a word
            continue
    return numbers


def softens(card):
    """Whether rock of a card loses the moduli of its pressure where it dilates: by its word, and as published without one."""
    words = {entry.get("name"): entry.get("value") for entry in xml.parse(card).getroot().iter("Parameter")}
    return words.get("Dilated moduli", "constant") == "constant"


class Plug:
    """One point under axial strain and constant pressure at the side."""

    def __init__(self, material, pore_pressure, dt=1.0):
        """@param dt  of an increment [s]"""
        self.material, self.dt = material, dt
        self.stress, self.state = material.virgin(1)
        self.stress[:, :3] = -(pore_pressure or 0.0)

    def get(self, name):
        names = self.material.state_names
        return float(self.state[0, names.index(name)]) if name in names else 0.0

    def confine(self, pressure):
        """All stresses to -pressure, in steps; the volume strain of that."""
        start = -self.stress[0, 0]
        parts = np.linspace(0.0, 1.0, 11)[1:]
        return sum(self._reach(np.zeros(3), [0, 1, 2], -(start + part * (pressure - start))) for part in parts)

    def shorten(self, strain, pressure):
        """Axial strain, constant stress at the side; the volume strain of that."""
        return self._reach(np.array([strain, 0.0, 0.0]), [1, 2], -pressure)

    def shear(self, strain):
        """Shear strain alone, which leaves the pressures of elastic rock as they are."""
        self._strain(3, strain)

    def strain_axially(self, strain):
        """Axial strain alone."""
        self._strain(0, strain)

    def squeeze(self, strain):
        """The same strain along all axes."""
        self._strain(slice(0, 3), strain)

    def _strain(self, components, strain):
        increment = np.zeros((1, 6))
        increment[0, components] = strain
        answer = self.material.update(increment, self.stress, self.state, self.dt, CONSISTENT)
        assert not answer.status.any(), "the point failed"
        self.stress, self.state = answer.stress, answer.state

    def pressure(self):
        return -float(self.stress[0, :3].mean())

    def root_j2(self):
        deviator = self.stress[0].copy()
        deviator[:3] += self.pressure()
        return float(np.sqrt(0.5 * (deviator[:3] ** 2).sum() + (deviator[3:] ** 2).sum()))

    def _reach(self, strain, free, target):
        """Newton's method for the free strains; at a jump the nearest of its strains."""
        strain = np.concatenate([strain, np.zeros(3)])[None, :]
        scale, nearest = max(abs(target), 1e6), (np.inf, None, None)
        for _ in range(60):
            answer = self.material.update(strain, self.stress, self.state, self.dt, CONSISTENT)
            assert not answer.status.any(), "the point failed"
            miss = answer.stress[0, free] - target
            if np.abs(miss).max() < nearest[0]:
                nearest = np.abs(miss).max(), answer, float(strain[0, :3].sum())
            if nearest[0] <= HELD * scale:
                break
            strain[0, free] -= np.linalg.solve(answer.tangent[0][np.ix_(free, free)], miss)
        left, answer, volume = nearest
        assert left <= JUMP * scale, f"the confinement was not reached: {left:.3g} of {target:.3g} Pa are left"
        self.stress, self.state = answer.stress, answer.state
        return volume
