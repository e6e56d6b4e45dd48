#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The preset gpu with a path that holds no Trilinos ends with a sentence, and configures no build for processors.

    test_device_preset.py CMAKE
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    with tempfile.TemporaryDirectory() as scratch:
        wrong = pathlib.Path(scratch) / "no Trilinos"
        result = subprocess.run(
            [sys.argv[1], "--preset", "gpu", "-B", f"{scratch}/build"], cwd=ROOT, env={**os.environ, "BARRENO_DEVICE_TRILINOS": str(wrong)},
            capture_output=True, text=True, timeout=120, check=False)  # fmt: skip
        said = " ".join(result.stderr.split())
        assert result.returncode != 0 and f"names '{wrong}', which holds no TrilinosConfig.cmake" in said, result.stdout + result.stderr
        assert not (pathlib.Path(scratch) / "build" / "build.ninja").exists()
    print(said)


if __name__ == "__main__":
    main()
