#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The preset gpu configures no build for processors: without a Trilinos, with a path that holds none and with one whose
Kokkos has no device backend it ends with a sentence.

    test_device_preset.py CMAKE TRILINOS

TRILINOS is the folder of the TrilinosConfig.cmake of this build, which is for processors.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def configure(trilinos, build):
    """What the preset says when it is given this folder; it must fail and leave nothing to build."""
    result = subprocess.run(
        [sys.argv[1], "--preset", "gpu", "-B", str(build)], cwd=ROOT, env={**os.environ, "BARRENO_DEVICE_TRILINOS": str(trilinos)},
        capture_output=True, text=True, timeout=120, check=False)  # fmt: skip
    assert result.returncode != 0, result.stdout + result.stderr
    assert not (build / "build.ninja").exists()
    return " ".join(result.stderr.split())


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        said = configure("", folder / "none")
        assert "The preset gpu needs a Trilinos whose Kokkos has a device backend" in said, said
        wrong = folder / "no Trilinos"
        said = configure(wrong, folder / "wrong")
        assert f"names '{wrong}', which holds no TrilinosConfig.cmake" in said, said
        said = configure(sys.argv[2], folder / "processors")
        assert "has no device backend (SERIAL)" in said, said
    print(said)


if __name__ == "__main__":
    main()
