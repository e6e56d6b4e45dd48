#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that start from the particles of a finished run: test_continue.py BARRENO. The example of docs/continue.md is run as it stands."""
import json
import pathlib
import re
import shlex
import shutil
import sys
import tempfile

import h5py
import numpy as np
from test_forged_checkpoints import all_kinds, put, remove, replace, seal

from tools.resumed import at_previous, different_fields, different_files, different_sums, must_work, program
from tools.runs import DECKS, ROOT, Run

TAYLOR = str(DECKS / "taylor_bar.xml")
QUICK = str(DECKS / "perforation_quick.xml")
STEP = 2.0**-27  # [s]: times that are whole numbers of such steps are exact, so that no end shortens a step
STEPS = 640  # of a stage
DEBRIS = 1 << 30  # bit of a particle's body
# Decks, their step as a power of two, and their steps: contact, a hollow ball, three dimensions, cells of several sizes, an explosive.
SEAMS = (("contact_disks.xml", -19, 100), ("shell_coasting.xml", -26, 60), ("taylor_bar_3d.xml", -26, 20), ("border_pulse.xml", -27, 30),
    ("detonation.xml", -28, 100))  # fmt: skip
LIGHTING = {"detonation.xml": ["0/history"]}  # times from the new start are rounded
SMALL = ("Time/End Time=6 us", "Grid/Cell Size=5 mm", "Output/Field Interval=3 us")  # of perforation_quick.xml

BLOCK = """<ParameterList name="Barreno">
  <Parameter name="Schema Version" type="int" value="1"/>
  <Parameter name="Title" type="string" value="Block under pressure"/>
  <ParameterList name="Grid">
    <Parameter name="Mode" type="string" value="axisymmetric"/>
    <Parameter name="Lower" type="string" value="{0 mm, -4 mm}"/>
    <Parameter name="Upper" type="string" value="{24 mm, 44 mm}"/>
    <Parameter name="Cell Size" type="string" value="4 mm"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rock">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="string" value="2300 kg/m3"/>
      <Parameter name="Bulk Modulus" type="string" value="10 GPa"/>
      <Parameter name="Shear Modulus" type="string" value="6 GPa"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Block">
      <Parameter name="Material" type="string" value="Rock"/>
      <Parameter name="Lower" type="string" value="{0 mm, 0 mm}"/>
      <Parameter name="Upper" type="string" value="{16 mm, 40 mm}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Conditions">
    <ParameterList name="Axis">
      <Parameter name="Face" type="string" value="x_lower"/>
      <Parameter name="Kind" type="string" value="symmetry"/>
    </ParameterList>
  </ParameterList>
  %s
</ParameterList>
"""
BULK, SHEAR = 10e9, 6e9
FIRST_PRESSURE, SIDE, END = 10e6, 20e6, 50e6
LARGEST_STRAIN = 2.4e-3  # of these stages
FIRST = """<ParameterList name="Confinement">
    <Parameter name="Pressure" type="string" value="10 MPa"/>
    <Parameter name="Bodies" type="string" value="{Block}"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="End Time" type="string" value="20 us"/></ParameterList>"""
SECOND = """<ParameterList name="Loads">
    <ParameterList name="Side">
      <Parameter name="Kind" type="string" value="pressure"/>
      <Parameter name="Body" type="string" value="Block"/>
      <Parameter name="Faces" type="string" value="{x_upper}"/>
      <Parameter name="Pressure" type="string" value="20 MPa"/>
    </ParameterList>
    <ParameterList name="Ends">
      <Parameter name="Kind" type="string" value="pressure"/>
      <Parameter name="Body" type="string" value="Block"/>
      <Parameter name="Faces" type="string" value="{y_lower, y_upper}"/>
      <Parameter name="Pressure" type="string" value="50 MPa"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Quasi-Static"><Parameter name="Inertia Factor" type="double" value="100"/></ParameterList>
  <ParameterList name="Time"><Parameter name="End Time" type="string" value="20 ms"/></ParameterList>
  <ParameterList name="Output"><Parameter name="History Interval" type="string" value="1 ms"/></ParameterList>"""


def settings(*values):
    return [word for value in values for word in ("--set", value)]


def run(barreno, ranks, deck, folder, *values):
    must_work(program(barreno, ranks, "run", deck, "--out", folder, *settings(*values)))
    return folder


def go_on(barreno, ranks, first, deck, folder, *values, rest=True):
    words = ["continue", first, "--deck", deck, "--out", folder, *(["--at-rest"] if rest else []), *settings(*values)]
    must_work(program(barreno, ranks, *words))
    return folder


def summary(folder):
    return json.loads((folder / "summary.json").read_text())


def particles(folder):
    """Fields of all materials of the last checkpoint, by id."""
    fields = {}
    with h5py.File(folder / "checkpoint.h5", "r") as h5:
        for material, group in h5["particles"].items():
            order = np.argsort(group["id"][:, 0])
            for name in group:
                if name != "rank_counts":
                    fields[f"{material}/{name}"] = group[name][...][order]
    return fields


def different(one, other):
    """Fields that are not the same to the bit."""
    a, b = particles(one), particles(other)
    return sorted({*a} ^ {*b}) + [name for name in a if name in b and a[name].tobytes() != b[name].tobytes()]


def check_seam(barreno, folder):
    """With steps of one length a run in two stages ends as the run straight through, every field of every particle to the bit."""
    fixed = (f"Step/Largest Step={STEP!r} s", "Output/Field Interval=0")
    whole = run(barreno, 1, TAYLOR, folder / "whole", *fixed, f"Time/End Time={2 * STEPS * STEP!r} s")
    first = run(barreno, 1, TAYLOR, folder / "first", *fixed, f"Time/End Time={STEPS * STEP!r} s")
    second = go_on(barreno, 1, first, TAYLOR, folder / "second", *fixed, f"Time/End Time={STEPS * STEP!r} s", rest=False)
    assert summary(whole)["steps"] == 2 * STEPS and summary(second)["steps"] == STEPS, (summary(whole)["steps"], summary(second)["steps"])
    assert not different(whole, second), different(whole, second)
    assert different(first, second), "nothing moved in the second stage"
    found = summary(second)["continued"]
    assert found["time"] == STEPS * STEP and found["velocities"] == "kept" and not found["left_out"], found
    assert found["bodies"]["Rod"]["particles"] == summary(first)["particles"]
    # Steps as the code takes them: those at the seam are of other lengths.
    whole = run(barreno, 1, TAYLOR, folder / "free", "Time/End Time=10 us")
    first = run(barreno, 1, TAYLOR, folder / "free_first", "Time/End Time=5 us")
    second = go_on(barreno, 1, first, TAYLOR, folder / "free_second", "Time/End Time=5 us", rest=False)
    a, b = particles(whole)["0/position"], particles(second)["0/position"]
    moved = np.abs(a - particles(first)["0/position"]).max()
    assert np.abs(a - b).max() < 1e-4 * moved, (np.abs(a - b).max(), moved)
    for name in ("mass", "momentum", "energy"):  # the balances close as well as those of the run straight through
        error, before = (abs(summary(one)["balances"][name]["error"]) for one in (second, whole))
        assert error <= max(before, 1e-12), (name, error, before)


def check_seams(barreno, folder):
    """The same of other decks, with the second stage on two ranks; radii of hollow balls go on too."""
    for deck, power, steps in SEAMS:
        place = folder / deck
        place.mkdir()
        step = 2.0**power
        fixed = (f"Step/Largest Step={step!r} s", "Output/Field Interval=0", "Output/History Interval=0")
        half = f"Time/End Time={steps * step!r} s"
        whole = run(barreno, 1, DECKS / deck, place / "whole", *fixed, f"Time/End Time={2 * steps * step!r} s")
        first = run(barreno, 1, DECKS / deck, place / "first", *fixed, half)
        second = go_on(barreno, 2, first, DECKS / deck, place / "second", *fixed, half, rest=False)
        assert summary(whole)["steps"] == 2 * steps and summary(second)["steps"] == steps, deck
        assert different(first, second), f"{deck}: nothing moved in the second stage"
        apart = different(whole, second)
        assert apart == LIGHTING.get(deck, []), f"{deck}: {apart}"
        for name in apart:
            a, b = (particles(one)[name] for one in (whole, second))
            assert np.abs(a - b).max() < 1e-12 * np.abs(a).max(), (deck, name)
        if (whole / "radii.csv").exists():
            ends = [(one / "radii.csv").read_text().splitlines()[-1].split(",")[1:] for one in (whole, second)]
            assert ends[0] == ends[1], ends


def check_ranks(barreno, folder):
    """The same bits on 1, 2 and 3 ranks from runs on 2 and 1, and after a restart from a checkpoint of the second stage."""
    one = run(barreno, 1, QUICK, folder / "shot1", *SMALL)
    two = run(barreno, 2, QUICK, folder / "shot2", *SMALL)
    assert not different(one, two)
    stage = ("Jet=", "Time/End Time=8 us", "Output/Field Interval=2 us", "Grid/Cell Size=5 mm", "Output/Checkpoint Steps=9")
    ends = [go_on(barreno, ranks, two, QUICK, folder / f"stage{ranks}", *stage, rest=False) for ranks in (1, 2, 3)]
    ends.append(go_on(barreno, 2, one, QUICK, folder / "stage_of_one", *stage, rest=False))
    for ranks in (1, 3):
        again = at_previous(pathlib.Path(shutil.copytree(ends[1], folder / f"again{ranks}")))
        shutil.move(two, folder / "elsewhere")  # a restart does not need the first run
        must_work(program(barreno, ranks, "resume", again))
        shutil.move(folder / "elsewhere", two)
        ends.append(again)
    for end in ends[1:]:
        assert not different(ends[0], end) and not different_fields(ends[0], end), end
        assert not different_files(ends[0], end, ("history.csv",)), end
    for end in ends[4:]:
        assert not different_sums(ends[1], end), different_sums(ends[1], end)


def hooke(before, after, exact, stiffer):
    """Errors of stress relative to the larger pressure, and of volume, axial and radial strain relative to the largest strain."""
    change = exact[:3] + FIRST_PRESSURE
    mean = change.mean()
    strain = ((change - mean) / (2 * SHEAR) + mean / (3 * BULK)) / stiffer  # logarithmic, which the rate law integrates to
    volume = np.log(after["0/volume"] / before["0/volume"])[:, 0]
    x, y = (np.log(np.polyfit(before["0/position"][:, d], after["0/position"][:, d], 1)[0]) for d in (0, 1))
    strains = max(abs(volume - strain.sum()).max(), abs(y - strain[1]), abs(x - strain[0])) / abs(strain).max()
    return np.abs(after["0/stress"] - exact).max() / np.abs(exact).max(), strains


def check_pressures(barreno, folder):
    """A block that was under one pressure comes to rest under two others, and in a third stage under one again: stresses and strains of
    Hooke's law. The errors are of the order of the strain, as faces move and particles' shapes follow: a rock 100 times as stiff has a
    100th."""
    for name, more in (("first", FIRST), ("second", SECOND), ("third", SECOND.replace("20 MPa", "50 MPa"))):
        (folder / f"{name}.xml").write_text(BLOCK % more)
    for stiffer in (1, 100):
        rock = (f"Materials/Rock/Bulk Modulus={BULK * stiffer}", f"Materials/Rock/Shear Modulus={SHEAR * stiffer}",
            "Step/Shape Function=CPDI")  # fmt: skip
        slow = (*rock, f"Time/End Time={20 / stiffer**0.5} ms")
        place = folder / f"stiffer{stiffer}"
        place.mkdir()
        first = run(barreno, 1, folder / "first.xml", place / "first", *rock)
        second = go_on(barreno, 2, first, folder / "second.xml", place / "second", *slow)
        # From a run that is itself a second one: loads find the faces of the body as it was made.
        third = go_on(barreno, 1, second, folder / "third.xml", place / "third", *slow)
        before = particles(first)
        assert np.abs(before["0/stress"] - [*(-FIRST_PRESSURE,) * 3, 0.0]).max() < 1e-9 * FIRST_PRESSURE
        for name, end, side in (("second", second, SIDE), ("third", third, END)):
            stress, strain = hooke(before, particles(end), -np.array([side, END, side, 0.0]), stiffer)
            print(f"check_pressures: {stiffer} times as stiff, {name} stage: stress to {stress:.2g}, strain to {strain:.2g}")
            assert stress < LARGEST_STRAIN / stiffer and strain < 3 * LARGEST_STRAIN / stiffer, (stress, strain)
        # The true mass is listed; that of the particles has the inertia, and gets it once.
        for one, listed in ((first, second), (first, third)):
            mass = particles(one)["0/mass"].sum()
            assert np.isclose(summary(listed)["continued"]["bodies"]["Block"]["mass"], mass, rtol=1e-12)
            assert np.isclose(particles(listed)["0/mass"].sum(), 100 * mass, rtol=1e-12)


def check_drained(barreno, folder):
    """The example of the page: a shot without flow, then the pore fluid flows: what was taken over and left is listed."""
    page = (ROOT / "docs" / "continue.md").read_text()
    lines = re.findall(r"^    \./barreno ((?:run|continue) .*(?:\\\n.*)*)", page, re.MULTILINE)
    shot_line, stage_line = (shlex.split(line.replace("\\\n", " ")) for line in lines[:2])
    cheap = settings("Time/End Time=8 us", "Grid/Cell Size=6 mm")
    at = {"runs": folder, "input_xml": ROOT}
    place = lambda word: str(at[word.split("/")[0]] / word) if word.split("/")[0] in at else word  # noqa: E731
    must_work(program(barreno, 1, *map(place, shot_line), *cheap))
    result = must_work(program(barreno, 2, *map(place, stage_line), *cheap))
    shot, stage = (pathlib.Path(place(words[words.index("--out") + 1])) for words in (shot_line, stage_line))
    found = summary(stage)["continued"]
    with h5py.File(shot / "checkpoint.h5", "r") as h5:
        body = np.concatenate([h5[f"particles/{m}/body"][:, 0] for m in h5["particles"]]) & ~DEBRIS
        mass = np.concatenate([h5[f"particles/{m}/mass"][:, 0] for m in h5["particles"]])
    for index, name in enumerate(("Plate", "Rock", "Jet")):
        taken, left = (found[part].get(name, {"particles": 0, "mass": 0.0}) for part in ("bodies", "left_out"))
        assert taken["particles"] + left["particles"] == np.count_nonzero(body == index), (name, found)
        assert np.isclose(taken["mass"] + left["mass"], mass[body == index].sum(), rtol=1e-12), (name, found)
    assert "Jet" in found["left_out"] and found["left_out"]["Jet"]["particles"] > 0 and found["velocities"] == "at rest", found
    assert found["run"] == str(shot) and found["time"] == summary(shot)["time"]
    for words in ("continues  ", "taken      Rock: ", "left       Jet: "):
        assert words in result.stdout, result.stdout
    flow = Run(stage).table("history.csv")
    assert flow["kinetic"][0] == 0.0 and flow["kinetic"][-1] > 0.0
    assert flow["pore_solves"][-1] > 0 and flow["fluid"][-1] > 0.0 and abs(flow["fluid_error"][-1]) < 1e-12, flow


def check_slow(barreno, folder):
    """After a shot the rock is slowly unloaded under a fifth of the pressure; other cells; what is outside of the grid is listed."""
    shot = run(barreno, 1, QUICK, folder / "slow_shot", *SMALL)
    stage = go_on(barreno, 1, shot, QUICK, folder / "slow", "Jet=", "Grid/Cell Size=6 mm", "Grid/Lower={0 mm, -6 mm}",
        "Grid/Upper={60 mm, 318 mm}", "Confinement/Pressure=2 ksi", "Quasi-Static/Inertia Factor=16", "Time/End Time=40 us")  # fmt: skip
    found = summary(stage)["continued"]
    assert set(found["bodies"]) == {"Casing", "Rock"} and "Jet" in found["left_out"], found
    assert summary(stage)["inertia_factor"] == 16 and abs(summary(stage)["balances"]["mass"]["error"]) < 1e-12
    # The masses that are listed are true ones, those of the ledger have the inertia.
    true = sum(body["mass"] for body in found["bodies"].values())
    assert np.isclose(summary(stage)["balances"]["mass"]["initial"], 16 * true, rtol=1e-9)
    narrow = program(barreno, 1, "continue", shot, "--deck", QUICK, "--out", folder / "narrow", "--at-rest",
        *settings("Jet=", "Grid/Cell Size=1 mm"))  # fmt: skip
    refused(narrow, 1, "is smaller than the particles of Bodies/")


def refused(result, code, *words):
    said = result.stderr.strip()
    assert result.returncode == code, f"exit {result.returncode}: {said}"
    assert said.count("\n") == 0 and said.startswith("barreno: ") and said.endswith("."), said
    for word in words:
        assert word in said, f"{word!r} is not in: {said}"


def check_faults(barreno, folder):
    """Each in one sentence, before a folder is made."""
    shot = run(barreno, 1, QUICK, folder / "good", *SMALL)
    cut = pathlib.Path(shutil.copytree(shot, folder / "cut"))
    text = (cut / "summary.json").read_text()
    (cut / "summary.json").write_text(text.replace('"finished": true', '"finished": false'))
    bare = pathlib.Path(shutil.copytree(shot, folder / "bare"))
    (bare / "checkpoint.h5").unlink()
    (bare / "checkpoint_previous.h5").unlink(missing_ok=True)
    edited = pathlib.Path(shutil.copytree(shot, folder / "edited"))
    deck = (edited / "deck.xml").read_text()
    (edited / "deck.xml").write_text(deck.replace('name="Direction" type="string" value="+y"', 'name="Direction" type="string" value="-y"'))
    (folder / "block.xml").write_text(BLOCK % FIRST)
    block = str(folder / "block.xml")
    card = "Materials/Sandstone/Card=seeberger_sandstone.xml"  # with rate dependence
    fine = ("Jet=", "Grid/Cell Size=5 mm", "Time/End Time=1 us")
    faults = (
        (folder / "none", QUICK, fine, 2, "has no summary.json"),
        (cut, QUICK, fine, 1, "has not finished"),
        (bare, QUICK, fine, 2, "holds no checkpoint.h5"),
        (edited, QUICK, fine, 1, "differs from the deck in its checkpoint"),
        (shot, QUICK, fine[1:], 1, "Jet has no place in a deck that continues a run"),
        (shot, QUICK, (*fine, "Grid/Mode=plane strain"), 1, "is not the mode of the run"),
        (shot, block, (), 1, "Bodies/Block is no body of the run", "Casing, Rock"),
        (shot, QUICK, (*fine, "Bodies/Rock/Upper={50.8 mm, 200 mm}"), 1, "Bodies/Rock has another shape"),
        (shot, QUICK, (*fine, "Bodies/Rock/Material=Steel"), 1, "Bodies/Rock/Material", "has the model Johnson-Cook"),
        (shot, QUICK, (*fine, card), 1, "Bodies/Rock/Material", "has other internal variables"),
        (shot, QUICK, (*fine, "Bodies/Rock/Material=Chalk"), 1, "Chalk"),
        (shot, QUICK, (*fine, "Quasi-Static/Inertia Factor=4"), 1, "Continue/Velocities", "Quasi-Static"),
        (shot, QUICK, (*fine, "Step/Transfer=APIC"), 1, "Continue/Velocities", "APIC"),
        (shot, QUICK, (*fine, "Grid/Upper={80 mm, 400 mm}", "Grid/Lower={0 mm, 320 mm}"), 1, "reaches outside the grid"),
    )
    for number, (first, deck, values, code, *words) in enumerate(faults):
        out = folder / f"fault{number}"
        refused(program(barreno, 1, "continue", first, "--deck", deck, "--out", out, *settings(*values)), code, *words)
        assert not out.exists(), out
    refused(program(barreno, 1, "continue", shot), 1, "--deck is missing")
    refused(program(barreno, 1, "continue", "--deck", QUICK), 1, "the folder of the finished run is missing")
    # A card of the same model with other numbers is taken; `check` says where the bodies come from.
    go_on(barreno, 1, shot, QUICK, folder / "other_card", *fine, "Materials/Sandstone/FSLOPE=0.5", rest=False)
    plan = must_work(program(barreno, 1, "check", QUICK, *settings(*fine, f"Continue/Run={shot}")))
    assert f"start with the particles that {shot}" in plan.stdout, plan.stdout
    check_version(barreno, folder, shot, settings(*fine))


def check_version(barreno, folder, shot, words):
    """A checkpoint of another version."""
    other = pathlib.Path(shutil.copytree(shot, folder / "version"))
    (other / "checkpoint_previous.h5").unlink(missing_ok=True)
    with h5py.File(other / "checkpoint.h5", "r+") as h5:
        h5["run/version"][...] = 7.0
    seal(other / "checkpoint.h5")
    refused(program(barreno, 1, "continue", other, "--deck", QUICK, *words), 2, "it has version 7")


def check_forged(barreno, folder):
    """What a checkpoint keeps of the first run is looked at before it is used, whatever its seal."""
    shot = run(barreno, 1, QUICK, folder / "shot", *SMALL)
    stage = go_on(barreno, 1, shot, QUICK, folder / "stage", "Jet=", "Grid/Cell Size=5 mm", "Time/End Time=1 us")
    (stage / "summary.json").unlink()
    file = stage / "checkpoint.h5"
    good = file.read_bytes()
    with h5py.File(file) as h5:
        forged = [(table, change) for table, change in all_kinds(h5, max(h5["particles"])) if table.startswith("continued/")]
        letters = h5["continued_names"][...]
        other = letters.copy()
        other[0] += 1
        forged += [remove("continued_names"), replace("continued_names", letters[:-1]), replace("continued_names", other)]
        forged += [put("continued/id_first", int(h5["continued/id_first"][1, 0])), put("continued/id_material", 99),
            put("continued/in_deck", 0), put("continued/id_count", 1e300)]  # fmt: skip
    assert len(forged) > 30, len(forged)
    for table, change in forged:
        file.write_bytes(good)
        with h5py.File(file, "r+") as h5:
            change(h5)
        seal(file)
        result = program(barreno, 1, "resume", stage, "--until", "2 us")
        assert result.returncode == 2, f"{table} was taken"
        refused(result, 2, "continued")
    file.write_bytes(good)
    must_work(program(barreno, 1, "resume", stage, "--until", "2 us"))
    assert summary(stage)["continued"]["run"] == str(shot) and "Jet" in summary(stage)["continued"]["left_out"]


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    for check in (check_seam, check_seams, check_ranks, check_pressures, check_drained, check_slow, check_faults, check_forged):
        with tempfile.TemporaryDirectory() as name:
            check(barreno, pathlib.Path(name).resolve())
            print(check.__name__, "holds")


if __name__ == "__main__":
    main()
