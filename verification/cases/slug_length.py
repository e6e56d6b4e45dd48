# SPDX-License-Identifier: BSD-3-Clause
"""What the cells do to the depth of a jet whose slugs are longer or shorter, of the same mass and momentum."""
import os

import numpy as np
from barreno.runs.csv_table import arrays_of, read_csv
from tools.case import Result
from tools.runs import DECKS, run_deck, scratch_folder

DECK, TABLE = "perforation_120us.xml", "jets/tungsten_154.csv"
COLUMNS = ("time", "velocity", "radius", "length", "density")
# Name -> slugs of the table that become one, or parts that one becomes.
JETS = {"two slugs as one": 2.0, "as in the table": 1.0, "halves of slugs": 0.5}
FINE = 4  # cells per radius of the runs that the others are compared with


def slugs():
    """Columns of the shipped table."""
    table = arrays_of(read_csv(DECKS / TABLE))
    return {name: table[name] for name in COLUMNS}


def joined(jet):
    """Neighbours as one slug with their mass and momentum."""
    first, second = ({name: values[i : len(jet["time"]) // 2 * 2 : 2] for name, values in jet.items()} for i in (0, 1))
    mass = [part["density"] * part["radius"] ** 2 * part["length"] for part in (first, second)]
    mean = {name: (mass[0] * first[name] + mass[1] * second[name]) / (mass[0] + mass[1]) for name in ("time", "velocity", "density")}
    length = first["length"] + second["length"]
    radius = np.sqrt((mass[0] + mass[1]) / (mean["density"] * length))
    return {**mean, "radius": radius, "length": length}


def halved(jet):
    """Each slug as two of half its length, a quarter of the way to its neighbours before and after it. They have its mass and momentum."""
    time = jet["time"]
    quarter = 0.25 * np.gradient(time)
    change = np.gradient(jet["velocity"], time) * quarter
    parts = {name: np.repeat(values, 2) for name, values in jet.items()}
    parts["length"] = 0.5 * parts["length"]
    for name, step in (("time", quarter), ("velocity", change)):
        parts[name] += np.stack([-step, step], axis=1).ravel()
    parts["time"] -= min(0.0, parts["time"][0])
    return parts


def mass_of(jet):
    return float(np.sum(jet["density"] * jet["radius"] ** 2 * jet["length"]))


def jet_of(factor):
    return {2.0: joined, 1.0: lambda jet: jet, 0.5: halved}[factor](slugs())


def table_file(name, jet):
    """A table of a jet in a folder that goes when the script ends."""
    path = os.path.join(scratch_folder(), f"{name.replace(' ', '_')}.csv")
    with open(path, "w") as stream:
        stream.write("# units: SI\n" + ",".join(COLUMNS) + "\n")
        stream.writelines(",".join(f"{jet[column][i]:.12g}" for column in COLUMNS) + "\n" for i in range(len(jet["time"])))
    return path


def depth_at(run, time):
    depth = run.table("depth.csv")
    return 1e3 * float(np.interp(time, depth["time"], depth["depth"]))


def settings_of(cells, table, end):
    common = {"Time/End Time": f"{end:g} us", "Output/Field Interval": "0 us", "Output/History Interval": "0.1 us", "Jet/Table": table}
    return {**common, "Grid/Cell Size": "1 mm", "Jet/Cells Per Radius": str(cells), "Step/Subcycles": "4"}


def run(barreno, full):
    end, sizes = (10, (1, 2, FINE)) if full else (2, (1, 2))
    result = Result(
        "Long slugs and short ones",
        "What cells cost of a jet's depth depends on their number in a slug's radius, and hardly on that in its length; `check` says how "
        "much.",
        f"{sizes[-1]} cells per radius. `{DECK}` to {end} us, cells small along the path alone; slugs as in the table, neighbours joined, "
        "and cut in halves, "
        "with the same mass and momentum.",
        ["slugs", "length over radius of the tip", "cells per radius", "cells per length of the tip", "depth [mm]", "error",
            "lowest error that check gives",
         "highest", "processor time [s]"],
        [],
    )  # fmt: skip
    for name, factor in JETS.items():
        jet = jet_of(factor)
        table = table_file(name, jet)
        shape = jet["length"][0] / jet["radius"][0]
        runs = {cells: run_deck(barreno, DECK, settings_of(cells, table, end)) for cells in sizes}
        exact = depth_at(runs[sizes[-1]], 1e-6 * end)
        for cells, one in runs.items():
            said, depth = one.summary["penetration"]["depth_error"], depth_at(one, 1e-6 * end)
            row = [name, shape, cells, cells * shape, depth, depth / exact - 1.0, said.get("low", ""), said.get("high", ""),
                one.summary["cpu_seconds"]]
            result.rows.append(row)
            if cells != sizes[-1] and full:
                outside = max(0.0, said["low"] - row[5], row[5] - said["high"])
                result.demand(f"{name}, {cells} per radius: error beyond the range that check gives", outside, 0.0)
    if full:
        usual = {row[2]: row[5] for row in result.rows if row[0] == "as in the table"}
        change = max(abs(row[5] - usual[row[2]]) for row in result.rows)
        result.demand("change of the error by the length of the slugs, the greatest", change, 0.02)
    result.demand("mass of the joined and halved jets against the table's",
        max(abs(mass_of(jet_of(f)) / mass_of(slugs()) - 1.0) for f in (2.0, 0.5)), 1e-12)
    return result
