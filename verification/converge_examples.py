#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of docs/converge.md, run anew:

    converge_examples.py BARRENO [NAME...]    writes verification/results/converge.json and docs/pictures/converge.png; pages.py --write
    then the page
"""
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

from tools import foreign_python  # noqa: F401
from tools.runs import mpi_environment

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
STORED = HERE / "results" / "converge.json"
PICTURE = ROOT / "docs" / "pictures" / "converge.png"


def cut(until, length):
    """The shot to 120 us to a time [us], in a target cut down to what it needs [mm]."""
    return (f'input_xml/perforation_120us.xml --set "Time/End Time={until} us" --set "Grid/Lower={{0 mm, -16 mm}}" '
        f'--set "Grid/Upper={{40 mm, {length + 12} mm}}" '
            f'--set "Bodies/Casing/Upper={{30.8 mm, 12.7 mm}}" --set "Bodies/Rock/Upper={{30.8 mm, {length + 0.7} mm}}"')  # fmt: skip


EXAMPLES = {  # name: words behind ./barreno converge
    "shell": 'input_xml/shell_coasting.xml --quantity Shell_inner_radius --times "5 us, 10 us, 15 us, 20 us"',
    "jet": cut(20, 112),
    "fine jet": cut(10, 60) + ' --set "Grid/Cell Size=0.5 mm"',
}
DRAWN = "fine jet"


def run_example(barreno, words, folder):
    """What converge.json says, without the folders of this machine."""
    command = [sys.executable, "-m", "barreno.converge", *shlex.split(words), "--out", str(folder)]
    environment = {**mpi_environment(), "BARRENO_PROGRAM": str(barreno)}
    subprocess.run(command, env=environment, cwd=ROOT, check=True)
    (file,) = folder.glob("converge*.json")
    found = json.loads(file.read_text())
    summary = json.loads((folder / pathlib.Path(found["levels"][0]["folder"]).name / "summary.json").read_text())
    error = summary.get("penetration", {}).get("depth_error")
    return {"words": words, "quantity": found["quantity"], "cells": [level["cells"] for level in found["levels"]],
        "results": found["results"], "depth_error": error}


def main():
    barreno = pathlib.Path(sys.argv[1]).resolve()
    data = json.loads(STORED.read_text()) if STORED.exists() else {}
    chosen = sys.argv[2:] or list(EXAMPLES)
    with tempfile.TemporaryDirectory() as scratch:
        for name in chosen:
            words = EXAMPLES[name]
            folder = pathlib.Path(scratch) / name.replace(" ", "_") / "study"
            data[name] = run_example(barreno, words, folder)
            if name == DRAWN:
                shutil.copyfile(next(folder.glob("*.png")), PICTURE)
    STORED.write_text(json.dumps(data, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
