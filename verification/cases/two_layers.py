# SPDX-License-Identifier: BSD-3-Clause
"""Terzaghi's column of two layers whose permeabilities differ ten times; the jump in a face of the grid, and inside a cell."""
import numpy as np
from tools.case import Result
from tools.columns import HEIGHT, LOAD, RAMP, ROCK, VISCOSITY, column_settings, exact, permeability, state_of
from tools.runs import order, run_deck

FAST, SLOW = 10.0, 1.0  # diffusivities, m2/s
LAYERS = {"tight above": (SLOW, FAST), "tight below": (FAST, SLOW)}
TIMES = [0.01 * k for k in range(1, 11)]  # s
CARD = {"Model": "Poroelastic", "Density": "2300 kg/m3", "Bulk Modulus": ROCK.bulk, "Shear Modulus": ROCK.shear,
        "Grain Bulk Modulus": ROCK.grains, "Porosity": ROCK.porosity, "Fluid Bulk Modulus": ROCK.fluid}  # fmt: skip


def settings_of(h, split, top, bottom):
    """The deck's column is the lower layer; a lid of a rock of its own lies on it."""
    settings = column_settings("plane strain", h, slower=10.0 / bottom)
    corner = settings["Bodies/Column/Upper"].split(",")[0]
    settings.update({f"Materials/Lid/{name}": value if isinstance(value, str) else repr(value) for name, value in CARD.items()})
    settings.update({
        "Bodies/Column/Upper": f"{corner}, {HEIGHT - split!r} m}}",
        "Bodies/Lid/Material": "Lid",
        "Bodies/Lid/Lower": f"{{0 m, {HEIGHT - split!r} m}}",
        "Bodies/Lid/Upper": f"{corner}, {HEIGHT!r} m}}",
        "Loads/Piston/Body": "Lid",
        "Pore Flow/Rocks/Lid/Permeability": f"{{{permeability(10.0 / top)!r} m2}}",
        # At the default interval between solves, the error of the coarse meshes depends on where the solves fall within the ramp.
        "Pore Flow/Diffusion Number": "0.5",
        "Time/End Time": repr(TIMES[-1]),
        "Output/Field Interval": repr(TIMES[0]),
    })  # fmt: skip
    return settings


def settlement(layers, t):
    soft, stiff, load = 1.0 / ROCK.confined, 1.0 / ROCK.undrained_confined, min(t / RAMP, 1.0)
    return LOAD * HEIGHT * (load * soft - (soft - stiff) * layers.mean(t, RAMP))


def errors_of(run, layers):
    worst, middle, settled = 0.0, 0.0, 0.0
    for instant in range(1, run.instants()):
        t, depth, pressure, settles = state_of(run, instant, slower=10.0)
        error = pressure - layers.pressure(depth, t, RAMP)
        worst = max(worst, float(np.max(np.abs(error))))
        middle = max(middle, float(np.sqrt(np.mean(error**2))))
        settled = max(settled, abs(settles - settlement(layers, t)) / (LOAD * HEIGHT / ROCK.confined))
    return worst, middle, settled


def run(barreno, full):
    result = Result(
        "Two layers that drain",
        "Flow through a jump of permeability inside the rock.",
        "eigenfunctions of both layers, checked against a finite difference solution. Pressures relative to that just after loading, "
        "settlement relative to the final one, the largest of ten instants.",
        ["layers", "jump", "cell over height", "worst particle", "rms", "order", "settlement", "order"],
        [],
    )
    levels = (0.1, 0.05, 0.025) if full else (0.1, 0.05)
    for name, (top, bottom) in LAYERS.items():
        for jump in ("in a face", "inside a cell") if full else ("in a face",):
            found = []
            for h in levels:
                split = 0.5 if jump == "in a face" else 0.5 + 0.5 * h
                layers = exact.Layers(split, top, bottom)
                found.append(errors_of(run_deck(barreno, "terzaghi.xml", settings_of(h, split, top, bottom)), layers))
                rates = [order([found[-2][k], found[-1][k]])[0] if len(found) > 1 else float("nan") for k in (1, 2)]
                worst, middle, settled = found[-1]
                result.rows.append([name, jump, h, worst, middle, rates[0], settled, rates[1]])
            where = f"{name}, jump {jump}, {levels[-1]} m"
            result.demand(f"{where}: largest pressure error", worst, 1e-2 if full else 1.5e-2)
            result.demand(f"{where}: settlement", settled, 1e-2)
            rates = order([found[0][1], found[-1][1]], 2.0 ** (len(found) - 1))
            result.demand(f"{where}: mean order of the pressure", rates[0], 1.5 if jump == "in a face" else 0.8, at_least=True)
    return result
