#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of `barreno sweep` and `barreno compare` without a run: values and samples, folders, time left, tables of synthetic run
folders."""
import argparse
import contextlib
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest.mock

import synthetic_runs

from barreno.compare import command as compare
from barreno.compare import differences, results
from barreno.converge import command as converge
from barreno.runs import effective_deck, make_runs, run_folder
from barreno.runs.csv_table import WORDS, read_csv
from barreno.sweeps import compute, plan, sample, slurm, variation, words, write
from refusals import refused


def read(kind, *lines):
    return variation.read_variations(list(lines), kind)


def texts_of(line):
    return [value.text for value in read("list", line)[0].values]


def check_values():
    """A plain number has the unit of the next value that has one; braces hold commas; names have spaces."""
    assert texts_of("Confinement/Pressure=0,34,69 MPa") == ["0 MPa", "34 MPa", "69 MPa"]
    assert texts_of("Confinement/Pressure = 1, 10 ksi, 2.5e1 MPa ") == ["1 ksi", "10 ksi", "2.5e1 MPa"]
    assert texts_of("Grid/Cell Size=1 mm,2") == ["1 mm", "2"]
    assert texts_of("Bodies/Rock/Upper={50.8 mm, 1 mm},{60 mm, 1 mm}") == ["{50.8 mm, 1 mm}", "{60 mm, 1 mm}"]
    assert texts_of("Step/Transfer=FLIP, APIC") == ["FLIP", "APIC"] and texts_of("A/B=-.5,1.") == ["-.5", "1."]
    (one,) = read("grid", " Grid / Cell Size =1,2 mm")
    assert one.path == "Grid/Cell Size" and one.name() == "Cell Size" and one.common_unit() == "mm", one
    assert read("grid", "A/B=1 mm,1 cm")[0].common_unit() is None and read("grid", "A/B=x,1 cm")[0].common_unit() is None


def check_narrow_hole():
    """How far a hole is as wide as the jet is a column where that ends above the bottom."""
    def heads(probed):
        scalars = {"penetration.depth": 0.55, write.CHANNEL: 0.55, write.PROBED: probed}
        (words, *_) = write.screen_table([], [results.Row("a", pathlib.Path("a"), [], results.FINISHED, scalars)])
        return words

    assert "as wide as the jet [mm]" in heads(0.48) and "as wide as the jet" not in heads(0.549)


BAD_VALUES = [  # sample, words, sentence
    ("grid", [], "sweep needs what to vary"),
    ("grid", ["Confinement/Pressure"], "names no parameter and its values"),
    ("grid", ["=3"], "names no parameter"),
    ("grid", ["Confinement//Pressure=3"], "names no parameter"),
    ("grid", ["Confinement/Pressure="], "has an empty value"),
    ("grid", ["Confinement/Pressure=1,,3 MPa"], "has an empty value"),
    ("grid", ["A/B=1 mm,2 mm,1 mm"], "has the value 1 mm twice"),
    ("grid", ["A/B=1", "A/B=2"], '"A/B" is given twice'),
    ("grid", ["A/B=0..3 MPa"], "is a range, from which --sample latin draws"),
    ("latin", ["A/B=0,3 MPa"], "is not a range"),
    ("latin", ["A/B=0...3"], "is not a range"),
    ("latin", ["A/B=1 mm..3 cm"], "has two units, mm and cm"),
    ("latin", ["A/B=3..3 mm"], "is an empty range (3 is not below 3)"),
]


def check_bad_values():
    for kind, lines, said in BAD_VALUES:
        refused(lambda kind=kind, lines=lines: read(kind, *lines), said)


def numbers(points):
    return [tuple(value.number for value in point) for point in points]


def check_samples():
    two = read("grid", "A/B=1,2", "A/C=5,6,7")
    assert numbers(sample.points_of(two, "grid", None, 1)) == [(1, 5), (1, 6), (1, 7), (2, 5), (2, 6), (2, 7)]
    refused(lambda: sample.points_of(two, "list", None, 1), "there are 2 of A/B and 3 of A/C")
    assert numbers(sample.points_of(read("list", "A/B=1,2", "A/C=5,5"), "list", None, 1)) == [(1, 5), (2, 5)]
    many = read("grid", *(f"A/{name}={','.join(map(str, range(30)))}" for name in "BCD"))
    refused(lambda: sample.points_of(many, "grid", None, 1), "has 27000 runs, more than 10000")


def check_latin():
    """Every one of N equal parts of each range has one value; the seed decides which go together."""
    draw = lambda seed: numbers(sample.points_of(read("latin", "A/B=0..20 MPa", "A/C=-1..1"), "latin", 20, seed))  # noqa: E731
    points = draw(7)
    assert points == draw(7) and points != draw(8)
    for column, low, width in ((0, 0.0, 1.0), (1, -1.0, 0.1)):
        parts = sorted(int((point[column] - low) / width) for point in points)
        assert parts == list(range(20)), parts
    (first, *_) = sample.points_of(read("latin", "A/B=0..20 MPa"), "latin", 3, 7)
    assert first[0].text.endswith(" MPa") and len(first[0].text) < 12, first


def values(*texts):
    return tuple(variation.value_of(text) for text in texts)


def check_folders():
    """Names say the values; those that would be the same, or too long, have a sign of their own."""
    assert plan.folder_name(["Pressure", "Cell Size"], values("34 MPa", "1 mm")) == "Pressure-34MPa_Cell_Size-1mm"
    assert plan.folder_name(["Density", "Table"], values("2.3 g/cm3", "../a b.csv")) == "Density-2.3g_cm3_Table-.._ab.csv"
    long = plan.folder_name([f"Parameter {i}" for i in range(20)], values(*["12.3456 MPa"] * 20))
    assert len(long) <= plan.LONGEST_NAME + 9, long
    same = plan.folder_names(["A"], [values("a/b"), values("a b"), values("a:b"), values("c")])
    assert len(set(same)) == 4 and same[3] == "A-c", same
    assert plan.short_names(read("grid", "Bodies/Rock/Upper=1", "Bodies/Casing/Upper=2")) == ["Bodies/Rock/Upper", "Bodies/Casing/Upper"]


def check_lists():
    deck = run_folder.body_of(synthetic_runs.DECK)
    plan.check_lists(deck, read("grid", "Bodies/Rock/Upper=1", "Confinement/Pressure=1", "Step/Courant Fraction=0.5"))
    refused(lambda: plan.check_lists(deck, read("grid", "Bodies/Rok/Upper=1")), "the deck has no list Rok in Bodies; did you mean 'Rock'?")
    refused(lambda: plan.check_lists(deck, read("grid", "Bodies/X/Upper=1")), "choose one of 'Rock', 'Casing'.")
    refused(lambda: plan.check_lists(deck, read("grid", "Conditions/Top/Kind=fixed")),
        "the deck has no list Top in Conditions; add it to the deck.")
    refused(lambda: plan.check_settings(["A/B=3"], read("grid", "A/B=1")), "varies what --set or --fidelity fixes")


def check_out(folder):
    """A sweep's folder is that of one deck; anything else is left alone."""
    out, options = folder / "out", argparse.Namespace(deck="a.xml", settings=[], sample="grid")
    plan.check_out(out, "deck")
    plan.write_record(options, "deck", [], [], out)
    plan.check_out(out, "deck")
    refused(lambda: plan.check_out(out, "other"), "holds a sweep of another deck")
    (out / "sweep.json").write_text("[")
    refused(lambda: plan.check_out(out, "deck"), "holds a sweep of another deck")
    (out / "sweep.json").unlink()
    (out / "a").write_text("")
    refused(lambda: plan.check_out(out, "deck"), "holds something else (a, and no sweep.json)")
    refused(lambda: plan.check_out(out / "a", "deck"), "is a file")


def check_taken(folder):
    """A finished run of the same deck is taken wherever it lies, an unfinished one goes on, one of another version does neither."""
    made = synthetic_runs.make_run(folder / "runs" / "by hand")
    deck = run_folder.deck_in(made)
    run = lambda: make_runs.Run([], deck, folder / "runs" / "own")  # noqa: E731
    finished = make_runs.finished_in([folder / "runs", folder / "nowhere"], "0.1.0")
    one = run()
    assert make_runs.take_finished(one, "0.1.0", finished) and one.folder == made and one.how == "reused", one
    assert not make_runs.take_finished(run(), "0.2.0", make_runs.finished_in([folder / "runs"], "0.2.0"))
    own = synthetic_runs.make_run(folder / "runs" / "own", finished=False)
    assert not make_runs.can_go_on(run(), "0.1.0")
    (own / "checkpoint.h5").write_text("")
    assert make_runs.can_go_on(run(), "0.1.0") and not make_runs.can_go_on(run(), "0.2.0")


class Passed:
    """A clock of a run that stands still."""

    def __init__(self, share, whole):
        self.share, self.whole = share, lambda: whole


def check_time_left(folder):
    assert compute.time_left([], [Passed(0.0, None)], 3, 1) is None
    assert compute.time_left([10.0], [], 4, 2) == 20.0
    assert compute.time_left([10.0], [Passed(0.5, 10.0), Passed(0.0, None)], 1, 2) == 12.5
    assert compute.time_left([1.0], [Passed(0.1, 100.0)], 0, 8) == 90.0
    assert [compute.duration(x) for x in (3.21, 99.4, 600.0, 9000.0, 1e6)] == ["3.2 s", "99 s", "10 min", "2.5 h", "278 h"]
    (folder / "run.log").write_text("  0 %  t 0 s  step 0\n 37 %  t 1 s  step 9\nwarning: 3 % of it\n")
    assert run_folder.progress_of(folder) == 0.37 and run_folder.progress_of(folder / "x") == 0.0


def check_words():
    base = ["a.xml", "--vary", "A/B=1"]
    for more, said in (
        (["--jobs", "-2"], "--jobs -2 is not a number of runs at a time"), (["--jobs", "0"], "--jobs 0"),
        (["--ranks", "0"], "--ranks 0 is not a number of ranks"),
        (["--sample", "random"], "--sample random is no way to choose values"), (["--sample", "latin"], "needs the number of its samples"),
        (["--sample", "latin", "--samples", "0"], "--samples 0 is not a number of samples"),
        (["--samples", "3"], "belongs to --sample latin"),
        (["--submit", "pbs"], "--submit pbs is not a batch system"), (["--submit", "slurm", "--collect"], "exclude each other"),
        (["--only", "1", "--collect"], "exclude each other"),
        ([], "a.xml does not exist"),
    ):  # fmt: skip
        refused(lambda more=more: words.check_words(words.parse([*base, *more])), said)
    refused(lambda: words.parse([*base, "--varry", "A/B=1"]), "unrecognized arguments: --varry", "write for example barreno sweep")
    refused(lambda: words.parse([*base, "--jobs", "two"]), "invalid int value")
    assert words.out_folder(words.parse(base)) == pathlib.Path("runs/a-sweep")


def check_slurm():
    assert slurm.ranges_of([1, 2, 3, 5, 8, 9]) == "1-3,5,8-9"
    assert slurm.without_submit(["a.xml", "--submit", "slurm", "--out", "x", "--submit=slurm"]) == ["a.xml", "--out", "x"]
    points = [plan.Point([], "", pathlib.Path("x"), how=how) for how in ("reused", "", "")]
    options = argparse.Namespace(deck="a deck.xml", ranks=4)
    vary = ["a deck.xml", "--vary", "A/B=1,2,3 mm", "--submit", "slurm"]
    with unittest.mock.patch.dict(os.environ, {"BARRENO_COMMAND": "./barreno sweep", "OMPI_MCA_btl": "self",
            "PYTHONPATH": "/of/this/machine", "BARRENO_PROGRAM": "/of/this/machine/barreno"}):
        text = slurm.script(slurm.SWEEP, options, vary, points, pathlib.Path("out"))
    for line in ("#SBATCH --array=2-3\n", "#SBATCH --ntasks=4\n", "#SBATCH --output=out/task-%a.log\n", "#SBATCH --signal=B:TERM@120\n",
            "exec ./barreno sweep 'a deck.xml' --vary 'A/B=1,2,3 mm' --only \"$SLURM_ARRAY_TASK_ID\"\n", "--collect\n"):
        assert line in text, f"{line}: {text}"
    with unittest.mock.patch.dict(os.environ):
        os.environ.pop("BARRENO_COMMAND", None)
        study = slurm.Study("uncertainty", "barreno.uncertainties")
        other = slurm.script(study, argparse.Namespace(deck="b.xml", ranks=1), ["b.xml"], points, pathlib.Path("out"))
    assert "--job-name=b-uncertainty\n" in other and "exec /usr/bin/python3 -m barreno.uncertainties b.xml --only" in other, other
    # Nothing of the machine that wrote it.
    assert not any(word in text for word in ("export", "OMPI", "/of/this/machine", os.getcwd(), sys.executable)), text


def check_script_lines(folder):
    """A line end in a name never becomes a line of the script: it is refused; what a shell would read in other names is quoted."""
    points, trap = [plan.Point([], "", pathlib.Path("x"))], folder / "executed"
    for evil in (f"a\ntouch {trap}\n.xml", f"a\rtouch {trap}", f"a\x85touch {trap}", "a\x00b", "a\x1b[2J.xml", "a\udc80"):
        for deck, out, more in ((evil, "out", []), ("a.xml", evil, []), ("a.xml", "out", ["--set", f"Title={evil}"])):
            options = argparse.Namespace(deck=deck, ranks=1)
            refused(lambda options=options, more=more, out=out: slurm.script(slurm.SWEEP, options, [options.deck, "--vary", "A/B=1", *more],
                points, pathlib.Path(out)), "line end or another control character", "rename it")
        with unittest.mock.patch.object(slurm, "start_of_command", lambda _, evil=evil: f"{evil} sweep"):
            refused(lambda: slurm.script(slurm.SWEEP, argparse.Namespace(deck="a.xml", ranks=1), ["a.xml"], points, pathlib.Path("out")),
                "the path of barreno")
    with unittest.mock.patch.dict(os.environ, {"BARRENO_COMMAND": "true"}):
        odd = f"$(touch {trap}) `touch {trap}`; touch {trap} #'\" & b.xml"
        text = slurm.script(slurm.SWEEP, argparse.Namespace(deck=odd, ranks=1), [odd, "--out", odd], points, pathlib.Path(odd))
    subprocess.run(["bash", "-c", text], cwd=folder, check=True, timeout=60)
    assert not trap.exists() and all(line.startswith("#") or line.startswith("exec true ") for line in text.splitlines()), text


def check_ranks():
    """sweep and converge refuse what run refuses, by the launcher's rule: processes that this machine cannot hold."""
    with unittest.mock.patch.dict(os.environ):
        for name in ("SLURM_JOB_ID", "PBS_NODEFILE"):
            os.environ.pop(name, None)
        base = ["a.xml", "--vary", "A/B=1"]
        for count in ("1000000000", "9" * 30, "999999"):
            refused(lambda count=count: words.check_words(words.parse([*base, "--ranks", count])),
                f"--ranks {count} is more than this machine can start")
            refused(lambda count=count: converge.check_words(converge.parse(["a.xml", "--ranks", count])),
                f"--ranks {count} is more than this machine can start")
        refused(lambda: words.check_words(words.parse([*base, "--ranks", "999999", "--submit", "slurm"])),
            "a.xml does not exist")  # for other machines
        refused(lambda: words.jobs_of(words.parse([*base, "--jobs", "999999"]), 10000),
            "--jobs 999999, which is 10000 processes at a time, is more than")
        assert words.jobs_of(words.parse([*base, "--jobs", "999999"]), 3) == 3 and words.jobs_of(words.parse(base), 10000) >= 1


def swept(folder, line, count=3):
    """Points of a sweep of one parameter over synthetic runs, the last of which has failed."""
    (one,) = read("grid", line)
    points = []
    for i, value in enumerate(one.values):
        run = synthetic_runs.make_run(folder / f"run {i}", pressure=1e6 * i, depth=0.03 - 0.001 * i)
        points.append(plan.Point([], run_folder.deck_in(run), run, how="computed", code=3 if i == count - 1 else 0, values=(value,),
            label=f"Pressure = {value.text}"))
    return one, points


def rows_in(file):
    return read_csv(file, cells=WORDS).to_dict("records")


def check_results(folder):
    """table.csv has all scalars of finished runs and says which failed; pictures for what is there, a remark for what is not."""
    one, points = swept(folder, "Confinement/Pressure=0,1,2 MPa")
    lines = []
    write.write_sweep(folder, [one], "grid", points, lines.append)
    rows = rows_in(folder / "table.csv")
    assert [row["Confinement/Pressure [MPa]"] for row in rows] == ["0", "1", "2"] and [row["state"] for row in rows] == ["finished",
        "finished", "failed"], rows
    assert (
        float(rows[1]["penetration.depth"]) == 0.03 - 0.001 and rows[1]["penetration.met_target"] == "true" and rows[1]["deck"] == "a.xml"
        and rows[2]["penetration.depth"] == ""
    ), rows
    for name in ("depth.png", "depth_against.png"):
        assert (folder / name).read_bytes()[:4] == b"\x89PNG", name
    said = "\n".join(lines)
    assert (
        "channels.png is not drawn, because no run has a particles.e that can be read." in said and not (folder / "channels.png").exists()
    ), said
    assert "run 2 (failed)" in said and f"Written to {folder}: table.csv, depth.png, depth_against.png" in said, said


def check_columns(folder):
    """A column in the unit of the values, in SI if they have several, or in words."""
    heads = {"Confinement/Pressure=0,1,2 MPa": "Confinement/Pressure [MPa]",
        "Confinement/Pressure=0 Pa,1 MPa,20 bar": "Confinement/Pressure [SI]",
        "Confinement/Pressure=low,1 MPa,2 MPa": "Confinement/Pressure"}
    for i, (line, head) in enumerate(heads.items()):
        one, points = swept(folder / str(i), line)
        (column,) = write.columns_of([one], points)
        assert column.head == head, column.head
        assert (column.numbers is None) == (i == 2) and (i != 1 or column.numbers == [0.0, 1e6, 2e6]), column.numbers


def check_pictures(folder):
    """One parameter, two with few and with many values, words."""
    from barreno.runs.pictures import draw_depths
    from barreno.sweeps.picture import Axis, draw_against

    few, many = ["1", "2"] * 6, [str(i) for i in range(12)]
    number, word = Axis("a", list(range(12)), many), Axis("b", None, few)
    assert word.places == [0.0, 1.0] * 6 and word.words == ["1", "2"]
    for name, axes, labels in (("one", [word], few), ("curves", [number, word], few),
            ("map", [number, Axis("c", list(range(12)), many)], many)):
        draw_against(folder / f"{name}.png", axes, labels, [0.001 * i for i in range(12)])
    table = run_folder.read_table(synthetic_runs.make_run(folder / "run") / "depth.csv")
    assert list(table["depth"]) == [0.0, 0.03], table  # a line that was cut off is left out
    for count in (3, 20, 30):
        draw_depths(folder / f"{count}.png", [(str(i), table["time"], table["depth"]) for i in range(count)])
    assert all(file.read_bytes()[:4] == b"\x89PNG" for file in folder.glob("*.png"))


def check_differences(folder):
    runs = [synthetic_runs.make_run(folder / name, pressure=p, depth=d, slugs=s)
        for name, p, d, s in (("a", 0, 0.04, "1" * 99), ("b", 1e6, 0.03, "2" * 99))]
    found = differences.deck_differences(runs)
    assert found == {"Confinement/Pressure": ["0", "1000000.0"], "Jet/Slugs": ["1" * 99, "2" * 99]}, found
    assert differences.shortened(found["Jet/Slugs"]) == ["(99 letters, no. 1)", "(99 letters, no. 2)"]
    assert differences.against(0.04, 0.03)[1] == 100.0 * (0.03 - 0.04) / 0.04 and differences.against(0.0, 2.0) == (2.0,
        None) and differences.against(None, 2.0) == (None, None)
    assert effective_deck.value_in(run_folder.deck_in(runs[1]), "Confinement/Pressure") == "1000000.0"
    rows = [results.finished_row(run.name, run, []) for run in runs]
    quantities = dict(differences.quantities_of(rows))
    assert quantities["penetration.depth"] == [0.04, 0.03] and "penetration.met_target" not in quantities, quantities


def compared(*runs):
    said, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(errors):
        code = compare.main([*map(str, runs)])
    return code, said.getvalue() + errors.getvalue()


def check_compare(folder):
    a, b = (synthetic_runs.make_run(folder / name / "run", pressure=p, depth=d) for name, p, d in (("a", 0, 0.04), ("b", 1e6, 0.03)))
    c = synthetic_runs.make_run(folder / "c", pressure=0, depth=None, finished=False, reason="interrupted", time=1e-5)
    code, said = compared(a, b, c, "--out", folder / "out")
    assert code == 0 and "Confinement/Pressure" in said and "-25" in said, said
    assert "a/run" in said and "/c has not finished: it ended at 1e-05 s (interrupted)." in said, said
    (row,) = [row for row in rows_in(folder / "out" / "differences.csv") if row["quantity"] == "penetration.depth"]
    assert float(row["b/run difference"]) == 0.03 - 0.04 and float(row["b/run percent"]) == differences.against(0.04, 0.03)[1], row
    assert rows_in(folder / "out" / "table.csv")[1]["Confinement/Pressure"] == "1000000.0" and (folder / "out" / "depth.png").exists()
    assert rows_in(folder / "out" / "decks.csv") == [{"parameter": "Confinement/Pressure", "a/run": "0", "b/run": "1000000.0",
        f"{folder.name}/c": "0"}]
    code, said = compared(a, b, "--out", folder / "out")
    assert code == 0, said
    code, said = compared(a, synthetic_runs.make_run(folder / "same", depth=0.04), "--out", folder / "same-out")
    assert code == 0 and "The decks are the same." not in said and "Confinement/Pressure" in said, said


def check_bad_compare(folder):
    run, other = (synthetic_runs.make_run(folder / name) for name in ("run", "other"))
    killed, no_run, held = synthetic_runs.make_run(folder / "killed"), folder / "empty", folder / "held"
    (killed / "summary.json").unlink()
    no_run.mkdir()
    held.mkdir()
    (held / "x").write_text("")
    broken = synthetic_runs.make_run(folder / "broken")
    (broken / "summary.json").write_text('{"finished": tr')
    cut = synthetic_runs.make_run(folder / "cut")
    (cut / "depth.csv").write_text("time,dep\n1,x\n")
    deck = synthetic_runs.make_run(folder / "deck")
    (deck / "deck.xml").write_text("<ParameterList>")
    for runs, code, said in (
        ([], 1, "compare needs two runs or more, and there are none"), ([run], 1, "and there is one"), ([run, run], 1, "is given twice"),
        ([run, folder / "nowhere"], 2, "is not a folder"), ([run, no_run], 2, "is not the folder of a run"),
        ([run, killed], 2, "was killed"),
        ([run, other, "--out", held], 2, "holds something else (x, and no compare.json)"),
        ([run, other, "--out", run / "depth.csv"], 2, "is a file"),
        ([run, broken], 2, "summary.json cannot be read"),
        ([run, cut, "--out", folder / "o"], 2, "depth.csv cannot be read as a table of numbers"),
        ([run, deck], 2, "deck.xml is not a deck"), ([run, other, "--owt", "x"], 1, "unrecognized arguments"),
    ):  # fmt: skip
        found = compared(*runs)
        assert found[0] == code and said in found[1] and found[1].count("\n") == 1 and found[1].startswith("barreno: "), f"{runs}: {found}"


CHECKS = (check_values, check_narrow_hole, check_bad_values, check_samples, check_latin, check_folders, check_lists, check_words,
    check_slurm, check_ranks)
IN_FOLDERS = (check_script_lines, check_out, check_taken, check_time_left, check_results, check_columns, check_pictures, check_differences,
    check_compare, check_bad_compare)


def main():
    for check in CHECKS:
        check()
    for check in IN_FOLDERS:
        with tempfile.TemporaryDirectory() as scratch:
            check(pathlib.Path(scratch))
    print("values, samples, folders and tables are as docs/sweep.md says")


if __name__ == "__main__":
    main()
