#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno uncertainty` from the outside: what it writes of real runs, against numbers made anew from their summaries; that a study
which was stopped goes on; both designs; ranges of a card; runs that fail; and a sentence for every bad input.

    test_uncertainty.py BARRENO
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest.mock

import numpy

import barreno
from barreno.runs.csv_table import WORDS, read_csv
from barreno.runs.effective_deck import value_in
from barreno.runs.program import found_program
from barreno.runs.run_folder import deck_in
from barreno.uncertainties.known import find_card
from python_commands import environment_of_runs, process_of, said_by
from tools.runs import DECKS

QUICK = DECKS / "perforation_quick.xml"
CARDS = DECKS.parent / "materials" / "cards"
TARGET = ("--set", "Grid/Upper={80 mm, 90 mm}", "--set", "Bodies/Rock/Upper={50.8 mm, 72.7 mm}")
SHORT = (*TARGET, "--set", "Time/End Time=2 us")
RANGES = ("--vary", "Jet/Velocity=0.9..1.1", "--vary", "Materials/Steel/A=500..1500 MPa")
DEPTH, EFFICIENCY = "penetration.depth", "flow.core_flow_efficiency"


def uncertainty(*words, **more):
    return said_by("barreno.uncertainties", *words, **more)


def record_of(out):
    return json.loads((out / "uncertainty.json").read_text())


def how_of(out):
    return [run["how"] for run in record_of(out)["runs"]]


def summaries(out):
    return [json.loads((pathlib.Path(run["folder"]) / "summary.json").read_text()) for run in record_of(out)["runs"]]


def wait_for(condition, what):
    until = time.monotonic() + 120
    while not condition():
        assert time.monotonic() < until, f"waited in vain for {what}"
        time.sleep(0.02)


def check_stopped(folder):
    """A signal ends the runs; the same command goes on, and leaves what a study in one go would."""
    out = folder / "study"
    words = (QUICK, *SHORT, *RANGES, "--runs", "6", "--jobs", "1", "--out", out)
    with subprocess.Popen(**process_of("barreno.uncertainties", *words), stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        wait_for(lambda: list(out.glob("run-02-*/run.log")), "the second run")
        os.kill(child.pid, signal.SIGINT)
        _, said = child.communicate(timeout=60)
    assert child.returncode == 130 and "of 6 runs finished; the same command continues" in said and said.count("\n") == 1, said
    assert "answers" not in record_of(out) and not (out / "tornado.png").exists()
    said = uncertainty(*words)
    assert how_of(out)[0] == "reused" and set(how_of(out)[2:]) == {"computed"}, how_of(out)
    names = sorted(file.name for file in out.iterdir() if not file.name.startswith("run-"))
    assert names == ["inputs", "ranges.csv", "tornado.png", "uncertainty.csv", "uncertainty.json"], names
    assert (out / "tornado.png").read_bytes()[:4] == b"\x89PNG"
    return out, said


def check_numbers(out, said):
    """Effects, shares and interval, from the summaries and the decks of the runs alone."""
    record, found = record_of(out), summaries(out)
    depths = numpy.array([summary["penetration"]["depth"] for summary in found])
    velocity = [float(value_in(deck_in(pathlib.Path(run["folder"])), "Jet/Slugs").partition("{")[2].split(",")[1]) / 7830.0
        for run in record["runs"]]
    strength = [float(value_in(deck_in(pathlib.Path(run["folder"])), "Materials/Steel/A")) for run in record["runs"]]
    assert len(set(velocity)) == len(set(strength)) == 6 and 0.9 < min(velocity) and max(velocity) < 1.1, velocity
    magnitude = numpy.log(numpy.array(strength) / 5e8) / numpy.log(3.0)
    z = numpy.column_stack([numpy.ones(6), (numpy.array(velocity) - 1.0) / 0.1, 2.0 * magnitude - 1.0])
    b, rest, *_ = numpy.linalg.lstsq(z, depths, rcond=None)
    answer = record["answers"][DEPTH]
    effects = answer["ranges"]["effects"]
    assert list(effects) == ["Jet/Velocity", "Materials/Steel/A"] and record["ranges"][1]["drawn_in_logarithm"], effects
    assert numpy.allclose([one["at_high"] for one in effects.values()], b[1:], rtol=1e-3, atol=1e-7), (effects, b)
    shares = [one["share"] for one in effects.values()]
    assert abs(sum(shares) + answer["ranges"]["rest"] - 1.0) < 1e-9 and shares[0] > 0.9, shares
    spread = answer["ranges"]
    assert spread["low"] < min(depths) + 0.1 * b[1] and spread["high"] > max(depths) - 0.1 * b[1], spread
    assert answer["largest"] == max(depths) and answer["least"] == min(depths)
    near_even = 0.9 * b[1]  # a single even range
    assert abs(0.5 * (spread["high"] - spread["low"]) - near_even) < 0.15 * near_even, (spread, b)
    errors = [summary["penetration"]["depth_error"] for summary in found]
    assert all("value" in error for error in errors) and answer["cells_unknown"] == ""
    assert answer["with_cells"]["high"] > max(depths / (1.0 + max(error["low"] for error in errors))) - 0.2 * b[1] > spread["high"]
    (sentence,) = [line for line in said.splitlines() if line.startswith("Depth ")]
    assert sentence == answer["sentence"] and "at 90 %" in sentence and "from Jet/Velocity" in sentence, sentence
    table = read_csv(out / "uncertainty.csv", cells=WORDS).to_dict("records")
    assert [float(row[DEPTH]) for row in table] == list(depths)
    named = {row["deck"] for row, how in zip(table, how_of(out)) if how != "resumed"}  # a resumed run names the deck in its folder
    assert named == {"perforation_quick.xml"}, named
    assert [float(row["Materials/Steel/A"]) for row in table] == strength


def check_goes_on(out):
    """Other ranges take what is there; another deck is left alone; the ranges come back as a file."""
    before = {file: file.stat().st_mtime_ns for file in out.glob("run-*/summary.json")}
    said = uncertainty(QUICK, *SHORT, "--ranges", out / "ranges.csv", "--runs", "6", "--out", out)
    assert set(how_of(out)) == {"reused"} and {file: file.stat().st_mtime_ns for file in before} == before, said
    found = uncertainty(QUICK, *TARGET, "--set", "Time/End Time=3 us", *RANGES, "--runs", "6", "--out", out, code=2)
    assert "holds a study of another deck" in found and found.count("\n") == 1, found
    strange = out.parent / "strange"
    strange.mkdir()
    (strange / "a.txt").write_text("")
    found = uncertainty(QUICK, *SHORT, *RANGES, "--out", strange, code=2)
    assert "holds something else (a.txt, and no uncertainty.json)" in found, found
    assert [file.name for file in strange.iterdir()] == ["a.txt"]


def check_one_at_a_time(folder):
    """The deck as it is, then both ends of each range; without a factor of the jet no other decks are written."""
    out = folder / "single"
    both = ("--vary", "Materials/Steel/Density=7000..9000", "--vary", "Materials/Steel/A=500..1000 MPa")
    said = uncertainty(QUICK, *SHORT, *both, "--design", "one-at-a-time", "--runs", "5", "--quantity", "balances.energy.plastic",
        "--quantity", "balances.nothing", "--out", out)
    record = record_of(out)
    assert [run["values"] for run in record["runs"]] == [[7830.0, 7.92e8], [7000.0, 7.92e8], [9000.0, 7.92e8], [7830.0, 5e8], [7830.0, 1e9]]
    depths = [summary["penetration"]["depth"] for summary in summaries(out)]
    density, strength = record["answers"][DEPTH]["ranges"]["effects"].values()
    changes = [density["at_low"], density["at_high"], strength["at_low"], strength["at_high"]]
    assert numpy.allclose(changes, numpy.array(depths[1:]) - depths[0])
    assert density["at_low"] > 0.0 > density["at_high"] and record["answers"][DEPTH]["ranges"]["rest"] is None, density
    assert "balances.energy.plastic" in record["answers"] and "balances.nothing is left out: 5 of 5 runs have no such number" in said, said
    assert not (out / "inputs").exists() and "] the middle: depth" in said and "] Steel/A at its high end: depth" in said, said


def check_cards(folder):
    """Both ends of every range that is shipped lie within the bounds of the program, and the moduli that hang together stay so."""
    materials = {"tungsten": "Tungsten", "berea": "Sandstone", "seeberger": "Sandstone", "cement": "Sandstone"}
    for file in sorted((CARDS / "ranges").glob("*.csv")):
        material = next((name for head, name in materials.items() if file.stem.startswith(head)), "Steel")
        others = [f"Materials/{other}" for other in materials.values() if other != material]
        card = ["--set", f"Materials/{material}/Card={file.stem}.xml"]
        card += [word for other in (*others, "Jet", "Confinement") for word in ("--hold", other)]
        found = uncertainty(QUICK, *SHORT, *card, "--runs", "3", "--out", folder / "x", code=1)
        assert "--runs 3 is too few for" in found and found.count("\n") == 1 and not (folder / "x").exists(), f"{file}: {found}"
    out = folder / "tied"
    uncertainty(QUICK, *TARGET, "--set", "Time/End Time=0.2 us", "--vary", "Materials/Sandstone/B0=3..15 GPa", "--runs", "4", "--out", out,
        "--quantity", "balances.energy.elastic")
    for run in record_of(out)["runs"]:
        deck = deck_in(pathlib.Path(run["folder"]))
        b0, g0 = (float(value_in(deck, f"Materials/Sandstone/{name}")) for name in ("B0", "G0"))
        assert abs(g0 / b0 - 1.5 * 0.66 / 1.17) < 1e-6 and 3e9 <= b0 <= 15e9, (b0, g0)
    return out


def check_found_cards(folder):
    """Ranges are looked for beside the card that the program takes: beside the deck, in BARRENO_MATERIALS, shipped. The same letters go
    first, and in the last two their case does not count."""
    beside, listed, later = (folder / name for name in ("beside", "listed", "later"))
    text, density = (CARDS / "steel_4340.xml").read_text(), 7000
    for place, names in ((beside, ("Mine.xml", "plain")), (listed, ("mine.xml", "steel_1018.xml", "OTHER.xml", "twice.XML")),
            (later, ("other.xml", "steel_4340.xml", "Twice.xml"))):
        place.mkdir()
        for name in names:
            density += 1
            (place / name).write_text(re.sub(r'(name="Density"[^>]*value=)"[^"]*"', rf'\1"{density}"', text))
    (beside / "steel_1018").mkdir()
    deck = beside / "deck.xml"
    barreno.Deck.read(QUICK).write(deck)
    found = {}
    folders = f"{folder / 'nowhere'}::{listed}:{later}"
    with unittest.mock.patch.dict(os.environ, {**environment_of_runs(), "BARRENO_MATERIALS": folders}):
        program = found_program("check", 1)
        for card in ("Mine", "Mine.xml", "mine", "MINE.XML", "plain", "steel_1018", "Other", "OTHER", "other.xml", "steel_4340",
                "Steel_4340.xml", "twice", "TWICE", "COPPER", str(listed / "mine")):
            effective = program.effective_deck([str(deck), "--set", f"Materials/Steel/Card={card}"])
            file = find_card(card, deck)
            own = re.search(r'name="Density"[^>]*value="([^"]*)"', file.read_text()).group(1)
            taken = float(value_in(effective, "Materials/Steel/Density"))
            assert taken == float(own), f"{card}: {file}, but the program took that of {taken} kg/m3"
            found[card] = file.relative_to(folder).parts[0] if file.is_relative_to(folder) else "shipped"
        assert find_card("no such card", deck) is None
    assert set(found.values()) == {"beside", "listed", "later", "shipped"} and found["mine"] == "listed" != found["Mine"], found


def check_flow(folder):
    """The core flow efficiency of each run is that of `barreno flow`, an answer of the study and a column of a sweep; a flow that is there
    is taken; a run without a hole in rock is named."""
    out = folder / "flows"
    words = (QUICK, *TARGET, "--set", "Time/End Time=8 us", *RANGES, "--runs", "5", "--flow", "axial", "--out", out)
    said = uncertainty(*words)
    answer, runs = record_of(out)["answers"][EFFICIENCY], [pathlib.Path(run["folder"]) for run in record_of(out)["runs"]]
    found = []
    for run in runs:
        said_by("barreno.flow", run, "--boundary", "axial")
        found.append(json.loads((run / "flow" / "flow.json").read_text())["core_flow_efficiency"])
    rows = read_csv(out / "uncertainty.csv", cells=WORDS).to_dict("records")
    assert [float(row[EFFICIENCY]) for row in rows] == found and len(set(found)) == 5 and 0.0 < min(found) <= max(found) < 1.0, found
    assert (answer["least"], answer["largest"], answer["runs"]) == (min(found), max(found), 5) and answer["ranges"]["low"] >= 0.0, answer
    assert answer["cells_unknown"] == "it was measured for radial flow alone", answer
    assert said.count(": core flow efficiency 0.") == 5 and " core flow efficiency   " in said, said
    kept = runs[0] / "flow_axial.json"
    kept.write_text(kept.read_text().replace(repr(found[0]), "0.125"))
    older = runs[1] / "flow_axial.json"
    older.write_text(older.read_text().replace(repr(found[1]), "0.125"))
    os.utime(older, (0, 0))  # as of a run that was made again
    uncertainty(*words)
    rows = read_csv(out / "uncertainty.csv", cells=WORDS).to_dict("records")
    assert [float(row[EFFICIENCY]) for row in rows] == [0.125, *found[1:]], rows
    said = said_by("barreno.sweeps", QUICK, *TARGET, "--vary", "Time/End Time=1,8 us", "--flow", "axial", "--out", folder / "swept")
    assert "End Time = 1 us has no flow: " in said and "has no hole in its rock" in said and "core flow efficiency" in said, said
    early, late = read_csv(folder / "swept" / "table.csv", cells=WORDS).to_dict("records")
    assert early[EFFICIENCY] == "" and 0.0 < float(late[EFFICIENCY]) < 1.0, (early, late)
    job = (*words[:-1], folder / "flow job")
    script = uncertainty(*job, "--submit", "slurm", BARRENO_COMMAND=f"{sys.executable} -m barreno.uncertainties")
    run_task(script, 2)
    assert len(list((folder / "flow job").glob("run-02-*/flow_axial.json"))) == 1


def check_failure(folder):
    """A run that fails: the others are there, no interval is given where too few are left, and the exit code is its own."""
    out = folder / "failed"
    words = (QUICK, *SHORT, "--set", "Materials/Tungsten/Bad Particles=stop", "--vary", "Step/Largest Expansion=1.001..100", "--design",
        "one-at-a-time", "--runs", "3", "--out", out)
    found = uncertainty(*words, code=3)
    assert "of 3 runs have finished, and 3 are needed for 1 ranges; no interval is given." in found, found
    assert "the run with Step/Largest Expansion at its low end ended with exit code 3" in found, found
    rows = read_csv(out / "uncertainty.csv", cells=WORDS).to_dict("records")
    assert [row["state"] for row in rows][1] == "failed" and "finished" in [row["state"] for row in rows], [row["state"] for row in rows]
    assert "answers" not in record_of(out) and not (out / "tornado.png").exists()


def task(script, number, **more):
    """Of an array job, as Slurm starts it: the script by bash."""
    environment = {**environment_of_runs(), "SLURM_ARRAY_TASK_ID": str(number)}
    return subprocess.Popen(["bash", "-c", script], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)


def run_task(script, number):
    said, errors = task(script, number).communicate(timeout=300)
    assert "[1/1] run " in said and not errors, said + errors


def check_time_limit(folder):
    """Slurm's signal ahead of it ends a task behind a checkpoint, and the task that comes then goes on."""
    out = folder / "limit"
    words = (QUICK, *TARGET, "--set", "Time/End Time=8 us", *RANGES, "--runs", "6", "--out", out)
    script = uncertainty(*words, "--submit", "slurm", BARRENO_COMMAND=f"{sys.executable} -m barreno.uncertainties")
    child = task(script, 1)
    wait_for(lambda: [file for file in out.glob("run-01-*/history.csv") if len(file.read_text().splitlines()) > 5], "the first task")
    child.send_signal(signal.SIGTERM)  # "--signal=B:TERM" sends it to the script, which has become the command
    _, errors = child.communicate(timeout=60)
    assert child.returncode == 143 and "interrupted with 0 of 1 runs finished" in errors and errors.count("\n") == 1, errors
    assert list(out.glob("run-01-*/checkpoint.h5"))
    said, errors = task(script, 1).communicate(timeout=300)
    log = next(out.glob("run-01-*/run.log")).read_text()
    assert "[1/1] run 1: depth" in said and "esum" in log, said + errors + log


def check_array_job(study, folder):
    """The script's tasks, also side by side, and what is collected in between: the study of one go."""
    out = folder / "job"
    words = (QUICK, *SHORT, *RANGES, "--runs", "6", "--out", out)
    found = uncertainty(*words, "--collect", code=2)
    assert "holds no study (no uncertainty.json)" in found and found.count("\n") == 1 and not out.exists(), found
    start = {"BARRENO_COMMAND": f"{sys.executable} -m barreno.uncertainties"}
    script = uncertainty(*words, "--ranks", "2", "--submit", "slurm", **start)
    assert script.startswith("#!/bin/bash\n") and "#SBATCH --array=1-6\n" in script and "#SBATCH --ntasks=2\n" in script, script
    assert sorted(file.name for file in out.iterdir()) == ["inputs", "ranges.csv", "uncertainty.json"]
    found = uncertainty(*words, "--collect", code=2)
    assert found == "barreno: none of the runs has finished; the command without --collect computes them.\n", found
    both = [task(script, number) for number in (1, 2)]  # at the same time
    assert [child.communicate(timeout=300)[1] for child in both] == ["", ""] and [child.returncode for child in both] == [0, 0]
    found = uncertainty(*words, "--collect", code=2)
    assert "2 of 6 runs have finished, and 5 are needed for 2 ranges; no interval is given." in found, found
    assert "4 of 6 runs have not finished (run 3, run 4, run 5 and run 6)" in found and "the tasks 3-6 of the array job" in found, found
    script = uncertainty(*words, "--submit", "slurm", **start)
    assert "#SBATCH --array=3-6\n" in script, script
    for number in (3, 4, 5):
        run_task(script, number)
    said = uncertainty(*words, "--collect", code=2)
    assert "the tasks 6 of the array job" in said and record_of(out)["answers"][DEPTH]["runs"] == 5, said
    rows = read_csv(out / "uncertainty.csv", cells=WORDS).to_dict("records")
    assert [row["state"] for row in rows] == ["finished"] * 5 + ["missing"], rows
    run_task(script, 6)
    uncertainty(*words, "--collect")
    assert record_of(out)["answers"] == record_of(study)["answers"], "not that of one go"
    summary = [json.loads(next(out.glob(f"run-{number:02d}-*/summary.json")).read_text()) for number in (2, 4)]
    assert [one["ranks"] for one in summary] == [2, 1], summary
    found = uncertainty(*words, "--submit", "slurm", code=1)
    assert "all runs have finished, so there is nothing to submit" in found and found.count("\n") == 1, found


BAD = (  # words, exit code, what is said
    (("--vary", "Materials/Sandstone/CR=0.5..1.2"), 1, '--vary "Materials/Sandstone/CR": the end 1.2 of the range is refused'),
    (("--vary", "Materials/Sandstone/CRR=0.5..0.6"), 1, "did you mean 'CR'?"),
    (("--vary", "Materials/Sand/CR=0.5..0.6"), 1, "the deck has no list Sand in Materials; did you mean 'Sandstone'?"),
    (("--vary", "Materials/Sandstone/CR=0.6"), 1, "is not a range (uncertainty draws between two numbers"),
    (("--vary", "Materials/Sandstone/CR=0.6..0.5"), 1, "is an empty range"),
    (("--vary", "Confinement/Pressure=1..2 GPam"), 1, "has an unknown unit 'GPam'"),
    (("--vary", "Jet/Kind=1..2"), 1, 'its value in the deck is "discrete", which is no number'),
    (("--vary", "Jet/Velocity=0..1"), 1, "is no factor of the jet"),
    (("--vary", "Materials/Sandstone/YSLOPE=0.01..0.5", "--vary", "Materials/Sandstone/FSLOPE=0.2..0.6"), 1,
        "the ranges allow a deck that is refused"),
    (("--vary", "Confinement/Pressure=1..2 MPa", "--set", "Confinement/Pressure=1 MPa"), 1, "varies what --set or --fidelity fixes"),
    (("--hold", "Jett"), 1, "--hold Jett names nothing that is varied"),
    (("--hold", "Jet", "--hold", "Materials", "--hold", "Confinement"), 1, "nothing has a range"),
    (("--runs", "9"), 1, "--runs 9 is too few for"),
    (("--set", "Jet=",), 1, "the deck has no jet"),
    (("--ranges", "nowhere.csv"), 2, "nowhere.csv does not exist (needed as --ranges)"),
    ((*RANGES, "--runs", "6", "--only", "7"), 1, "--only 7 is not the number of a run (1 to 6)"),
    (("--flow", "upwards"), 1, "--flow upwards does not say where the fluid comes from; it is one of radial, axial, both."),
    (("--flow", "radial", "--set", "Jet=", "--quantity", "steps"), 1, "--flow radial: the deck has no jet, and so no hole to flow into"),
    (("--submit", "pbs"), 1, "--submit pbs is not a batch system that scripts are written for; write --submit slurm."),
    (("--submit",), 1, "--submit does not say which batch system; write --submit slurm."),
    (("--submit", "slurm", "--collect"), 1, "--submit and --collect exclude each other"),
    (("--varry", "A/B=1..2"), 1, "write for example barreno uncertainty"),
)  # fmt: skip


def check_bad(folder):
    """One sentence, and nothing is written."""
    out = folder / "bad"
    for words, code, said in BAD:
        found = uncertainty(QUICK, *SHORT, *words, "--out", out, code=code)
        assert said in found and found.count("\n") == 1 and found.endswith((".\n", "?\n")) and not out.exists(), f"{words}: {found}"
    assert "does not exist (needed as the deck)" in uncertainty("nowhere.xml", code=2)
    for deck, said in (("perforation_plane_gimp.xml", "the deck is plane strain, and flow is"),
            ("jet_import_kinds.xml", "the deck has no rock with pores")):
        found = uncertainty(DECKS / deck, "--flow", "both", "--out", out, code=1)
        assert f"--flow both: {said}" in found and found.count("\n") == 1 and not out.exists(), found
    file = folder / "ranges.csv"
    file.write_text("parameter,low,high,known,source\nMaterials/Sandstone/FSLOPE,-0.5,0.6,assumed,a guess\n")
    found = uncertainty(QUICK, *SHORT, "--ranges", file, "--out", out, code=1)
    assert f'{file}, "Materials/Sandstone/FSLOPE": the end -0.5 of the range is refused' in found and "out of bounds" in found, found
    assert found.count("\n") == 1 and not out.exists()


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out, said = check_stopped(folder)
        check_numbers(out, said)
        check_goes_on(out)
        check_array_job(out, folder)
        for check in (check_time_limit, check_one_at_a_time, check_cards, check_found_cards, check_flow, check_failure, check_bad):
            check(folder)
    print("barreno uncertainty does as docs/uncertainty.md says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
