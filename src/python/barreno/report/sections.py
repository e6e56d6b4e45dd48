# SPDX-License-Identifier: BSD-3-Clause
"""The sections of a report, each from the files that it needs."""

import dataclasses

import numpy as np

from barreno.report.channel import draw_channel
from barreno.report.depth_picture import depth_figure
from barreno.report.energy_picture import energy_figure, energy_terms
from barreno.report.fields import known_fields, look_of
from barreno.report.files import reading
from barreno.report.hole import cell_along_path, face_of, hole_at
from barreno.report.hole_section import hole_section, zones_of_summary
from barreno.report.measured_section import measured_section
from barreno.report.numbers import depth_interval, depth_text, numerical_shares, resolution_rows, run_rows
from barreno.report.path_section import path_section
from barreno.report.penetration import STOPPED, depth_and_rate, jet_shares, launched_share
from barreno.report.section import Picture, Section
from barreno.report.strength_picture import NEAR, rock_near, strength_figure, surface_words
from barreno.report.view import STRETCH, View, hole_view, is_long

MILLI, MICRO = 1e-3, 1e-6
BESIDE, BEHIND, AHEAD = 14.0, 20.0, 10.0  # cells around the tip


def tip_of(run, table, frame):
    """(x, y, cell) of the bottom of the hole; None before the hit."""
    depth = float(np.interp(frame.time, table["time"], table["depth"])) if table is not None else 0.0
    if depth <= 0.0:
        return None
    return 0.0, face_of(table, run.file, run.deck) + run.deck.direction * depth, cell_along_path(run.file, run.deck)


def tip_box(tip, deck):
    """(x, x, y, y) in mm."""
    _, y, cell = tip
    # Where cells along the path are refined, some of the larger ones beside it are seen too.
    cell = min(max(cell, deck.number("Grid/Cell Size", cell)), 2.5 * cell)
    near, far = y - deck.direction * BEHIND * cell, y + deck.direction * AHEAD * cell
    return tuple(value / MILLI for value in (-BESIDE * cell, BESIDE * cell, min(near, far), max(near, far)))


def hole_pictures(frame, deck, fields, whole):
    """The hole alone, where the whole picture shows it small."""
    view = hole_view(whole, deck) if whole.hole is not None else None
    if view is None or not is_long(frame, deck.mirrored(), view.box):
        return []
    caption = "The hole alone: the thin line is its wall, a running median of the measured radius."
    if view.stretch > 1.0:
        caption += f" Radii are drawn {STRETCH:g} times larger than depths."
    return [Picture("channel", draw_channel(frame, deck, *fields, view), caption)]


def channel_section(run, frame, fields, table, whole):
    """Fields on both sides of the axis, whole, in the hole and near the tip; the pore fluid where there is one.

    @param whole  the view of all that there is
    """
    deck = run.deck
    caption = "Particles in their deformed shapes. A material without the field is grey. " + (
        "Cells and steps have a colour for each of their sizes." if any(look_of(name).doubling for name in fields)
        else "The colour scale leaves out the extreme 1.5 % of the area at each end."
    )
    if is_long(frame, deck.mirrored()):
        caption += " Depth runs along the paper; the field of the left is above."
    section = Section("Channel", pictures=[Picture("fields", draw_channel(frame, deck, *fields, whole), caption)])
    section.pictures += hole_pictures(frame, deck, fields, whole)
    tip = tip_of(run, table, frame)
    if tip and deck.mirrored():
        figure = draw_channel(frame, deck, *fields, dataclasses.replace(whole, box=tip_box(tip, deck), edges=True))
        section.pictures.append(Picture("tip", figure, "The same near the tip, where the size of particles shows the size of cells."))
    if "pore_pressure" in frame.names:
        beside = "porosity" if "porosity" in known_fields(run.file, deck) else "pressure"
        figure = draw_channel(frame, deck, "pore_pressure", beside, whole)
        section.pictures.append(Picture("pore_fluid", figure,
            f"Pressure of the pore fluid, and {'pore volume over volume' if beside == 'porosity' else 'mean stress of rock and fluid'}."))
    return section


def share_words(run, shares):
    time, spent, stopped = shares[-1]
    launched = launched_share(run.deck, time)
    return (
        f"At {time / MICRO:.4g} µs {100.0 * launched:.0f} % of the jet's table has been launched. Of that mass {100.0 * spent:.0f} % is "
        "slower along its flight than the hole grows, "
        f"so it will never get to the bottom, and {100.0 * stopped:.0f} % has stopped (below {100.0 * STOPPED:.0f} % of the fastest slug's "
        "speed)."
    )


def depth_section(run, table):
    penetration, last = run.summary.get("penetration", {}), table.last_row()
    section = Section("Depth")
    with reading(run.folder / "summary.json"):
        section.rows = [("depth", depth_text(last, penetration)), *resolution_rows(penetration)]
        interval = depth_interval(last["depth"], penetration)
        if interval is None and "unknown" in penetration.get("depth_error", {}):
            section.words.append("No interval is drawn at the end of the depth: its error from the size of the cells is unknown.")
    time, depth, rate, window = depth_and_rate(table)
    shares = []
    if len(time):
        section.rows.append(("rate of the depth at the end",
            f"{rate[-1]:.0f} m/s, by least squares over the last {0.5 * window / MICRO:.3g} µs"))
        section.words.append(f"The rate is the slope of the depth over windows of {window / MICRO:.3g} µs; the speed of the deepest piece "
            "of the jet (tip_velocity in depth.csv) is not that of the hole.")
        with run.particles_read():
            shares = jet_shares(run.file, run.deck, lambda when: float(np.interp(when, time, rate)))
    if shares:
        section.words.append(share_words(run, shares))
    section.pictures.append(Picture("depth", depth_figure(table, interval, time, rate, window, shares),
        "Depth, its rate, and the share of the launched jet that has done its work."))
    return section


def strength_section(run, frame, table):
    """None where no rock with pores is near the tip."""
    tip = tip_of(run, table, frame)
    found = rock_near(frame, run.deck, tip[:2], NEAR * tip[2])
    if not found:
        return None
    words = (
        "Every point is a particle. The surface is that of the run's card in triaxial compression: solid for virgin rock, dashed where "
        "crushing has closed the pores. A dotted line is virgin rock in triaxial extension, where its strength differs. "
        "In between, a particle's cap lies further out the more it is crushed; with rate dependence or scatter of the strength points may "
        "lie outside."
    )
    figure = strength_figure(run.deck, found, "pore_pressure" in frame.names, tip[:2], NEAR * tip[2])
    return Section("Strength at the tip", words=[words, *surface_words(found, run.deck)],
        pictures=[Picture("strength", figure, "Pressure and shear of rock near the tip.")])


def ledger_words(summary, remainder):
    shares = numerical_shares(summary)
    if shares is None:
        return []
    total = sum(shares)
    return [
        f"Numerically {'lost' if total < 0.0 else 'gained'}: {abs(total):.2g} % of the energy put in (stress integration {shares[0]:+.2g} "
        f"%, transfer {shares[1]:+.2g} %); "
        f"remainder of the ledger: {100.0 * remainder:+.1g} %.",
        "Stress integration is the work of the nodes' forces less that of the stresses at the particles; transfer is the kinetic energy "
        "that particles lose or gain when velocities go to the "
        "grid and back. Both are errors of the method, which the ledger measures step by step and counts as terms. Its remainder is what "
        "is still missing then: a small one says "
        "that nothing was forgotten, not that nothing was lost.",
    ]


def energy_section(run):
    table = run.history_table()
    with reading(run.folder / "history.csv"):
        figure = energy_figure(table, run.summary)
        rows, remainder = energy_terms(table, run.summary), float(table["energy_error"][-1])
    with reading(run.folder / "summary.json"):
        words = ledger_words(run.summary, remainder)
    return Section("Energy", rows, words, pictures=[Picture("energy", figure, "Energy by term, and the remainder of the ledger.")])


def summary_section(run, table):
    history = run.history_table()
    with reading(run.folder / "summary.json"):
        rows = run_rows(run.summary, history.last_row(), table.last_row() if table is not None else {})
    return Section("", rows, run.remarks())


def phases_section(run):
    with reading(run.folder / "summary.json"):
        rows = [(name, f"{phase['seconds']:.2f} s") for name, phase in run.summary.get("phases", {}).items()]
    return [Section("Phases", rows)] if rows else []


def particle_sections(run, fields, wishes, paths, table, folder):
    with run.particles_read():
        frame = run.frame(wishes.time)
        tip = tip_of(run, table, frame)
        hole = hole_at(run, table, frame)
        whole = View(hole=hole, measured=wishes.measured) if hole is not None and hole.open_rows else View()
        sections = [channel_section(run, frame, fields, table, whole)]
        if tip:
            with reading(run.folder / "summary.json"):
                known = zones_of_summary(run.summary, frame.time)
            sections += [hole_section(frame, run.deck, table, hole, wishes, folder, known), strength_section(run, frame, table)]
        if wishes.measured is not None:
            sections.insert(1, measured_section(hole, wishes.measured, folder))
        if paths:
            sections.append(path_section(run, frame, paths, tip_box(tip, run.deck) if tip and run.deck.mirrored() else None, folder))
    return [section for section in sections if section]


def all_sections(run, fields, wishes, paths, folder):
    """In their order on the page.

    @param paths  stress paths to show
    """
    table = run.depth_table()
    # What costs least comes first: a file that is damaged shows early.
    summary, energy, phases = summary_section(run, table), energy_section(run), phases_section(run)
    depth = []
    if table is not None:
        with reading(run.folder / "depth.csv"):
            depth = [depth_section(run, table)]
    channel, *around = particle_sections(run, fields, wishes, paths, table, folder)
    return [summary, channel, *depth, *around, energy, *phases]
