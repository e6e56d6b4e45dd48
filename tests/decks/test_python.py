#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package barreno from Python: examples of docs/python.md, frames and fields against the files of a real run, decks and materials
against the program, and what is said of folders that are cut, of another version or under way.

    test_python.py BARRENO
"""
import concurrent.futures
import contextlib
import doctest
import inspect
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest.mock
import warnings

import numpy as np

try:
    import pandas
    import xarray  # noqa: F401
except ModuleNotFoundError as error:
    print(f"skipped: Python lacks {error.name} (apt-get install python3-pandas python3-xarray)")
    sys.exit(77)

import barreno
from barreno.interface.squares import mean_on_squares
from barreno.interface.units import unit_of_column
from barreno.report.particles import ParticleFile
from refusals import refused
from tools.runs import DECKS, mpi_environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
QUICK = DECKS / "perforation_quick.xml"
SHORT = {"Time/End Time": "6 us", "Output/Field Interval": "2 us"}
LONGEST_IMPORT = 0.3  # s
AS_OF_A_DICTIONARY = {f"Deck.{name}" for name in ("get", "pop", "setdefault", "update")}
HEAVY = ("numpy", "pandas", "xarray", "netCDF4", "scipy", "matplotlib")


def check_import():
    """Quick, because it loads nothing; the best of several, since the machine may be busy."""
    program = (
        "import time; begin = time.perf_counter(); import barreno; took = time.perf_counter() - begin; "
        f"import sys; print(took, *(set({HEAVY}) & set(sys.modules)))"
    )
    said = [subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split() for _ in range(5)]
    assert min(float(words[0]) for words in said) < LONGEST_IMPORT and all(len(words) == 1 for words in said), said
    assert set(barreno.__all__) <= set(dir(barreno))
    refused(lambda: barreno.hello, "no attribute 'hello'", "open", kind=AttributeError)


def documented():
    """{name: callable} of what `import barreno` offers, with the methods of its classes."""
    found = {}
    for name in barreno.__all__:
        one = getattr(barreno, name)
        found[name] = one
        methods = vars(one) if isinstance(one, type) and not issubclass(one, Exception) else {}
        found |= {f"{name}.{method}": getattr(one, method) for method in methods if not method.startswith("_")}
    return found


def check_docstrings():
    """As numpydoc has them, with all parameters."""
    for name, one in documented().items():
        assert one.__doc__ and one.__doc__.strip(), f"{name} has no docstring"
        if not callable(one) or name in AS_OF_A_DICTIONARY:
            continue
        parameters = one.__doc__.partition("Parameters\n")[2].partition("Returns\n")[0]
        named = {word.strip() for line in parameters.splitlines() if " : " in line for word in line.partition(" : ")[0].split(",")}
        missing = {word for word in inspect.signature(one).parameters if word != "self"} - named
        assert not missing, f"{name} does not say what {', '.join(sorted(missing))} is"


def check_bare_python(run):
    """One sentence that names the package, from a Python without any."""
    for program, package in ((f"barreno.open({str(run.folder)!r}).depth", "pandas"), (f"barreno.open({str(run.folder)!r}).hole", "numpy"),
            ("barreno.Material('copper')", "numpy")):
        words = f"import barreno\ntry: {program}\nexcept barreno.Fault as fault: print(fault)"
        result = subprocess.run([sys.executable, "-S", "-c", words], capture_output=True, text=True, check=False)
        said = result.stdout
        assert said.startswith(f"Python lacks {package} (") and f"python3-{package}" in said and said.count("\n") == 1, said + result.stderr


def check_examples(folder):
    """Those of the page, from a folder as a user has it."""
    folder = folder / "examples"
    folder.mkdir()
    (folder / "input_xml").symlink_to(DECKS)
    with contextlib.chdir(folder):
        page = str(ROOT / "docs" / "python.md")
        failed, tried = doctest.testfile(page, module_relative=False, optionflags=doctest.NORMALIZE_WHITESPACE)
        assert tried > 30 and failed == 0, f"{failed} of {tried} examples"


def check_frames(run):
    """Against the files, read by NumPy."""
    for frame, name in ((run.depth, "depth.csv"), (run.history, "history.csv")):
        file = run.folder / name
        comments = sum(line.startswith("#") for line in file.read_text().splitlines())
        values = np.loadtxt(file, delimiter=",", skiprows=comments + 1)
        assert np.array_equal(frame.to_numpy(float), values) and frame.attrs["units"].keys() == set(frame.columns), name
    assert run.summary == json.loads((run.folder / "summary.json").read_text())
    refused(lambda: run.table("radii.csv"), "has no table radii.csv", "depth.csv, history.csv")


def check_units():
    """Units of columns are those of docs/output.md."""
    page = (ROOT / "docs" / "output.md").read_text()
    seen = 0
    for part in re.findall(r"<!-- words of (?:depth|history|radii|cavities)\.csv -->\n(.*?)<!-- end of words -->", page, re.DOTALL):
        for names, unit in re.findall(r"^\| (`[^|]*`) \| ([^|]+) \|", part, re.MULTILINE):
            first, *more = re.findall(r"`([^`]+)`", names)
            for name in [first, *(first[: -len(one)] + one if one.startswith("_") else one for one in more)]:
                assert unit_of_column(name.replace("NAME", "Ball")) == unit, f"{name}: {unit_of_column(name)}, not {unit}"
                seen += 1
    assert seen > 50, seen


def check_particles(run):
    """Against the file itself."""
    file = ParticleFile(run.folder / "particles.e")
    with contextlib.closing(file):
        frame = file.frame(2)
        found = run.particles(4e-6)
        assert found.attrs["time"] == frame.time and np.array_equal(found[["x", "y"]], frame.centres)
        assert np.array_equal(found["pressure"], frame.of_alive(["pressure"]), equal_nan=True)
        assert np.array_equal(found.index, file.numbers[frame.alive])
        assert [file.block_names[i] for i in frame.block] == found["material"].tolist()
        assert set(run.fields) == set(found.columns) - {"material", "x", "y"} and found.attrs["units"]["stress_xx"] == "Pa"
    speed = run.particles("4 us", "speed")["speed"]
    assert np.allclose(speed, np.hypot(found["velocity_x"], found["velocity_y"]), rtol=1e-15)
    assert len(run.particles()) == len(run.particles("6 us"))
    refused(lambda: run.particles("3 us"), "no output at 3 us", "2 us and 4 us")
    refused(lambda: run.particles(1.0), "the nearest are at 4 us and 6 us")
    refused(lambda: run.particles("soon"), "'soon' is not a time")
    refused(lambda: run.particles(fields=["Plastic Strain"]), '"Plastic Strain" is not a field', "plastic_strain")


def lattice(count, turn):
    """Parallelograms that fill the unit square but for the shear: corners of count x count."""
    edges = np.linspace(0.0, 1.0, count + 1)
    low, high = np.meshgrid(edges[:-1], edges[:-1]), np.meshgrid(edges[1:], edges[1:])
    corners = np.stack([np.stack([low[0], low[1]], -1), np.stack([high[0], low[1]], -1), np.stack([high[0], high[1]], -1),
        np.stack([low[0], high[1]], -1)], axis=2).reshape(-1, 4, 2)
    return corners + turn * corners[:, :, ::-1] * [1.0, 0.0]


def check_grid(run):
    """Exact for squares that particles fill: means of a linear field; a shear keeps the integral of any field."""
    shapes = lattice(8, 0.0)
    x, y, means = mean_on_squares(shapes, 3.0 * shapes.mean(axis=1)[:, 0] - shapes.mean(axis=1)[:, 1], 0.25)
    assert np.allclose(means, 3.0 * x - y[:, None], atol=1e-13) and np.allclose(x, [0.125, 0.375, 0.625, 0.875]), means
    shapes, values = lattice(16, 0.4), np.random.default_rng(1).random(256)
    values[::7] = np.nan
    _, _, means = mean_on_squares(shapes, np.where(np.isnan(values), np.nan, 2.0), 0.1)
    assert np.nanmin(means) == np.nanmax(means) == 2.0 and np.isnan(means).any()
    grid = run.grid("pressure", "6 us", spacing=4e-3)
    assert grid.dims == ("y", "x") and grid.attrs["units"] == "Pa" and np.isclose(np.diff(grid.x).mean(), 4e-3)
    assert np.isclose(run.grid("speed").x.diff("x").mean(), 2e-3)
    with unittest.mock.patch.dict(sys.modules, {"xarray": None}):
        plain = run.grid("pressure", "6 us", spacing=4e-3)
    assert np.array_equal(plain["values"], grid.to_numpy(), equal_nan=True) and np.array_equal(plain["x"], grid.x)
    for spacing in (0.0, -1.0, "1 mm", float("nan")):
        refused(lambda: run.grid("pressure", spacing=spacing), "is not a length above 0")  # noqa: B023
    refused(lambda: run.grid("pressure", spacing=1e-9), "more than 2e+07 squares", "choose a larger one")
    assert abs(run.hole.length - run.depth["channel_depth"].iloc[-1]) < 4e-3, run.hole.length


def copy_of(run, folder, name):
    return pathlib.Path(shutil.copytree(run.folder, folder / name))


def check_bad_folders(run, folder):
    refused(lambda: barreno.open(folder / "nowhere"), "is not a folder")
    (folder / "empty").mkdir()
    refused(lambda: barreno.open(folder / "empty"), "is not the folder of a run", "deck.xml")
    cut = copy_of(run, folder, "cut")
    data = (cut / "particles.e").read_bytes()
    for part in (0.001, 0.5, 0.99):
        (cut / "particles.e").write_bytes(data[: int(part * len(data))])
        refused(barreno.open(cut).particles, "cannot read", "particles.e", "make the run again")
    (cut / "particles.e").unlink()
    refused(barreno.open(cut).particles, "cannot read", "particles.e")
    rows, text = len(run.depth), (cut / "depth.csv").read_text()
    (cut / "depth.csv").write_text(text[:-9])
    assert len(barreno.open(cut).depth) == rows - 1, "a last line that was cut off is left out"
    (cut / "depth.csv").write_text(text.replace(text.splitlines()[-2].split(",")[1], "deep"))
    refused(lambda: barreno.open(cut).depth, "depth.csv has something that is not a number in the column 'depth'")
    (cut / "depth.csv").unlink()
    os.mkfifo(cut / "depth.csv")
    refused(lambda: barreno.open(cut).depth, "a named pipe")
    (cut / "summary.json").write_text("{")
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        opened = barreno.open(cut)
    assert len(said) == 1 and "summary.json cannot be read" in str(said[0].message), said
    assert not opened.finished and len(opened.history) > 1
    refused(lambda: opened.summary, "summary.json cannot be read")
    refused(lambda: barreno.open(None), "None is not a path", "barreno.open(")
    (cut / "summary.json").unlink()
    refused(lambda: barreno.open(cut).summary, "has no summary.json yet", "was stopped before its end", "barreno resume")
    other = copy_of(run, folder, "other")
    (other / "summary.json").write_text(json.dumps({**run.summary, "version": "9.1.0"}))
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        assert barreno.open(other).finished
    assert len(said) == 1 and "was made by Barreno 9.1.0, and this is" in str(said[0].message) and said[0].filename == __file__, said


def between_outputs(call):
    """While the program writes particles.e, a reader is told to try again."""
    for _ in range(200):
        try:
            return call()
        except barreno.Fault as fault:
            assert "is under way, so try again" in str(fault), fault
            time.sleep(0.05)
    raise AssertionError("the file is never whole")


def check_running(binary, folder):
    """A run under way: its tables and particles are there, its summary is not."""
    out = folder / "under way"
    words = [binary, "run", QUICK, "--set", "Time/End Time=400 us", "--set", "Output/Field Interval=1 us", "--out", out]
    child = subprocess.Popen(words, env=mpi_environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        end = time.monotonic() + 120.0
        while not ((out / "history.csv").exists() and len((out / "history.csv").read_text().splitlines()) > 8):
            assert child.poll() is None and time.monotonic() < end, "the run has not begun"
            time.sleep(0.05)
        run = barreno.open(out)
        assert run.running and not run.finished and "running" in repr(run)
        assert len(run.history) > 3 and len(between_outputs(lambda: run.particles("1 us", ["pressure"]))) > 1000
        refused(lambda: run.summary, "its run is under way", "%")
    finally:
        child.kill()
        child.wait()
    assert not run.running and "not finished" in repr(run)
    refused(lambda: run.summary, "was stopped before its end")


def check_interrupt(folder):
    """Ctrl-C ends a run behind a checkpoint, and the script with it."""
    out = folder / "interrupted"
    program = f"import barreno; barreno.run({str(QUICK)!r}, {{'Time/End Time': '400 us'}}, ranks=2, out={str(out)!r})"
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    seen = []
    for line in child.stdout:
        seen.append(line)
        if " %  t " in line and "step 0 " not in line:
            break
    child.send_signal(signal.SIGINT)
    _, errors = child.communicate(timeout=200)
    assert child.returncode != 0 and "KeyboardInterrupt" in errors and "Barreno 0" in seen[0], f"{seen[:1]} {errors}"
    run = barreno.open(out)
    assert (out / "checkpoint.h5").exists() and not run.running and not run.finished, sorted(file.name for file in out.iterdir())


def check_runs(folder):
    """The program's sentences and exit codes; a run that is there is not overwritten unless that is said."""
    refused(lambda: barreno.run(folder / "nowhere.xml"), "does not exist (needed as the deck)")
    refused(lambda: barreno.run(QUICK, {"Time/End Tim": "1 us"}, progress=False), "did you mean 'End Time'?")
    refused(lambda: barreno.run(QUICK, "Time/End Time=1 us", progress=False), "is not a dictionary", '{"Time/End Time": "30 us"}')
    refused(lambda: barreno.run(QUICK, SHORT, out=folder / "run", progress=False), "already holds a result")
    refused(lambda: barreno.run(QUICK, ranks=0), "ranks=0 is not a number of ranks", "write for example ranks=2")
    refused(lambda: barreno.run(QUICK, fidelity="exact", progress=False), "exact")
    with unittest.mock.patch.dict(os.environ, {"BARRENO_PROGRAM": str(folder / "no program")}):
        refused(lambda: barreno.check(QUICK), "cannot be started", "BARRENO_PROGRAM")
    with contextlib.chdir(folder):
        first = barreno.run(QUICK, {"Time/End Time": "0.2 us", "Jet": None}, ranks=2, progress=False)
        assert str(first.folder) == "runs/perforation_quick-1" and first.summary["ranks"] == 2
        refused(lambda: first.depth, "has no table depth.csv")
        refused(lambda: first.hole, "has no jet")


def check_decks(folder):
    """Every shipped deck keeps its meaning as dictionaries and back in a file elsewhere."""
    for file in ("perforation_quick.xml", "terzaghi.xml", "sliding_block.xml"):
        deck = barreno.Deck.read(DECKS / file)
        deck.write(folder / file)
        whole = barreno.check(DECKS / file)
        assert barreno.check(folder / file) == whole == deck.check() and whole["Schema Version"] == 1, file
    deck = barreno.Deck({"Time/x": 1}, name="mine.xml")
    deck["A/B"] = 2
    deck.update({"D/E/F": 1}, G=2)
    assert deck.pop("D/E/F") == 1 and deck.pop("D/E/F", 5) == 5 and deck.setdefault("D/E/F", 6) == 6 == deck.setdefault("D/E/F", 7), deck
    assert deck.pop("D") == {"E": {"F": 6}} and deck.pop("G") == 2 and "D" not in deck, deck
    refused(lambda: deck.pop("A/C"), "mine.xml has no 'A/C'", kind=KeyError)
    assert deck["A"] == {"B": 2} and "A/B" in deck and "A/C" not in deck and deck.get("A/C", 3) == 3
    refused(lambda: deck["A/b"], "mine.xml has no 'A/b'", "did you mean 'B'?", kind=KeyError)
    refused(lambda: deck["C/B"], "has no list 'C'", kind=KeyError)
    refused(deck.check, "mine.xml: ")
    deck["A/B"] = object()
    refused(deck.text, "mine.xml has a value that no deck can hold")
    refused(lambda: barreno.Deck.read(folder / "nowhere.xml"), "does not exist (needed as the deck)")
    (folder / "bad.xml").write_text("<ParameterList>")
    refused(lambda: barreno.Deck.read(folder / "bad.xml"), "cannot be read as a deck")


def check_sweep(folder):
    deck = barreno.Deck.read(QUICK)
    deck["Time/End Time"] = "1 us"
    out = folder / "sweep"
    table = barreno.sweep(deck, {"Confinement/Pressure": ["0 MPa", "34 MPa"]}, out=out, jobs=2, progress=False)
    depths = [json.loads((pathlib.Path(run) / "summary.json").read_text())["penetration"]["depth"] for run in table["run"]]
    assert table["penetration.depth"].tolist() == depths and table["Confinement/Pressure [MPa]"].tolist() == [0, 34], table.columns
    units = table.attrs["units"]
    assert units["Confinement/Pressure [MPa]"] == "MPa" and units["penetration.depth"] == "SI" and "state" not in units, units
    named = {json.loads((pathlib.Path(run) / "summary.json").read_text())["deck"] for run in table["run"]}
    assert named == {QUICK.name}, f"of a deck of dictionaries: {named}"
    with concurrent.futures.ThreadPoolExecutor(1) as other:  # as a window's worker; finished runs are taken
        again = other.submit(barreno.sweep, deck, {"Confinement/Pressure": "0,34 MPa"}, out=out, progress=False).result()
    assert again["penetration.depth"].tolist() == depths
    refused(lambda: barreno.sweep(deck, {"Confinement/Pressur": "0,34 MPa"}, out=out, progress=False), "Pressur")
    refused(lambda: barreno.sweep(deck, {}, out=out), "sweep needs what to vary")
    refused(lambda: barreno.sweep(deck, "Confinement/Pressure=1"), "vary is not a dictionary")
    refused(lambda: barreno.sweep(deck, {"Confinement/Pressure": 34e6}, set=["Time/End Time=1 us"], out=out), "is not a dictionary")
    one = barreno.sweep(deck, {"Confinement/Pressure": 34e6}, out=folder / "one", progress=False)
    assert one["penetration.depth"].tolist() == depths[1:], one


def check_uncertainty(folder):
    """Frames against uncertainty.json and the summaries; the sentences are the command's."""
    out, vary = folder / "study", {"Jet/Velocity": (0.9, 1.1), "Materials/Steel/A": "500..1500 MPa"}
    short = {"Time/End Time": "1 us"}
    study = barreno.uncertainty(QUICK, vary, short, runs=6, seed=2, out=out, quantities="balances.energy.plastic", progress=False)
    record = json.loads((out / "uncertainty.json").read_text())
    depth = record["answers"]["penetration.depth"]
    assert study.answers == list(record["answers"]) and study.sentence == record["answers"][study.answers[0]]["sentence"]
    row = study.intervals.loc["penetration.depth"]
    assert [row[name] for name in ("5 %", "median", "95 %", "least")] == [depth["ranges"][name] for name in ("low", "median", "high")] + [
        depth["least"]], row
    cells = depth["with_cells"]
    assert [row[f"{name} with cells"] for name in ("5 %", "95 %")] == [cells["low"], cells["high"]] if cells else np.isnan(
        row["95 % with cells"]), row
    units = study.intervals.attrs["units"]
    assert units["penetration.depth"] == "m" and units["balances.energy.plastic"] == "SI", units
    assert np.allclose(study.shares.sum(), 1.0) and list(study.shares.index) == [*vary, "interaction and scatter"], study.shares
    effects = study.effects("penetration.depth")
    assert effects.index[0] == "Jet/Velocity" and effects.loc["Jet/Velocity", "at_high"] > 0.0, effects
    assert effects["share"].to_dict() == study.shares["penetration.depth"].drop("interaction and scatter").to_dict()
    depths = [json.loads((pathlib.Path(run) / "summary.json").read_text())["penetration"]["depth"] for run in study.runs["run"]]
    assert study.runs["penetration.depth"].tolist() == depths and len(set(depths)) == 6
    assert study.runs.attrs["units"]["Jet/Velocity"] == "SI"
    assert study.ranges.loc["Materials/Steel/A", ["low", "high"]].tolist() == [5e8, 1.5e9], study.ranges
    single = barreno.uncertainty(QUICK, {"Materials/Steel/A": "500..1500 MPa"}, short, design="one-at-a-time", out=folder / "single",
        progress=False)
    assert list(single.shares.index) == ["Materials/Steel/A"] and single.intervals["foretold"].isna().all(), single.intervals
    for call in (barreno.sweep, barreno.uncertainty):
        refused(lambda call=call: call(QUICK, {"Jet/Velocity": "0.9..1.1"}, flow="up", out=out), "--flow up does not say where the fluid")
    refused(lambda: study.effects("depth"), '"depth" is not an answer of', "penetration.depth")
    refused(lambda: barreno.uncertainty(QUICK, "Jet/Velocity=1..2"), "vary is not a dictionary")
    refused(lambda: barreno.uncertainty(QUICK, {"Jet/Velocity": 1.1}), "vary of Jet/Velocity is 1.1, which is no range")
    refused(lambda: barreno.uncertainty(QUICK, {"Jet/Velocity": (1.1, 0.9)}, out=out), "is an empty range")
    refused(lambda: barreno.uncertainty(QUICK, vary, short, runs=4, out=out), "--runs 4 is too few for 2 ranges")
    refused(lambda: barreno.uncertainty(QUICK, vary, hold="Jett", out=out), "--hold Jett names nothing that is varied")
    refused(lambda: barreno.uncertainty(QUICK, vary, out=out, progress=False), "holds a study of another deck")
    few = {**short, "Materials/Tungsten/Bad Particles": "stop"}
    refused(lambda: barreno.uncertainty(QUICK, {"Step/Largest Expansion": "1.001..100"}, few, design="one-at-a-time", out=folder / "few",
        progress=False), "too few runs of the study")
    refused(lambda: barreno.uncertainty(QUICK, {"Materials/Steel/A": "500..501 MPa"}, {"Time/End Time": "0.1 us"}, runs=4, seed=2,
        out=folder / "before", progress=False), "no answer of the study in", "depth")


def check_material(binary, folder):
    rock = barreno.Material("berea_sandstone")
    path, out = DECKS / "paths" / "triaxial_berea.csv", folder / "answer.csv"
    subprocess.run([binary, "drive", "--material", "berea_sandstone", "--path", path, "--out", out, "--steps-per-row", "4", "--set",
        "PEAKI1=12 MPa"], env=mpi_environment(), check=True, capture_output=True)
    answer = rock.drive(path, steps_per_row=4, set={"PEAKI1": "12 MPa"})
    assert answer.equals(pandas.read_csv(out, skiprows=1, float_precision="round_trip")) and len(answer) > 3
    columns = {"time": [0, 1, 2], "strain_xx": [0, np.nan, -0.01], "stress_xx": [np.nan, -40e6, np.nan], "stress_yy": [0, -40e6, -40e6],
        "stress_zz": [0, -40e6, -40e6]}
    stress = rock.drive(columns, steps_per_row=20)
    assert np.allclose(stress[["stress_yy", "stress_zz"]].iloc[-1], -40e6, rtol=1e-5) and stress["stress_xx"].iloc[-1] < -40e6, stress
    assert len(rock.drive(columns, 20, every_step=True)) == 41
    units = stress.attrs["units"]
    assert units["time"] == "s" and units["stress_xx"] == "Pa" and units["strain_zx"] == "-" and "porosity" not in units, units
    refused(lambda: barreno.Material("nowhere"), "nowhere")
    refused(lambda: rock.update(np.zeros((1, 5)), *rock.virgin(1)), "strain has the shape (1, 5); (1, 6) is needed")
    refused(lambda: rock.drive(folder / "nowhere.csv"), "does not exist (needed as a path)")
    refused(lambda: rock.drive({"time": [0, 1], "F11": ["a", "b"]}), "path.csv")
    refused(lambda: rock.drive({"time": [0, 1], "F11": [1.0, 0.99, 0.98]}), "are no table", "the same number of rows")
    refused(lambda: rock.drive(columns, set="PEAKI1=12 MPa"), "set='PEAKI1=12 MPa' is not a dictionary", "PEAKI1")


def main():
    binary = pathlib.Path(sys.argv[1]).resolve()
    os.environ["BARRENO_PROGRAM"] = str(binary)
    os.environ.setdefault("BARRENO_LIBRARY", str(binary.parents[1] / "materials" / "libBARRENO.so"))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        run = barreno.run(QUICK, SHORT, ranks=1, out=folder / "run", progress=False)
        for check in (check_import, check_docstrings, lambda: check_bare_python(run), lambda: check_frames(run), check_units,
                lambda: check_particles(run), lambda: check_grid(run), lambda: check_bad_folders(run, folder),
                lambda: check_running(binary, folder), lambda: check_interrupt(folder), lambda: check_runs(folder),
                lambda: check_decks(folder), lambda: check_sweep(folder), lambda: check_uncertainty(folder),
                lambda: check_material(binary, folder), lambda: check_examples(folder)):
            check()
    print("the package does as docs/python.md says")


if __name__ == "__main__":
    main()
