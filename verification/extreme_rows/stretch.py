# SPDX-License-Identifier: BSD-3-Clause
"""F stretched a thousandfold and turned by 1e4 rad on the grid; matrices that hardly change their volume."""
import re

import numpy as np
from cases.simple_motions import BLOCK, RADIANS, angular_momentum, energy_gained, spin
from tools.manufactured_runs import Failed
from tools.small_decks import BARE, DECKS, attempt, attempt_file, check_notes, elastic, symmetry


def pulled(shape, longest, domain="1"):
    """input_xml/stretched_bar.xml, pulled by its grip at 10 /s."""
    return {
        "Step/Shape Function": shape,
        "Step/Largest Domain": domain,
        "Step/Largest Expansion": "1e4",
        "Grid/Upper": f"{{{0.1 * (longest + 1)!r} m, 0.05 m}}",
        "Time/End Time": repr((longest - 1.0) / 10.0),
        "Output/Field Interval": repr((longest - 1.0) / 10.0),
    }


def stretched_rows(barreno, full, table):
    title = "F stretched a thousandfold, on the grid"
    longest = 1000.0 if full else 20.0
    for shape in ("CPDI", "contiguous GIMP", "GIMP"):
        done = attempt_file(barreno, DECKS / "stretched_bar.xml", pulled(shape, longest), longest=900.0)  # 1e6 steps
        setup = f"a bar of four cells pulled to {longest:g} times its length, {shape}"
        words = ("at t = ", "of material")
        table.holds_or_stops(title, setup, done, "mass error", lambda r: np.abs(r.table("history.csv")["mass_error"]).max(), 1e-12, *words)
        if done.finished:
            table.within(title, setup, "energy error", np.abs(done.run.table("history.csv")["energy_error"]).max(), 1e-2)
            if shape != "GIMP":
                clipped = done.run.table("history.csv")["clipped"].max()
                table.within(title, setup, "domains cut at Largest Domain, counted", clipped, 1, at_least=True)
    settings = {**pulled("CPDI", 4.0), "Step/Largest Expansion": "2", "Materials/Soft/Bad Particles": "stop"}
    limit = attempt_file(barreno, DECKS / "stretched_bar.xml", settings)
    table.stops(title, "beyond Largest Expansion 2, policy stop", limit, 3, "Particle ", "of material 'Soft' expanded beyond", "at t = ")


def particles_gone(run):
    """nan where the run stopped before its end."""
    if not isinstance(run, Failed):
        return 0.0
    gone = re.match(r"(\d+) particles left the grid", run.why)
    return float(gone.group(1)) if gone else float("nan")


def turned_rows(barreno, full, table):
    title = "Rotation of 1e4 rad, on the grid"
    radians, rows = (RADIANS, 1000) if full else (20.0 * np.pi, 100)
    for shape in ("GIMP", "cubic B-spline") if full else ("GIMP",):
        run = spin(barreno, shape, 0.02, radians, rows, {"Step/Transfer": "APIC", "Step/Order": "modified stress last", **BLOCK})
        setup = f"block of 4 by 4 cells, {shape}, APIC, modified stress last, {radians:.5g} rad"
        table.within(title, setup, "particles that left the grid", particles_gone(run), 0.0)
        if isinstance(run, Failed):
            continue
        momentum = angular_momentum(run.particles()) / angular_momentum(run.particles(0)) - 1.0
        table.within(title, setup, "greatest energy over that at the start, less 1",
            energy_gained(run.table("history.csv"), every_step=False), 1e-3)
        table.within(title, setup, "|change of angular momentum|", abs(momentum), 2e-2)


def column(poisson, shape="GIMP", load=1e5):
    """A square block on a frictionless floor, squeezed on a part of its top: shear and volume both matter."""
    shear = 1e7
    bulk = 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson))
    return {
        "Grid": {"Mode": "plane strain", "Lower": (0, 0), "Upper": (1.25, 1.25), "Cell Size": 0.125},
        "Materials": {"Rubber": elastic(bulk, shear)},
        "Bodies": {
            "Left": {"Material": "Rubber", "Lower": (0, 0), "Upper": (0.5, 1)},
            "Right": {"Material": "Rubber", "Lower": (0.5, 0), "Upper": (1, 1)},
        },
        "Conditions": symmetry("x_lower", "y_lower"),
        "Loads": {"Top": {"Kind": "pressure", "Body": "Left", "Faces": "{y_upper}", "Times": (0, 0.02), "Pressures": (0, load)}},
        "Step": {"Damping": 100, "Shape Function": shape, **BARE},
        "Time": {"End Time": 0.1},
    }


def sunk(run):
    """How far the loaded top has come down [m]."""
    first, last = run.particles(0), run.particles()
    top = (first["y"] > 0.9) & (first["x"] < 0.4)
    return float((first["y"] - last["y"])[top].mean())


def incompressible_rows(barreno, full, table):
    title = "Nearly incompressible matrix"
    base = attempt(barreno, column(0.45))
    reference = sunk(base.run) if base.finished else float("nan")
    for poisson in (0.49, 0.499, 0.4999):
        done = attempt(barreno, column(poisson), longest=200.0)
        table.finishes(title, f"block under half a load, GIMP, nu = {poisson:g}", done, "|settlement over that at nu = 0.45, less 1|",
                       lambda r: abs(sunk(r) / reference - 1.0), 0.2)
    for poisson, wanted in ((0.45, False), (0.4999, True)):
        code, said, _ = check_notes(barreno, column(poisson))
        warned = "volumetric locking" in said
        table.add(title, f"`check` of nu = {poisson:g}", f"{'a note' if wanted else 'no note'} on locking", "note" if warned else "no note",
            code == 0 and warned == wanted)


def run(barreno, full, table):
    stretched_rows(barreno, full, table)
    turned_rows(barreno, full, table)
    incompressible_rows(barreno, full, table)
