#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checkpoints with a right seal and impossible values: test_forged_checkpoints.py BARRENO [--every N]. Each is refused in one sentence that
names the table, before any file is touched. And damaged or half-named files: what is whole is taken, and nothing is lost."""
import pathlib
import shutil
import sys
import tempfile
import zlib

import h5py
import numpy as np

from tools.resumed import at_previous, different_fields, different_files, must_work, program
from tools.runs import DECKS

WORDS = ("--set", "Time/End Time=4 us", "--set", "Grid/Cell Size=5 mm", "--set", "Output/Field Interval=2 us", "--set",
    "Output/Checkpoint Steps=7")
USER_BLOCK = 512
NAN = float("nan")


def seal(file):
    data = bytearray(file.read_bytes())
    text = f"barreno checkpoint\nbytes {len(data) - USER_BLOCK}\ncrc32 {zlib.crc32(data[USER_BLOCK:]):08x}\n".encode()
    data[:USER_BLOCK] = text.ljust(USER_BLOCK, b"\0")
    file.write_bytes(data)


def put(name, value, row=0):
    def change(h5):
        table = h5[name]
        values = table[...]
        values[row, 0] = value
        table[...] = values

    return name, change


def replace(name, values):
    def change(h5):
        del h5[name]
        h5.create_dataset(name, data=values)

    return name, change


def remove(name):
    return name, lambda h5: h5.__delitem__(name)


def all_kinds(h5, jet):
    """(table, change) for every table of the file: missing, cut, of another kind, and with values that cannot be."""
    names = []
    h5.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
    for name in names:
        if name in ("deck", "run/version"):
            continue
        yield remove(name)
        size = h5[name].shape
        if size[0] > 0:
            yield replace(name, h5[name][...][:-1])
            yield replace(name, np.hstack([h5[name][...], h5[name][...]]))
            whole = np.issubdtype(h5[name].dtype, np.integer)
            yield put(name, -(2**62) if whole else NAN)
    yield put("grid/owner", 77)
    yield put("grid/owner", -1)
    yield put("run/ranks", 1e9)
    yield put("run/time", -1e-6)
    yield put("run/step", 0.5)
    yield put("run/next_slug", 1e6)
    yield put("run/stable_step", 0.0)
    for name in ("mass", "volume", "half_size"):
        yield put(f"particles/{jet}/{name}", -1.0)
        yield put(f"particles/{jet}/{name}", float("inf"))
    yield put(f"particles/{jet}/half_size", 0.1)  # many cells
    yield replace(f"particles/{jet}/stress", h5[f"particles/{jet}/stress"][...].astype(np.float32))
    yield put(f"particles/{jet}/position", 1e9)
    yield put(f"particles/{jet}/id", 2**62)
    yield put(f"particles/{jet}/id", int(h5[f"particles/{jet}/id"][1, 0]))  # twice
    yield put(f"particles/{jet}/body", 99)
    yield put(f"particles/{jet}/removal", 9)
    yield put(f"particles/{jet}/rank_counts", 10**9)
    yield replace(f"particles/{jet}/rank_counts", np.zeros((0, 1), np.int64))
    yield replace("ledger/terms", np.zeros((3, 2), np.int64))
    yield put("ledger/terms", 2**62)
    yield put("output/history_bytes", 10.0)
    yield put("output/fields_kept", 1e12)


def check_forged(barreno, folder, plain, every):
    """Every table is validated: nothing forged crashes, hangs or is taken."""
    run = folder / "forged"
    shutil.copytree(plain, run)
    (run / "summary.json").unlink()  # as if it had been killed before its last words
    good = (run / "checkpoint.h5").read_bytes()
    before = {file.name: file.read_bytes() for file in run.iterdir()}
    with h5py.File(plain / "checkpoint.h5", "r") as h5:
        kinds = list(all_kinds(h5, max(h5["particles"])))[::every]
    for table, change in kinds:
        file = run / "checkpoint.h5"
        file.write_bytes(good)
        with h5py.File(file, "r+") as h5:
            change(h5)
        seal(file)
        forged = file.read_bytes()
        result = program(barreno, 1, "resume", run)
        said = result.stderr.strip()
        group = table.split("/")[0]
        assert result.returncode == 2, f"{table}: exit {result.returncode}: {said}"
        assert said.count("\n") == 0 and group in said, f"{table}: {said}"
        assert file.read_bytes() == forged, table
        for name, data in before.items():
            assert name == file.name or (run / name).read_bytes() == data, f"{table}: {name} was changed"
    return len(kinds)


def check_set_aside(barreno, folder, plain):
    """A damaged checkpoint.h5 is kept under another name and does not replace the good one before it."""
    run = folder / "set_aside"
    shutil.copytree(plain, run)
    (run / "summary.json").unlink()
    data = bytearray((run / "checkpoint.h5").read_bytes())
    data[len(data) // 2] ^= 1
    (run / "checkpoint.h5").write_bytes(data)
    must_work(program(barreno, 1, "resume", run))
    assert (run / "checkpoint_damaged.h5").read_bytes() == bytes(data)
    assert "checkpoint_damaged.h5" in (run / "run.log").read_text()
    assert not different_fields(plain, run) and not different_files(plain, run)


def check_sealed_aside(barreno, folder, plain):
    """A checkpoint that was sealed but not named yet is the newest one; one that was not sealed is no news."""
    run = at_previous(pathlib.Path(shutil.copytree(plain, folder / "sealed_aside")))
    shutil.copy(plain / "checkpoint.h5", run / "checkpoint.h5.tmp")
    must_work(program(barreno, 1, "resume", run))
    assert "resumed from checkpoint.h5.tmp" in (run / "run.log").read_text()
    assert not (run / "checkpoint.h5.tmp").exists() and not different_files(plain, run)
    cut = at_previous(pathlib.Path(shutil.copytree(plain, folder / "cut_aside")))
    (cut / "checkpoint.h5.tmp").write_bytes((plain / "checkpoint.h5").read_bytes()[:5000])
    must_work(program(barreno, 1, "resume", cut))
    assert "resumed from checkpoint.h5:" in (cut / "run.log").read_text() and not different_files(plain, cut)


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plain = folder / "plain"
        must_work(program(barreno, 1, "run", str(DECKS / "perforation_quick.xml"), "--out", plain, *WORDS))
        every = int(sys.argv[3]) if sys.argv[2:3] == ["--every"] else 1
        print("check_forged holds for", check_forged(barreno, folder, plain, every), "files")
        for check in (check_set_aside, check_sealed_aside):
            check(barreno, folder, plain)
            print(check.__name__, "holds")


if __name__ == "__main__":
    main()
