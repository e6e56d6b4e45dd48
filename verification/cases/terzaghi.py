# SPDX-License-Identifier: BSD-3-Clause
"""Terzaghi's column: pressure in all heights and settlement against the series, in mesh and in time between solves."""
import numpy as np
from tools.case import Result
from tools.choices import modes, shape_functions
from tools.columns import DIFFUSIVITY, HEIGHT, LOAD, RAMP, ROCK, SLOWER, column_run, diffusion_number, exact, state_of
from tools.runs import missing_fluid, order

TIMES = [0.05 * k for k in range(1, 11)]  # c t / height^2
RAMP_T = RAMP * DIFFUSIVITY / SLOWER / HEIGHT**2
STEP, SOLVE_STEPS, SOLVES_H = 5e-6, (4000, 2000, 1000), 0.05  # s; between solves


def rms(x):
    return float(np.sqrt(np.mean(np.square(x))))


def settlement(T):
    """Undrained at first; the rest as the pores drain."""
    soft, stiff = 1.0 / ROCK.confined, 1.0 / ROCK.undrained_confined
    load = min(T / RAMP_T, 1.0)
    return LOAD * HEIGHT * (load * stiff + (soft - stiff) * exact.terzaghi_settled(T, RAMP_T))


def errors_of(run):
    """Over all instants: largest and rms error of pressure over that after the load; settlement over the final one."""
    worst, middle, settled = 0.0, [], 0.0
    for instant in range(1, run.instants()):
        T, depth, pressure, settles = state_of(run, instant)
        error = pressure - exact.terzaghi_ramped(depth, T, RAMP_T)
        worst = max(worst, float(np.max(np.abs(error))))
        middle.append(rms(error))
        settled = max(settled, abs(settles - settlement(T)) / (LOAD * HEIGHT / ROCK.confined))
    return worst, max(middle), settled, missing_fluid(run)


def refine(barreno, mode, shape, cells, result):
    """Rows of one mode and shape function; errors of each mesh."""
    found = []
    for h in cells:
        found.append(errors_of(column_run(barreno, mode, h, TIMES, more={"Step/Shape Function": shape})))
        rates = [order([found[-2][k], found[-1][k]])[0] if len(found) > 1 else float("nan") for k in (1, 2)]
        worst, middle, settled, _ = found[-1]
        result.rows.append([mode, shape, h, "1", worst, middle, rates[0], settled, rates[1]])
    return found


def between_solves(barreno, result):
    """Error against the same mesh with eight times as many solves as the shortest: backward Euler is of first order."""
    states = []
    for steps in SOLVE_STEPS + (SOLVE_STEPS[-1] // 8,):
        number = diffusion_number(steps, STEP, SOLVES_H, SLOWER)
        # The first step is solved by itself; the last solve falls on the last step for each of them.
        end = (1 + 4 * SOLVE_STEPS[0]) * STEP
        more = {"Pore Flow/Diffusion Number": repr(number), "Step/Largest Step": repr(STEP), "Step/Initial Step": repr(STEP),
                "Time/End Time": repr(end), "Output/Field Interval": "0"}  # fmt: skip
        states.append(state_of(column_run(barreno, "plane strain", SOLVES_H, TIMES, more=more), -1))
    T = states[0][0]
    final = LOAD * HEIGHT / ROCK.confined
    found = [(rms(s[2] - states[-1][2]), abs(s[3] - states[-1][3]) / final) for s in states[:-1]]
    for i, (steps, (pressure, settled)) in enumerate(zip(SOLVE_STEPS, found)):
        rates = [order([found[i - 1][k], found[i][k]])[0] if i else float("nan") for k in (0, 1)]
        exact_error = states[i][2] - exact.terzaghi_ramped(states[i][1], T, RAMP_T)
        each = f"c dt / height^2 = {steps * STEP * DIFFUSIVITY / SLOWER / HEIGHT**2:.3g}"
        result.rows.append(["plane strain", "GIMP", SOLVES_H, each, float(np.max(np.abs(exact_error))), pressure, rates[0],
            settled, rates[1]])
    rates = [order([found[-2][k], found[-1][k]])[0] for k in (0, 1)]
    result.demand("order in the time between solves, pressure", rates[0], 0.85, at_least=True)
    result.demand("order in the time between solves, settlement", rates[1], 0.85, at_least=True)


def run(barreno, full):
    result = Result(
        "Terzaghi's column",
        "Pore flow, and rock that takes over the load from the fluid: pressure and settlement in time.",
        "the series solution of heat conduction, with the load ramp by superposition. Pressures relative to that just after loading, "
        "settlement relative to the final one; the largest of the instants c t / height^2 = 0.05, 0.1 ... 0.5. Where c dt / height^2 is "
        "given: rms and settlement compared with many solves on the same mesh, at one time.",
        ["mode", "shape function", "cell over height", "Diffusion Number", "worst particle", "rms", "order", "settlement", "order"],
        [],
    )
    cells = (0.1, 0.05, 0.025) if full else (0.1, 0.05)
    balances = []
    for mode in modes(barreno) if full else ("plane strain",):
        for shape in shape_functions(barreno) if full and mode == "plane strain" else ("GIMP",):
            levels = cells[:2] if mode == "3D" else cells
            found = refine(barreno, mode, shape, levels, result)
            balances += [errors[-1] for errors in found]
            where = f"{mode}, {shape}, {levels[-1]} m"
            worst, _, settled, _ = found[-1]
            result.demand(f"{where}: largest pressure error", worst, 1e-2 if levels[-1] < 0.05 else 1.5e-2)
            result.demand(f"{where}: settlement", settled, 1e-2)
            rates = order([found[0][1], found[-1][1]], 2.0 ** (len(found) - 1))
            result.demand(f"{where}: mean order of the pressure in the mesh", rates[0], 1.5, at_least=True)
    result.demand("fluid balance, maximum", max(balances), 1e-12)
    between_solves(barreno, result)
    return result
