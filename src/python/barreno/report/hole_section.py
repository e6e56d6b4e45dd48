# SPDX-License-Identifier: BSD-3-Clause
"""The section on the hole: its measures, the rock around it, profile.csv."""

import numpy as np

from barreno.report.channel import time_text
from barreno.report.files import write_text
from barreno.report.hole_picture import hole_figure
from barreno.report.porosity import IMPAIRED, LAW, LEAST_PERMEABILITY
from barreno.report.section import Picture, Section
from barreno.report.zones import CHANGED, Rock, chosen_depths, rings_at, zones_of
from barreno.runs.faults import Fault

MILLI = 1e-3
ROUND_OFF = 1e-9
ZONES = ("depth", "radius", "crushed_from", "crushed_to", "dilated_to", "impaired_to", "least_porosity", "least_permeability",
    "greatest_breakage", "skin")  # fmt: skip
COLUMNS = "depth,radius,crushed_from,crushed_to,dilated_to,porosity_at_wall,impaired_to,breakage_at_wall"


def rows_in_rock(hole, top, across):
    """Length and entrance in the rock, which begins at a depth; none without rock or above it."""
    if top is None or hole.length <= top:
        return []
    return [
        ("length in rock", f"{(hole.length - top) / MILLI:.1f} mm below the face of the rock, which was {top / MILLI:.1f} mm below the "
            "outer face"),
        (f"entrance {across} in rock", f"{hole.diameter_below(top) / MILLI:.2f} mm"),
    ]


def face_of_rock(frame, deck, face):
    """Depth of the rock's face at the start; None without rock."""
    rock = Rock(frame.file.frame(0), deck, face)
    return max(0.0, float((rock.depth - rock.half_height).min())) if len(rock) else None


def hole_rows(hole, mark, time, top):
    per = "mm2 per thickness" if hole.plane else "cm3"
    scale = MILLI**2 if hole.plane else 1e-6
    across = "width" if hole.plane else "diameter"
    rows = [
        ("time", time_text(time)),
        *rows_in_rock(hole, top, across),
        ("length of the hole", f"{hole.length / MILLI:.1f} mm below the outer face, to where it is closed or leaves the target"),
        (f"entrance {across}", f"{hole.entrance_diameter / MILLI:.2f} mm, in the first row with a wall, "
            f"{hole.depth[hole.first_row] / MILLI:.2g} mm below the outer face"),
        ("volume", f"{hole.volume / scale:.3g} {per}"),
    ]
    if mark:
        rows.append(("radius at half the depth of the channel",
            f"{hole.radius_at(mark[0]) / MILLI:.2f} mm; depth.csv, without the shear of particles, has {mark[1] / MILLI:.2f} mm"))
    return rows


def rock_rows(rock):
    return [("virgin porosity", f"{100.0 * rock.virgin:.1f} %")]


def zones_of_summary(summary, time):
    """What the run itself found half-way down the hole in each body of rock, if its summary is of that time."""
    if "time" not in summary or abs(summary["time"] - time) > ROUND_OFF * time:
        return []
    found = summary.get("penetration", {}).get("zones_in_body", {})
    # Runs of former versions know no impaired zone.
    return [{name: float("nan" if (value := zones.get(name)) is None else value) for name in ZONES} for zones in found.values()]


def zone_table(zones):
    """Heads and rows.  @param zones  as Rings.zones"""
    heads = ("depth [mm]", "wall [mm]", "crushed from [mm]", "to [mm]", "dilated to [mm]", "impaired to [mm]", "least porosity [%]",
        "greatest breakage", "least permeability / virgin", "skin")
    rows = []
    for one in zones:
        none = one["crushed_from"] == one["crushed_to"]
        rows.append((
            f"{one['depth'] / MILLI:.1f}", f"{one['radius'] / MILLI:.2f}", "none" if none else f"{one['crushed_from'] / MILLI:.1f}",
            "" if none else f"{one['crushed_to'] / MILLI:.1f}",
            "none" if one["dilated_to"] == one["radius"] else f"{one['dilated_to'] / MILLI:.1f}",
            "none" if one["impaired_to"] == one["radius"] else f"{one['impaired_to'] / MILLI:.1f}",
            f"{100.0 * one['least_porosity']:.1f}", f"{one['greatest_breakage']:.2f}", f"{one['least_permeability']:.2f}",
            f"{one['skin']:+.2f}",
        ))  # fmt: skip
    return heads, rows


WALL = (
    "The wall is where the target's particles, with their deformed shapes, cover half of a window one cell wide and high. A sharp wall is "
    "found to less than a tenth of a cell; debris that is half a cell away from it makes no difference. profile.csv has the radius in rows "
    "of half a cell."
)
ROCK = (
    "Porosity is what crushing and dilation have left, phi = 1 - (1 - phi_0) exp(-e) with the plastic volume strain e, averaged over rings "
    "one cell wide and four "
    f"cells high; a zone is crushed or dilated where it differs from the virgin porosity by more than {100.0 * CHANGED:.0f} % of that. "
    "Permeability follows Kozeny and Carman, "
    f"k ~ phi^3/(S (1 - phi))^2, at most {LAW['most']:g} times the virgin one by its porosity; the surface S of the grains grows with "
    f"their breakage, so that fully broken ones let {LAW['of_broken']:g} through of what whole ones do. A card without Breakage energy "
    "has whole grains: crushed rock then lets less through than computed. "
    f"Rock is impaired below {IMPAIRED:g} of the virgin permeability. The skin is Hawkins' sum of (k_0/k - 1) ln(r_outer/r_inner) over the "
    f"rings, for flow towards the hole at that depth; closed pores count as {LEAST_PERMEABILITY:g} of the virgin permeability. Expanded "
    "debris at the wall counts as rock."
)


def profile_text(hole, rock, top):
    lines = [
        "# SI units: depth below the outer face, radius of the wall, inner and outer radius of the crushed zone, outer radius of the "
        "dilated zone and of the impaired zone m;"
        " nan where there is no rock with pores",
        COLUMNS,
    ]
    for depth, radius in zip(hole.depth[: hole.open_rows], hole.radius[: hole.open_rows]):
        values = [np.nan] * 6
        if top is not None and depth >= top and np.isfinite(radius):
            ring = rings_at(rock, hole, depth)
            values = [*ring.crushed, ring.dilated[1], float(ring.porosity[0]), ring.impaired[1], float(ring.breakage[0])]
        lines.append(",".join(f"{value:.9g}" for value in (depth, radius, *values)))
    return "\n".join(lines) + "\n"


def mark_at(table, time):
    """(depth, radius) of the middle of the channel in depth.csv at a time."""
    at = lambda name: float(np.interp(time, table["time"], table[name]))  # noqa: E731
    return (0.5 * at("channel_depth"), at("channel_radius_mid")) if at("channel_depth") > 0.0 else None


def depths_in_rock(hole, top, wanted):
    """The wanted depths, or three where none is wanted; none without rock. @raises Fault  for one that is beside the hole in rock"""
    if top is None:
        return []
    for depth in wanted:
        if not top <= depth <= hole.length:
            raise Fault(f"--depths has {depth / MILLI:g} mm, where there is no hole in rock ({top / MILLI:.1f} to "
                f"{hole.length / MILLI:.1f} mm); choose depths in between.")
    return wanted or chosen_depths(hole, top)


def rings_and_zones(rock, hole, top, wanted, known):
    """Rings for the picture, and zones for the table: at wanted depths; else where they are known, a quarter and three quarters down."""
    depths = depths_in_rock(hole, top, wanted)
    known = {one["depth"]: one for one in known} if depths and not wanted else {}
    if known:
        depths = sorted([depths[0], depths[-1], *known])
    rings = [rings_at(rock, hole, depth, known[depth]["radius"] if depth in known else None) for depth in depths]
    return rings, [known.get(ring.depth, ring.zones) for ring in rings]


def hole_section(frame, deck, table, hole, wishes, folder, known=()):
    """
    @param table   depth.csv
    @param wishes  depths of rings, none: three, and a measured hole
    @param folder  where profile.csv is written
    @param known   zones half-way down the hole, of summary.json
    """
    if hole.open_rows == 0:
        return Section("Hole", words=["There is no hole in the target yet."])
    mark, rock = mark_at(table, frame.time), Rock(frame, deck, hole.face)
    top = face_of_rock(frame, deck, hole.face) if len(rock) else None
    rings, zones = rings_and_zones(rock, hole, top, wishes.depths, known)
    rows = zones_of(rock, hole, top) if top is not None else []
    write_text(folder / "profile.csv", profile_text(hole, rock, top))
    section = Section("Hole", hole_rows(hole, mark, frame.time, top) + (rock_rows(rock) if len(rock) else []), [WALL])
    if rings:
        section.heads, section.table = zone_table(zones)
        section.words.append(ROCK)
    if deck.mode == "3D":
        section.words.append("In three dimensions the hole is measured in the plane of the picture.")
    section.pictures.append(Picture("hole", hole_figure(hole, rows, rings, mark, wishes.measured),
        "Wall of the hole against depth and porosity around it; porosity and permeability against radius."))
    return section
