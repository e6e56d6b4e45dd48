# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/figures.md: accuracy and cost."""
import json

from tools.case_list import RESULTS, stored
from performance.solver_cost import FAST, read_table
from tools.trade_page import FIDELITIES
from tools.uniform_cells import REFERENCE, TIP, depths as all_depths, interval


def results(name):
    return json.loads((RESULTS / f"{name}.json").read_text())


def rows_of(case):
    """{first column: {column: value}}"""
    data = stored(case)
    return {row[0]: dict(zip(data["columns"], row)) for row in data["rows"]}


def exponent(value):
    return f"{abs(value):.0e}".replace("e-0", "e-")


def with_interval(depth, cells):
    """180 (176 to 187): what was computed, and where the depth lies by the errors that were measured with so many cells per radius."""
    low, high = interval(depth, cells)
    return f"{depth:.0f} ({low:.0f} to {high:.0f})"


LAST = 90  # us, until then the errors of depths were measured


def depth_cells(cells, job, last):
    """Cells of a row: depths with their intervals, and that of 120 us, whose error nobody has measured (None: not kept)."""
    found = [with_interval(job[f"depth at {time} us [mm]"], cells) for time in (50, LAST)]
    return " | ".join([*found, "-" if last is None else f"{last:.0f} (unknown)"])


def largest_error(size):
    """Of the depths with cells of this size everywhere, from 10 us on."""
    found = all_depths()
    errors = [depth / found[REFERENCE, time] - 1.0 for (cells, time), depth in found.items() if cells == size and 10 <= time <= LAST]
    return max(map(abs, errors))


def depths():
    """Depths by the cells in the radius of the jet's tip, and by fidelity."""
    runs, jobs = rows_of("perforation"), rows_of("fidelities")
    lines = [f"| cells | cells per jet radius | depth at 50 us [mm] | depth at {LAST} us [mm] | depth at 120 us [mm] | largest error, 10 "
        f"to {LAST} us | CPU time |",
             "|---|---|---|---|---|---|---|"]  # fmt: skip
    for size in (2.0, 1.0, 0.5):
        run = runs[f"{size} mm"]
        row = depth_cells(TIP / size, run, run["final depth [mm]"])
        lines.append(f"| {size:g} mm everywhere | {TIP / size:g} | {row} | {100.0 * largest_error(size):.1f} % | - |")
    for name in ("fast", "balanced"):
        job = jobs[name]
        row = depth_cells(job["cells per radius"], job, None)
        error, seconds = 100.0 * job["greatest error of the depth"], job["processor time [s]"]
        lines.append(f"| `--fidelity {name}` | {job['cells per radius']:g} along the path | {row} | {error:.1f} % | {seconds:.0f} s |")
    return lines


def figures():
    job, run = results("decks")["perforation_120us.xml"], rows_of("perforation")["perforation_120us.xml, 1 ranks"]
    strong = next(one for one in results("scaling")["strong"] if one["name"].startswith("perforation"))
    notes, rock = read_table()
    point = next(row for row in rock if row["solver"] == FAST and row["knob"] == 1e-2)
    elastic = next(note for note in notes if note.startswith("elastic")).split(": ")[1]
    skipped = job["skipped_particle_steps"] / (job["skipped_particle_steps"] + job["particle_steps"])
    main_job = "perforation_120us.xml to 120 us, one core"
    return [
        "| quantity | condition | figure | measured in |", "|---|---|---|---|",
        f"| CPU time | {main_job} | {job['seconds']:.0f} s | |",
        f"| memory | {main_job} | {1e-6 * job['bytes']:.0f} MB | |",
        f"| particle-steps skipped in dormant tiles | {main_job} | {100 * skipped:.0f} % | |",
        f"| speed of two ranks over one | {strong['name']} | {strong['speedup']:.1f} | [performance](performance.md) |",
        f"| remainder of the mass | {main_job} | {exponent(run['mass'])} | [perforation](verification/perforation.md) |",
        f"| remainder of the axial momentum | {main_job} | {exponent(run['axial momentum'])} | [perforation](verification/perforation.md) "
        "|",
        f"| remainder of the energy ledger | {main_job} | {exponent(run['energy ledger'])} | [perforation](verification/perforation.md) |",
        f"| stress update of a rock point | yielding | {1e-3 * point['ns_lanes']:.2g} us | [cost of Arenisca](materials/arenisca_cost.md) "
        "|",
        f"| stress update of a rock point | elastic | {elastic} | [cost of Arenisca](materials/arenisca_cost.md) |",
    ]  # fmt: skip


# Problems of the trade, and the level that the page shows.
SHOWN = (("box", 32, "manufactured motion, 32 cells"), ("shell", 16, "coasting shell, 16 cells in the wall"),
         ("shock", 0.5, "shock, pressures, 0.5 mm cells"), ("depth", 1.0, "depth of a perforation after 20 us, 1 mm cells"))  # fmt: skip


def fidelities():
    data = results("trade")
    at = {(p["problem"], p["name"], p["level"]): p for p in data["points"] if "error" in p}
    lines = ["| fidelity | " + " | ".join(words for _, _, words in SHOWN) + " |", "|---|" + "---|" * len(SHOWN)]
    for name in FIDELITIES:
        errors = [f"{100 * at[problem, name, level]['error']:.2g} %" for problem, level, _ in SHOWN]
        lines.append(f"| {name} ({data['chosen'][name][0]['Shape Function']}) | " + " | ".join(errors) + " |")
    steps = [at[problem, "fast", level]["work"] / at[problem, "balanced", level]["work"] for problem, level, _ in SHOWN]
    return [*lines, "", f"*fast* takes {min(steps):.2f} to {max(steps):.2f} of the particle-steps of *balanced*."]
