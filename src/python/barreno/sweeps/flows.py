# SPDX-License-Identifier: BSD-3-Clause
"""Flow into the holes of many runs, as numbers beside those of their summaries (docs/flow.md)."""

import json

from barreno.runs.effective_deck import lists_in, value_in
from barreno.runs.faults import Fault, needed
from barreno.runs.regular_file import read_text
from barreno.runs.run_folder import numbers_of
from barreno.runs.tables import place

HEAD = "flow"  # of the names of its numbers
EFFICIENCY = f"{HEAD}.core_flow_efficiency"


def add_word(add):
    add("--flow", metavar="WORD", help="also the steady flow into the hole of every run, radial, axial or both: core flow efficiency, skin "
        "(docs/flow.md)")


def check_word(options):
    if options.flow is None:
        return
    needed("numpy")
    needed("netCDF4")  # not only when all runs have been made
    from barreno.flow.solve import BOUNDARIES

    if options.flow not in BOUNDARIES:
        raise Fault(f"--flow {options.flow} does not say where the fluid comes from; it is one of {', '.join(BOUNDARIES)}.")


def check_deck(options, base):
    """Before anything is computed: what flow refuses of every run.  @param base  the effective deck"""
    if options.flow is None:
        return
    mode = value_in(base, "Grid/Mode")
    if mode != "axisymmetric":
        raise Fault(f"--flow {options.flow}: the deck is {mode}, and flow is computed of axisymmetric runs alone; leave it out.")
    if all(value_in(base, path) is None for path in ("Jet/Material", "Jet Monitor/Position")):
        raise Fault(f"--flow {options.flow}: the deck has no jet, and so no hole to flow into; leave it out.")
    if all(value_in(base, f"Materials/{material}/Model") != "Arenisca" for material in lists_in(base, "Materials")):
        raise Fault(f"--flow {options.flow}: the deck has no rock with pores (Arenisca), so nothing flows; leave it out.")


def kept_in(folder, file):
    """What an earlier study has written of the run as it is; None if there is none."""
    try:
        if file.stat().st_mtime_ns >= (folder / "summary.json").stat().st_mtime_ns:
            return json.loads(read_text(file))
    except (OSError, ValueError):
        pass
    return None


def computed(point, file, boundary, say):
    from barreno.flow.command import as_json, flow_of  # slow to load

    text = as_json(point.folder, boundary, *flow_of(point.folder, boundary))
    place(file, text)
    found = json.loads(text)
    say(f"{point.label}: core flow efficiency {found['core_flow_efficiency']:.3f}")
    return found


def numbers_of_flow(point, boundary, say):
    """{name: number} of a finished run."""
    file = point.folder / f"flow_{boundary}.json"
    kept = kept_in(point.folder, file)
    return numbers_of({HEAD: kept if isinstance(kept, dict) else computed(point, file, boundary, say)})


def add_flows(program, points, boundary, say):
    """To all runs that have finished; those without a flow are said."""
    for point in points:
        if not point.how or point.code:
            continue
        if program.asked:
            raise Fault("interrupted between the flows of the runs; the same command continues.", 128 + program.asked)
        try:
            point.more = numbers_of_flow(point, boundary, say)
        except Fault as fault:
            say(f"{point.label} has no flow: {fault}")
