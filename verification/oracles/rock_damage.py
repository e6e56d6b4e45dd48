# SPDX-License-Identifier: BSD-3-Clause
"""Rock that breaks, under axial strain and constant stress at its side: docs/method.md 18 written anew, without the library.

The plastic deviator is the variable. At each of its values damage tells the surface, the surface tells the axial stress, and their slopes
tell dilation and damage. Nothing elastic enters.
"""
import numpy as np

ROOT_3 = np.sqrt(3.0)


class BreakingRock:
    """Surface and rules of a card; stresses in Pa, tension positive."""

    def __init__(self, card):
        """@param card  parameters by their published names"""
        self.card = {"BETA_nonassociativity": 1.0, "Dilatancy limit": 0.0, "Dilatancy pressure": 0.0, "Damage pressure": 0.0,
            "Broken dilatancy": 0.0, **card}  # fmt: skip

    def limit(self, x, damage):
        """sqrt(J2) and its slope at I1 = x."""
        c = self.card
        slope = c["FSLOPE"] - damage * (c["FSLOPE"] - c["Residual slope"])
        y = (1.0 - damage) * c["PEAKI1"] - x
        room = c["STREN"] - c["YSLOPE"] * (1.0 - damage) * c["PEAKI1"]
        rate = (slope - c["YSLOPE"]) / room
        left = np.exp(-rate * y)
        return room * (1.0 - left) + c["YSLOPE"] * y, -(room * rate * left + c["YSLOPE"])

    def branch_point(self, damage, evp):
        """kappa and X."""
        c = self.card
        if evp > 0.0:
            X = c["p0_crush_curve"] * (1.0 + evp) ** (1.0 / (c["p0_crush_curve"] * c["p1_crush_curve"] * c["p3_crush_curve"]))
        else:
            X = c["p0_crush_curve"] + np.log1p(evp / c["p3_crush_curve"]) / c["p1_crush_curve"]
        peak = (1.0 - damage) * c["PEAKI1"]
        return peak - c["CR"] * (peak - X), X

    def cap(self, x, damage, evp):
        """Factor of the strength, its slope, and how far along the cap x is."""
        kappa, X = self.branch_point(damage, evp)
        if x >= kappa:
            return 1.0, 0.0, 0.0
        along = (kappa - x) / (kappa - X)
        factor = np.sqrt(max(1.0 - along**2, 0.0))
        return factor, along / ((kappa - X) * max(factor, 1e-300)), along

    def strength(self, x, damage, evp):
        (limit, slope), (factor, rise, along) = self.limit(x, damage), self.cap(x, damage, evp)
        return limit * factor, slope * factor + limit * rise, along

    def denser(self, x, damage, evp):
        """How far broken rock is from the volume and the pressure at which it shears without dilating, from 0 to 1 (18.4)."""
        c = self.card
        if c["Broken dilatancy"] == 0.0:
            return 0.0
        return min(max(-evp, 0.0) / c["Dilatancy limit"], 1.0) * min(max(1.0 - x / self.branch_point(damage, evp)[0], 0.0), 1.0)

    def axial_stress(self, side, damage, evp, sign):
        """Where the path under constant stress at the side meets the surface: sign 1 in tension, -1 in compression."""

        def outside(difference):
            return difference / ROOT_3 - self.strength(3.0 * side + sign * difference, damage, evp)[0]

        low, high = 0.0, 1e6
        while outside(high) < 0.0:
            low, high = high, 1.5 * high
        for _ in range(80):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if outside(middle) < 0.0 else (low, middle)
        return side + sign * high

    def rates(self, side, damage, evp, sign, fracture_strain):
        """d(damage), d(evp) and d(plastic axial strain) for a unit of equivalent plastic shear strain."""
        c = self.card
        x = 2.0 * side + self.axial_stress(side, damage, evp, sign)
        _, slope, along = self.strength(x, damage, evp)
        pressure = max(-x / 3.0, 0.0)
        share = c["BETA_nonassociativity"] ** 2
        if c["Dilatancy limit"] > 0.0 or c["Dilatancy pressure"] > 0.0:
            room = 1.0 - max(evp, 0.0) / c["Dilatancy limit"] if c["Dilatancy limit"] > 0.0 else 1.0
            pressed = np.exp(-pressure / c["Dilatancy pressure"]) if c["Dilatancy pressure"] > 0.0 else 1.0
            left = max(room * (1.0 - damage), 1e-4) * pressed + damage * c["Broken dilatancy"] * self.denser(x, damage, evp)
            share *= left + (1.0 - left) * along
        volume = -3.0 * ROOT_3 * share * slope
        weight = (np.exp(-pressure / c["Damage pressure"]) if c["Damage pressure"] > 0.0 else 1.0) * (1.0 - along)
        growth = weight * (1.0 + max(volume, 0.0) / 3.0) / fracture_strain if damage < 1.0 else 0.0
        return np.array([growth, volume, sign + volume / 3.0])

    def path(self, side, shears, sign, fracture_strain, crushed=0.0):
        """Damage, volumetric and axial plastic strain and axial stress at these plastic shear strains, which begin with 0.

        @param crushed  volumetric plastic strain at the start
        """
        state, rows = np.array([0.0, crushed, 0.0]), []
        for begin, end in zip(shears, [*shears[1:], None]):
            rows.append([*state, self.axial_stress(side, state[0], state[1], sign)])
            if end is None:
                break
            first = self.rates(side, state[0], state[1], sign, fracture_strain)
            middle = state + 0.5 * (end - begin) * first
            state = state + (end - begin) * self.rates(side, min(middle[0], 1.0), middle[1], sign, fracture_strain)
            state[0] = min(state[0], 1.0)
        return np.array(rows).T

    def mean_tension(self):
        """Of the uniaxial tensile strength over damage from 0 to 1."""
        at = np.linspace(0.0, 1.0, 2001)
        strengths = np.array([self.axial_stress(0.0, d, 0.0, 1) if d < 1.0 else 0.0 for d in at])
        return float(np.sum(0.5 * (strengths[1:] + strengths[:-1]) * np.diff(at)))
