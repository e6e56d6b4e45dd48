# SPDX-License-Identifier: BSD-3-Clause
"""Closed cycles of elastic rock in mean pressure and shear: the work that each leaves over, against its closed form, for every card of
rock (docs/method.md 21); and the most that one cycle can create."""
import pathlib
import tempfile

import numpy as np
from barreno.materials import ELASTIC, Material, load
from oracles.rock_elasticity import RockElasticity
from tools.case import Result
from tools.plug import card_numbers, softens, write_card
from tools.works import works_along

CARDS_FOLDER = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"
CARDS = ("berea_sandstone", "berea_sandstone_bounded", "berea_sandstone_damage", "berea_sandstone_shock", "berea_sandstone_heat",
    "seeberger_sandstone", "seeberger_sandstone_heat", "cement_class_g")  # fmt: skip
WITH_CONSTANT = "berea_sandstone_bounded"  # which is driven with a constant shear modulus too
CHEAP = ("berea_sandstone_bounded", "berea_sandstone_heat", "seeberger_sandstone_heat")
MEGA, GIGA = 1e6, 1e9
PORES, CRUSHED, DILATED = "pores as they are", "crushed", "dilated"
WET, WET_CRUSHED, CONSTANT = "wet", "wet, crushed", "constant G"
STEPS = {PORES: 500, DILATED: 500, CONSTANT: 500, CRUSHED: 1000, WET: 1000, WET_CRUSHED: 1000}  # of a side of a rectangle
PRESSURES = {  # corners of rectangles: in pressures of the first crushing, or for crushed rock [Pa]
    **dict.fromkeys((PORES, CONSTANT, WET), ((0.05, 0.15), (0.25, 0.5), (0.5, 0.7))),
    DILATED: ((0.05, 0.1), (0.1, 0.3), (0.3, 0.5)),
    WET_CRUSHED: ((0.65, 0.7), (0.7, 0.9), (0.65, 0.9)),  # in the pressure that has crushed it
    CRUSHED: ((0.1 * GIGA, 0.5 * GIGA), (0.5 * GIGA, 2.0 * GIGA), (1.0 * GIGA, 4.0 * GIGA)),
}
SHEARS = 0.1, 0.4  # q of the corners, in strengths at the lower pressure
MOST = (1.0 * GIGA, 5.0 * GIGA)  # pressures up to which the bound is given
BOUND, SOFTER = "along the strength", "softer where it dilates"
MOST_CREATED, MOST_SOFTER, MOST_ROUND = "most of one cycle", "most where it dilates", "most that compaction leaves of it"
CAP_POINTS = 41
AT_CRUSHING = 0.4  # pressure at which rock is made to dilate, of that of the first crushing
NEAR, CORNERS, PER_SIDE = 0.98, 80, 80  # how near to the strength the path of the bound runs; its corners
CRUSHED_TO, CRUSHING_STEP = 3.0 * MOST[-1], 2e-3  # so that no cap is near; strain along each axis
WET_CRUSHING = 1.2  # of the pressure of the first crushing
FLUID = {"fluid_B0": 2.2e9}
COLUMNS = ["card", "state", "pressure [MPa]", "q [MPa]", "created [kJ/m3]", "closed form [kJ/m3]", "difference over the closed form",
    "created over stored"]  # fmt: skip


class Points:
    """Material points at stresses (p, q), q as a shear stress, and what their elastic work has been."""

    def __init__(self, material, count):
        self.material = material
        self.stress, self.state = material.virgin(count)
        self.work = np.zeros((count, 2))
        self.strained(np.zeros((1, count, 6)))  # fills states that are all zero

    def get(self, name):
        return self.state[:, self.material.state_index(name)]

    def effective(self):
        """Mean pressure that the rock bears itself."""
        pressure = -self.stress[:, :3].mean(axis=1)
        return pressure - self.get("pore_pressure") if "pore_pressure" in self.material.state_names else pressure

    def strained(self, increments):
        stresses, self.state, works = works_along(self.material, increments, self.stress, self.state)
        self.stress = stresses[-1].copy()
        self.work += works.sum(axis=0)

    def crush(self, pressure):
        """By the same strain along all axes, to a pressure and a little beyond."""
        step = np.zeros((1, *self.stress.shape))
        step[..., :3] = -CRUSHING_STEP
        while self.effective().min() < pressure:
            self.strained(step)

    def go(self, p, q, steps=STEPS[PORES], shear=None):
        """In a straight line to p and q; with `shear` q is what that strain makes it."""
        end = np.zeros_like(self.stress)
        end[:, :3], end[:, 3] = -np.asarray(p, float)[..., None], q
        parts = (np.arange(steps) + 1.0)[:, None, None] / steps
        wanted = self.stress + parts * (end - self.stress)
        strain = np.zeros_like(wanted)
        if shear is not None:
            wanted[..., 3], strain[..., 3] = np.nan, shear / steps
        followed = self.material.follow(strain, wanted, self.stress, self.state)
        assert not followed.status.any(), self.material.why()
        self.strained(followed.strain)
        if shear is None:
            self.settle(end)

    def settle(self, end):
        """From within the tolerance of follow() to stresses in full, so that cycles close."""
        tangent = self.material.update(np.zeros_like(end), self.stress, self.state, want=ELASTIC).tangent
        strain = np.linalg.solve(tangent, (end - self.stress)[..., None])[..., 0]
        strain[:, 3:] *= 0.5  # the tangent is that of engineering strains
        self.strained(strain[None])


class Rock:
    """A card: its numbers, its law written anew, and points of it."""

    def __init__(self, file, library):
        self.material = Material(file, library)
        self.card = card_numbers(file)
        self.law = RockElasticity(self.card)
        self.dilated = RockElasticity(self.card, constant=softens(file))
        self.crushing = -self.card["p0_crush_curve"] / 3.0

    def points(self, count):
        return Points(self.material, count)

    def softened(self, points):
        """Share of the strength that heat has left."""
        if "temperature" not in self.material.state_names:
            return 1.0
        cold = self.points(1).get("temperature")[0]
        return 1.0 - float((points.get("temperature").max() - cold) / (self.card["Melting temperature"] - cold))


def prepared(rock, state, count, low):
    """Points in a state, at a pressure without shear."""
    points = rock.points(count)
    if state in (CRUSHED, WET_CRUSHED):
        points.crush(crushing_pressure(rock, state))
    if state == DILATED:
        pressure = np.full(count, 0.05 * rock.crushing)
        points.go(pressure, 0.0)
        points.go(pressure, 0.0, shear=0.02)
        points.go(pressure, 0.0)
        assert (points.get("plastic_volume_strain") > 1e-6).all(), "the rock has not dilated"
    points.go(low, 0.0)
    return points


def crushing_pressure(rock, state):
    """Mean pressure that the rock itself has borne."""
    return WET_CRUSHING * rock.crushing if state == WET_CRUSHED else CRUSHED_TO


def corners_of(state, rock):
    scale = 1.0 if state == CRUSHED else rock.crushing
    if state == WET_CRUSHED:
        points = rock.points(1)
        points.crush(crushing_pressure(rock, state))
        scale = -points.stress[0, 0]
    return scale * np.array(PRESSURES[state])


def cycled(rock, state, steps):
    """(pressures, shears, works of four cycles, closed form, stored energy), for every rectangle of a state."""
    law = rock.dilated if state == DILATED else rock.law
    corners = corners_of(state, rock)
    low, high = (np.repeat(side, 4) for side in corners.T)  # of each: there, back, pressure alone, shear alone
    points = prepared(rock, state, len(low), low)
    first, volume = points.effective(), points.get("volume_ratio").copy()
    strength = rock.softened(points) * law.strength(first)
    least, most = (share * strength for share in SHEARS)
    points.go(low, least)
    kind = np.arange(len(low)) % 4
    before = points.work.copy()
    there = [(low, most), (high, most), (high, least), (low, least)]
    back = [(high, least), (high, most), (low, most), (low, least)]
    alone = [(high, least), (low, least)] * 2, [(low, most), (low, least)] * 2
    far = {}
    for side in range(4):
        ways = (there, back, *alone)
        p, q = (np.choose(kind, [way[side][i] for way in ways]) for i in (0, 1))
        points.go(p, q, steps)
        if side == 1:
            far = {"effective": points.effective()[0::4], "volume": points.get("volume_ratio")[0::4].copy()}
    made = points.work - before
    exact, stored = [], []
    for i in range(len(corners)):
        p, q, start = (first[4 * i], far["effective"][i]), (least[4 * i], most[4 * i]), volume[4 * i]
        if state in (WET, WET_CRUSHED):  # the law of the fluid is not written anew: the volume is that of the point
            squares = 0.5 * (q[1] ** 2 - q[0] ** 2)
            exact.append(squares * (start / law.shear(p[0]) - far["volume"][i] / law.shear(p[1])))
        else:
            exact.append(law.rectangle(p, q) * start / float(law.volume(p[0])))
        stored.append(law.stored(p[1], q[1]) * start / float(law.volume(p[0])))
    return corners, np.stack([least[::4], most[::4]], axis=1), made.reshape(-1, 4, 2), np.array(exact, float), np.array(stored)


def add_rectangles(result, name, rock, state):
    corners, shears, made, exact, stored = cycled(rock, state, STEPS[state])
    if state in (WET, WET_CRUSHED):  # of first order in the step, by the pressure of the fluid: its limit, from two lengths of step
        made = 2.0 * cycled(rock, state, 2 * STEPS[state])[2] - made
    # What changes its sign with the direction is the law's; what does not would be the step's.
    taken, left = 0.5 * (made[:, 0, 0] - made[:, 1, 0]), 0.5 * (made[:, 0, 0] + made[:, 1, 0])
    for i, (pressures, q) in enumerate(zip(corners / MEGA, shears / MEGA)):
        result.rows.append([name, state, f"{pressures[0]:.3g} to {pressures[1]:.3g}", f"{q[0]:.3g} to {q[1]:.3g}", taken[i] / 1e3,
            exact[i] / 1e3, abs(taken[i] / exact[i] - 1.0), exact[i] / stored[i]])  # fmt: skip
    where = f"{name}, {state}"
    result.demand(f"{where}: created work against the closed form, relative", float(np.abs(taken / exact - 1.0).max()), 1e-6)
    result.demand(f"{where}: work that both directions leave, over the stored energy", float((np.abs(left) / stored).max()), 1e-6)
    alone = np.abs(made[:, 2:, 0]).max(axis=1) / stored
    result.demand(f"{where}: work of pressure alone, and of shear alone, over the stored energy", float(alone.max()), 1e-6)
    result.demand(f"{where}: dissipated work [J/m3]", float(np.abs(made[..., 1]).max()), 0.0)


def add_bound(result, name, rock, most):
    """A cycle that loads shear at the highest pressure and follows the strength down; rock so crushed that no cap closes it."""
    points = rock.points(1)
    points.crush(CRUSHED_TO)
    points.go([most], 0.0)
    soft = rock.softened(points)
    at = np.geomspace(most, MEGA, CORNERS)
    down = [*at, 0.0]
    path = [*((p, 0.0) for p in down[::-1]), *zip(down, NEAR * soft * rock.law.strength(down))]
    volume = float(points.get("volume_ratio")[0] / rock.law.volume(most))
    before = points.work.copy()
    for p, q in path[len(down) :] + path[: len(down)]:
        points.go([p], q, PER_SIDE)
    made = points.work - before
    exact = rock.law.polygon(path) * volume
    bound, stored = (of * volume for of in (rock.law.bound(most), rock.law.stored(most, float(rock.law.strength(most)))))
    apart = abs(float(made[0, 0]) / exact - 1.0)
    least = float(rock.law.falls(most)[0].min() / rock.law.compliance(0.0))
    where = f"{name}, {BOUND} to {most / GIGA:g} GPa"
    result.rows.append([name, BOUND, f"0 to {most / MEGA:g}", f"0 to {float(rock.law.strength(most)) / MEGA:.3g}", -made[0, 0] / 1e3,
        -exact / 1e3, apart, bound / stored])  # fmt: skip
    result.demand(f"{where}: work against the closed form, relative", apart, 1e-6)
    result.demand(f"{where}: J/G falls everywhere, at least by this part of it", least, 0.0, at_least=True)
    result.demand(f"{where}: created over the bound", float(-made[0, 0] / bound), 1.0)
    result.demand(f"{where}: dissipated work [J/m3]", float(abs(made[0, 1])), 0.0)


def softening(rock, p, q):
    """By how much more dilated rock stores at the same stress, per volume at no pressure."""
    at = [law.stored(p, q) / float(law.volume(p)) for law in (rock.dilated, rock.law)]
    return (at[0] - at[1]) * float(rock.law.volume(p))


def add_softening(result, name, rock):
    """Rock that begins to dilate under load, and is unloaded."""
    pressure = AT_CRUSHING * rock.crushing
    points = rock.points(1)
    points.go([pressure], 0.0)
    reach = 1.002 * 0.5 * float(rock.law.strength(pressure) / rock.law.shear(pressure))
    points.go([pressure], 0.0, shear=reach)
    q = float(points.stress[0, 3])
    points.go([pressure], 0.0)
    points.go([0.0], 0.0)
    exact, made = softening(rock, pressure, q), -float(points.work[0, 0])
    of = exact if exact > 0.0 else rock.law.stored(pressure, q)
    apart = abs(made - exact) / of
    result.rows.append([name, SOFTER, f"{pressure / MEGA:.3g}", f"{q / MEGA:.3g}", made / 1e3, exact / 1e3, apart, ""])
    result.demand(f"{name}, {SOFTER}: given back against the closed form, over it or else what is stored", apart, 0.01 if exact else 1e-3)


def add_most(result, name, rock):
    """The bounds, for docs/materials/arenisca.md."""
    law = rock.law
    for most in MOST:
        bound, stored = law.bound(most), law.stored(most, float(law.strength(most)))
        result.rows.append([name, MOST_CREATED, f"0 to {most / MEGA:g}", "to the strength", "", bound / 1e3, "", bound / stored])
    # Rock dilates on the limit surface, before the cap begins at kappa = PEAKI1 - CR (PEAKI1 - X), and is compacted on the cap.
    vertex, end = rock.card["PEAKI1"], rock.card["p0_crush_curve"]
    kappa = vertex - rock.card["CR"] * (vertex - end)
    on_cap = []
    for x in np.linspace(kappa, end, CAP_POINTS):
        q = float(law.strength(-x / 3.0)) * np.sqrt(max(0.0, 1.0 - ((kappa - x) / (kappa - end)) ** 2))
        on_cap.append((-x / 3.0, float(q), softening(rock, -x / 3.0, float(q))))
    pressure, q, most = on_cap[0]
    stored = most + law.stored(pressure, q)
    left = most - min(row[2] for row in on_cap)
    at = [f"{pressure / MEGA:.3g}", f"{q / MEGA:.3g}"]
    result.rows.append([name, MOST_SOFTER, *at, "", most / 1e3, "", most / stored])
    result.rows.append([name, MOST_ROUND, "", "", "", left / 1e3, "", left / stored])


def run(barreno, full):
    library = load(barreno.resolve().parents[1] / "materials" / "libBARRENO.so")
    result = Result(
        "Closed cycles of elastic rock",
        "A cycle of elastic rock leaves over the work of its closed form, in both directions, and none where pressure or shear goes round "
        "alone.",
        "the integral of J/G q dq round the cycle, with moduli written anew (oracles/rock_elasticity.py). One material point, no grid; "
        f"{STEPS[PORES]} or {STEPS[CRUSHED]} steps a side. Rectangles are given in the direction that creates work. "
        f"`{BOUND}`: the cycle that creates the most, at {NEAR:g} of the strength; its share is that of the bound. "
        f"`{SOFTER}`: what dilation under load adds to the stored energy. Volumes are those of the virgin rock",
        COLUMNS,
        [],
    )  # fmt: skip
    for name in CARDS if full else CHEAP:
        rock = Rock(CARDS_FOLDER / f"{name}.xml", library)
        for state in (PORES, DILATED, CRUSHED):
            add_rectangles(result, name, rock, state)
        for most in MOST:
            add_bound(result, name, rock, most)
        add_softening(result, name, rock)
        add_most(result, name, rock)
        if "Grain stiffening" in rock.card:
            continue  # wet rock: the closed form is that of grains and fluid of constant moduli
        with tempfile.TemporaryDirectory() as folder:
            if name == WITH_CONSTANT:
                file = write_card(folder, CARDS_FOLDER / f"{name}.xml", {"G1": 0.0, "G2": 0.0})
                add_rectangles(result, name, Rock(file, library), CONSTANT)
            wet = Rock(write_card(folder, CARDS_FOLDER / f"{name}.xml", FLUID), library)
            for state in (WET, WET_CRUSHED):
                add_rectangles(result, name, wet, state)
    return result
