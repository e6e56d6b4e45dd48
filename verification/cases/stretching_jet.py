# SPDX-License-Identifier: BSD-3-Clause
"""A jet that stretches from a virtual origin into a target without strength: depth over time against the theory of such jets."""
import pathlib

import numpy as np
from tools.case import Result
from tools.penetration import depth_at
from tools.runs import run_deck, scratch_folder

TIP, DENSITY = 6000.0, 8930.0  # of the jet; jet and target are of the same copper [m/s, kg/m3]
RADIUS, PLANE = 3e-3, 1e-3  # of the jet at the launch plane, and how far that is before the target [m]
BETWEEN = 0.1e-6  # slugs: shorter than a cell [s]
TAIL = 2500.0  # [m/s]
INSTANTS = (5.0, 10.0, 15.0)  # after the impact [us]
FINE = 1.0  # cells of which the limits are demanded [mm]


def jet_table(folder, standoff):
    """The slugs of a jet whose velocities are x / t from an origin `standoff` before the target, as they pass the launch plane."""
    flight = standoff - PLANE
    first = flight / TIP
    passing = np.arange(first, flight / TAIL, BETWEEN)
    lines = ["# units: SI", "time,velocity,radius,length,density"]
    for time in passing:
        speed = flight / time
        lines.append(f"{time - first:.9g},{speed:.9g},{RADIUS},{speed * BETWEEN:.9g},{DENSITY}")
    file = pathlib.Path(folder) / "stretching.csv"
    file.write_text("\n".join(lines) + "\n")
    return file


def exact(standoff, time):
    """Depth a time after the impact. The slice u arrives at the depth P at t = (S + P) / u after it left the origin, and digs at u / 2 in a
    target of its own density: S + P = sqrt(S V0 t)."""
    return np.sqrt(standoff * TIP * (standoff / TIP + time)) - standoff


def run(barreno, full):
    result = Result(
        "Stretching jet",
        "A whole jet that stretches on its way digs as the theory of a virtual origin says, the closer the origin the less.",
        "W. A. Allison & R. Vitali, BRL report 1184 (1963): P = sqrt(S V0 t) - S, t from the origin, for jet and target of one density, "
        "without strength "
        "and compression. The jet of 6 km/s at its tip has a radius of 3 mm where it is launched, and is thinned as it arrives.",
        ["origin before the target [mm]", "cell [mm]", *(f"depth {t:g} us after impact [mm]" for t in INSTANTS),
            *(f"error at {t:g} us" for t in INSTANTS),
         "energy ledger remainder"],
        [],
    )  # fmt: skip
    for standoff in (0.02, 0.03, 0.04) if full else (0.03,):
        for h in (2.0, FINE) if full else (FINE,):
            folder = scratch_folder()
            settings = {
                "Jet/Table": str(jet_table(folder, standoff)), "Jet/Kind": "thinned", "Jet/Launch Position": f"{-1e3 * PLANE} mm",
                "Grid/Cell Size": f"{h} mm",
                "Time/End Time": f"{INSTANTS[-1] + 0.5} us", "Output/History Interval": "0.1 us",
            }  # fmt: skip
            finished = run_deck(barreno, "jet_import_kinds.xml", settings)
            impact = PLANE / TIP
            depths = [depth_at(finished, 1e-6 * t + impact) for t in INSTANTS]
            errors = [depth / exact(standoff, 1e-6 * t) - 1.0 for depth, t in zip(depths, INSTANTS)]
            remainder = finished.summary["balances"]["energy"]["error"]
            result.rows.append([1e3 * standoff, h, *(1e3 * depth for depth in depths), *errors, remainder])
            for t, error in zip(INSTANTS, errors) if h == FINE else ():
                result.demand(f"origin {1e3 * standoff:g} mm before the target, {h:g} mm: depth {t:g} us after impact", abs(error), 0.1)
            result.demand(f"origin {1e3 * standoff:g} mm before the target, {h:g} mm: energy ledger remainder", abs(remainder), 1e-3)
    result.notes = (
        "Limits are required with cells of 1 mm, three in the radius of the jet where it is launched and two where its end digs. Cells "
        "of 2 mm are shown only. The depth is "
        "that of the tip: slugs of one velocity each follow it, shorter than a cell."
    )
    return result
