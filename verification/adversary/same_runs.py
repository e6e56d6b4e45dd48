# SPDX-License-Identifier: BSD-3-Clause
"""Whether two run folders hold the same result: every file, to the bit or to a tolerance."""
import json
import pathlib

import h5py
import numpy as np
from barreno.runs.csv_table import read_csv

from tools.resumed import different_fields, different_sums

NUMERICAL_ERRORS = "numerical errors above 10 % of the energy"
TABLES = ("history.csv", "depth.csv", "radii.csv", "cavities.csv")
# Of a checkpoint: who had what, and how the work was shared, which follows measured times.
OF_THE_RANKS = ("run/ranks", "grid/owner", "rank_counts", "output/fields_files")
# Particles that rested in one run may be stepped over in another, with the same answer; seconds are those of the clock.
OF_THE_WORK = ("ledger/particle_steps", "ledger/step_shares", "output/seconds")


def numbers_of(file):
    return read_csv(file).to_numpy(float)


def far(a, b, tolerance):
    """Whether two arrays differ by more than the tolerance, times the largest value of a."""
    if a.shape != b.shape:
        return True
    if tolerance == 0.0:
        return not np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    size = np.max(np.abs(a), initial=0.0)
    return not np.all(np.abs(a - b) <= tolerance * size + 1e-300)


def different_tables(one, other, tolerance):
    wrong = []
    for name in TABLES:
        a, b = one / name, other / name
        if a.exists() != b.exists():
            wrong.append(f"{name} is in one only")
        elif not a.exists():
            continue
        elif tolerance == 0.0 and a.read_bytes() != b.read_bytes():
            wrong.append(name)
        elif tolerance > 0.0:
            rows = numbers_of(a), numbers_of(b)
            if rows[0].shape != rows[1].shape:
                wrong.append(f"{name} has other rows")
    return wrong


def contents(path):
    """Tables of a checkpoint by their path; those of particles by ascending id."""
    tables = {}
    with h5py.File(path, "r") as file:
        file.visititems(lambda name, item: tables.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    for group in {name.rpartition("/")[0] for name in tables if name.endswith("/id")}:
        order = np.argsort(tables[f"{group}/id"].ravel(), kind="stable")
        for name in [name for name in tables if name.startswith(group + "/") and not name.endswith("rank_counts")]:
            tables[name] = tables[name][order]
    return {name: table for name, table in tables.items() if name not in OF_THE_WORK and not name.endswith(OF_THE_RANKS)}


def different_checkpoints(one, other, tolerance):
    if not (one / "checkpoint.h5").exists() or not (other / "checkpoint.h5").exists():
        return ["checkpoint.h5 is not in both"]
    a, b = contents(one / "checkpoint.h5"), contents(other / "checkpoint.h5")
    wrong = sorted(set(a) ^ set(b))
    for name in sorted(set(a) & set(b)):
        if isinstance(a[name], bytes) or a[name].dtype.kind not in "fiu":
            if a[name] != b[name]:
                wrong.append(name)
        elif far(np.asarray(a[name]), np.asarray(b[name]),
                tolerance if a[name].dtype.kind == "f" and name.startswith("particles/") else 0.0):
            if tolerance == 0.0 or name.startswith("particles/"):
                wrong.append(name)
    return [f"checkpoint.h5: {name}" for name in wrong]


def different(one, other, tolerance=0.0, same_ranks=True):
    """What is not the same in two run folders, as words; empty: they are the same run."""
    one, other = pathlib.Path(one), pathlib.Path(other)
    wrong = different_tables(one, other, tolerance) + different_checkpoints(one, other, tolerance)
    if tolerance == 0.0:
        wrong += [f"summary.json: {name}" for name in different_sums(one, other)]
        if (one / "particles.e").exists() and (other / "particles.e").exists():
            wrong += [f"particles.e: {name}" for name in different_fields(one, other)]
        elif same_ranks:
            wrong.append("particles.e is not in both")
    return wrong


def unwarned(summary):
    """Numerical errors above a tenth of the energy that nobody is told of."""
    energy = summary["balances"]["energy"]
    shares = {name: energy.get(f"{name}_share") or 0.0 for name in ("stress_integration", "transfer")}
    if NUMERICAL_ERRORS in summary.get("warnings", {}):
        return []
    return [f"summary.json: {name} is {share:+.0%} of the energy put in, without a warning"
        for name, share in shares.items() if abs(share) > 0.1]


def unsound(folder):
    """Numbers of a run that no run may give."""
    wrong = []
    for name in TABLES:
        file = folder / name
        if not file.exists():
            continue
        values = numbers_of(file)
        wrong += [f"{name} holds {word}" for word, found in (("nan", np.isnan(values)), ("inf", np.isinf(values))) if found.any()]
    summary = json.loads((folder / "summary.json").read_text(), parse_constant=lambda word: wrong.append(f"summary.json holds {word}"))
    error = summary["balances"]["mass"]["error"]
    if error is None or not abs(error) <= 1e-12:
        wrong.append(f"summary.json: the mass balance is off by {error}")
    wrong += unwarned(summary)
    with h5py.File(folder / "checkpoint.h5", "r") as file:
        tables = []
        file.visititems(lambda name, item: tables.append(item) if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" else None)
        # Without a particle any step is stable.
        wrong += [f"checkpoint.h5: {t.name} has values that are not finite" for t in tables if t.name != "/run/stable_step"
            and not np.all(np.isfinite(t[()]))]
    return wrong
