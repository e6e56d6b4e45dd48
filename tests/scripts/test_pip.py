#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package, which pip installs from the source tree and from an installation, without a network and without writing there: the
console script starts the same commands as the launcher, and the package finds program and library where it came from.

    test_pip.py CMAKE BUILD_FOLDER
"""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # what ctest counts as skipped
NEEDED = {"pip": "python3-pip", "setuptools": "python3-setuptools", "wheel": "python3-wheel"}
FROM = "import barreno; from barreno import places; print(places.launcher()); print(barreno.Material('copper').file)"


def call(*words, code=0, environment=None):
    """What it prints on success, else what it says."""
    result = subprocess.run(list(map(str, words)), env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert result.returncode == code, f"{words}: exit {result.returncode}: {result.stdout}{result.stderr}"
    return result.stdout if code == 0 else result.stderr


def listing(folder):
    return sorted(str(path) for path in folder.rglob("*") if "__pycache__" not in path.parts)


def pip_install(source, target):
    """@return environment in which the installed package is used, and nothing of the caller's leads to the tree"""
    before = listing(source)
    call(sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index", "--disable-pip-version-check",
        "--quiet", "--target", target, source)
    assert listing(source) == before, f"pip has written into {source}: {set(listing(source)) ^ set(before)}"
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(("BARRENO", "PYTHON"))}
    return {**inherited, "PYTHONPATH": str(target)}


def check_tree(folder):
    environment = pip_install(ROOT / "src" / "python", folder / "of tree")
    script = folder / "of tree" / "bin" / "barreno"
    assert call(script, "help", environment=environment) == call(ROOT / "barreno", "help")
    found = call(sys.executable, "-c", "from barreno import places; print(places.launcher())", environment=environment)
    assert found.strip() == str(ROOT / "barreno"), found


def check_installation(cmake, build, folder):
    prefix = folder / "a prefix"
    call(cmake, "--install", build, "--prefix", prefix)
    environment = pip_install(prefix / "share" / "barreno" / "python", folder / "of prefix")
    script = folder / "of prefix" / "bin" / "barreno"
    deck = prefix / "share" / "barreno" / "input_xml" / "perforation_quick.xml"
    for words in (("check", deck, "--print-deck"), ("describe", "Time"), ("--version",)):
        said = call(script, *words, environment=environment)
        assert said and said == call(prefix / "bin" / "barreno", *words), words
    launcher, card = call(sys.executable, "-c", FROM, environment=environment).splitlines()
    assert launcher == str(prefix / "bin" / "barreno") and card == str(prefix / "share" / "barreno" / "cards" / "copper.xml"), card
    program = f"import barreno; print(barreno.check({str(deck)!r}, {{'Time/End Time': '5 us'}})['Time/End Time'])"
    assert call(sys.executable, "-c", program, environment=environment) == "5e-06\n"
    said = call(sys.executable, "-m", "barreno.report", "report", folder / "nowhere", code=2, environment=environment)
    assert "is not a folder" in said and said.count("\n") == 1, said
    shutil.rmtree(prefix)
    said = call(script, "help", code=2, environment=environment)
    assert said.startswith("barreno: the launcher is not found (") and said.count("\n") == 1, said


def main():
    lacking = [package for module, package in NEEDED.items() if importlib.util.find_spec(module) is None]
    if lacking:
        print(f"skipped: Python lacks {' '.join(lacking)}")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        check_tree(folder)
        check_installation(sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), folder)
    print("pip installs the package from the tree and from an installation")
    return 0


if __name__ == "__main__":
    sys.exit(main())
