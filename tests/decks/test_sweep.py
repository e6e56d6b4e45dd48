#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno sweep` and `barreno compare` from the outside: what they write of real runs, that finished runs are taken and stopped ones
continued, that a failure stops nothing else, the array job and what is collected of it, and a sentence for every bad input.

    test_sweep.py BARRENO
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from barreno.runs.csv_table import WORDS, read_csv
from python_commands import environment_of_runs, process_of, said_by
from tools.runs import DECKS, mpi_environment

QUICK = DECKS / "perforation_quick.xml"
TARGET = ("--set", "Grid/Upper={80 mm, 90 mm}", "--set", "Bodies/Rock/Upper={50.8 mm, 72.7 mm}")
SHORT = (*TARGET, "--set", "Time/End Time=2 us")
PRESSURES = ("--vary", "Confinement/Pressure=0,34,69 MPa")
TWO = ("--vary", "Confinement/Pressure=0,69 MPa")


def sweep(*words, **more):
    return said_by("barreno.sweeps", *words, **more)


def table_of(out, name="table.csv"):
    return read_csv(out / name, cells=WORDS).to_dict("records")


def how_of(out):
    return [run["how"] for run in json.loads((out / "sweep.json").read_text())["runs"]]


def check_sweep(folder):
    """Three pressures: a row, a curve and a channel for each."""
    out = folder / "sweep"
    said = sweep(QUICK, *SHORT, *PRESSURES, "--jobs", "2", "--out", out)
    assert said.count("[3/3] Pressure = ") == 1 and "Written to" in said and "depth [mm]" in said, said
    rows = table_of(out)
    assert [row["Confinement/Pressure [MPa]"] for row in rows] == ["0", "34", "69"] and {row["state"] for row in rows} == {"finished"}, rows
    for row in rows:
        summary = json.loads((pathlib.Path(row["run"]) / "summary.json").read_text())
        assert float(row["penetration.depth"]) == summary["penetration"]["depth"] > 0.0 and row["finished"] == "true", row
        assert (
            float(row["balances.energy.plastic"]) == summary["balances"]["energy"]["plastic"] and int(row["steps"]) == summary["steps"]
        ), row
    assert all((out / name).read_bytes()[:4] == b"\x89PNG"
        for name in ("depth.png", "depth_against.png", "channels.png")) and how_of(out) == ["computed"] * 3
    assert sorted(file.name for file in out.iterdir() if file.is_dir()) == ["Pressure-0MPa", "Pressure-34MPa",
        "Pressure-69MPa"] and not list(out.glob(".*"))
    return out


def check_reuse(out):
    """Finished runs are taken, also with more values and under other names; a changed deck is another sweep."""
    (out / "Pressure-34MPa").rename(out / "by hand")
    before = {file: file.stat().st_mtime_ns for file in out.glob("*/particles.e")}
    said = sweep(QUICK, *SHORT, "--vary", "Confinement/Pressure=10,34,69,0 MPa", "--out", out)
    assert said.count("finished run in") == 3 and how_of(out) == ["computed", "reused", "reused", "reused"], said
    assert {file: file.stat().st_mtime_ns for file in before} == before
    rows = table_of(out)
    assert [row["Confinement/Pressure [MPa]"] for row in rows] == ["10", "34", "69", "0"] and rows[1]["run"] == str(out / "by hand"), rows
    found = sweep(QUICK, *TARGET, "--set", "Time/End Time=3 us", *PRESSURES, "--out", out, code=2)
    assert "holds a sweep of another deck" in found and found.count("\n") == 1, found


def wait_for(condition, what):
    until = time.monotonic() + 120
    while not condition():
        assert time.monotonic() < until, f"waited in vain for {what}"
        time.sleep(0.02)


def check_interruption(folder):
    """A signal ends the runs behind a checkpoint; the same command continues. Runs that are long enough to be caught."""
    other = folder / "cut"
    words = (QUICK, *TARGET, "--set", "Time/End Time=8 us", *PRESSURES, "--jobs", "1", "--out", other)
    log = other / "Pressure-34MPa" / "run.log"
    with subprocess.Popen(**process_of("barreno.sweeps", *words), stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        wait_for(lambda: log.exists() and " % " in log.read_text(), "progress of the second run")
        os.kill(child.pid, signal.SIGINT)
        _, said = child.communicate(timeout=60)
    assert (
        child.returncode == 130
        and said == "barreno: interrupted with 1 of 3 runs finished; the same command continues, and takes the finished runs as they are.\n"
    ), said
    assert not (other / "table.csv").exists() and not (other / "Pressure-69MPa").exists()
    sweep(*words)
    assert how_of(other) == ["reused", "resumed", "computed"], how_of(other)
    assert [float(row["time"]) for row in table_of(other)] == [8e-6] * 3, table_of(other)


def check_failure(folder):
    """A run that fails leaves the others alone, and the exit code is its own."""
    out = folder / "failed"
    words = (QUICK, *SHORT, "--set", "Materials/Tungsten/Bad Particles=stop", "--vary", "Step/Largest Expansion=1.001,100", "--out", out)
    found = sweep(*words, code=3)
    assert (
        found.count("\n") == 1 and "the run with Largest Expansion = 1.001 ended with exit code 3" in found
        and "its policy is to stop" in found
    ), found
    rows = table_of(out)
    assert [row["state"] for row in rows] == ["failed",
        "finished"] and rows[0]["penetration.depth"] == "" and float(rows[1]["penetration.depth"]) > 0.0, rows
    found = sweep(*words, "--collect", code=3)
    assert found.count("\n") == 1 and "Largest Expansion = 1.001 ended with exit code 3" in found, found


def check_two_parameters(folder):
    """Two parameters, a Latin hypercube, values that go together: as many runs as they say."""
    out = folder / "latin"
    sweep(QUICK, *TARGET, "--set", "Time/End Time=0.4 us", "--vary", "Confinement/Pressure=10..69 MPa", "--vary",
        "Materials/Sandstone/PEAKI1=5..20 MPa",
          "--sample", "latin", "--samples", "3", "--seed", "4", "--out", out)  # fmt: skip
    rows = table_of(out)
    assert len({row["Confinement/Pressure [MPa]"] for row in rows}) == len(
        {row["Materials/Sandstone/PEAKI1 [MPa]"] for row in rows}) == len(rows) == 3, rows
    assert all(10.0 <= float(row["Confinement/Pressure [MPa]"]) <= 69.0 for row in rows), rows
    assert not (out / "depth_against.png").exists() or rows[0]["penetration.depth"]  # the jet has not arrived
    out = folder / "list"
    said = sweep(QUICK, *TARGET, "--set", "Time/End Time=0.4 us", "--vary", "Step/Transfer=FLIP,APIC", "--vary", "Grid/Cell Size=2,5 mm",
        "--sample", "list", "--ranks", "2", "--out", out)
    assert [(row["Step/Transfer"], row["Grid/Cell Size [mm]"], row["ranks"]) for row in table_of(out)] == [("FLIP", "2", "2"),
        ("APIC", "5", "2")], said


def check_array_job(out, folder):
    """The script's tasks, run here one after the other, and what is collected in between."""
    job = folder / "job"
    words = (QUICK, *SHORT, *PRESSURES, "--out", job)
    script = sweep(*words, "--submit", "slurm", BARRENO_COMMAND=f"{sys.executable} -m barreno.sweeps")
    assert "#SBATCH --array=1-3\n" in script and f"exec {sys.executable} -m barreno.sweeps {QUICK}" in script and [file.name
        for file in job.iterdir()] == ["sweep.json"], script
    found = sweep(*words, "--collect", code=2)
    assert found == "barreno: none of the runs has finished; the command without --collect computes them.\n", found
    for task in ("1", "3"):
        result = subprocess.run(["bash", "-c", script], env={**environment_of_runs(), "SLURM_ARRAY_TASK_ID": task}, capture_output=True,
            text=True, timeout=300)
        assert result.returncode == 0 and "[1/1] Pressure = " in result.stdout, result.stderr
    found = sweep(*words, "--collect", code=2)
    assert (
        found.count("\n") == 1 and "1 of 3 runs have not finished (Pressure = 34 MPa)" in found and "the tasks 2 of the array job" in found
    ), found
    assert [row["state"] for row in table_of(job)] == ["finished", "missing", "finished"]
    assert "#SBATCH --array=2\n" in sweep(*words, "--submit", "slurm")
    shutil.copytree(out / "Pressure-34MPa", job / "Pressure-34MPa")
    sweep(*words, "--collect")
    assert [row["penetration.depth"] for row in table_of(job)] == [row["penetration.depth"] for row in table_of(out)]
    found = sweep(*words, "--submit", "slurm", code=1)
    assert "all runs have finished, so there is nothing to submit" in found, found


BAD = [  # words behind the deck, exit code, sentence
    ([], 1, "sweep needs what to vary"),
    (["--vary", "Confinement/Presure=1,2 MPa"], 1, "Confinement/Presure is not a known parameter; did you mean 'Pressure'?"),
    (["--vary", "Confinment/Pressure=1,2 MPa"], 1, "Confinment is not a known section; did you mean 'Confinement'?"),
    (["--vary", "Bodies/Rok/Upper={1 mm, 2 mm}"], 1, "the deck has no list Rok in Bodies; did you mean 'Rock'?"),
    (["--vary", "Materials/Sandstone/PEAKI=1,2 MPa"], 1, "did you mean 'PEAKI1'?"),
    (["--vary", "Confinement/Pressure=1,2 mm"], 1, "has the unit of a length ('mm'), but a stress is expected here"),
    (["--vary", "Confinement/Pressure=1,2 parsec"], 1, "has an unknown unit 'parsec'"),
    (["--vary", "Confinement/Pressure=1,-2 MPa"], 1, "Confinement/Pressure = -2 MPa is out of bounds"),
    (["--vary", "Confinement/Pressure="], 1, "has an empty value"),
    (["--vary", "Confinement/Pressure=1 MPa,1000 kPa"], 1, "make the same run (the values that take effect are equal)"),
    ([*TWO, "--jobs", "-1"], 1, "--jobs -1 is not a number of runs at a time"),
    ([*TWO, "--set", "Confinement/Pressure=1 MPa"], 1, "varies what --set or --fidelity fixes"),
    ([*TWO, "--fidelity", "best"], 1, "best"),
    ([*TWO, "--only", "3"], 1, "--only 3 is not the number of a run (1 to 2)"),
    ([*TWO, "--submit"], 1, "--submit does not say which batch system; write --submit slurm."),
    ([*TWO, "--submit", "pbs"], 1, "--submit pbs is not a batch system that scripts are written for; write --submit slurm."),
    ([*TWO, "--collect"], 2, "none of the runs has finished"),
]


def check_bad_words(folder):
    for words, code, said in BAD:
        out = folder / "nothing"
        found = sweep(QUICK, *words, "--out", out, code=code)
        assert found.count("\n") == 1 and found.startswith("barreno: ") and said in found, f"{words}: {found}"
        assert not out.exists(), f"{words} leaves {list(out.rglob('*'))}"
    held = folder / "held"
    held.mkdir()
    (held / "thesis.tex").write_text("")
    found = sweep(QUICK, *TWO, "--out", held, code=2)
    assert found.count("\n") == 1 and "holds something else (thesis.tex, and no sweep.json); name another folder." in found, found
    found = sweep(QUICK, *TWO, "--out", held / "thesis.tex" / "x", code=2)
    assert found.count("\n") == 1 and "cannot be made" in found, found
    found = sweep(folder / "nowhere.xml", *TWO, code=2)
    assert "nowhere.xml does not exist (needed as the deck)" in found, found
    found = sweep(QUICK, *TWO, code=2, BARRENO_PROGRAM=str(folder / "nowhere"))
    assert "cannot be started" in found and found.count("\n") == 1, found


def check_compare(out, folder):
    """Two runs of the sweep: their pressures, and differences of their results."""
    first, second = (out / f"Pressure-{value}MPa" for value in (0, 69))
    said = said_by("barreno.compare", first, second, "--out", folder / "compared")
    assert "Confinement/Pressure" in said and "penetration.depth" in said and "difference" in said, said
    (row,) = [row for row in table_of(folder / "compared", "differences.csv") if row["quantity"] == "penetration.depth"]
    depths = [json.loads((run / "summary.json").read_text())["penetration"]["depth"] for run in (first, second)]
    assert float(row["Pressure-69MPa difference"]) == depths[1] - depths[0] and abs(float(row["Pressure-69MPa percent"])
        - 100.0 * (depths[1] / depths[0] - 1.0)) < 1e-9, row
    (probed,) = [line.split() for line in said.splitlines() if line.split()[:1] == ["penetration.probed_depth"]]
    widths = [json.loads((run / "summary.json").read_text())["penetration"]["probed_depth"] for run in (first, second)]
    assert [float(cell) for cell in probed[1:3]] == [float(f"{width:.6g}") for width in widths], (probed, widths)
    assert all((folder / "compared" / name).read_bytes()[:4] == b"\x89PNG" for name in ("depth.png", "channels.png"))
    copy = folder / "elsewhere" / "copy"  # a finished run beside a sweep would be taken
    shutil.copytree(first, copy)
    (copy / "particles.e").write_bytes((copy / "particles.e").read_bytes()[:5000])
    said = said_by("barreno.compare", first, copy, "--out", folder / "compared")
    assert "The decks are the same." in said and "channels.png lacks copy, because" in said, said


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_bad_words(folder)
        out = check_sweep(folder)
        check_compare(out, folder)
        check_interruption(folder)
        check_array_job(out, folder)
        check_reuse(out)
        check_failure(folder)
        check_two_parameters(folder)
    print("barreno sweep and barreno compare do as their page says")


if __name__ == "__main__":
    main()
