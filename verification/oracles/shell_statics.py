# SPDX-License-Identifier: BSD-3-Clause
"""Thick spherical shell of an incompressible von Mises matrix, quasi-static, with a barotropic fluid in its pore.

M. Carroll, A. Holt, J. Appl. Phys. 43 (1972) 1626, with unloading, reverse yield and pore fluid. Every material point
keeps X - c = r^3, where X is its r^3 at the start and c = a0^3 - a^3 is common to all; lengths are such that the matrix
has b^3 - a^3 = 1. With alpha = b^3 (distension; porosity phi = 1 - 1/alpha), a^3 = alpha - 1, c = alpha0 - alpha and
the volume strain of the whole is ln(alpha / alpha0). Equilibrium, with s = sigma_r - sigma_theta:

    P - p_f = (2/3) int_{a^3}^{b^3} s dx / x

Elastic laws: "H", the rate form ds = 2 G (d_r - d_theta) dt integrated exactly, s = 2 G ln(1 + c/x); "S", its
linearisation s = 2 G c / x, the published one. Stresses in Pa; P and p_f positive in compression.
"""
import dataclasses
import math

from scipy.optimize import brentq
from scipy.special import spence


def dilogarithm(z):
    """Li2(z) = -int_0^z ln(1 - t) / t dt, real z <= 1."""
    return float(spence(1.0 - z))


@dataclasses.dataclass(frozen=True)
class Shell:
    """Material and geometry. `law` is "H" or "S"; no fluid if fluid_modulus is 0."""

    porosity: float = 0.2
    shear_modulus: float = 15e9
    strength: float = 300e6  # Y: |sigma_r - sigma_theta| at yield
    fluid_modulus: float = 0.0
    fluid_pressure: float = 0.0  # at the start
    law: str = "H"

    @property
    def start(self):
        """alpha0."""
        return 1.0 / (1.0 - self.porosity)

    @property
    def yield_ratio(self):
        """c / x where a virgin point yields."""
        ratio = self.strength / (2.0 * self.shear_modulus)
        return math.expm1(ratio) if self.law == "H" else ratio

    @property
    def reverse_ratio(self):
        """(alpha - alpha_turn) / x where a point that was at yield yields the other way."""
        ratio = self.strength / self.shear_modulus
        return -math.expm1(-ratio) if self.law == "H" else ratio


def distension(shell, strain):
    """alpha at a volume strain of the whole."""
    return shell.start * math.exp(strain)


def strain_of(shell, alpha):
    return math.log(alpha / shell.start)


def elastic_part(shell, c, low, high):
    """int_low^high s dx / x with the elastic s that c has caused."""
    if shell.law == "S":
        return 2.0 * shell.shear_modulus * c * (1.0 / low - 1.0 / high)
    return 2.0 * shell.shear_modulus * (dilogarithm(-c / high) - dilogarithm(-c / low))


def first_yield(shell):
    """alpha where the inner wall yields."""
    k = shell.yield_ratio
    return (shell.start + k) / (1.0 + k)


def full_yield(shell):
    """alpha where the outer surface yields."""
    return shell.start / (1.0 + shell.yield_ratio)


def plastic_front(shell, alpha):
    """x = r^3 up to which the shell has yielded in loading, within [a^3, b^3]."""
    return min(max((shell.start - alpha) / shell.yield_ratio, alpha - 1.0), alpha)


def loading(shell, alpha):
    """(P - p_f, phase) under monotone loading from alpha0 to alpha."""
    front = plastic_front(shell, alpha)
    plastic = shell.strength * math.log(front / (alpha - 1.0))
    outside = elastic_part(shell, shell.start - alpha, front, alpha)
    phase = "elastic" if front <= alpha - 1.0 else "plastic" if front >= alpha else "el-plastic"
    return 2.0 / 3.0 * (plastic + outside), phase


def unloading(shell, alpha, turn):
    """(P - p_f, phase) at alpha >= turn, after monotone loading to alpha = turn.

    From inside out: points at reverse yield, s = -Y; points that were at yield when the load turned, elastic since;
    points that never yielded, whose s follows from c alone.
    @raise ValueError beyond the closed form: reverse yield has reached points that had not yielded
    """
    opened = alpha - turn
    yielded = plastic_front(shell, turn) + opened  # the same material points, now further out
    reverse = min(max(opened / shell.reverse_ratio, alpha - 1.0), alpha)
    if reverse > yielded * (1.0 + 1e-12):
        raise ValueError("reverse yield has passed the old front; integrate a column of points instead")
    value = -shell.strength * math.log(reverse / (alpha - 1.0)) + shell.strength * math.log(yielded / reverse)
    value += elastic_part(shell, -opened, reverse, yielded)
    value += elastic_part(shell, shell.start - alpha, yielded, alpha)
    if reverse <= alpha - 1.0:
        return 2.0 / 3.0 * value, "elastic-unload"
    return 2.0 / 3.0 * value, "reverse-plastic" if reverse >= alpha else "reverse-partial"


def reverse_yield_range(shell, turn):
    """alpha where reverse yield begins at the wall, and where it is complete (after full yield)."""
    k = shell.reverse_ratio
    return (turn - k) / (1.0 - k), turn / (1.0 - k)


def fluid_pressure(shell, alpha):
    """p_f = p_f0 - K_f ln(a^3 / a0^3): the fluid fills the pore and none escapes."""
    return shell.fluid_pressure + shell.fluid_modulus * math.log((shell.start - 1.0) / (alpha - 1.0))


def elastic_centre(shell, turn):
    """alpha on the unloading path where P = p_f."""
    beyond = reverse_yield_range(shell, turn)[1]
    return brentq(lambda alpha: unloading(shell, alpha, turn)[0], turn, beyond, xtol=1e-15, rtol=1e-14)


def zero_pressure(shell, turn):
    """alpha on the unloading path where the total pressure P is zero."""
    total = lambda alpha: unloading(shell, alpha, turn)[0] + fluid_pressure(shell, alpha)
    return brentq(total, turn, shell.start, xtol=1e-15, rtol=1e-14)


def landmarks(shell, turn_strain):
    """The states that mark the curve, by the names of the stored numbers."""
    turn = distension(shell, turn_strain)
    begin, end = reverse_yield_range(shell, turn)
    centre = elastic_centre(shell, turn)
    peak, at_centre = loading(shell, turn)[0], fluid_pressure(shell, centre)
    modulus = 4.0 / 3.0 * shell.shear_modulus * (1.0 - shell.porosity) / shell.porosity
    out = {
        "alpha1": first_yield(shell), "P1": loading(shell, first_yield(shell))[0],
        "alpha2": full_yield(shell), "P2": loading(shell, full_yield(shell))[0],
        "K_dry0": modulus, "K_undrained0": modulus + shell.fluid_modulus / shell.porosity,
        "Pm": peak, "pf_m": fluid_pressure(shell, turn),
        "alpha3": begin, "P3": unloading(shell, begin, turn)[0],
        "alpha4": end, "P4": unloading(shell, end, turn)[0],
        "alpha_star": centre, "ev_star": strain_of(shell, centre), "pf_star": at_centre, "zeta": -3.0 * at_centre,
        "X_drained": -3.0 * peak, "X_total_minus_zeta": -3.0 * (peak + fluid_pressure(shell, turn) - at_centre),
        "ev_P0_undrained": strain_of(shell, zero_pressure(shell, turn)),
    }  # fmt: skip
    return out


def curve(shell, strains, turn_strain):
    """Rows (strain, branch, phase, P - p_f, p_f): down to turn_strain, then back; strains in that order."""
    turn, rows, turned = distension(shell, turn_strain), [], False
    for strain in strains:
        alpha = distension(shell, strain)
        value, phase = unloading(shell, alpha, turn) if turned else loading(shell, alpha)
        rows.append((strain, "unload" if turned else "load", phase, value, fluid_pressure(shell, alpha)))
        turned = turned or strain <= turn_strain
    return rows
