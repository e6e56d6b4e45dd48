# SPDX-License-Identifier: BSD-3-Clause
"""A rod of tungsten, whole and in ten pieces with gaps, digs into steel until its hole is at rest: depth, energy, the theory of rods."""
import dataclasses
import functools
import xml.etree.ElementTree as ElementTree

import numpy as np
from oracles.rod_penetration import cavity_resistance, flow_stress, penetrate, tate_resistance, young_modulus
from tools.case import Result
from tools.runs import ROOT, run_deck

DECK = "steady_penetration.xml"
COUNT, RADIUS, SHORT, VELOCITY = 10, 1.0, 4.0, 3000.0  # pieces, of this length [mm, m/s]
LENGTH = COUNT * SHORT  # of metal [mm]
ROD, TARGET = "tungsten_alloy.xml", "steel_4340_fracture.xml"
CARDS = ROOT / "materials" / "cards"
WIDE, FINE_WIDE = 30.0, 5.0  # radii of the target and of the small cells [mm]
COARSE = 5.0 / 3.0  # cells elsewhere, two in 2.4 of the coarsest small cells [mm]
LEVELS = {1.2: 1, 2.4: 2, 4.8: 3}  # cells per radius -> Refinement/Path/Level
GAPS = (0, 1, 3)  # in lengths of a piece
NAMES = {0: "whole rod", 1: "gaps of one length", 3: "gaps of three lengths"}
DEEP = {0: 90.0, 1: 135.0, 3: 145.0}  # of the target: half as much again as the hole [mm]
FINE_DEEP = {0: 66.0, 1: 100.0, 3: 112.0}  # of the small cells [mm]
ABOVE = {0: 48.0, 1: 16.0, 3: 16.0}  # the target's face: room for a piece that is born, and for what is thrown back [mm]
END = {0: 50.0, 1: 100.0, 3: 160.0}  # us
LATE = 0.2  # of the time since the impact, in which a hole at rest no longer grows
ROD_STRENGTH = (1.0, 1.7)  # Tate's strength of a rod over its flow stress
STRAIN = 1.0  # plastic, to which the flow stress is a mean


@dataclasses.dataclass(frozen=True)
class Train:
    name: str
    gap: int = 0
    pieces: int = COUNT
    more: tuple = ()  # settings beside those of all trains

    @property
    def length(self):
        """Of a piece that is born at once [mm]."""
        return LENGTH if self.gap == 0 else SHORT

    @property
    def launch(self):
        """Where its centre is born: its front 2 mm before the target [mm]."""
        return -0.5 * self.length - 2.0

    @property
    def times(self):
        """Of the births [us]."""
        return [0.0] if self.gap == 0 else [1e3 * i * SHORT * (1 + self.gap) / VELOCITY for i in range(self.pieces)]


def strengths(body, factor):
    """Settings that multiply the flow stress of a body's card."""
    values = card(ROD if body == "Rod" else TARGET)
    return tuple((f"Materials/{body}/{name}", f"{factor * values[name]:g}") for name in "AB")


TRAINS = {gap: Train(NAMES[gap], gap) for gap in GAPS}


@functools.lru_cache(None)
def extra_trains():
    """Experiments on the reasons: {key: (train, cells per radius, end)}."""
    neither = Train("no strength of rod and target, to 36 us", more=(*strengths("Target", 0.0), *strengths("Rod", 0.0)))
    again = (("Step/Courant Fraction", "0.79999"),)
    return {
        "soft": (Train("whole rod, target 10 % weaker", more=strengths("Target", 0.9)), (2.4,), END[0]),
        "hard": (Train("whole rod, target 10 % stronger", more=strengths("Target", 1.1)), (2.4,), END[0]),
        "limp": (Train("whole rod with a tenth of its strength", more=strengths("Rod", 0.1)), (2.4,), END[0]),
        "neither": (neither, (1.2, 2.4), 36.0),
        "alone": (Train("one piece alone", 3, 1), (2.4,), 20.0),
        **{f"again {gap}": (Train(f"{NAMES[gap]}, Courant Fraction 0.79999", gap, more=again), (2.4,), END[gap]) for gap in GAPS},
    }


@functools.lru_cache(None)
def card(name):
    """Numbers of a card by their names."""
    root = ElementTree.parse(CARDS / name).getroot()
    return {one.get("name"): float(one.get("value")) for one in root.findall("Parameter") if one.get("type") == "double"}


def whole(length):
    """In whole coarse cells [mm]."""
    return np.ceil(length / COARSE - 1e-9) * COARSE


def settings_of(train, cells, end):
    low, deep = -whole(ABOVE[train.gap]), whole(DEEP[train.gap])
    table = ",".join(f"{1e-6 * time:.9g}, {VELOCITY:g}, {1e-3 * RADIUS:g}, {1e-3 * train.length:g}, {card(ROD)['Density']:g}"
        for time in train.times)  # fmt: skip
    return {
        "Materials/Rod/Card": ROD, "Materials/Rod/A": "", "Materials/Rod/B": "", "Materials/Target/Card": TARGET,
        "Materials/Target/A": "", "Materials/Target/B": "", "Grid/Lower": f"{{0 mm, {low:.12g} mm}}",
        "Grid/Upper": f"{{{whole(WIDE + 4.0):.12g} mm, {whole(deep + 8.0):.12g} mm}}", "Grid/Cell Size": f"{COARSE:.12g} mm",
        "Refinement/Path/Lower": f"{{0 mm, {low:.12g} mm}}", "Refinement/Path/Upper": f"{{{FINE_WIDE:g} mm, {FINE_DEEP[train.gap]:g} mm}}",
        "Refinement/Path/Level": str(LEVELS[cells]), "Jet/Cells Per Radius": "0", "Jet/Particles Per Cell": "4",
        "Jet/Launch Position": f"{train.launch:g} mm", "Jet/Slugs": f"{len(train.times)}x5:{{{table}}}",
        "Bodies/Block/Upper": f"{{{whole(WIDE):.12g} mm, {deep:.12g} mm}}", "Bodies/Block/Particles Per Cell": "2",
        "Step/Largest Strain": "0.1", "Step/Subcycles": "4", "Time/End Time": f"{end:g} us", "Output/Field Interval": "0 us",
        "Output/History Interval": "0.2 us", **dict(train.more),
    }  # fmt: skip


class Hole:
    """What a run left: lengths in mm, times in us, energies in J, volumes in cm3."""

    def __init__(self, train, finished):
        table = finished.table("depth.csv")
        self.train = train
        self.time, self.grown = 1e6 * table["time"], 1e3 * np.maximum.accumulate(table["depth"])
        self.depth, self.volume = float(self.grown[-1]), 1e6 * float(table["probed_volume"][-1])
        energy = self.energy = finished.summary["balances"]["energy"]
        self.launched, self.plastic, self.shocks = energy["launched_kinetic"], energy["plastic"], energy["viscous"]
        self.steps, self.seconds = finished.summary["steps"], finished.summary["cpu_seconds"]
        self.fronts, self.rears = zip(*map(self.meetings, train.times))
        self.history = finished.table("history.csv")

    def at(self, time):
        return float(np.interp(time, self.time, self.grown))

    def meetings(self, born):
        """When front and rear of a piece meet the bottom, if it flies as it was launched."""
        fine = np.linspace(born, self.time[-1], 20001)
        bottom = np.interp(fine, self.time, self.grown)
        centre = self.train.launch + 1e-3 * VELOCITY * (fine - born)
        return [float(fine[np.argmax(centre + side * self.train.length >= bottom)]) for side in (0.5, -0.5)]

    @property
    def spent(self):
        """Depth when the rear of the last piece meets the bottom."""
        return self.at(self.rears[-1])

    @property
    def in_gaps(self):
        """Depth that the hole gains while no piece digs."""
        return self.depth - sum(self.at(rear) - self.at(front) for front, rear in zip(self.fronts, self.rears))

    @property
    def late(self):
        """Growth of the depth over the depth, at the end."""
        since = self.time[-1] - LATE * (self.time[-1] - self.fronts[0])
        return 1.0 - self.at(since) / self.depth

    @property
    def rate(self):
        """Between a quarter and three quarters of the time that the first piece lasts [m/s]."""
        first, last = (self.fronts[0] + share * (self.rears[0] - self.fronts[0]) for share in (0.25, 0.75))
        return 1e3 * (self.at(last) - self.at(first)) / (last - first)

    @property
    def kinetic_when_spent(self):
        return float(np.interp(1e-6 * self.rears[-1], self.history["time"], self.history["kinetic"])) / self.launched

    def stress(self):
        """Plastic work over volume [GPa]."""
        return 1e-3 * self.plastic / self.volume

    def curve(self):
        times = np.arange(0.0, self.time[-1] + 0.5, 0.5)
        return [[float(time), self.at(time)] for time in times]


@dataclasses.dataclass(frozen=True)
class Theory:
    """Of Alekseevskii and Tate, for the whole rod: least and most of what the formulas give."""

    flow: tuple  # stresses of target and rod [Pa]
    resistance: tuple  # of the target, by the cavity and by Tate [Pa]
    depth: tuple  # [mm]
    rate: tuple  # at the impact [m/s]


def theory():
    rod, target = card(ROD), card(TARGET)
    flows = tuple(flow_stress(metal, 1e3 * VELOCITY / (2.0 * RADIUS), STRAIN) for metal in (target, rod))
    resistances = tuple(formula(flows[0], young_modulus(target)) for formula in (cavity_resistance, tate_resistance))
    dug = [penetrate(VELOCITY, 1e-3 * LENGTH, rod["Density"], target["Density"], factor * flows[1], resistance)
        for resistance in resistances for factor in ROD_STRENGTH]  # fmt: skip
    ends = lambda values: (min(values), max(values))  # noqa: E731
    return Theory(flows, resistances, ends([1e3 * one.depth for one in dug]), ends([one.first_rate for one in dug]))


def beyond(value, least, most):
    """How far a value is outside a range, over the nearest end."""
    return max(0.0, value / most - 1.0, 1.0 - value / least)


def demand_depths(result, holes, theory_, cells):
    """cells: of the finest runs of the whole rod."""
    for (gap, fineness), hole in holes.items():
        result.demand(f"{NAMES[gap]}, {fineness:g} cells per radius: growth of the depth in the last fifth", hole.late, 1e-3)
    for gap in GAPS:
        if (gap, 4.8) in holes:
            change = holes[gap, 4.8].depth / holes[gap, 2.4].depth - 1.0
            result.demand(f"{NAMES[gap]}: change of the depth from 2.4 to 4.8 cells per radius", abs(change), 0.03)
            change = holes[gap, 4.8].volume / holes[gap, 2.4].volume - 1.0
            result.demand(f"{NAMES[gap]}: change of the hole's volume from 2.4 to 4.8 cells per radius", abs(change), 0.05)
    one = holes[0, cells]
    for word, depth in zip(("greatest", "least"), theory_.depth):
        result.demand(f"whole rod, {cells:g} cells per radius, {word} resistance: depth at rest against Alekseevskii-Tate",
            abs(one.depth / depth - 1.0), 0.05)  # fmt: skip
    result.demand(f"whole rod, {cells:g} cells per radius: depth when the rod is spent, beyond the range of Alekseevskii-Tate",
        beyond(one.spent, *theory_.depth), 0.05)  # fmt: skip


def demand_energies(result, holes, cells):
    for gap in GAPS:
        hole, one = holes[gap, cells], holes[0, cells]
        name = f"{NAMES[gap]}, {cells:g} cells per radius"
        result.demand(f"{name}: ledger remainder", abs(hole.energy["error"]), 1e-3)
        if gap:
            work = abs(hole.stress() / one.stress() - 1.0)
            result.demand(f"{name}: share of the depth gained while no piece digs", hole.in_gaps / hole.depth, 0.25, at_least=True)
            result.demand(f"{name}: volume per kinetic energy, over the whole rod's, less 1", abs(hole.volume / one.volume - 1.0), 0.1)
            result.demand(f"{name}: plastic work per volume, over the whole rod's, less 1", work, 0.15)


def words_of(holes, theory_):
    """What the notes of the full form quote."""
    fine, coarse, small = holes[0, 4.8], holes[0, 2.4], holes[0, 1.2]
    later = lambda hole: hole.depth - hole.spent  # noqa: E731
    swing = lambda what: 100.0 * (getattr(holes["soft", 2.4], what) / getattr(holes["hard", 2.4], what) - 1.0)  # noqa: E731
    words = {"spent": fine.spent, "rate": fine.rate, "after": later(fine), "part": 100.0 * later(fine) / fine.depth,
        "kinetic": 100.0 * fine.kinetic_when_spent, "limp": later(holes["limp", 2.4]), "coarse_after": later(coarse),
        "small_after": later(small), "volume": swing("volume"), "deeper": swing("depth"), "least": theory_.depth[0],
        "most": theory_.depth[1], "slowest": theory_.rate[0], "fastest": theory_.rate[1],
        "rise": 100.0 * (fine.rate / coarse.rate - 1.0), "times": VELOCITY / (VELOCITY - fine.rate),
        "free_small": holes["neither", 1.2].rate, "free": holes["neither", 2.4].rate,
        "free_kinetic": 100.0 * holes["neither", 2.4].kinetic_when_spent,
        "fluid": VELOCITY / (1.0 + (card(TARGET)["Density"] / card(ROD)["Density"]) ** 0.5),
        "small_rate": small.rate, "coarse_rate": coarse.rate}  # fmt: skip
    words |= {"first": holes[1, 4.8].rate, "first_coarse": holes[1, 2.4].rate}
    for gap in GAPS:
        words[f"scatter_{gap}"] = 100.0 * abs(holes[f"again {gap}", 2.4].depth / holes[gap, 2.4].depth - 1.0)
        words[f"volume_scatter_{gap}"] = 100.0 * abs(holes[f"again {gap}", 2.4].volume / holes[gap, 2.4].volume - 1.0)
    alone = holes["alone", 2.4]
    words |= {"alone": alone.depth / SHORT, "lasts": alone.spent, "alone_after": later(alone),
        "alone_shocks": 100.0 * alone.shocks / alone.launched}  # fmt: skip
    for gap in GAPS:
        hole = holes[gap, 4.8]
        words |= {f"depth_{gap}": hole.depth, f"gaps_{gap}": hole.in_gaps, f"shocks_{gap}": 100.0 * hole.shocks / hole.launched,
            f"stress_{gap}": hole.stress(), f"work_{gap}": 1e-6 * hole.volume * theory_.resistance[0] / hole.launched}  # fmt: skip
    return words


NOTES = (
    "The whole rod. With 4.8 cells per radius it is used up at {spent:.1f} mm and digs at {rate:.0f} m/s, both in the range of the "
    "theory ({least:.1f} to {most:.1f} mm, {slowest:.0f} to {fastest:.0f} m/s). The theory ends there, the hole goes on: {after:.1f} "
    "mm, {part:.0f} % of the depth, come after the rod is used up. Metal of rod and target still has {kinetic:.0f} % of the kinetic "
    "energy then. The rod's last part has to do with it: with a tenth of the rod's strength {limp:.1f} mm come after the rod, with all "
    "of it {coarse_after:.1f} mm (2.4 cells per radius). The strength of the target changes the volume more than the depth: with 0.9 "
    "instead of 1.1 times the strength the volume is {volume:.0f} % larger and the depth {deeper:.1f} %.",
    "The cells. From 2.4 to 4.8 per radius the rate rises by {rise:.1f} %, from {coarse_rate:.0f} to {rate:.0f} m/s. A rod of length l "
    "digs l u / (v - u) at the rate u, so the depth rises by v / (v - u) = {times:.1f} times as many per cent. What comes after the rod"
    " hardly changes: {small_after:.1f}, {coarse_after:.1f} and {after:.1f} mm with 1.2, 2.4 and 4.8 cells. Without strength of rod and"
    " target 2.4 cells are enough: the rate is {free:.0f} m/s, by the hydrodynamic theory {fluid:.0f} m/s. So the cells raise the "
    "resistance of metal that has strength.",
    "The gaps. One piece alone digs {alone:.2f} times its length: {lasts:.1f} mm while it lasts, {alone_after:.1f} mm after that. In "
    "the gaps of a train the hole grows likewise: with gaps of one length {gaps_1:.1f} of {depth_1:.1f} mm, with gaps of three "
    "{gaps_3:.1f} of {depth_3:.1f} mm. So the theory of one rod is no bound for pieces. In a target without strength the hole never "
    "rests: when a rod without strength is spent there, {free_kinetic:.0f} % of the energy is still kinetic. When pieces dig is taken "
    "from their flight at the velocity of launch; what lies in the hole slows them down, so they dig later than that.",
    "The energy. With wider gaps the hole has less volume: times R (cavity) and over the kinetic energy it is {work_0:.2f} for the "
    "whole rod, {work_1:.2f} with gaps of one length and {work_3:.2f} with gaps of three. Shocks heat metal with {shocks_0:.1f} % of "
    "the energy of the whole rod, {shocks_1:.0f} % with gaps of one length and {shocks_3:.0f} % with gaps of three, but with "
    "{alone_shocks:.1f} % of one piece alone: pieces of a train hit the spent metal that lies in the hole. What is left goes into "
    "plastic work, nearly the same per volume: {stress_0:.2f}, {stress_1:.2f} and {stress_3:.2f} GPa, about the resistance of the "
    "target.",
    "Scatter. Runs whose Courant Fraction differs in the fifth digit differ in depth by {scatter_0:.1f} % (whole rod), {scatter_1:.1f} "
    "% (gaps of one length) and {scatter_3:.1f} % (gaps of three), in volume by {volume_scatter_0:.1f}, {volume_scatter_1:.1f} and "
    "{volume_scatter_3:.1f} % (2.4 cells per radius): where spent metal flies in the hole differs from run to run. The change with the "
    "cells is larger. In smaller cells the hole of a train is deeper and thinner; its volume hardly changes. The first piece digs at "
    "{first_coarse:.0f} m/s with 2.4 cells and at {first:.0f} m/s with 4.8, so the later pieces make the difference; why is not known.",
)  # fmt: skip


def row_of(hole, cells, resistance):
    work = 1e-6 * hole.volume * resistance / hole.launched
    return [hole.train.name, cells, hole.depth, hole.depth / (SHORT if hole.train.pieces == 1 else LENGTH), hole.spent, hole.in_gaps,
        hole.rate, hole.volume, work, hole.shocks / hole.launched, hole.stress(), hole.kinetic_when_spent, hole.steps,
        hole.seconds]  # fmt: skip


def plan(full):
    """(key, train, cells, end)."""
    of = lambda gap: tuple(LEVELS) if full else (1.2, 2.4) if gap == 0 else (1.2,)  # noqa: E731
    out = [((gap, cells), TRAINS[gap], cells, END[gap]) for gap in GAPS for cells in of(gap)]
    if full:
        out += [((key, cells), train, cells, end) for key, (train, sizes, end) in extra_trains().items() for cells in sizes]
    return out


def run(barreno, full):
    theory_ = theory()
    finest = 4.8 if full else 2.4
    result = Result(
        "A rod and its pieces",
        "A rod digs as deep as the theory of rods says until it is used up, and goes on for a tenth of its depth after that. In pieces it "
        "digs in the gaps too.",
        f"Alekseevskii and Tate for the whole rod, and the finest cells. Tungsten alloy of {RADIUS:g} mm in radius and {LENGTH:g} mm in "
        f"length, whole or in {COUNT} pieces, hits steel (4340, Rockwell C 30) at {VELOCITY:g} m/s. By the cards the flow stress, a mean "
        f"to a plastic strain of {STRAIN:g} at velocity over diameter without heat flow, is {1e-9 * theory_.flow[0]:.2f} GPa in the target "
        f"and {1e-9 * theory_.flow[1]:.2f} GPa in the rod. The target's resistance R follows from it: "
        f"{1e-9 * theory_.resistance[0]:.2f} GPa by a cavity in it, {1e-9 * theory_.resistance[1]:.2f} GPa by Tate. The rod's strength is "
        f"its flow stress or 1.7 times that. So the theory gives {theory_.depth[0]:.1f} to {theory_.depth[1]:.1f} mm, at "
        f"{theory_.rate[0]:.0f} to {theory_.rate[1]:.0f} m/s.",
        ["rod", "cells per radius", "depth at rest [mm]", "depth over length", "depth when the last piece is spent [mm]",
         "depth gained while no piece digs [mm]", "rate while the first piece digs [m/s]", "volume of the hole [cm3]",
         "volume times R (cavity) over kinetic energy", "heat of shocks over kinetic energy", "plastic work over volume [GPa]",
         "kinetic energy when the last piece is spent, over launched", "steps", "processor time [s]"],
        [],
    )  # fmt: skip
    holes = {}
    for key, train, cells, end in plan(full):
        hole = holes[key] = Hole(train, run_deck(barreno, DECK, settings_of(train, cells, end)))
        result.rows.append(row_of(hole, cells, theory_.resistance[0]))
    trains = {key: hole for key, hole in holes.items() if key[0] in GAPS}
    demand_depths(result, trains, theory_, finest)
    demand_energies(result, trains, finest if full else 1.2)
    if full:
        result.notes = "\n\n".join(NOTES).format(**words_of(holes, theory_))
        result.curves = {NAMES[gap]: holes[gap, finest].curve() for gap in GAPS}
    return result
