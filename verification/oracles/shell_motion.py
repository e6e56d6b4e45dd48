# SPDX-License-Identifier: BSD-3-Clause
"""Motion of the thick spherical shell: the exact coasting implosion, and the same with a compressible matrix.

Coasting: no load; the shell starts with the divergence-free velocity v = -D / r^2 and is stopped by the plastic work of
its matrix and the compression of the fluid in its pore. With an incompressible matrix the motion has one degree of
freedom, c = a0^3 - a^3 (shell_statics.py), now in units of length^3: r^2 v = a^2 a' = -c'/3 everywhere, so that

    kinetic energy E = 2 pi rho D^2 (1/a - 1/b),  D = c'/3,      dE = -(P_eff + p_f) (4 pi / 3) dc
"""
import math

import numpy as np
from scipy.integrate import quad, solve_ivp

from oracles.shell_statics import distension, first_yield, fluid_pressure, full_yield, loading, strain_of


class Coasting:
    """Exact history of an incompressible shell of inner radius a0 [m] that stops at a volume strain of the whole."""

    def __init__(self, shell, stop_strain, inner_radius=0.02, density=2650.0):
        self.shell, self.density, self.a0 = shell, density, inner_radius
        self.matrix = inner_radius**3 / (shell.start - 1.0)  # b^3 - a^3
        self.b0 = (self.matrix * shell.start) ** (1.0 / 3.0)
        self.stop = distension(shell, stop_strain)
        energy = self.work(self.stop)
        self.strength = math.sqrt(energy / self.inertia(shell.start))  # D at the start [m^3/s]
        self._integrate()

    def resistance(self, alpha):
        """P_eff + p_f in loading [Pa]."""
        return loading(self.shell, alpha)[0] + fluid_pressure(self.shell, alpha)

    def radii(self, alpha):
        return (self.matrix * (alpha - 1.0)) ** (1.0 / 3.0), (self.matrix * alpha) ** (1.0 / 3.0)

    def inertia(self, alpha):
        """E / D^2."""
        a, b = self.radii(alpha)
        return 2.0 * math.pi * self.density * (1.0 / a - 1.0 / b)

    def work(self, alpha):
        """Work of the whole from the start to alpha [J]."""
        corners = [x for x in (first_yield(self.shell), full_yield(self.shell)) if alpha < x < self.shell.start]
        value = quad(self.resistance, alpha, self.shell.start, points=corners or None, epsabs=0.0, epsrel=1e-12)[0]
        return 4.0 * math.pi / 3.0 * self.matrix * value

    def _integrate(self):
        """alpha' = -3 D / matrix and, from the energy, D' = -(dI/dt D / 2 + ...) with I = E / D^2."""

        def rate(_, y):
            alpha, d = y
            a, b = self.radii(alpha)
            falling = -3.0 * d / self.matrix
            # d(1/a)/dt = D / a^4 (and the same for b), since a' = -D / a^2.
            inertia_rate = 2.0 * math.pi * self.density * d * (a**-4 - b**-4)
            power = 4.0 * math.pi * self.resistance(alpha)  # times D
            return [falling, -(power + inertia_rate * d) / (2.0 * self.inertia(alpha))]

        at_rest = lambda _, y: y[1]
        at_rest.terminal = True
        solution = solve_ivp(rate, (0.0, 1.0), [self.shell.start, self.strength], method="DOP853", rtol=1e-12,
                             atol=1e-16, events=at_rest, dense_output=True, first_step=1e-9, max_step=1e-6)  # fmt: skip
        self.stop_time, self.state = float(solution.t[-1]), solution.sol

    def at(self, time):
        """(a, b, inner velocity, strain, p_f) at a time up to the stop."""
        alpha, d = self.state(time)
        a, b = self.radii(alpha)
        return a, b, -d / a**2, strain_of(self.shell, alpha), fluid_pressure(self.shell, alpha)


class CompressibleShell:
    """The coasting shell with bulk modulus K: one dimension in r, rate-form elasticity and von Mises yield in cells.

    Forces are the derivative of the cells' power by the nodes' velocities, so that energy is kept to the step's order;
    centred differences in time, no viscosity: the start is smooth, only elastic waves run.
    """

    def __init__(self, coasting, bulk_modulus, cells=200):
        self.shell, self.bulk = coasting.shell, bulk_modulus
        self.r = np.linspace(coasting.a0, coasting.b0, cells + 1)
        self.v = -coasting.strength / self.r**2
        self.volume0 = self.volumes()
        mass = coasting.density * self.volume0
        self.mass = 0.5 * (np.append(mass, 0.0) + np.append(0.0, mass))
        self.cell_mass = mass
        self.s = np.zeros(cells)
        speed = math.sqrt((bulk_modulus + 4.0 / 3.0 * self.shell.shear_modulus) / coasting.density)
        self.dt = 0.4 * (coasting.b0 - coasting.a0) / cells / speed
        self.time = 0.0
        self.a0, self.matrix, self.mean_cube0 = coasting.a0, coasting.matrix, self.mean_cube()

    def volumes(self):
        return 4.0 * math.pi / 3.0 * np.diff(self.r**3)

    def forces(self):
        """- d(power)/d(v): pressure on the spheres, and s (d_r - d_theta) V of the cells."""
        volume = self.volumes()
        pressure = -self.bulk * np.log(volume / self.volume0)
        radial, hoop = 1.0 / np.diff(self.r), 1.0 / (self.r[1:] + self.r[:-1])
        work = 2.0 / 3.0 * self.s * volume
        force = np.zeros_like(self.r)
        area = 4.0 * math.pi * self.r**2
        force[1:] += pressure * area[1:] - work * (radial - hoop)
        force[:-1] += -pressure * area[:-1] + work * (radial + hoop)
        return force

    def step(self):
        # Before the first step the velocity is that of time 0; half a step of force brings it to the half step.
        self.v += self.dt * (0.5 if self.time == 0.0 else 1.0) * self.forces() / self.mass
        middle = self.r + 0.5 * self.dt * self.v
        rate = np.diff(self.v) / np.diff(middle) - (self.v[1:] + self.v[:-1]) / (middle[1:] + middle[:-1])
        y = self.shell.strength
        self.s = np.clip(self.s + 2.0 * self.shell.shear_modulus * self.dt * rate, -y, y)
        self.r = self.r + self.dt * self.v
        self.time += self.dt

    def profile(self):
        """(radius, pressure) of the cells."""
        radius = np.cbrt(0.5 * (self.r[1:] ** 3 + self.r[:-1] ** 3))
        return radius, -self.bulk * np.log(self.volumes() / self.volume0)

    def mean_radius(self):
        """Inner radius from the mean of r^3 and the volume, as radii.csv has it (src/output/radii.hpp)."""
        volume = float(self.r[-1] ** 3 - self.r[0] ** 3)
        return np.cbrt(self.a0**3 + self.mean_cube() - self.mean_cube0 - 0.5 * (volume - self.matrix))

    def mean_cube(self):
        """Mass average of r^3."""
        cube = 0.5 * (self.r[1:] ** 3 + self.r[:-1] ** 3)
        return float(np.sum(self.cell_mass * cube) / np.sum(self.cell_mass))

    def kinetic(self):
        """Of the last half step [J]."""
        return 0.5 * float(np.sum(self.mass * self.v**2))

    def history(self, end):
        """Columns time, inner radius, the same from the mean of r^3, kinetic energy; a row per step."""
        rows = [(self.time, self.r[0], self.mean_radius(), self.kinetic())]
        while self.time < end:
            self.step()
            rows.append((self.time, self.r[0], self.mean_radius(), self.kinetic()))
        return np.array(rows).T
