#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno drive` from the outside: every shipped card answers, every bad input has its own sentence and exit code and
leaves nothing behind.

    test_drive.py BARRENO
"""
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

from barreno.runs.csv_table import MIXED, read_csv

ROOT = pathlib.Path(__file__).resolve().parents[2]
CARDS = sorted((ROOT / "materials" / "cards").glob("*.xml"))
EXAMPLE = ROOT / "input_xml" / "paths" / "uniaxial_berea.csv"
HEADER = "time,F11,F12,F13,F21,F22,F23,F31,F32,F33"
START = "0,1,0,0,0,1,0,0,0,1"
SQUEEZE = "1e-6,0.99,0,0,0,1,0,0,0,1"
GLASS = """<ParameterList name="Glass">
  <Parameter name="Model" type="string" value="Linear Elastic"/>
  <Parameter name="Density" type="double" value="2500"/>
  <Parameter name="Bulk Modulus" type="string" value="40 GPa"/>
  <Parameter name="Shear Modulus" type="string" value="30 GPa"/>
</ParameterList>
"""
EXPECTED_HEADER = (
    HEADER.split(",") + ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"]
)

CARD, PATH, OUT = ["--material", "glass.xml"], ["--path", "good.csv"], ["--out", "answer.csv"]
GOOD = CARD + PATH + OUT
EXAMPLE_LINE = (
    "write for example barreno drive --material berea_sandstone.xml --path input_xml/paths/uniaxial_berea.csv "
    "--out answer.csv."
)
PATH_FILES = {
    "good.csv": [HEADER, START, SQUEEZE],
    "header.csv": ["time,F11,F22", START, SQUEEZE],
    "text.csv": [HEADER, START, "1e-6,0.99,0,0,0,one,0,0,0,1"],
    "infinite.csv": [HEADER, START, "1e-6,inf,0,0,0,1,0,0,0,1"],
    "short_row.csv": [HEADER, START, "1e-6,0.99"],
    "one_row.csv": [HEADER, START],
    "no_row.csv": ["# nothing"],
    "times.csv": [HEADER, START, SQUEEZE, "0.5e-6,1,0,0,0,1,0,0,0,1"],
    "inverted.csv": [HEADER, START, "1e-6,1,0,0,0,-0.5,0,0,0,1"],
    "first_inverted.csv": [HEADER, "0,0,0,0,0,1,0,0,0,1", SQUEEZE],
    "half_turn.csv": [HEADER, START, "1e-6,-1,0,0,0,-1,0,0,0,1"],
    "misspelt.csv": ["time,stress_xx,stres_yy", "0,0,0", "1,-1e6,0"],
    "too_strong.csv": ["time,stress_xx,stress_yy,stress_zz", "0,0,0,0", "1,-40 MPa,-40 MPa,-40 MPa", "2,-400 MPa,-40 MPa,-40 MPa"],
    "drained.csv": ["time,strain_xx,pore_pressure", "0,0,0", "1,-1e-3,0"],
    "both.csv": ["time,strain_xx,stress_xx", "0,,0", "1,-1e-3,-1 MPa"],
    "neither.csv": ["time,strain_xx,stress_xx", "0,,0", "1,,"],
    "empty.csv": ["time,stress_xx,stress_yy", "0,0,0", "1,-1 MPa,"],
    "twice.csv": ["time,stress_xx,stress_xx", "0,0,0", "1,0,0"],
    "loaded.csv": ["time,strain_xx,stress_xx", "0,,-1 MPa", "1,,-2 MPa"],
    "answer_surface.csv": [HEADER, START, SQUEEZE],
    "too_far.csv": [HEADER, START, SQUEEZE, "2e-6,1e-6,0,0,0,1,0,0,0,1"],
}
BAD = (
    {  # name: (arguments, exit code, sentence)
    "missing path file": (
        CARD + ["--path", "nowhere.csv"] + OUT, 2,
        "nowhere.csv does not exist (needed as a path); check the path."),
    "path is a directory": (
        CARD + ["--path", "folder"] + OUT, 2,
        "folder is a directory (needed as a path); give the path of a file."),
    "header": (
        CARD + ["--path", "header.csv"] + OUT, 1,
        f'header.csv: line 1 = "time,F11,F22" is not the header of a path (the header identifies the columns); write "{HEADER}".'),
    "text in a number": (
        CARD + ["--path", "text.csv"] + OUT, 1,
        'text.csv: line 3, F22 = "one" is not a number (a number without unit is expected here); write for example "0.5".'),
    "infinite": (
        CARD + ["--path", "infinite.csv"] + OUT, 1,
        'infinite.csv: line 3, F11 = "inf" is not a number (a number without unit is expected here); write for example '
        '"0.5".'),
    "short row": (
        CARD + ["--path", "short_row.csv"] + OUT, 1,
        f"short_row.csv: line 3 has 2 values (10 are expected); write a row as {HEADER}."),
    "one row": (
        CARD + ["--path", "one_row.csv"] + OUT, 1,
        "one_row.csv: too few rows: 1 below the header (a path leads from one instant to another); give at least two."),
    "no row": (
        CARD + ["--path", "no_row.csv"] + OUT, 1,
        "no_row.csv: too few rows: 0 below the header (a path leads from one instant to another); give at least two."),
    "times": (
        CARD + ["--path", "times.csv"] + OUT, 1,
        "times.csv: line 4, time = 5e-07 is not after 1e-06 of line 3 (times must increase); sort the rows or correct "
        "the time."),
    "inverted": (
        CARD + ["--path", "inverted.csv"] + OUT, 1,
        "inverted.csv: line 3 has det F = -0.5 (volumes are positive); correct F11 to F33 of that row."),
    "first row without volume": (
        CARD + ["--path", "first_inverted.csv"] + OUT, 1,
        "first_inverted.csv: line 2 has det F = 0 (volumes are positive); correct F11 to F33 of that row."),
    "half a turn": (
        CARD + ["--path", "half_turn.csv"] + OUT, 1,
        "half_turn.csv: line 3 is half a turn or more from line 2 (there is no unique constant velocity gradient between them); add rows "
        "between them."),
    "the model fails": (
        ["--material", "berea_sandstone.xml", "--path", "too_far.csv"] + OUT, 3,
        "too_far.csv: line 4 cannot be reached: at time 2e-06 s the Arenisca of 'berea_sandstone' fails (the strain of one step is too "
        "large for it); check F of that row, or take smaller steps with --steps-per-row."),
    "a column that is none": (
        CARD + ["--path", "misspelt.csv"] + OUT, 1,
        "misspelt.csv: line 1 = \"stres_yy\" is not a column of a path (strain_xx to strain_zx, stress_xx to stress_zx, axial_strain, "
        "radial_strain, axial_stress, confinement, pore_pressure and "
        "time are); did you mean 'stress_yy'?"),
    "both controls": (
        CARD + ["--path", "both.csv"] + OUT, 1,
        "both.csv: line 3 gives both strain_xx and stress_xx (a component is controlled by one of them); leave one of the two cells "
        "empty."),
    "no control": (
        CARD + ["--path", "neither.csv"] + OUT, 1,
        "neither.csv: line 3 gives neither strain_xx nor stress_xx (a component is controlled by one of them); fill one of the two "
        "cells."),
    "an empty cell without another column": (
        CARD + ["--path", "empty.csv"] + OUT, 1,
        "empty.csv: line 3 leaves stress_yy empty, and there is no column strain_yy that could control the component instead; write a "
        "value, or add that column."),
    "a column twice": (
        CARD + ["--path", "twice.csv"] + OUT, 1,
        'twice.csv: line 1 = "stress_xx" is there twice (every column has its own name); take one of them out.'),
    "loaded at the start": (
        CARD + ["--path", "loaded.csv"] + OUT, 1,
        'loaded.csv: line 2, stress_xx = -1e+06 is not that of the virgin point, 0 Pa (a path begins there); write that, and the first '
        "load in the next row."),
    "no picture": (
        GOOD + ["--plot", "answer.jpg"], 1,
        '--plot "answer.jpg" is not the name of a picture (it ends with .png, .pdf or .svg); write for example --plot answer.png.'),
    "a picture without a name": (
        GOOD + ["--plot"], 1, "--plot needs a value; write for example --plot answer.png."),
    "the surface would overwrite the path": (
        CARD + ["--path", "answer_surface.csv"] + OUT + ["--plot", "answer.png"], 1,
        '--plot with its table "answer_surface.csv" is an input of this command (it would be overwritten); give another file.'),
    "the surface would overwrite the answer": (
        CARD + PATH + ["--out", "a_surface.csv", "--plot", "a.png"], 1,
        '--plot writes "a_surface.csv", which is the file of --out (one would overwrite the other); give another name.'),
    "the picture in no folder": (
        GOOD + ["--plot", "nowhere/a.png"], 2,
        '--plot "nowhere/a.png" cannot be drawn (No such file or directory); mend that, or leave --plot out.'),
    "a value of a flag": (
        GOOD + ["--every-step=3"], 1, "--every-step takes no value; write --every-step."),
    "beyond the strength": (
        ["--material", "berea_sandstone", "--path", "too_strong.csv", "--steps-per-row", "40"] + OUT, 3,
        "too_strong.csv: line 4 cannot be reached: 'berea_sandstone' cannot sustain stress_xx = -2.38e+08 Pa at time 1.55 s (highest value "
        "reached: -2.366e+08 Pa); prescribe strain_xx to go beyond the strength."),
    "drained without fluid": (
        CARD + ["--path", "drained.csv"] + OUT, 1,
        "drained.csv: pore_pressure: the Linear Elastic of 'glass' holds no fluid that could flow; give it a fluid or take "
        "the column out."),
    "missing card": (
        ["--material", "berea_sandstome.xml"] + PATH + OUT, 2,
        '--material "berea_sandstome.xml" names no card (there is none of that name in the working directory, in '
        "BARRENO_MATERIALS or among those that Barreno comes with); did you mean 'berea_sandstone'?"),
    "card of a far name": (
        ["--material", "granite"] + PATH + OUT, 2,
        '--material "granite" names no card (there is none of that name in the working directory, in BARRENO_MATERIALS or '
        "among those that Barreno comes with); choose one of " + ", ".join(f"'{card.stem}'" for card in CARDS) + "."),
    "unknown parameter": (
        GOOD + ["--set", "Bulk Modulis=1 GPa"], 1,
        "glass.xml: Bulk Modulis is not a known parameter; did you mean 'Bulk Modulus'?"),
    "wrong dimension": (
        GOOD + ["--set", "Bulk Modulus=1 m"], 1,
        "glass.xml: Bulk Modulus = 1 m has the unit of a length ('m'), but a stress is expected here; write for example "
        '"10 ksi".'),
    "out of bounds": (
        GOOD + ["--set", "Bulk Modulus=-1"], 1,
        "glass.xml: Bulk Modulus = -1 is out of bounds (it must be above 0 Pa); choose a value in that range."),
    "set without value": (
        GOOD + ["--set", "Bulk Modulus"], 1,
        "--set \"Bulk Modulus\" assigns nothing (a path, '=' and a value are expected here); write for example --set "
        '"PEAKI1=20 MPa".'),
    "unknown option": (
        GOOD + ["--step-per-row", "3"], 1,
        "--step-per-row is not an option of this command; did you mean '--steps-per-row'?"),
    "no steps": (
        GOOD + ["--steps-per-row", "0"], 1,
        "--steps-per-row 0 is not a number of steps (1 or more); write for example --steps-per-row 2."),
    "option without value": (
        CARD + PATH + ["--out"], 1, "--out needs a value; write for example --out answer.csv."),
    "no card": (
        PATH + OUT, 1,
        f"--material is missing (drive needs a card, a path and a file for the answer); {EXAMPLE_LINE}"),
    "no path": (
        CARD + OUT, 1, f"--path is missing (drive needs a card, a path and a file for the answer); {EXAMPLE_LINE}"),
    "no out": (
        CARD + PATH, 1, f"--out is missing (drive needs a card, a path and a file for the answer); {EXAMPLE_LINE}"),
    "a file without option": (
        ["good.csv"] + GOOD, 1,
        '"good.csv" is not preceded by an option (drive takes every file with its option); write --material, --path or --out before it.'),
    "out is an input": (
        CARD + PATH + ["--out", "good.csv"], 1,
        '--out "good.csv" is an input of this command (it would be overwritten); give another file.'),
    "out below a file": (
        CARD + PATH + ["--out", "good.csv/answer.csv"], 2,
        "cannot write 'good.csv/answer.csv' (Not a directory). Free disk space or choose another folder with --out."),
    "out in no folder": (
        CARD + PATH + ["--out", "nowhere/answer.csv"], 2,
        "cannot write 'nowhere/answer.csv' (No such file or directory). Free disk space or choose another folder with "
        "--out."),
    "out is a directory": (
        CARD + PATH + ["--out", "folder"], 2,
        "cannot write 'folder' (Is a directory). Free disk space or choose another folder with --out."),
}
)  # fmt: skip


def drive(barreno, folder, arguments):
    environment = dict(os.environ, BARRENO_MATERIALS="")
    command = [barreno, "drive", *arguments]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)


def prepare(folder):
    (folder / "glass.xml").write_text(GLASS)
    (folder / "folder").mkdir()
    for name, lines in PATH_FILES.items():
        (folder / name).write_text("\n".join(lines) + "\n")


def listing(folder):
    return {str(path.relative_to(folder)): path.is_file() and path.read_bytes() for path in folder.rglob("*")}


def table(file):
    frame = read_csv(file)
    return list(frame.columns), frame.to_numpy(float).tolist()


def check_bad_inputs(barreno, folder):
    before = listing(folder)
    for name, (arguments, code, sentence) in BAD.items():
        result = drive(barreno, folder, arguments)
        if (result.returncode, result.stderr) != (code, f"barreno: {sentence}\n"):
            yield f"{name}: expected exit {code}\n{sentence}\nbut got exit {result.returncode}\n{result.stderr}"
        if listing(folder) != before:
            yield f"{name}: left behind or changed {set(listing(folder)) ^ set(before)}"


def check_failure_keeps_old_answer(barreno, folder):
    (folder / "answer.csv").write_text("old\n")
    result = drive(barreno, folder, ["--material", "berea_sandstone.xml", "--path", "too_far.csv"] + OUT)
    if result.returncode != 3 or (folder / "answer.csv").read_text() != "old\n":
        yield "a failed drive touched the answer that was there"


def check_elastic(barreno, folder):
    """K and G of the card, then of --set with a unit: uniaxial log strain in closed form."""
    softer = ["--set", "Bulk Modulus=22 GPa", "--set", "Shear Modulus=1e10"]
    for settings, bulk, shear in (([], 40e9, 30e9), (softer, 22e9, 10e9)):
        result = drive(barreno, folder, GOOD + ["--steps-per-row", "3"] + settings)
        header, rows = table(folder / "answer.csv")
        strain = math.log(0.99)
        exact = [0.0] * 6
        exact[0], exact[1] = (bulk + 4 / 3 * shear) * strain, (bulk - 2 / 3 * shear) * strain
        exact[2] = exact[1]
        worst = max(abs(a - b) for a, b in zip(rows[1][10:], exact)) / abs(exact[0])
        if result.returncode != 0 or header != EXPECTED_HEADER or not worst <= 1e-12:
            yield f"elastic, {settings}: exit {result.returncode}, error {worst}, header {header}"
        if rows[1][:10] != [1e-6, 0.99, 0, 0, 0, 1, 0, 0, 0, 1]:
            yield f"time and F are not those of the path: {rows[1][:10]}"
        for note in ("glass.xml does not state its Units", "glass.xml does not state its Schema Version"):
            if note not in result.stdout:
                yield f"no note '{note}' in {result.stdout}"


def check_cards(barreno, folder):
    """Every shipped card along the example: by name, a row per row, all numbers."""
    count = sum(1 for line in EXAMPLE.read_text().splitlines() if line and not line.startswith("#")) - 1
    for card in CARDS:
        arguments = ["--material", card.name, "--path", str(EXAMPLE), "--steps-per-row", "4"] + OUT
        result = drive(barreno, folder, arguments)
        if result.returncode != 0:
            yield f"{card.name}: {result.stderr}"
            continue
        header, rows = table(folder / "answer.csv")
        if len(rows) != count or header[:16] != EXPECTED_HEADER or "note" in result.stdout:
            yield f"{card.name}: {len(rows)} rows of {count}, header {header}, screen {result.stdout}"
        if not all(len(row) == len(header) and all(map(math.isfinite, row)) for row in rows):
            yield f"{card.name}: a row is not whole"
        if "JWL Explosive" in card.read_text():  # of which nothing has burnt
            if any(rows[20][10:16]):
                yield f"{card.name}: an unlit explosive bears stress: {rows[20]}"
        elif not rows[20][10] < -1e8:
            yield f"{card.name}: no stress at 10 % of shortening: {rows[20]}"


def shipped_command(path):
    """The words of the command that stands in a path file."""
    lines = [line[1:].strip() for line in path.read_text().splitlines() if line.startswith("#")]
    first = next(i for i, line in enumerate(lines) if line.startswith("Run: barreno drive"))
    words = shlex.split(" ".join(lines[first:]))[3:]
    words[words.index("--path") + 1] = str(path)
    return words


def yield_curve(file, state, section):
    """(I1, sqrt(J2)) of one curve of a surface's table."""
    table = read_csv(file, cells=MIXED)
    found = table[(table["state"] == state) & (table["section"] == section)]
    return found[["I1", "sqrt_J2"]].to_numpy(float).tolist()


def strength_at(curve, x):
    (x0, y0), (x1, y1) = next(pair for pair in zip(curve, curve[1:]) if pair[0][0] <= x <= pair[1][0])
    return y0 + (x - x0) / (x1 - x0) * (y1 - y0)


def check_shipped_paths(barreno, folder):
    """Every path of input_xml/paths by the command that stands in it, with a picture: a row per row; the triaxial tests end on
    the surface that is drawn, in the effective stress, and have one strength dry and drained."""
    paths = sorted(EXAMPLE.parent.glob("*.csv"))
    strengths = {}
    for path in paths:
        result = drive(barreno, folder, shipped_command(path) + ["--plot", "answer.png"])
        if result.returncode != 0:
            yield f"{path.name}: {result.stderr}"
            continue
        header, rows = table(folder / "answer.csv")
        count = sum(1 for line in path.read_text().splitlines() if line and not line.startswith("#")) - 1
        if len(rows) != count or not all(len(row) == len(header) and all(map(math.isfinite, row)) for row in rows):
            yield f"{path.name}: {len(rows)} rows instead of {count}, or one is not whole"
        if (folder / "answer.png").read_bytes()[:8] != b"\x89PNG\r\n\x1a\n" or "picture in answer.png" not in result.stdout:
            yield f"{path.name}: no picture, {result.stdout}"
        if "triaxial" not in path.name:
            continue
        last = dict(zip(header, rows[-1]))
        stress = [last[f"stress_{c}"] for c in ("xx", "yy", "zz")]
        I1 = sum(stress) + 3.0 * last.get("pore_pressure", 0.0)
        shear = math.sqrt(sum((s - sum(stress) / 3.0) ** 2 for s in stress) / 2.0)
        there = strength_at(yield_curve(folder / "answer_surface.csv", "current", "compression"), I1)
        if not abs(shear / there - 1.0) <= 0.01:  # the tolerance of the card
            yield f"{path.name}: ends at sqrt(J2) = {shear}, the surface has {there}"
        strengths[path.stem] = [dict(zip(header, row))["stress_yy"] - dict(zip(header, row))["stress_xx"] for row in rows[2:]]
        confined = dict(zip(header, rows[1]))
        if confined["stress_xx"] != confined["stress_yy"] and abs(confined["stress_xx"] / confined["stress_yy"] - 1.0) > 1e-6:
            yield f"{path.name}: the confinement is not hydrostatic: {rows[1]}"
    dry, drained, undrained = (strengths.get(f"triaxial{kind}_berea", [math.nan] * 2) for kind in ("", "_drained", "_undrained"))
    # Sealed rock yields earlier, under the pressure of its fluid, and is stronger in the end, when dilation has taken that away.
    sealed = 0.8 * dry[0] < undrained[0] < 0.95 * dry[0] and undrained[1] > 1.05 * dry[1]
    if len(paths) != 6 or not abs(dry[1] / drained[1] - 1.0) <= 1e-3 or not sealed:
        yield f"{len(paths)} paths; strengths of the triaxial tests: {strengths}"


def check_every_step(barreno, folder):
    """A row per step, of which every N-th is a row of the path, for both kinds of path; a picture changes no bit of the answer."""
    steps = 5
    for path in (EXAMPLE, EXAMPLE.with_name("triaxial_berea.csv")):
        words = ["--material", "berea_sandstone", "--path", str(path), "--steps-per-row", str(steps)]
        drive(barreno, folder, words + ["--out", "rows.csv"])
        rows = (folder / "rows.csv").read_text().splitlines()
        for more, name in ((["--every-step"], "steps.csv"), (["--plot", "p.svg"], "plotted.csv"),
                (["--every-step", "--plot", "p.pdf"], "all.csv")):
            result = drive(barreno, folder, words + more + ["--out", name])
            if result.returncode != 0:
                yield f"{path.name} {more}: {result.stderr}"
        every = (folder / "steps.csv").read_text().splitlines()
        if len(every) - 2 != (len(rows) - 3) * steps + 1 or every[:2] + every[2::steps] != rows:
            yield f"{path.name}: {len(every) - 2} rows of every step, {len(rows) - 2} of the path, or other numbers in them"
        for one, other in (("rows.csv", "plotted.csv"), ("steps.csv", "all.csv")):
            if (folder / one).read_bytes() != (folder / other).read_bytes():
                yield f"{path.name}: a picture changes the answer"
        if not (folder / "p.svg").read_text().startswith("<?xml") or (folder / "p.pdf").read_bytes()[:4] != b"%PDF":
            yield "pictures of other formats"


def check_surfaces(barreno, folder):
    """A metal's circle is at its flow stress; elastic materials have no surface; without Matplotlib nothing is written."""
    words = ["--path", str(EXAMPLE), "--steps-per-row", "4"] + OUT + ["--plot", "metal.png"]
    drive(barreno, folder, ["--material", "copper.xml"] + words)
    header, rows = table(folder / "answer.csv")
    stress = rows[-1][10:13]
    shear = math.sqrt(sum((s - sum(stress) / 3.0) ** 2 for s in stress) / 2.0)
    heights = {y for _, y in yield_curve(folder / "metal_surface.csv", "current", "compression")}
    if len(heights) != 1 or not abs(heights.pop() / shear - 1.0) <= 1e-2:
        yield f"copper ends at sqrt(J2) = {shear}, its surface is at {heights}"
    result = drive(barreno, folder, GOOD + ["--plot", "glass.png"])
    if result.returncode != 0 or not (folder / "glass.png").exists() or (folder / "glass_surface.csv").exists():
        yield f"glass: {result.stdout}{result.stderr}"
    (folder / "without").mkdir()
    (folder / "without" / "matplotlib.py").write_text("raise ImportError(\"No module named 'matplotlib'\")\n")
    (folder / "answer.csv").unlink()
    before = listing(folder)
    environment = dict(os.environ, PYTHONPATH=str(folder / "without"), PYTHONDONTWRITEBYTECODE="1", BARRENO_MATERIALS="")
    command = [barreno, "drive", *GOOD, "--plot", "none.png"]
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
    expected = (
        "barreno: --plot \"none.png\" cannot be drawn (it needs Python 3 with Matplotlib: No module named 'matplotlib'); install it: "
        "apt-get install --no-install-recommends python3 python3-numpy python3-matplotlib.\n"
    )
    if (result.returncode, result.stderr) != (2, expected) or listing(folder) != before:
        yield f"without Matplotlib: exit {result.returncode}, {result.stderr}, new {set(listing(folder)) - set(before)}"


def check_place_of_cards(barreno, folder):
    """A full path; a folder of BARRENO_MATERIALS, which goes before the shipped cards; a shipped card by its bare name."""
    for name in ("berea_sandstone", "BEREA_Sandstone.xml"):
        result = drive(barreno, folder, ["--material", name] + PATH + OUT)
        if f"Arenisca of '{name.removesuffix('.xml')}'" not in result.stdout:
            yield f"{name}: {result.stdout}{result.stderr}"
    other = folder / "folder" / "brick.xml"
    other.write_text(GLASS)
    result = drive(barreno, folder, ["--material", str(other)] + PATH + OUT)
    if result.returncode != 0:
        yield f"full path of a card: {result.stderr}"
    environment = dict(os.environ, BARRENO_MATERIALS=str(other.parent))
    command = [barreno, "drive", "--material", "brick.xml"] + PATH + OUT
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
    if result.returncode != 0:
        yield f"a card of BARRENO_MATERIALS: {result.stderr}"
    other.rename(other.with_name("copper.xml"))
    command[3] = "copper"
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
    if "Linear Elastic of 'copper'" not in result.stdout:
        yield f"BARRENO_MATERIALS goes before the shipped cards: {result.stdout}{result.stderr}"


def check_extension(barreno, folder):
    """What docs/materials/arenisca.md says of rock that is pulled in uniaxial strain: with the associated flow of the shipped card its mean
    stress becomes compressive, with BETA_nonassociativity = 0.5 it stays in tension."""
    (folder / "pull.csv").write_text("time,strain_xx\n0,0\n1 us,0.001\n2 us,0.01\n3 us,0.1\n")
    pressures = []
    for beta in ("1", "0.5"):
        result = drive(barreno, folder, ["--material", "berea_sandstone", "--path", "pull.csv", "--steps-per-row", "100", "--set",
            f"BETA_nonassociativity={beta}", *OUT])
        if result.returncode != 0:
            yield f"extension with beta = {beta}: {result.stderr}"
            return
        stress = read_csv(folder / OUT[1])[["stress_xx", "stress_yy", "stress_zz"]]
        pressures.append((-stress.sum(axis=1) / 3.0).tolist())
        if not (stress["stress_xx"][1:] > 0.0).all():
            yield f"the axis is not in tension: {stress}"
    associated, less = pressures
    if not (associated[1] < 0.0 < associated[2] < associated[3] and max(less[1:]) < 0.0):
        yield f"pressures of extension: {pressures}"


def check_compression_limit(barreno, folder):
    """Smaller steps do not move the limit of a law: the sentence names it, on both kinds of paths, and where a stress is asked for."""
    crush = {
        "strain": "time,strain_xx,strain_yy,strain_zz\n0,0,0,0\n1 us,-0.3,-0.3,-0.3\n3 us,-0.6,-0.6,-0.6\n",
        "gradient": "time,F11,F12,F13,F21,F22,F23,F31,F32,F33\n0,1,0,0,0,1,0,0,0,1\n2 us,0.3,0,0,0,1,0,0,0,1\n",
        "stress": "time,stress_xx,strain_yy\n0,0,0\n1 us,-1e17,0\n",
    }  # fmt: skip
    for name, text in crush.items():
        (folder / "crush.csv").write_text(text)
        for steps in ("10", "1000"):
            result = drive(barreno, folder, ["--material", "copper", "--path", "crush.csv", "--steps-per-row", steps, *OUT])
            said = result.stderr
            if (
                result.returncode != 3 or "the compression limit of its Mie-Grueneisen law, V/V0 = 0.33" not in said
                or "smaller steps" in said
            ):
                yield f"{name}, {steps} steps: exit {result.returncode}: {said}"


def check_ranks(barreno, folder):
    """Two ranks give the bytes of one, and say an error once."""
    example = ["--material", "copper.xml", "--path", str(EXAMPLE)]
    drive(barreno, folder, example + ["--out", "one.csv"])
    both = ["mpirun", "--quiet", "-n", "2", barreno, "drive"]
    options = {"cwd": folder, "capture_output": True, "text": True, "timeout": 120}
    result = subprocess.run(both + example + ["--out", "two.csv"], **options)
    if result.returncode != 0 or result.stdout.count("\n") != 1:
        yield f"two ranks: exit {result.returncode}, {result.stdout}{result.stderr}"
    elif (folder / "one.csv").read_bytes() != (folder / "two.csv").read_bytes():
        yield "two ranks give other numbers than one"
    for arguments, code, sentence in (BAD["text in a number"], BAD["out in no folder"], BAD["the model fails"]):
        result = subprocess.run(both + arguments, **options)
        if (result.returncode, result.stderr) != (code, f"barreno: {sentence}\n"):
            yield f"two ranks: expected exit {code}\n{sentence}\nbut got exit {result.returncode}\n{result.stderr}"


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    checks = [check_bad_inputs, check_failure_keeps_old_answer, check_elastic, check_cards, check_shipped_paths, check_every_step,
        check_surfaces,
              check_place_of_cards, check_extension, check_compression_limit, check_ranks]  # fmt: skip
    failed = 0
    for check in checks:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            prepare(folder)
            for problem in check(barreno, folder):
                failed += 1
                print(f"{check.__name__}: {problem}")
    print(f"{len(BAD)} bad inputs, {len(CARDS)} cards: {failed} problems")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
