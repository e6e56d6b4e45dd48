# SPDX-License-Identifier: BSD-3-Clause
"""Skempton's B: pore pressure in a sealed block that is pressed, and its undrained bulk modulus, from soft fluids to stiff ones."""
import dataclasses

import numpy as np
from tools.case import Result
from tools.choices import modes
from tools.columns import ROCK
from tools.runs import missing_fluid, run_deck

LOAD = 1e6
FLUIDS = (1e7, 1e9, 2.25e9, 36e9, 1e12)  # Pa; 36e9: as stiff as the grains, B = 1


PERMEABILITIES = (0.0, 1e-10)  # m2; with the latter the fluid evens out soon after the load's waves


def settings_of(mode, fluid, permeability):
    settings = {"Grid/Mode": mode, "Materials/Rock/Fluid Bulk Modulus": repr(fluid), "Pore Flow/Drainage": "on",
                "Pore Flow/Rocks/Rock/Permeability": f"{{{permeability!r} m2}}"}  # fmt: skip
    if mode == "3D":
        origin, cube = "{0 m, 0 m, 0 m}", "{1 m, 1 m, 1 m}"
        settings.update({"Grid/Lower": origin, "Grid/Upper": "{1.25 m, 1.25 m, 1.25 m}", "Bodies/Block/Lower": origin,
                         "Bodies/Block/Upper": cube, "Loads/Around/Faces": "{x_upper, y_upper, z_upper}",
                         "Conditions/Third plane/Face": "z_lower", "Conditions/Third plane/Kind": "symmetry"})  # fmt: skip
    return settings


def expected(mode, rock):
    """Pore pressure and volume strain under the load. Plane strain: the mean stress is 2 (1 + nu_u) / 3 of the load."""
    undrained = rock.undrained_bulk
    nu = (3.0 * undrained - 2.0 * rock.shear) / (6.0 * undrained + 2.0 * rock.shear)
    mean = LOAD * (2.0 * (1.0 + nu) / 3.0 if mode == "plane strain" else 1.0)
    return rock.skempton * mean, -mean / undrained


def measure(barreno, mode, fluid, permeability):
    """A row of the table: its last three are errors."""
    rock = dataclasses.replace(ROCK, fluid=fluid)
    pressure, strain = expected(mode, rock)
    finished = run_deck(barreno, "sealed_block.xml", settings_of(mode, fluid, permeability))
    particles = finished.particles()
    error = float(np.max(np.abs(particles["pore_pressure"] / pressure - 1.0)))
    measured = rock.skempton * float(np.mean(particles["pore_pressure"])) / pressure
    bulk = abs(float(np.mean(np.log(particles["volume_ratio"]))) / strain - 1.0)
    return [mode, fluid, permeability, rock.skempton, measured, error, bulk, missing_fluid(finished)]


def run(barreno, full):
    result = Result(
        "Skempton's coefficient",
        "A sealed block under pressure keeps its fluid, whatever its permeability: the pores carry their share of the load.",
        "B = alpha / (alpha + K / M), K_u = K + alpha^2 M; in plane strain the mean stress is 2 (1 + nu_u) / 3 of the load. Largest error "
        "of all particles; the volume strain follows from their sizes.",
        ["mode", "fluid's modulus [Pa]", "permeability [m2]", "B", "measured", "error of the pressure", "error of the volume strain",
         "missing fluid"],
        [],
    )  # fmt: skip
    for mode in modes(barreno):
        fluids = FLUIDS if full or mode != "3D" else (ROCK.fluid,)
        permeabilities = PERMEABILITIES if full or mode == "axisymmetric" else PERMEABILITIES[1:]
        rows = [measure(barreno, mode, fluid, permeability) for fluid in fluids for permeability in permeabilities]
        result.rows += rows
        for column, what, limit in ((-3, "pore pressure", 1e-4), (-2, "volume strain", 1e-4), (-1, "missing fluid", 1e-12)):
            result.demand(f"{mode}: {what}, maximum", max(row[column] for row in rows), limit)
    return result
