# SPDX-License-Identifier: BSD-3-Clause
"""The section on stress paths (--particles): pictures, a table, paths.csv."""

import numpy as np

from barreno.report.channel import time_text
from barreno.report.files import write_text
from barreno.report.path_picture import axis_names, map_figure, paths_figure
from barreno.report.section import Picture, Section
from barreno.report.strength import surface_of
from barreno.report.stress_paths import COARSE, elements_near, elements_of, numbers_of, path_of, share_of_strength

MILLI, MEGA = 1e-3, 1e6
HEADS = ("particle", "material", "starts at [mm]", "at [mm]", "p [MPa]", "sqrt(J2) [MPa]", "Lode angle [degrees]", "plastic volume strain",
    "sqrt(J2) / surface", "largest step of the path [%]")
SURFACES = (
    "Solid: the surface of the card for virgin rock, in triaxial compression. Dashed, in the colour of a particle: its own surface now, "
    "with the cap where its plastic volume strain has "
    "brought it, and its own strength where that is scattered; in the octahedral view at its present pressure. With rate dependence a path "
    "may leave its surface."
)
ANGLES = (
    "The Lode angle is 0 in triaxial compression, 30 in pure shear, 60 in triaxial extension. Each principal stress is followed by its "
    "direction, and named after that at the start. "
    "paths.csv has every point of the paths."
)


def chosen_paths(run, text, frame, tip, distance):
    """Of the particles that --particles means. @raises Fault"""
    numbers = numbers_of(text)
    elements = elements_of(run.file, numbers) if numbers else elements_near(frame, run.deck, tip[:2] if tip else None, distance)
    return [path_of(run.file, element) for element in elements]


def rounded(value):
    """Down to one digit."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(np.floor(value / power + 1e-9) * power)


def coarse_words(paths):
    """What the times of particles.e are too far apart for; none where they are not."""
    share, interval, number = max((*path.largest_step, path.number) for path in paths)
    if share <= COARSE:
        return []
    enough = rounded(interval * COARSE / share)
    return [
        f"The times of particles.e are too far apart for these paths: from one to the next, {time_text(interval)} later, the stress of "
        f"particle {number} changes by {100.0 * share:.0f} % of all that "
        "its path extends over, and the line between two marks is not the way that it took. A run with an Output/Field Interval of "
        f"{time_text(enough)} or less would show it."
    ]


def place_text(place):
    return ", ".join(f"{value / MILLI:.1f}" for value in place)


def path_row(path, strength, time):
    at = path.at(time)
    share = share_of_strength(path, strength, at) if strength else float("nan")
    return (
        str(path.number), path.material, place_text(path.places[0]), place_text(path.places[at]), f"{path.pressure[at] / MEGA:.4g}",
        f"{path.shear[at] / MEGA:.4g}", f"{path.lode[at]:.0f}",
        f"{path.strain[at]:+.4f}" if np.isfinite(path.strain[at]) else "none", f"{share:.2f}" if np.isfinite(share) else "none",
        f"{100.0 * path.largest_step[0]:.0f}",
    )  # fmt: skip


def path_lines(paths, names):
    """paths.csv."""
    stresses = ",".join(name.replace(" ", "_") for name in names)
    yield (
        f"# SI units, compression positive; principal stresses by their directions at the start, {', '.join(names)}; effective where there "
        "is pore pressure; lode: degrees from triaxial compression"
    )
    yield f"particle,time,{stresses},pressure,shear_stress,lode,plastic_volume_strain"
    for path in paths:
        for time, stress, p, q, lode, e in zip(path.times, path.stress, path.pressure, path.shear, path.lode, path.strain):
            yield f"{path.number},{time:.9g}," + ",".join(f"{value:.6g}" for value in (*stress, p, q, lode, e))


def path_section(run, frame, paths, box, folder):
    """@param box  of the map, (x, x, y, y) in mm; None: all"""
    known = {name: surface_of(run.deck, name) for name in dict.fromkeys(path.material for path in paths)}
    surfaces = {name: strength for name, (strength, _) in known.items()}
    reasons = [f"{name}: {why}, so only the path is drawn." for name, (_, why) in known.items() if why]
    wet = "pore_pressure" in frame.names
    write_text(folder / "paths.csv", "\n".join([*path_lines(paths, axis_names(run.deck)), ""]))
    words = [*([SURFACES] if any(surfaces.values()) else []), *reasons, ANGLES, *coarse_words(paths)]
    pictures = [
        Picture("map", map_figure(frame, run.deck, paths, surfaces, box),
            "Pressure and shear stress as one colour, with its legend; the particles, and their paths in the legend."),
        Picture("paths", paths_figure(frame.time, run.deck, paths, surfaces, wet),
            "Stress paths with a mark for every time of particles.e, and a larger one for the time of the pictures."),
    ]
    table = [path_row(path, surfaces[path.material], frame.time) for path in paths]
    return Section("Stress paths", words=words, pictures=pictures, heads=HEADS, table=table)
