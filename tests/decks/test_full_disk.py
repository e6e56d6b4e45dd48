#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A disk that takes no more before the last checkpoint: the run ends with one sentence and exit code 2, never with a signal.

    test_full_disk.py BARRENO
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECK = ROOT / "input_xml" / "perforation_quick.xml"
SOURCE = ROOT / "verification" / "tools" / "full_disk.c"
SHORT = ("--set", "Time/End Time=2 us", "--set", "Grid/Cell Size=10 mm", "--set", "Output/Field Interval=0 us", "--set",
    "Output/History Interval=2 us")
FINISHED, FILE = 0, 2


def run(barreno, folder, **variables):
    environment = dict(os.environ, BARRENO_FULL_FOLDER=str(folder), **variables)
    return subprocess.run([barreno, "run", DECK, *SHORT, "--out", folder], env=environment, capture_output=True, text=True, timeout=120)


def main():
    barreno = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch).resolve()
        library = scratch / "full_disk.so"
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, SOURCE, "-ldl"], check=True)
        count = scratch / "count"
        whole = run(barreno, scratch / "whole", LD_PRELOAD=str(library), BARRENO_FULL_CALL="1000000000", BARRENO_FULL_COUNT=str(count))
        assert whole.returncode == FINISHED, whole.stderr
        calls, lost = int(count.read_text()), 0
        # The last calls write run.log and the summary, each for itself.
        tried = sorted({*range(calls // 2, calls, 4), *range(max(0, calls - 10), calls + 1)})
        for call, once in [(call, once) for call in tried for once in ({}, {"BARRENO_FULL_ONCE": "1"})]:
            ended = run(barreno, scratch / f"at_{call}_{len(once)}", LD_PRELOAD=str(library), BARRENO_FULL_CALL=str(call), **once)
            assert ended.returncode in (FINISHED, FILE), (call, once, ended.returncode, ended.stderr[-800:])
            errors = [line for line in ended.stderr.splitlines() if line.startswith("barreno: ")]
            assert len(errors) == (ended.returncode == FILE), (call, once, ended.stderr)
            assert ended.returncode == FINISHED or "Finished" not in ended.stdout, (call, once, ended.stdout[-800:])
            if "last checkpoint is lost" in ended.stderr:
                lost += 1
                assert "Finished" not in ended.stdout and ended.returncode == FILE, (call, once, ended.stdout[-800:])
        # Else nothing was said of the last checkpoint.
        assert lost >= 3, (lost, calls)
        print(f"{lost} last checkpoints of {calls} writes were lost with a sentence each")


if __name__ == "__main__":
    main()
