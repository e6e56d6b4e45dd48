#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What checkpoints cost: checkpoint_cost.py BARRENO [--ranks N] [--quick] [--document].

Runs the block of scaling_decks.py with a checkpoint every few steps. Writing (HDF5 and rows, then seal, fsync and rename) and
reading back are timers of the code, `write_checkpoint` less `read_checkpoint_back`, and the latter. The disk's own bandwidth is that of as
many bytes written to a new file in the same folder and brought to the disk (fsync) by one process, right after the run: like a checkpoint
they go through the system's memory, and the time ends when the disk has them. A part of a checkpoint may reach the disk while it is read
back, so both together are compared with the disk too. --document writes docs/performance.md.
"""
import argparse
import json
import os
import pathlib
import sys
import time

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from performance import scaling_decks

from tools.resumed import must_work, program  # noqa: I001
from tools.runs import ROOT, Run, scratch_folder
from tools.write_pages import write_pages

STORED = ROOT / "verification" / "results" / "checkpoint_cost.json"

DEFAULT_INTERVAL = 600.0  # Checkpoint Wall Interval [s]
LEAST_BANDWIDTH, MOST_SHARE = 0.5, 0.02


def raw_seconds(folder, size):
    """Of writing so many bytes in pieces of 8 MB, fsync included."""
    piece = os.urandom(1 << 23)
    name = folder / "raw"
    begin = time.monotonic()
    with open(name, "wb", buffering=0) as stream:
        for left in range(size, 0, -len(piece)):
            stream.write(piece[:left])
        os.fsync(stream.fileno())
    seconds = time.monotonic() - begin
    name.unlink()
    return seconds


def measure(barreno, ranks, quick):
    scratch = pathlib.Path(scratch_folder())
    problem = scaling_decks.block(scratch, (16, 32, 16) if quick else (32, 64, 32), 30)
    folder = scratch / "run"
    must_work(program(barreno, ranks, "run", problem.deck, "--out", folder, "--set", f"Time/End Time={problem.end}",
                      "--set", f"Output/Field Interval={problem.end}", "--set", "Output/Checkpoint Steps=5",
                      environment={"OMPI_MCA_mpi_yield_when_idle": "0"}))  # fmt: skip
    size = (folder / "checkpoint.h5").stat().st_size
    phases = Run(folder).summary["phases"]
    writes = phases["write_checkpoint"]["calls"]
    verify = phases["read_checkpoint_back"]["largest_rank_seconds"] / writes
    write = phases["write_checkpoint"]["largest_rank_seconds"] / writes - verify
    raw = sorted(raw_seconds(folder, size) for _ in range(5))[2]
    return {"particles": Run(folder).summary["particles"], "bytes": size, "writes": writes, "write": write, "verify": verify, "raw": raw}


def stored_part():
    found = json.loads(STORED.read_text())
    return page(found, found["ranks"])


def page(found, ranks):
    size = 1e-6 * found["bytes"]
    both = found["write"] + found["verify"]
    return [
        f"{found['particles']:,.0f} particles in three dimensions on {ranks} rank{'s' if ranks > 1 else ''}, {size:.0f} MB "
        f"({found['bytes'] / found['particles']:.0f} bytes per particle), "
        f"mean of {found['writes']:.0f} checkpoints.", "",
        "| part | what | seconds | MB/s | relative to the disk | required |", "|---|---|---|---|---|---|",
        f"| the disk | the same number of bytes, fsync included (median of 5) | {found['raw']:.2f} | {size / found['raw']:.0f} | 1 | |",
        f"| write | lay out, rows by every rank, seal, fsync, rename | {found['write']:.2f} | {size / found['write']:.0f} | "
        f"{found['raw'] / found['write']:.2f} | {LEAST_BANDWIDTH} |",
        f"| verify | read back, compare the CRC-32 of each piece | {found['verify']:.2f} | {size / found['verify']:.0f} | | |",
        f"| both | write and verify | {both:.2f} | {size / both:.0f} | {found['raw'] / both:.2f} | |", "",
        f"Both take {100 * both / DEFAULT_INTERVAL:.2f} % of the {DEFAULT_INTERVAL:.0f} s between two checkpoints by default; at most "
        f"{100 * MOST_SHARE:.0f} % are allowed.",
    ]  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--quick", action="store_true", help="a smaller state: whether it works")
    parser.add_argument("--document", action="store_true")
    arguments = parser.parse_args()
    found = measure(pathlib.Path(arguments.barreno).resolve(), arguments.ranks, arguments.quick)
    lines = page(found, arguments.ranks)
    print("\n".join(lines))
    if arguments.document:
        STORED.write_text(json.dumps({"ranks": arguments.ranks, **found}, indent=1) + "\n")
        write_pages()
    slow = found["raw"] / found["write"] < LEAST_BANDWIDTH
    long = found["write"] + found["verify"] > MOST_SHARE * DEFAULT_INTERVAL
    wrong = [text for text, bad in (("writing is slower than half the disk", slow), ("checkpoints take too long", long)) if bad]
    sys.exit("; ".join(wrong) if wrong and not arguments.quick else 0)


if __name__ == "__main__":
    main()
