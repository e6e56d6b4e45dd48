#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno fit` from the outside: a known card is found again from the curves that the code makes of it, the ranges hold the true values
where the curves are noisy, the laboratory answers as `barreno drive` does, and every bad input has its own sentence and exit code.

    test_fit.py LIBRARY BARRENO [--full]    --full: nine parameters from noisy curves, not five
"""
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

from barreno.fit import card as cards
from barreno.fit import command, profiles, ranges, solve, units, weights
from barreno.fit.answers import Laboratory
from barreno.fit.data import Test, read_test
from barreno.fit.kinds import DIMENSIONS
from barreno.fit.parameters import PARAMETERS
from barreno.fit.specimens import opened
from barreno.materials import load
from barreno.runs.csv_table import read_csv
from barreno.runs.faults import Fault

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEGA = 1e6
NOISE = 0.01
FITTED = {"PEAKI1", "FSLOPE", "STREN", "CR", "B0", "B1", "B2", "G1", "p0_crush_curve", "p1_crush_curve"}
EXACT = 2e-3
SHIFTED = {"PEAKI1": 1.6, "FSLOPE": 0.8, "STREN": 1.5, "B0": 1.3, "B1": 0.7, "B2": 1.4, "p0_crush_curve": 1.3, "p1_crush_curve": 0.6}
OF_CRUSHING = ("B1", "B2", "p0_crush_curve", "p1_crush_curve")  # which a fit takes most of its time for
HELD = ["--fix", "YSLOPE=0.02", "--fix", "G2=0.02", "--fix", "p3_crush_curve=0.22"]


def true_card():
    card = {**cards.read("arenisca_demonstration"), "G1": 0.2, "G2": 0.02}
    return {**card, "G0": 1.5 * card["B0"] * (1 - 2 * card["G1"]) / (1 + card["G1"])}


def unloaded(top, low, last, rows):
    """Strains up to top, back to low and up to last."""
    return numpy.concatenate([numpy.linspace(0, top, rows), numpy.linspace(top, low, 6)[1:], numpy.linspace(low, last, rows)[1:]])


def test_of(name, kind, columns, channel, confinement=0.0):
    rows = len(next(iter(columns.values())))
    return Test(name, kind, "", "", {**columns, channel: numpy.zeros(rows)}, [""] * rows, numpy.full(rows, NOISE), confinement * MEGA)


def specimens():
    tests = [test_of("hydrostatic", "hydrostatic", {"volume_strain": unloaded(0.035, 0.028, 0.09, 16)}, "pressure")]
    for side, last in ((0, 0.012), (30, 0.02), (120, 0.05)):
        tests.append(test_of(f"triaxial_{side}", "triaxial", {"axial_strain": numpy.linspace(0, last, 16)}, "differential_stress", side))
    return tests


def write_data(folder, card, noise, library, seed=7):
    """The curves of a card as a laboratory would hand them over: engineering strains in %, stresses in MPa or psi."""
    tests, random = specimens(), numpy.random.default_rng(seed)
    with opened(cards.in_a_test(card, Tolerance=1e-5), library) as rock:
        answers = Laboratory(tests).answers(rock)
    files = []
    for test, answer in zip(tests, answers):
        unit = "psi" if test.file == "triaxial_30" else "MPa"
        lines = [f"# kind: {test.kind}", "# compression: positive", f"# uncertainty: {100 * NOISE} %",
            f"# confinement: {test.confinement / MEGA} MPa"]
        (channel,) = answer
        (strain,) = set(test.columns) - {channel}
        stress = answer[channel] + noise * numpy.abs(answer[channel]).max() * random.standard_normal(test.rows)
        lines.append(f"{strain} [%],{channel} [{unit}]")
        engineering = -numpy.expm1(-test.columns[strain])
        lines += [f"{100 * e!r},{s / units.UNITS['stress'][unit]!r}" for e, s in zip(engineering.tolist(), stress.tolist())]
        files.append(folder / f"{test.file}.csv")
        files[-1].write_text("\n".join(lines) + "\n")
    return list(map(str, files))


def run(words):
    """Exit code and what is said."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = command.main(list(map(str, words)))
    return code, out.getvalue(), err.getvalue()


def fitted(files, folder, *words):
    code, out, err = run([*files, "--out", folder / "card.xml", *HELD, *words])
    assert code == 0, err
    return out, {entry["name"]: entry for entry in json.loads((folder / "card.json").read_text())["parameters"]}


def check_known_card(folder, library):
    """Without noise: every parameter, from a start that is 20 to 60 % away, and from data in two units."""
    truth = true_card()
    start = folder / "start.xml"
    start.write_text(cards.text_of({**truth, **{name: truth[name] * factor for name, factor in SHIFTED.items()}, "CR": 0.7, "G1": 0.3}))
    out, found = fitted(write_data(folder, truth, 0.0, library), folder, "--start", start)
    off = {name: abs(entry["value"] / truth[name] - 1) for name, entry in found.items()}
    print("  without noise, largest difference:", max(off.items(), key=lambda item: item[1]))
    assert set(off) == FITTED, f"fitted {sorted(off)}"
    assert all(value <= EXACT for value in off.values()), off
    assert "hydrostatic.csv (hydrostatic, pressure)" in out and "95 % range" in out, out
    assert (folder / "card.png").read_bytes()[:4] == b"\x89PNG"
    text = (folder / "card.xml").read_text()
    assert '"Schema Version" type="int"' in text and 'name="Units" type="string" value="SI"' in text and str(folder) not in text, text
    with opened(cards.read(str(folder / "card.xml")), library) as rock:
        assert rock.model == "Arenisca"


def check_noise(folder, library, full):
    """With 1 % of noise: at most one of ten true values outside of its 95 % range, and the ranges no wider than that needs."""
    truth = true_card()
    held = [word for name in OF_CRUSHING for word in ("--fix", f"{name}={truth[name]!r}")] if not full else []
    _, found = fitted(write_data(folder, truth, NOISE, library), folder, "--start", "arenisca_demonstration", "--fix", "G1=0.2", *held)
    outside = [name for name, entry in found.items() if not entry["low"] <= truth[name] <= entry["high"]]
    wide = {name: entry["high"] / entry["low"] for name, entry in found.items() if name in ("B0", "FSLOPE", "CR")}
    print("  with noise, outside of their range:", outside, "; high/low:", wide)
    assert len(found) == (9 if full else 5) and len(outside) <= (1 if full else 0), outside
    assert all(ratio < 1.5 for ratio in wide.values()), wide


def check_dilatancy(folder, library):
    """The bounds of the dilatancy from volume strains of triaxial tests, the rest of the card known."""
    truth = {**cards.read("berea_sandstone_bounded"), "BETA_nonassociativity": 1.0}
    strain = {"axial_strain": numpy.linspace(0, 0.05, 16), "volume_strain": numpy.zeros(16)}
    tests = [test_of(f"volume_{side}", "triaxial", strain, "differential_stress", side) for side in (5, 40, 120)]
    with opened(cards.in_a_test(truth, Tolerance=1e-5), library) as rock:
        answers = Laboratory(tests).answers(rock)
    files = []
    for test, answer in zip(tests, answers):
        lines = ["# kind: triaxial", "# compression: positive", "# strain: logarithmic", f"# confinement: {test.confinement / MEGA} MPa",
            "axial_strain [-],volume_strain [-],differential_stress [Pa]"]  # fmt: skip
        rows = zip(*(column.tolist() for column in (test.columns["axial_strain"], answer["volume_strain"], answer["differential_stress"])))
        files.append(folder / f"{test.file}.csv")
        files[-1].write_text("\n".join([*lines, *(f"{a!r},{v!r},{q!r}" for a, v, q in rows)]) + "\n")
    bounds = ("Dilatancy limit", "Dilatancy pressure")
    held = [word for name, value in truth.items() if name in PARAMETERS and name not in bounds for word in ("--fix", f"{name}={value!r}")]
    start = folder / "start.xml"
    start.write_text(cards.text_of({**truth, "Dilatancy limit": 0.02, "Dilatancy pressure": 150e6}))
    code, _, err = run([*files, "--start", start, "--out", folder / "card.xml", *held])
    assert code == 0, err
    found = {entry["name"]: entry["value"] for entry in json.loads((folder / "card.json").read_text())["parameters"]}
    print("  bounds of the dilatancy:", found)
    assert set(found) == set(bounds) and all(abs(found[name] / truth[name] - 1) < 0.01 for name in bounds), found


def check_left_open(folder, library):
    """A hydrostatic test that ends before the rock crushes says nothing of crushing, and the fit says so."""
    truth = true_card()
    strain = numpy.linspace(0, 0.008, 16)
    test = test_of("elastic", "hydrostatic", {"volume_strain": strain}, "pressure")
    with opened(cards.in_a_test(truth), library) as rock:
        pressure = Laboratory([test]).answers(rock)[0]["pressure"]
    lines = ["# kind: hydrostatic", "# compression: positive", "# strain: logarithmic", "volume_strain [-],pressure [Pa]"]
    (folder / "elastic.csv").write_text("\n".join([*lines, *(f"{e!r},{p!r}" for e, p in zip(strain.tolist(), pressure.tolist()))]) + "\n")
    out, found = fitted([str(folder / "elastic.csv")], folder, "--start", "arenisca_demonstration", "--fix", "G1=0.2", "--fix",
        "B2=400 MPa")
    for name in ("p0_crush_curve", "p1_crush_curve"):
        start = cards.read("arenisca_demonstration")[name]
        assert found[name]["low"] is None and found[name]["value"] == start, found[name]
        assert f"{name} is not determined by these data and is kept at its start" in out, out
    assert abs(found["B0"]["value"] / truth["B0"] - 1) < 0.01, found["B0"]


def refused(does):
    try:
        does()
    except Fault as fault:
        return "the library refuses every card that the fit could start from" in str(fault)
    return False


def check_restart(folder, library):
    """Where the library refuses the card that the stages found, the joint fit starts from the simpler one, and finds the truth."""
    truth = true_card()
    tests = [read_test(file) for file in write_data(folder, truth, 0.0, library)]
    search = solve.Search(solve.Problem(library, truth, {}, {}), tests, ["FSLOPE", "PEAKI1"], truth)
    simpler = {"FSLOPE": 0.9 * truth["FSLOPE"], "PEAKI1": 1.2 * truth["PEAKI1"]}
    found = {"FSLOPE": 0.1 * truth["YSLOPE"], "PEAKI1": truth["PEAKI1"]}  # the slope at the vertex is less than that far from it
    assert refused(lambda: search.solve([found])), "the card that must be refused is not"
    values, _, _ = solve.together(search, [found], simpler)
    off = {name: abs(values[name] / truth[name] - 1) for name in simpler}
    assert all(value <= EXACT for value in off.values()), off
    assert refused(lambda: solve.together(search, [found], found))


def check_bound(folder, library):
    """A parameter that its bounds keep from the truth is said to stand at its bound, and is not given a range."""
    truth = true_card()
    strain = numpy.linspace(0, 0.008, 16)
    test = test_of("elastic", "hydrostatic", {"volume_strain": strain}, "pressure")
    with opened(cards.in_a_test(truth), library) as rock:
        pressure = Laboratory([test]).answers(rock)[0]["pressure"]
    lines = ["# kind: hydrostatic", "# compression: positive", "# strain: logarithmic", "volume_strain [-],pressure [Pa]"]
    (folder / "elastic.csv").write_text("\n".join([*lines, *(f"{e!r},{p!r}" for e, p in zip(strain.tolist(), pressure.tolist()))]) + "\n")
    held = [word for name in OF_CRUSHING for word in ("--fix", f"{name}={truth[name]!r}")]
    low, high = 1.2 * truth["B0"], 2.0 * truth["B0"]
    out, found = fitted([str(folder / "elastic.csv")], folder, "--start", "arenisca_demonstration", "--fix", "G1=0.2", *held, "--bounds",
        f"B0={low!r},{high!r}")
    assert found["B0"]["low"] is None and abs(found["B0"]["value"] / low - 1) < 0.03, found["B0"]
    assert "B0 stands at its bound and is kept at" in out, out


def check_better_minimum(folder, library):
    """Ranges that are asked for beside the minimum find it: a profile that goes below the solution begins the fit again."""
    truth = true_card()
    tests = [read_test(file) for file in write_data(folder, truth, 0.0, library)]
    search = solve.Search(solve.Problem(library, truth, {}, {}), tests, ["FSLOPE", "PEAKI1"], truth)
    beside = {"FSLOPE": truth["FSLOPE"], "PEAKI1": 1.1 * truth["PEAKI1"]}
    z = search.seen_start(beside)
    squares = float((search.residuals(z) ** 2).sum())
    lower = None
    try:
        spread, i = ranges.spread_of(search, z), search.names.index("FSLOPE")
        profiles.grown(search, spread, i, z[i], z, spread.slopes)
    except profiles.Better as better:
        (lower,) = better.args
    assert lower and abs(lower["PEAKI1"] / truth["PEAKI1"] - 1) < 0.02, lower
    asked, true_range = [], solve.range_of
    solve.range_of = lambda *given, **more: true_range(*given, **more) if asked else once(asked, lower)
    try:
        (values, _, _), _, found, _ = solve.opened_and_ranged(search, ({**truth, **beside}, squares, z))
    finally:
        solve.range_of = true_range
    assert set(found) == set(beside) and abs(values["PEAKI1"] / truth["PEAKI1"] - 1) <= EXACT, (values["PEAKI1"], found)


def once(asked, values):
    asked.append(True)
    raise profiles.Better(values)


def scales_from(folder, truth, library, noises, stated):
    """Of the curves of a known card, each with its own noise."""
    tests = []
    for k, noise in enumerate(noises):
        files = write_data(folder, truth, noise, library, seed=k)
        for file in files if not stated else []:
            path = pathlib.Path(file)
            path.write_text("".join(line for line in path.read_text().splitlines(True) if not line.startswith("# uncertainty")))
        tests.append(read_test(files[k]))
    names = ["B0", "FSLOPE", "G1"]
    search = solve.Search(solve.Problem(library, truth, {}, {}), tests, names, truth)
    found = weights.weigh(search, search.solve([truth]))
    return [test.scales.get(test.channels[0], 1.0) for test in tests], search, found


def check_columns(folder, library):
    """Curves that scatter unlike are weighed by their own scatter, and the parameters of a quiet one no longer suffer from a loud one;
    curves that scatter alike, and those whose files state an uncertainty, keep their weights."""
    truth, noises = true_card(), (0.005, 0.03, 0.03, 0.005)
    scales, search, found = scales_from(folder, truth, library, noises, stated=False)
    parts = [scale / noise for scale, noise in zip(scales, noises)]
    print("  scales:", scales)
    # 13 degrees of freedom know a scatter to 0.72 to 1.6 of itself; equal weights would give 6.
    assert max(parts) < 1.6 / 0.72 * min(parts), scales
    r = search.residuals(found[2])
    assert abs(found[1] - float(r @ r)) < 1e-6 * found[1], "the sum of squares is that of other weights"
    assert scales_from(folder, truth, library, noises, stated=True)[0] == [1.0] * 4
    assert scales_from(folder, truth, library, (0.01,) * 4, stated=False)[0] == [1.0] * 4


def check_many_starts(folder, library):
    """A stage that leaves the cap and the limit surface in a corner does not keep the joint fit there."""
    truth = {**true_card(), "YSLOPE": 0.02}
    tests = [read_test(file) for file in write_data(folder, truth, 0.0, library)]
    names = ["FSLOPE", "YSLOPE", "CR"]
    search = solve.Search(solve.Problem(library, truth, {}, {}), tests, names, truth)
    values, squares, _ = solve.together(search, [{"FSLOPE": 1.3 * truth["FSLOPE"], "YSLOPE": 0.0, "CR": 0.021}], truth)
    assert squares < 1e-2, squares
    assert abs(values["CR"] / truth["CR"] - 1) < 0.01, values["CR"]


def check_against_drive(folder, library, barreno):
    """The laboratory's unconfined, oedometer and hydrostatic tests are those of `barreno drive`."""
    strain = numpy.linspace(0, 0.02, 21)
    cases = {"triaxial": ("axial_stress", "strain_xx,stress_yy,stress_zz", "{e},0,0"),
        "uniaxial strain": ("axial_stress", "strain_xx", "{e}"),
             "hydrostatic": ("pressure", "strain_xx,strain_yy,strain_zz", "{e},{e},{e}")}  # fmt: skip
    tests = [test_of(kind, kind,
        {"volume_strain" if kind == "hydrostatic" else "axial_strain": strain * (3 if kind == "hydrostatic" else 1)}, channel)
        for kind, (channel, _, _) in cases.items()]
    with opened(cards.in_a_test(true_card()), library) as rock:
        answers = Laboratory(tests).answers(rock)
    (folder / "rock.xml").write_text(cards.text_of(true_card()))
    for (kind, (channel, columns, row)), answer in zip(cases.items(), answers):
        path, out = folder / "path.csv", folder / "answer.csv"
        path.write_text("\n".join([f"time,{columns}", *(f"{i}," + row.format(e=repr(-e + 0.0)) for i, e in enumerate(strain.tolist()))])
            + "\n")
        subprocess.run([barreno, "drive", "--material", folder / "rock.xml", "--path", path, "--out", out], check=True, capture_output=True)
        stress = -read_csv(out)["stress_xx"].to_numpy(float)
        off = numpy.abs(answer[channel] - stress).max() / stress.max()
        assert off < 1e-6, f"{kind}: {off}"


HEAD = "# kind: hydrostatic\n# compression: positive\n"
ROWS = "".join(f"{0.1 * i},{10 * i}\n" for i in range(12))
TABLE = "volume_strain [%],pressure [MPa]\n" + ROWS
TRIAXIAL = "# kind: triaxial\n# compression: positive\n# confinement: 40 MPa\n"
BAD = {  # file name: (text or None, further words, exit code, sentence)
    "nowhere.csv": (None, [], 2, "does not exist (needed as the data of a test)"),
    "no_kind.csv": ("# compression: positive\n" + TABLE, [], 1, "does not say which kind of test it is"),
    "odd_kind.csv": ("# kind: hydrostatik\n# compression: positive\n" + TABLE, [], 1, "did you mean 'hydrostatic'?"),
    "no_units.csv": (HEAD + "volume_strain,pressure\n" + ROWS, [], 1, "gives no unit for the column 'volume_strain'"),
    "odd_unit.csv": (HEAD + TABLE.replace("MPa", "Mpa"), [], 1, "has the unit 'Mpa', which is none of a stress; did you mean MPa?"),
    "strain_unit.csv": (HEAD + TABLE.replace("%", "MPa"), [], 1, "has the unit 'MPa', which is none of a strain"),
    "no_sign.csv": ("# kind: hydrostatic\n" + TABLE, [], 1, "does not say its sign convention"),
    "wrong_sign.csv": (HEAD.replace("positive", "negative") + TABLE, [], 1, "says that compression is negative, but the largest value of"),
    "few_rows.csv": (HEAD + "\n".join(TABLE.splitlines()[:5]) + "\n", [], 1, "has 4 rows, too few for a curve (8 at least)"),
    "no_rows.csv": (HEAD + "volume_strain [%],pressure [MPa]\n", [], 1, "has no row of numbers"),
    "empty.csv": (HEAD, [], 1, "contains no table"),
    "noisy.csv": (HEAD + "volume_strain [%],pressure [MPa]\n" + "".join(f"{0.1 * i + (0.3 if i % 2 else 0)},{i}\n" for i in range(30)), [],
        1, "is not monotone: 'volume_strain' turns 28 times"),
    "text.csv": (HEAD + TABLE.replace("50\n", "fifty\n", 1), [], 1, "line 9 has 'fifty' in the column 'pressure', which is not a number"),
    "nan.csv": (HEAD + TABLE.replace("50\n", "nan\n", 1), [], 1, "which is not a number"),
    "ragged.csv": (HEAD + TABLE + "1,2,3\n", [], 1, "line 16 has 3 cells under 2 column names"),
    "misspelt.csv": (HEAD + TABLE.replace("pressure", "presure"), [], 1,
        "lacks the column 'pressure', which a test of kind 'hydrostatic' needs (is one misspelt?"),
    "twice.csv": (HEAD + TABLE.replace("pressure [MPa]", "volume_strain [%]"), [], 1, "has the column 'volume_strain' twice"),
    "percent.csv": (HEAD + TABLE.replace("[%]", "[-]"), [], 1, "has a largest 'volume_strain' of 110 %, which no test has"),
    "binary.csv": (b"\xff\xfe\x00", [], 1, "is not text in UTF-8"),
    "side.csv": ("# kind: triaxial\n# compression: positive\naxial_strain [%],axial_stress [MPa]\n" + ROWS, [], 1,
        "does not say its confinement"),
    "above.csv": (TRIAXIAL + "axial_strain [%],axial_stress [MPa]\n" + ROWS, [], 1, "call it differential_stress"),
    "side_unit.csv": (TRIAXIAL.replace(" MPa", "") + "axial_strain [%],differential_stress [MPa]\n" + ROWS, [], 1,
        "'confinement' is '40', without a unit"),
    "only_triaxial.csv": (TRIAXIAL + "axial_strain [%],differential_stress [MPa]\n" + ROWS, [], 1, "no hydrostatic test is among the data"),
    "only_hydrostatic.csv": (HEAD + TABLE, [], 1, "no triaxial test is among the data"),
    "start.csv": (HEAD + TABLE, ["--start", "nowhere"], 2, "nowhere is neither a file nor the name of a card"),
    "metal.csv": (HEAD + TABLE, ["--start", "copper"], 1, "--start needs one of Arenisca in SI"),
    "fixed.csv": (HEAD + TABLE, ["--fix", "PEEK=1"], 1, "--fix PEEK names no parameter of a fit"),
    "fix_unit.csv": (HEAD + TABLE, ["--fix", "B0=3 m"], 1, "has the unit 'm', which is none of a stress"),
    "bounds.csv": (HEAD + TABLE, ["--bounds", "B0=3 GPa,1 GPa"], 1, "is not an interval above 0"),
    "all_fixed.csv": (HEAD + TABLE,
        ["--start", "berea_sandstone",
            *(w for n in ("B0=6 GPa", "B1=2 GPa", "B2=9 MPa", "p0_crush_curve=-9 MPa", "p1_crush_curve=1 1/GPa", "p3_crush_curve=0.2")
                for w in ("--fix", n))], 1, "nothing is left to fit"),
    "word.csv": (HEAD + TABLE, ["--fixx", "B0=1"], 1, "unrecognized arguments: --fixx"),
    "refused.csv": (HEAD + TABLE, ["--start", "berea_sandstone", "--fix", "FSLOPE=0.01"], 3,
        "the library refuses every card that the fit could start from"),
}  # fmt: skip


def check_bad_inputs(folder):
    problems = []
    for name, (text, words, code, sentence) in BAD.items():
        file, out = folder / name, folder / "bad.xml"
        if text is not None:
            file.write_bytes(text if isinstance(text, bytes) else text.encode())
        got, _, err = run([file, "--out", out, *words])
        said = [line for line in err.splitlines() if line.startswith("barreno: ")]
        if got != code or len(said) != 1 or sentence not in said[0] or out.exists() or "Traceback" in err:
            problems.append(f"{name}: exit {got}: {err}")
    for words, code, sentence in (
        ([folder / "only_hydrostatic.csv"], 1, "--out"),
        ([folder / "only_hydrostatic.csv"] * 2 + ["--out", folder / "bad.xml"], 1, "a file is given twice"),
        ([folder / "only_hydrostatic.csv", "--out", folder / "none" / "bad.xml"], 2, "the folder of --out"),
        ([folder / "only_hydrostatic.csv", "--out", folder / "bad.csv"], 1, "end it with .xml"),
    ):
        got, _, err = run(words)
        if got != code or sentence not in err or err.count("\n") != 1:
            problems.append(f"{words}: exit {got}: {err}")
    assert not problems, "\n".join(problems)


def check_reading(folder):
    """A row of units, another sign and another order of columns give the same test; the tables of Berea are read."""
    (folder / "first.csv").write_text(HEAD + TABLE)
    rows = "".join(f"{-1450.37738 * i},ignored,{-0.1 * i}\n" for i in range(12))
    (folder / "second.csv").write_text("# kind: hydrostatic\n# compression: negative\npressure,note,volume_strain\npsi,-,%\n" + rows)
    first, second = read_test(folder / "first.csv"), read_test(folder / "second.csv")
    for name in first.columns:
        numpy.testing.assert_allclose(first.columns[name], second.columns[name], rtol=1e-8)
    assert second.notes == [f"{folder / 'second.csv'}: not used: note."], second.notes
    kinds = {read_test(file).kind for file in (ROOT / "verification" / "fits" / "berea").glob("*.csv")}
    assert len(kinds) == 7 and set(DIMENSIONS) >= {"bulk_modulus"}, kinds


def main():
    os.environ["BARRENO_LIBRARY"] = str(pathlib.Path(sys.argv[1]).resolve())
    barreno, library = pathlib.Path(sys.argv[2]).resolve(), load()
    checks = {
        "reading": lambda f: check_reading(f), "bad inputs": lambda f: check_bad_inputs(f),
        "drive": lambda f: check_against_drive(f, library, barreno),
        "dilatancy": lambda f: check_dilatancy(f, library),
        "left open": lambda f: check_left_open(f, library), "restart": lambda f: check_restart(f, library),
        "bound": lambda f: check_bound(f, library), "better minimum": lambda f: check_better_minimum(f, library),
        "columns": lambda f: check_columns(f, library), "many starts": lambda f: check_many_starts(f, library),
        "known card": lambda f: check_known_card(f, library), "noise": lambda f: check_noise(f, library, sys.argv[3:] == ["--full"]),
    }  # fmt: skip
    for name, check in checks.items():
        with tempfile.TemporaryDirectory() as scratch:
            print(name, flush=True)
            check(pathlib.Path(scratch))
    print("fit finds what was put in, and says what it cannot use")


if __name__ == "__main__":
    main()
