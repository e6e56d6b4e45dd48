#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A deck whose title, materials, bodies and folder have dollar signs and whatever else a formula is written with: run, report, film,
compare, sweep and the picture of drive draw the names letter by letter.

    test_dollar_names.py BARRENO
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from python_commands import said_by
from tools.runs import mpi_environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECK = ROOT / "tests" / "decks" / "dollar_names.xml"
NAME = r"$x$ \foo{$"
EVIL = r"R $\foo{$ \ ^_# %d %s {0} $a_{$"


def program(*words):
    result = subprocess.run([sys.argv[1], *map(str, words)], env=mpi_environment(), capture_output=True, text=True, timeout=500,
        check=False)
    assert result.returncode == 0, f"{words}: {result.stderr}"
    return result.stdout


def check_runs(folder):
    """Two runs with such names, alone and side by side."""
    runs = [folder / NAME / f"{NAME} {i}" for i in (1, 2)]
    runs[0].parent.mkdir()
    for run, end in zip(runs, ("10 us", "8 us")):
        program("run", DECK, "--set", f"Time/End Time={end}", "--out", run)
    said_by("barreno.report", "report", runs[0], "--particles", "near tip")
    assert EVIL[1:] in (runs[0] / "report" / "index.html").read_text(encoding="utf-8")
    said_by("barreno.report", "film", runs[0], "--field", "speed")
    out = folder / f"compared {NAME}"
    said = said_by("barreno.compare", *runs, "--out", out)
    assert f"{NAME} 1" in said and "lacks" not in said and "not drawn" not in said, said
    assert all((out / name).read_bytes()[:4] == b"\x89PNG" for name in ("depth.png", "channels.png"))


def check_sweep(folder):
    """The deck's name and the varied names have dollar signs too."""
    deck = folder / f"{NAME}.xml".replace("\\", "")
    deck.write_text(DECK.read_text(encoding="utf-8").replace("../../input_xml", str(ROOT / "input_xml")), encoding="utf-8")
    said = said_by("barreno.sweeps", deck, "--set", "Time/End Time=6 us", "--vary", f"Bodies/{EVIL}/Particles Per Cell=1,2", "--out",
        folder / f"swept {NAME}")
    assert "not drawn" not in said and "depth_against.png" in said, said


def check_drive(folder):
    """A card of such a name, in the title of its picture."""
    card = folder / f"{NAME}.xml".replace("\\", "")
    shutil.copyfile(ROOT / "materials" / "cards" / "berea_sandstone.xml", card)
    card.write_text(card.read_text(encoding="utf-8").replace('<ParameterList name="', f'<ParameterList name="{EVIL} ', 1), encoding="utf-8")
    program("drive", "--material", card, "--path", ROOT / "input_xml" / "paths" / "uniaxial_berea.csv", "--out", folder / "a.csv", "--plot",
        folder / "a.png")
    assert (folder / "a.png").read_bytes()[:4] == b"\x89PNG"


def main():
    for check in (check_runs, check_sweep, check_drive):
        with tempfile.TemporaryDirectory() as scratch:
            check(pathlib.Path(scratch).resolve())
    print("names are drawn letter by letter")


if __name__ == "__main__":
    main()
