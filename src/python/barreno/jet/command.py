# SPDX-License-Identifier: BSD-3-Clause
"""The command: the jet of a deck as a table, a picture, and the depths that theory gives it."""

import dataclasses
import json
import math
import pathlib

from barreno.jet import theory
from barreno.runs.effective_deck import lists_in, value_in
from barreno.runs.faults import FILE, Fault, exit_code
from barreno.runs.program import as_set, found_program
from barreno.runs.tables import aligned, make_folder, place
from barreno.runs.units import UNITS
from barreno.runs.words import Words, quantity_of

EXAMPLE = 'write for example barreno jet input_xml/perforation.xml --cut-off "2 km/s"'
STRETCHES = 0.01  # rms of launch times over their span, up to which a jet comes from one origin


def parse(words):
    parser = Words("jet", EXAMPLE, "jets.md", description="The jet of a deck: table, audit, picture, and depths by theory (docs/jets.md).")
    parser.add_argument("deck", metavar="DECK", help="deck file with a Jet")
    parser.add_argument("--cut-off", metavar="VELOCITY", help="slower metal does not dig (default: a fifth of the tip's velocity)")
    parser.add_argument("--resistance", metavar="STRESS", help='of the last body, "1 GPa": adds the depth of Alekseevskii and Tate')
    parser.add_argument("--strength", metavar="STRESS", help="of the jet, for the same (default 0)")
    parser.add_argument("--out", metavar="FOLDER", help="folder of jet.csv, jet.png and jet.json (default runs/DECK-jet)")
    parser.add_argument("--fidelity", metavar="NAME", help="fast, balanced, reference or none, as for run")
    parser.add_argument("--set", action="append", default=[], dest="settings", metavar='"LIST/NAME=VALUE"',
        help="changes a value of the deck")
    return parser.parse_args(words)


def velocity_of(text):
    try:
        return quantity_of(text, UNITS["speed"])
    except ValueError:
        raise Fault(f'--cut-off "{text}" is no velocity; write for example --cut-off "2 km/s".') from None


def stress_of(option, text):
    try:
        return quantity_of(text, UNITS["stress"])
    except ValueError:
        raise Fault(f'{option} "{text}" is no stress; write for example {option} "1 GPa".') from None


def numbers_in(text):
    return [float(word) for word in text[text.index("{") + 1 : text.rindex("}")].split(",")]


def slugs_of(text):
    """(slugs as the deck has them, as they are launched) of `barreno check --print-jet`."""
    found = json.loads(text)
    return [theory.Slug(**slug) for slug in found["table"]], [theory.Slug(**slug) for slug in found["slugs"]]


def with_pieces(slugs, below):
    """Slugs of a discrete jet: for theory they are pieces where they are slower than `below`, or have a gap behind."""
    for i, slug in enumerate(slugs[:-1]):
        room = 0.5 * (slug.velocity + slugs[i + 1].velocity) * (slugs[i + 1].time - slug.time)
        slug.piece = slug.velocity < below or 0.5 * (slug.length + slugs[i + 1].length) < 0.99 * room
    slugs[-1].piece = slugs[-1].velocity < below or (len(slugs) > 1 and slugs[-2].piece)


def layers_of(deck, launch, sign):
    """[(body, layer)] of boxes on the axis, in the order in which the jet meets them, and where the first begins; what is not a box."""
    found, others = [], []
    for body in lists_in(deck, "Bodies"):
        path = f"Bodies/{body}"
        if value_in(deck, f"{path}/Shape") not in (None, "box") or value_in(deck, f"{path}/Lower") is None:
            others.append(body)
            continue
        low, high = (numbers_in(value_in(deck, f"{path}/{end}")) for end in ("Lower", "Upper"))
        across = [axis for axis in range(len(low)) if axis != 1]
        ends = sorted(sign * (end[1] - launch) for end in (low, high))
        density = value_in(deck, f"Materials/{value_in(deck, f'{path}/Material')}/Density")
        if any(low[axis] > 0.0 or high[axis] <= 0.0 for axis in across) or ends[1] <= 0.0 or density is None:
            continue
        found.append((ends[0], ends[1], body, float(density)))
    found.sort()
    if not found:
        raise Fault("no box lies on the jet's path, so theory has no target" + (f" ({', '.join(others)}: not a box)" if others else "") +
            "; give the deck one.")
    start = found[0][0]
    return [(body, theory.Layer(end - start, density)) for _, end, body, density in found], start, others


def break_up_of(deck, origin):
    """Time since the origin, from the velocity below which slugs are pieces as they cross the plane."""
    below = float(value_in(deck, "Jet/Pieces Below") or 0.0)
    return origin / below if below > 0.0 else math.inf


def theory_rows(jet, asked):
    """[(what, depth)]"""
    bare = [layer for _, layer in jet.layers]
    plain = {"metal_density": jet.metal_density}
    stretching = {**plain, "origin": jet.origin, "break_up": jet.break_up}
    rows = [("hydrodynamic, as launched", theory.depth(jet.slugs, bare, jet.start, **plain))]
    if jet.origin > 0.0:
        rows.append(("stretching on from the virtual origin", theory.depth(jet.slugs, bare, jet.start, **stretching)))
    rows.append((f"the same, cut off at {asked['cut_off']:g} m/s",
        theory.depth(jet.slugs, bare, jet.start, cut_off=asked["cut_off"], **stretching)))
    if asked["resistance"] is not None:
        strong = [*bare[:-1], theory.Layer(bare[-1].end, bare[-1].density, asked["resistance"])]
        rows.append((f"Alekseevskii-Tate, R = {asked['resistance']:g} Pa, Y = {asked['strength']:g} Pa",
            theory.depth(jet.slugs, strong, jet.start, strength=asked["strength"], **stretching)))
    return rows


def table_rows(slugs, most=12):
    """Some of the slugs, the first and the last among them."""
    count = len(slugs)
    chosen = sorted({round(i * (count - 1) / max(1, min(most, count) - 1)) for i in range(min(most, count))})
    rows = [("slug", "time [us]", "velocity [m/s]", "radius [mm]", "length [mm]", "density [kg/m3]", "")]
    for i in chosen:
        slug = slugs[i]
        rows.append((str(i + 1), f"{1e6 * slug.time:.2f}", f"{slug.velocity:.0f}", f"{1e3 * slug.radius:.3f}", f"{1e3 * slug.length:.3f}",
            f"{slug.density:.0f}", "piece" if slug.piece else "whole"))
    return rows


def as_csv(slugs):
    lines = ["# units: SI", "time,velocity,radius,length,density"]
    return "\n".join(lines + [f"{s.time:.9g},{s.velocity:.9g},{s.radius:.9g},{s.length:.9g},{s.density:.9g}" for s in slugs]) + "\n"


def origin_of(slugs):
    """Distance of the virtual origin; 0 where the launch times do not show one."""
    distance, left = theory.virtual_origin(slugs)
    span = slugs[-1].time - slugs[0].time
    return (distance, left) if span > 0.0 and left < STRETCHES * span else (0.0, left)


@dataclasses.dataclass
class Jet:
    """What the command found of a deck's jet."""

    title: str
    material: str
    kind: str
    table: list  # slugs as the deck has them
    slugs: list  # as they are launched
    layers: list  # (body, layer) of the target
    others: list  # bodies that are no boxes
    start: float  # distance of the target from the launch plane
    metal_density: float
    origin: float  # distance of the virtual origin; 0: none
    residual: float  # rms of launch times about it
    break_up: float  # time since the origin


def jet_of(words, name):
    """@param words  the deck and its changes, as check takes them"""
    program = found_program("jet", 1)
    deck = program.effective_deck(words)
    if value_in(deck, "Jet/Slugs") is None:
        raise Fault("the deck has no Jet; give one that has.")
    table, slugs = slugs_of(program.call(["check", *words, "--print-jet"]))
    material, kind = value_in(deck, "Jet/Material"), value_in(deck, "Jet/Kind")
    metal_density = float(value_in(deck, f"Materials/{material}/Density"))
    if kind == "discrete":
        with_pieces(slugs, float(value_in(deck, "Jet/Pieces Below") or 0.0))
    sign = 1.0 if value_in(deck, "Jet/Direction") == "+y" else -1.0
    layers, start, others = layers_of(deck, float(value_in(deck, "Jet/Launch Position")), sign)
    origin, residual = origin_of(slugs)
    return Jet(value_in(deck, "Title") or name, material, kind, table, slugs, layers, others, start, metal_density, origin, residual,
        break_up_of(deck, origin))


def audit_lines(jet):
    mass, momentum, kinetic = theory.totals(jet.slugs)
    changes = ", ".join(f"{now / before - 1.0:+.1e}" for now, before in zip((mass, momentum, kinetic), theory.totals(jet.table)))
    whole = 100.0 * sum(slug.mass for slug in jet.slugs if not slug.piece) / mass
    yield (f"{len(jet.slugs)} slugs of {jet.material}, {jet.kind}: {1e3 * mass:.5g} g, {momentum:.5g} kg m/s, {1e-3 * kinetic:.5g} kJ "
        f"({changes} of the table's)")
    yield f"{whole:.3g} % of the mass is whole as it crosses the launch plane, the rest are pieces"
    if jet.origin > 0.0:
        yield (f"virtual origin {1e3 * jet.origin:.4g} mm before the launch plane, which the launch times show within "
            f"{1e6 * jet.residual:.2g} us rms" + (f"; break-up {1e6 * jet.break_up:.3g} us after it" if jet.break_up < math.inf else ""))
    else:
        yield f"no virtual origin: the launch times are {1e6 * jet.residual:.3g} us rms away from one; theory takes the jet not to stretch"


def target_line(jet):
    bodies = ", ".join(f"{body} to {1e3 * layer.end:.4g} mm ({layer.density:.4g} kg/m3)" for body, layer in jet.layers)
    return f"target {bodies}" + (f"; not looked at, for not being a box: {', '.join(jet.others)}" if jet.others else "")


def depth_lines(jet, depths):
    yield "depth by theory [mm]; a hole goes on growing in gaps and after the jet, which theory leaves out"
    length = max(len(what) for what, _ in depths)
    for what, found in depths:
        yield f"  {what.ljust(length)}  {1e3 * found:7.1f}" + ("  (comes through)" if found >= jet.layers[-1][1].end else "")


def as_json(jet, depths):
    mass, momentum, kinetic = theory.totals(jet.slugs)
    found = {"mass": mass, "momentum": momentum, "kinetic_energy": kinetic,
        "whole_mass": sum(slug.mass for slug in jet.slugs if not slug.piece), "virtual_origin": jet.origin,
        "origin_residual": jet.residual, "break_up_time": jet.break_up if jet.break_up < math.inf else None, "depths": dict(depths)}
    return json.dumps(found, indent=2) + "\n"


def write(jet, depths, out):
    make_folder(out)
    place(out / "jet.csv", as_csv(jet.table))
    place(out / "jet.json", as_json(jet, depths))

    def picture(aside):
        from barreno.jet.picture import draw  # slow to load

        draw(aside, f"{jet.title}: {jet.kind} jet", jet.slugs, jet.start)

    place(out / "jet.png", picture)


def asked_of(options, tip):
    return {"cut_off": velocity_of(options.cut_off) if options.cut_off else 0.2 * tip,
        "resistance": stress_of("--resistance", options.resistance) if options.resistance else None,
        "strength": stress_of("--strength", options.strength) if options.strength else 0.0}


def run(words):
    options = parse(words)
    if not pathlib.Path(options.deck).is_file():
        raise Fault(f"{options.deck} does not exist (needed as the deck); check the path.", FILE)
    settings = [*as_set(options.settings), *(["--fidelity", options.fidelity] if options.fidelity else [])]
    jet = jet_of([options.deck, *settings], options.deck)
    asked = asked_of(options, max(slug.velocity for slug in jet.slugs))
    depths = theory_rows(jet, asked)
    out = pathlib.Path(options.out) if options.out else pathlib.Path("runs") / f"{pathlib.Path(options.deck).stem}-jet"
    lines = [*aligned(table_rows(jet.slugs)), "", *audit_lines(jet), target_line(jet), "", *depth_lines(jet, depths)]
    print("\n".join(lines))
    write(jet, depths, out)
    print(f"\nWritten: {out}/jet.csv, jet.json and jet.png")
    return 0


def main(words):
    return exit_code(run, words)
