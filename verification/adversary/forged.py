# SPDX-License-Identifier: BSD-3-Clause
"""Checkpoints whose seal is right and one of whose fields is not: each is refused with a sentence, or changes nothing.

A single value that a state may have gives another state, which no check can know; what no state can have, not a number
and a table of another form above all, must be refused."""
import shutil

import h5py
import numpy as np
from adversary.one_set import FILE, FINISHED, NUMERICAL, REFUSED, Finding, must_end, sentence_of
from adversary.same_runs import different, unsound
from adversary.sealed import reseal

# Jet, confinement and torn faces; pore flow; a rigid body; a cavity.
SCENES = (
    ("perforation_quick.xml", {"Grid/Cell Size": "10 mm", "Time/End Time": "10 us", "Output/Checkpoint Steps": "20",
        "Output/Field Interval": "3 us"}),
    ("terzaghi.xml", {"Time/End Time": "1 ms", "Output/Checkpoint Steps": "30"}),
    ("rigid_plate.xml", {"Grid/Cell Size": "1 mm", "Time/End Time": "3 us", "Output/Checkpoint Steps": "5",
        "Output/History Interval": "1 us"}),
    ("shell_squeezed.xml", {"Grid/Cell Size": "3 mm", "Time/End Time": "10 us", "Output/Checkpoint Steps": "5"}),
)
NUMBERS = {
    "nan": np.nan, "inf": np.inf, "-inf": -np.inf, "-1": -1.0, "77": 77.0, "2^31": 2.0**31, "2^63": 2.0**63, "1e300": 1e300,
    "denormal": 5e-324, "-0": -0.0, "0": 0.0,
}
WHOLE = {"-1": -1, "77": 77, "0": 0, "2^31": 2**31, "2^63-1": 2**63 - 1, "-2^63": -(2**63)}
IMPOSSIBLE = {"nan", "inf", "-inf"}
FORMS = ("no rows", "a row less", "a row more", "a column more", "other type", "missing", "a group")


def tables_of(path):
    tables = {}
    with h5py.File(path, "r") as file:
        file.visititems(lambda name, item: tables.update({name: (item.shape, item.dtype)}) if isinstance(item, h5py.Dataset) else None)
    return tables


def forgeries_of(path):
    """All (table, what is done to it, where) of a checkpoint."""
    found = []
    for name, (shape, kind) in tables_of(path).items():
        values = NUMBERS if kind.kind == "f" else WHOLE
        found += [(name, value, place) for value in values for place in ("one", "all") if np.prod(shape) > 0]
        found += [(name, form, "") for form in FORMS]
    return found


def another_form(form, values):
    if form == "no rows":
        return values[:0]
    if form == "a row less":
        return values[:-1]
    if form == "a row more":
        return np.concatenate([values, values[-1:]]) if len(values) else np.zeros((1, *values.shape[1:]), values.dtype)
    if form == "a column more":
        return np.concatenate([values, values[:, :1]], axis=1)
    return values.astype("S8" if values.dtype.kind == "i" and values.dtype.itemsize == 1 else "f4")


def forge(path, forgery, rng):
    name, what, place = forgery
    with h5py.File(path, "r+") as file:
        table = file[name]
        values = table[()]
        if what in FORMS:
            unit = dict(table.attrs)
            del file[name]
            if what == "a group":
                file.create_group(name)
            elif what != "missing":
                changed = another_form(what, values)
                new = file.create_dataset(name, data=changed, chunks=changed.shape or None,
                    fletcher32=True) if changed.size else file.create_dataset(name, data=changed)
                for key, value in unit.items():
                    new.attrs[key] = value
        else:
            new = (NUMBERS if values.dtype.kind == "f" else WHOLE)[what]
            if values.dtype.itemsize == 1:
                new = np.int64(new).astype(values.dtype)
            if place == "all":
                values[...] = new
            else:
                values.reshape(-1)[int(rng.integers(values.size))] = new
            table[...] = values
    reseal(path)


def prepared(barreno, deck, settings, folder):
    """A run in the middle of which there is one checkpoint, and the same run to its end."""
    straight = folder / "straight"
    must_end(barreno.run("run", deck, "--out", straight, *settings), FINISHED)
    middle = shutil.copytree(straight, folder / "middle")
    (middle / "checkpoint_previous.h5").replace(middle / "checkpoint.h5")
    (middle / "summary.json").unlink()
    resumed = shutil.copytree(middle, folder / "resumed")
    must_end(barreno.run("resume", resumed), FINISHED)
    wrong = different(straight, resumed)
    if wrong:
        raise Finding(f"resumed from what is to be forged, it differs: {wrong}")
    return straight, middle


def try_forgery(barreno, straight, middle, folder, forgery, rng):
    """@return what came of it. @raises Finding"""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(middle, folder)
    forge(folder / "checkpoint.h5", forgery, rng)
    ended = barreno.run("resume", folder, limit=20)
    name, what, _ = forgery
    if must_end(ended, FINISHED, REFUSED, FILE, NUMERICAL) in (REFUSED, FILE):
        sentence = sentence_of(ended)
        last = name.rpartition("/")[2]
        # Where two disagree, either may be named: a file of the run that is shorter than its length here, counts against rows.
        if not any(word in sentence for word in (last, ".csv", "particles.e", "rank_counts")):
            raise Finding(f"the refusal does not name it: {sentence}")
        return "refused"
    if ended.code == NUMERICAL:
        if what in IMPOSSIBLE or what in FORMS:
            raise Finding(f"not refused; the run failed: {ended.out.strip().splitlines()[-3:]}")
        return "stopped with a reason"
    wrong = different(straight, folder)
    if not wrong:
        return "the same run"
    if what in IMPOSSIBLE or what in FORMS:
        raise Finding(f"not refused, and the run is another one: {'; '.join(wrong[:4])}")
    # The balances say that mass or a ledger is another one.
    wrong = [] if name.startswith("ledger/") else [what for what in unsound(folder) if "mass balance" not in what]
    if wrong:
        raise Finding(f"not refused, and what came of it is {'; '.join(wrong[:4])}")
    return "another state"
