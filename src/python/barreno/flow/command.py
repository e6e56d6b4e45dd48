# SPDX-License-Identifier: BSD-3-Clause
"""The command: how much flows through the shot rock into the hole of a run, against the same hole in virgin rock."""

import json
import math
import pathlib

import numpy as np

from barreno.flow.rings import rings_of
from barreno.flow.solve import BOUNDARIES, solve
from barreno.flow.surge import LIMIT, cleaned
from barreno.flow.surge_table import lines_of_surge, numbers_of_surge, skin_of
from barreno.report.files import read_summary
from barreno.report.numbers import error_words
from barreno.report.run import opened
from barreno.runs.faults import FILE, BadRun, Fault, exit_code, on_one_line
from barreno.runs.ranks import check_ranks
from barreno.runs.tables import aligned, make_folder, place
from barreno.runs.words import GRADIENT_UNITS, LENGTH_UNITS, PRESSURE_UNITS, TIME_UNITS, Words, quantity_of

EXAMPLE = "write for example barreno flow runs/perforation-1 --boundary radial"
PARTS = 10  # of the hole's length, whose shares are printed


def parse(words):
    parser = Words("flow", EXAMPLE, "flow.md",
        description="Steady flow through the rock around the hole of a run: core flow efficiency, skin, shares of depths (docs/flow.md).")
    parser.add_argument("run", metavar="RUN", help="folder of an axisymmetric run with a jet")
    parser.add_argument("--boundary", default="radial", choices=BOUNDARIES,
        help="where the fluid comes from: the rock's side (radial, default), its rear (axial) or both")
    parser.add_argument("--time", metavar="TIME", help='the output nearest to it, "200 us" (default: the last)')
    parser.add_argument("--cell", metavar="LENGTH", help='of the rings, "1 mm" (default: half a cell along the path of the jet)')
    parser.add_argument("--surge", metavar="PRESSURE",
        help='clean-up first: the hole is this much below the pore pressure, "7 MPa", and rock without cohesion leaves its wall')
    parser.add_argument("--surge-limit", metavar="GRADIENT",
        help=f'of the pore pressure, above which such rock goes (default, assumed: "{1e-9 * LIMIT:g} MPa/mm")')
    parser.add_argument("--ranks", type=int, default=1, metavar="N", help="processes of the solver")
    parser.add_argument("--out", metavar="FOLDER", help="folder of flow.json and flow.png (default RUN/flow)")
    return parser.parse_args(words)


def quantity_in(option, text, units, example, least="above 0"):
    """@param least  "above 0" or "of 0 or more" """
    try:
        value = quantity_of(text, units)
    except ValueError:
        value = -1.0
    if not (math.isfinite(value) and (value > 0.0 or value == 0.0 and least != "above 0")):
        raise Fault(f'{option} "{text}" is not a quantity {least} with its unit; write for example {option} "{example}".')
    return value


def surge_in(options):
    """(pressure, limit of the gradient); None without a surge."""
    if options.surge is None:
        if options.surge_limit is not None:
            raise Fault('--surge-limit says nothing without --surge; add for example --surge "7 MPa", or leave it out.')
        return None
    pressure = quantity_in("--surge", options.surge, PRESSURE_UNITS, "7 MPa", "of 0 or more")
    return pressure, LIMIT if options.surge_limit is None else quantity_in("--surge-limit", options.surge_limit, GRADIENT_UNITS,
        "0.1 MPa/mm", "of 0 or more")  # fmt: skip


def shares_of(rings, flow):
    """[(from, to, share of the flow)] of equal parts of the hole's length in rock."""
    rows = np.flatnonzero(rings.hole.any(axis=1))
    edges = np.linspace(rows[0], rows[-1] + 1, min(PARTS, len(rows)) + 1)
    total = np.concatenate([[0.0], np.cumsum(flow.into_hole)])
    at = np.interp(edges, np.arange(len(total)), total) / flow.rate
    depth = np.interp(edges, np.arange(len(rings.depths)), rings.depths)
    below = [(depth[-1], rings.depths[-1], 1.0 - at[-1])] if 1.0 - at[-1] > 1e-9 else []
    above = [(rings.depths[0], depth[0], at[0])] if at[0] > 1e-9 else []
    return [*above, *zip(depth[:-1], depth[1:], np.diff(at)), *below]


def warning_of(options, found):
    """Whether the hole is one that goes on growing, or has no bottom; empty where nothing is to be said.  @param found  penetration"""
    if options.time:
        return ""
    rest = found.get("rest", {})
    if found.get("through"):
        return "The jet has come out of the rear of the target: the fluid flows into a hole without a bottom, as deep as the target."
    return rest["sentence"] + " The flow is that into the hole as it is." if rest.get("at_rest") is False else ""


def error_of(options, found):
    """What the size of the run's cells does to the efficiency, as its summary says it; {} where the summary says nothing.
    @param found  penetration of the summary"""
    error = found.get("core_flow_efficiency_error", {})
    if error and (options.boundary != "radial" or options.time or options.surge):
        return {"unknown": "it was measured for radial flow at the end of runs without a surge only"}
    return error


def interval_of(efficiency, error):
    """(low, high), or None where the error is unknown."""
    return tuple(efficiency / (1.0 + error[end]) for end in ("high", "low")) if "value" in error else None


def as_json(run, boundary, rings, shot, virgin, shares, more=None):
    """@param more  further entries"""
    efficiency = shot.rate / virgin.rate
    return json.dumps({"run": str(run), "boundary": boundary, "core_flow_efficiency": efficiency,
        "skin": skin_of(efficiency, rings), "shape_factor": shot.rate, "shape_factor_virgin": virgin.rate,
        "hole_radius": rings.hole_radius, "cell": float(rings.radii[1] - rings.radii[0]), "mass_error": max(shot.leak, virgin.leak),
        "method": shot.method, "iterations": shot.iterations,
        "shares": [{"from": float(low), "to": float(high), "share": float(share)} for low, high, share in shares],
        **(more or {})}, indent=2) + "\n"


def lines_of(options, rings, shot, virgin, shares, error):
    efficiency = shot.rate / virgin.rate
    interval = interval_of(efficiency, error)
    yield (f"core flow efficiency {efficiency:.3f} ({options.boundary} flow: {efficiency:.0%} of what the same hole in virgin rock "
        "would let in)" + (f", {interval[0]:.3f} to {interval[1]:.3f}" if interval else "") + error_words(error))
    yield f"skin {skin_of(efficiency, rings):+.2f} (outer radius {1e3 * rings.radii[-1]:.4g} mm, hole {1e3 * rings.hole_radius:.3g} mm)"
    yield (f"flow rate / (permeability x pressure drop / viscosity) = {shot.rate:.4g} m, virgin {virgin.rate:.4g} m; in and out agree to "
        f"{max(shot.leak, virgin.leak):.1e}")
    yield ""
    yield "share of the flow by depth:"
    rows = [("from [mm]", "to [mm]", "share [%]")]
    rows += [(f"{1e3 * low:.1f}", f"{1e3 * high:.1f}", f"{100.0 * share:.1f}") for low, high, share in shares]
    yield from aligned(rows)
    yield ""
    broken = np.nanmax(rings.breakage) > 0.0
    yield ("Permeability follows Kozeny and Carman from the porosity that plastic flow has left, "
        + ("and from the breakage of the grains." if broken else "for grains that stay whole: broken grains "
        "of the crushed zone let less through, so the real efficiency is lower. A card with Breakage energy knows them."))  # fmt: skip


def flow_of(folder, boundary, time=None, cell=None, ranks=1):
    """(rings, flow into the hole as it is, flow in virgin rock, shares of depths) of a run."""
    with opened(folder) as run:
        rings = rings_of(run, time, cell)
    shot = solve(rings, rings.permeability, boundary, ranks)
    virgin = solve(rings, rings.virgin_mobility, boundary, ranks)
    return rings, shot, virgin, shares_of(rings, shot)


def run(words):
    options = parse(words)
    try:
        return flow(options)
    except BadRun as bad:
        raise Fault(f"cannot find the flow into the hole of '{on_one_line(options.run)}' ({bad}).", FILE) from None


def flow(options):
    check_ranks(options.ranks)
    if not pathlib.Path(options.run).is_dir():
        raise Fault(f"'{options.run}' is not a folder (flow reads what a run wrote into it); check the path.", FILE)
    time = quantity_in("--time", options.time, TIME_UNITS, "200 us") if options.time else None
    cell = quantity_in("--cell", options.cell, LENGTH_UNITS, "1 mm") if options.cell else None
    surge = surge_in(options)
    found = read_summary(pathlib.Path(options.run) / "summary.json").get("penetration", {})
    cleaning, more, error, warning = None, {}, error_of(options, found), warning_of(options, found)
    if surge is None:
        rings, shot, virgin, shares = flow_of(options.run, options.boundary, time, cell, options.ranks)
    else:
        cleaning = cleaned(options.run, options.boundary, *surge, time, cell, options.ranks)
        rings, shot, virgin = cleaning.after.rings, cleaning.after.shot, cleaning.after.virgin
        shares, more = shares_of(rings, shot), {"surge": numbers_of_surge(cleaning)}
        print("\n".join(lines_of_surge(cleaning)))
    if error:
        more["core_flow_efficiency_error"] = error
    if warning:
        more["warning"] = warning
        print(warning)
    print("\n".join(lines_of(options, rings, shot, virgin, shares, error)))
    out = pathlib.Path(options.out) if options.out else pathlib.Path(options.run) / "flow"
    make_folder(out)
    place(out / "flow.json", as_json(options.run, options.boundary, rings, shot, virgin, shares, more))

    def picture(aside):
        from barreno.flow.picture import draw  # slow to load

        draw(aside, rings, shot, options.boundary, cleaning.before.rings if cleaning else None)

    place(out / "flow.png", picture)
    print(f"\nWritten: {out}/flow.json and flow.png")
    return 0


def main(words):
    return exit_code(run, words)
