# SPDX-License-Identifier: BSD-3-Clause
"""What the particles of a finished run have stored, of metals and of dry rock, found from its last checkpoint; and what rock gains where it
begins to dilate (docs/method.md 21)."""
import h5py
import numpy as np
from oracles.rock_elasticity import RockElasticity, integral

DILATED = 1e-12  # plastic volume strain
FINE = 6000  # points of tables


class Rows:
    """The particles of one material at the end of a run."""

    def __init__(self, run, material, density):
        with h5py.File(run.folder / "checkpoint.h5") as file:
            group = file[f"particles/{material}"]
            self.mass, volume = (group[name][:, 0] for name in ("mass", "volume"))
            self.stress, self.history = group["stress"][:], group["history"][:]
        self.reference = self.mass / density  # volume
        self.ratio = volume / self.reference


def invariants(stress):
    """Mean pressure and J2 of rows of xx, yy, zz, xy."""
    pressure = -stress[..., :3].mean(axis=-1)
    deviator = stress[..., :3] + pressure[..., None]
    return pressure, 0.5 * (deviator**2).sum(axis=-1) + stress[..., 3] ** 2


def cold_energy(card, compression):
    """Of a Mie-Grueneisen solid at 1 - V/V0 on the isentrope from its first state; where it is expanded, against its cohesion [J/m3]."""
    bulk, gamma, slope = card["Density"] * card["Sound Speed"] ** 2, card["Gruneisen"], card["Hugoniot Slope"]
    eta = np.linspace(0.0, max(float(compression.max()), 1e-6), FINE)
    cold = bulk * eta / (1.0 - slope * eta) ** 2 * (1.0 - 0.5 * gamma * eta)
    part = cold * np.exp(-gamma * eta)
    integrals = np.concatenate([[0.0], np.cumsum(0.5 * (part[1:] + part[:-1]) * np.diff(eta))])
    compressed = np.interp(compression, eta, np.exp(gamma * eta) * integrals)
    stretch, fading = np.maximum(-compression, 0.0), card["Sound Speed"] / np.sqrt(card["Cohesive Energy"])
    apart = card["Density"] * card["Cohesive Energy"] * (1.0 - (1.0 + fading * stretch) * np.exp(-fading * stretch))
    return np.where(compression > 0.0, compressed, apart)


def metal(run, material, card):
    """{cold energy, shear energy, internal energy} of a metal with cohesive energy and voids [J]."""
    rows = Rows(run, material, card["Density"])
    _, _, energy, _, voids = rows.history.T  # plastic strain, temperature, internal energy, damage, expansion strain
    solid = rows.ratio * np.exp(-voids)
    _, squares = invariants(rows.stress)
    return {
        "cold": float((rows.reference * cold_energy(card, 1.0 - solid)).sum()),
        "shear": float((rows.reference * solid * squares / (2.0 * card["Shear Modulus"])).sum()),
        "internal": float((rows.mass * energy).sum()),
    }


class RockEnergy:
    """Stored energy of dry rock per volume, by its stress and whether it has dilated."""

    def __init__(self, card, softens=True):
        self.whole, self.dilated = RockElasticity(card), RockElasticity(card, constant=softens)
        self.pressures = np.concatenate([[0.0], np.geomspace(1e4, 6e10, FINE)])
        pairs = zip(self.pressures[:-1], self.pressures[1:])
        self.energies = np.concatenate([[0.0], np.cumsum([integral(lambda p: p / self.whole.bulk(p), a, b) for a, b in pairs])])

    def soft(self, pressure, squares):
        return 0.5 * pressure**2 / self.dilated.bulk(0.0) + 0.5 * squares / self.dilated.shear(0.0)

    def stiff(self, pressure, squares):
        tension = 0.5 * pressure**2 / self.dilated.bulk(0.0)
        pressed = np.interp(pressure, self.pressures, self.energies)
        return np.where(pressure > 0.0, pressed, tension) + 0.5 * squares / self.whole.shear(pressure)

    def bounds(self, pressure):
        """The most that a cycle to a pressure creates, per volume."""
        at = np.geomspace(1e6, 6e10, 60)
        return np.interp(pressure, at, [self.whole.bound(most) for most in at])

    def stored(self, rows):
        """[J]"""
        pressure, squares = invariants(rows.stress)
        by = np.where(rows.history[:, 0] > DILATED, self.soft(pressure, squares), self.stiff(pressure, squares))
        return float((rows.reference * rows.ratio * by).sum())


class Softening:
    """What particles of rock gained where they began to dilate, and lost where they were compacted again [J]."""

    def __init__(self):
        self.gained = self.lost = 0.0
        self.before = None

    def look(self, law, reference, now):
        """@param now  pressure, J2, volume ratio, whether dilated, whether there, of every particle"""
        if self.before is not None:
            pressure, squares, ratio = (0.5 * (a + b) for a, b in zip(self.before[:3], now[:3]))
            rise = reference * ratio * (law.soft(pressure, squares) - law.stiff(pressure, squares))
            there, was, is_now = self.before[4] & now[4], self.before[3], now[3]
            self.gained += float(rise[there & is_now & ~was].sum())
            self.lost += float(rise[there & was & ~is_now].sum())
        self.before = now


def rock_history(run, block, law, density):
    """{gained, lost; the same of every other field; what one cycle of each particle could create at most} by the fields of a run [J]."""
    from netCDF4 import Dataset, chartostring

    all_fields, every_other = Softening(), Softening()
    with Dataset(run.folder / "particles.e") as data:
        data.set_auto_mask(False)
        names = [str(name).split("\0")[0] for name in chartostring(data.variables["name_elem_var"][:])]

        def field(name, step):
            return np.asarray(data.variables[f"vals_elem_var{names.index(name) + 1}eb{block}"][step], float)

        reference = masses(data, block, field) / density
        highest = np.zeros_like(reference)
        for step in range(len(data.variables["time_whole"][:])):
            stress = np.stack([field(f"stress_{c}", step) for c in ("xx", "yy", "zz", "xy")], axis=-1)
            now = (*invariants(stress), field("volume_ratio", step), field("plastic_volume_strain", step) > DILATED,
                field("status", step) == 1)  # fmt: skip
            all_fields.look(law, reference, now)
            if step % 2 == 0:
                every_other.look(law, reference, now)
            highest = np.maximum(highest, np.where(now[4], now[0], 0.0))
    return {
        "gained": all_fields.gained, "lost": all_fields.lost, "gained_coarse": every_other.gained, "lost_coarse": every_other.lost,
        "one_cycle": float((reference * law.bounds(highest)).sum()),
    }  # fmt: skip


def masses(data, block, field):
    """Of particles of a body of the deck in axisymmetry: density times the volume of their rings at the start."""
    places = [np.asarray(data.variables[f"coord{axis}"][:]) for axis in "xy"]
    corners = np.asarray(data.variables[f"connect{block}"][:]) - 1
    x, y = (place[corners] for place in places)
    across = x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y
    return field("density", 0) * np.abs(np.pi / 3.0 * ((x + np.roll(x, -1, axis=1)) * across).sum(axis=1))
