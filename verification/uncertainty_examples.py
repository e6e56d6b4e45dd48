#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The example of docs/uncertainty.md, run anew:

    uncertainty_examples.py BARRENO [--out FOLDER]    writes verification/results/uncertainty.json and docs/pictures/uncertainty.png;
    pages.py --write then the page

A study in FOLDER that was stopped goes on.
"""
import argparse
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
STORED = HERE / "results" / "uncertainty.json"
PICTURE = ROOT / "docs" / "pictures" / "uncertainty.png"
WORDS = 'input_xml/perforation.xml --fidelity fast --flow radial --set "Time/End Time=400 us"'


def run_example(barreno, folder):
    """What uncertainty.json says, without the folders of this machine."""
    command = [sys.executable, "-m", "barreno.uncertainties", *shlex.split(WORDS), "--out", str(folder)]
    subprocess.run(command, env={**mpi_environment(), "BARRENO_PROGRAM": str(barreno)}, cwd=ROOT, check=True)
    found = json.loads((folder / "uncertainty.json").read_text())
    summaries = [json.loads((ROOT / run["folder"] / "summary.json").read_text()) for run in found["runs"]]
    ranges = [{name: one[name] for name in ("path", "low", "high", "known", "drawn_in_logarithm")} for one in found["ranges"]]
    return {"words": WORDS, "design": found["design"], "runs": len(summaries), "ranges": ranges, "answers": found["answers"],
        "seconds": sum(summary["wall_seconds"] for summary in summaries)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.out.resolve() if options.out else pathlib.Path(scratch) / "study"
        data = run_example(options.barreno.resolve(), folder)
        STORED.write_text(json.dumps(data, indent=1) + "\n")
        shutil.copyfile(folder / "tornado.png", PICTURE)
    return 0


if __name__ == "__main__":
    sys.exit(main())
