#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run whose deck asks for the hole at rest ends there by itself, and says why: on one and on two ranks, after a resume, and with a
longest time that is too short. What `check` and resume say of it.

    test_rest.py BARRENO
"""
import json
import math
import pathlib
import sys
import tempfile

from tools.resumed import at_previous, different_fields, different_files, different_sums, must_work, program
from tools.runs import DECKS, Run

DECK = str(DECKS / "perforation_quick.xml")
# Three slugs that dig, one of which comes late, and one below the cut-off velocity that would come later.
SLUGS = "4x5:{0, 6000, 2e-3, 6e-3, 17600, 2e-6, 5500, 2e-3, 6e-3, 17600, 8e-6, 3000, 2e-3, 6e-3, 17600, 20e-6, 250, 2e-3, 4e-3, 17600}"
LATE, STOPPED = 8e-6, 250.0
CELL = 2e-3
SIZES = ("depth", "probed_depth", "probed_volume")
SETTINGS = ("Time/End Time=at rest", "Jet/Table=", f"Jet/Slugs={SLUGS}", "Output/History Interval=0.5 us", "Output/Field Interval=10 us",
    "Grid/Upper={40 mm, 170 mm}", "Bodies/Casing/Lower={0 mm, 0 mm}", "Bodies/Casing/Upper={20 mm, 4 mm}",
    "Bodies/Rock/Lower={0 mm, 4 mm}", "Bodies/Rock/Upper={20 mm, 150 mm}", "Output/Checkpoint Steps=200")  # fmt: skip


def words(*settings):
    return [word for setting in (*SETTINGS, *settings) for word in ("--set", setting)]


def run(barreno, folder, ranks=1, *settings):
    said = must_work(program(barreno, ranks, "run", DECK, "--out", folder, *words(*settings))).stdout
    return said, summary_of(folder)


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


def refused(result, *parts):
    text = result.stderr.strip()
    assert result.returncode == 1 and text.count("\n") == 0 and all(part in text for part in parts), text


def check_end(said, summary, folder):
    """The run ended by itself: between the late slug and the longest time, a fifth of its time after the last growth."""
    rest, time = summary["penetration"]["rest"], summary["time"]
    assert summary["finished"] and summary["ended_at"] == "rest" and rest["at_rest"], summary["penetration"]
    assert LATE < time < summary["end_time"], (time, summary["end_time"])
    depths = Run(folder).table("depth.csv")
    assert depths["time"][-1] == time == Run(folder).table("history.csv")["time"][-1]
    largest = {name: [max(depths[name][: i + 1]) for i in range(len(depths[name]))] for name in SIZES}
    first = next(t for t, depth in zip(depths["time"], depths["depth"]) if depth > 0.0)

    def settled(row):
        """The rule on depth and volume of the hole as wide as the jet, from the table alone."""
        now = depths["time"][row]
        begin = now - max(0.2 * (now - first), 20 * 2e-3 / 6000.0)
        if begin < first:
            return False
        before = max(i for i, t in enumerate(depths["time"]) if t <= begin)
        assert largest["probed_depth"][row] >= 0.5 * largest["depth"][row], "the depth alone would decide"
        depth, volume = (largest[name][row] for name in SIZES[1:])
        grown, widened = (largest[name][row] - largest[name][before] for name in SIZES[1:])
        wall = 2.0 * math.sqrt(math.pi * volume * depth)
        return grown <= max(1e-3 * depth, 1.000001 * CELL) and widened <= max(1e-3 * volume, 0.1 * CELL * wall)

    rows = len(depths["time"])
    assert settled(rows - 1), "the hole still grew"
    before = max(i for i, t in enumerate(depths["time"]) if t <= time - rest["window"] * (1.0 - 1e-9))
    assert rest["probed"], rest
    for name, growth in zip(SIZES[1:], ("probed_growth", "volume_growth")):
        assert abs(rest[growth] - (largest[name][-1] - largest[name][before])) <= 1e-12 * largest[name][-1], (growth, rest)
    assert rest["share_on_its_way"] <= 1e-3 and rest["window"] > 0.15 * (time - first), rest
    check_sentence(rest, time, largest)
    assert rest["sentence"] in said and ", at rest." in said and "100 %" in said, said
    assert rest["sentence"] in (folder / "run.log").read_text()
    assert summary["jet"]["slugs_launched"] >= 3, summary["jet"]


def check_sentence(rest, time, largest):
    """The target is free and drifts ahead: the tip, which it carries, goes on where the hole no longer grows, and that is said."""
    said = rest["sentence"]
    grew = rest["growth"] > 1e-3 * largest["depth"][-1]
    where = "as far as it is as wide as the jet, " if grew else ""
    deeper, wider = (100.0 * rest[name] / largest[of][-1] for name, of in (("probed_growth", SIZES[1]), ("volume_growth", SIZES[2])))
    assert said.startswith(f"The hole is at rest at {1e6 * time:.4g} us: {where}its depth grew by {deeper:.2g} % in the last"), rest
    assert f", its volume by {wider:.2g} %, and nothing of the jet that can still reach the bottom is on its way." in said, rest
    assert rest["thread_grew"] == grew == (" Its narrower end grew at" in said), rest


def check_quantities(summary):
    """Length and volume of the hole; the hole in all bodies is the hole."""
    found = summary["penetration"]
    parts = found["channel_depth_in_body"]
    assert abs(sum(parts.values()) - found["channel_depth"]) < 1e-12 and 0.0 < parts["Rock"] <= 0.146, found
    cylinder = 3.141592653589793 * found["channel_radius_mid"] ** 2 * found["channel_depth"]
    assert 0.2 * cylinder < found["channel_volume"] < 5.0 * cylinder, (cylinder, found)


def check_ranks_and_resume(barreno, folder, plain):
    two = folder / "two"
    run(barreno, two, 2)
    assert not different_fields(plain, two) and not different_files(plain, two) and not different_sums(plain, two)
    again = at_previous(two)
    must_work(program(barreno, 1, "resume", again))
    assert not different_fields(plain, again) and not different_files(plain, again) and not different_sums(plain, again)
    assert summary_of(again)["ended_at"] == "rest"


def check_going_on(barreno, folder, plain):
    """A run at rest is finished; a time goes on all the same."""
    time = summary_of(plain)["time"]
    refused(program(barreno, 1, "resume", plain), "because the hole of its jet is at rest", "--until")
    refused(program(barreno, 1, "resume", plain, "--longest", "1 ms"), "because the hole of its jet is at rest")
    later = 1.02 * time
    must_work(program(barreno, 1, "resume", plain, "--until", f"{later!r} s"))
    summary = summary_of(plain)
    assert summary["ended_at"] == "end time" and summary["time"] == later, summary["time"]
    assert 'value="at rest"' not in (plain / "deck.xml").read_text()


def check_longest(barreno, folder):
    """A longest time that is too short ends the run, which says so; with a longer one it comes to rest."""
    run_folder = folder / "short"
    said, summary = run(barreno, run_folder, 1, "Time/Longest Time=12 us")
    rest = summary["penetration"]["rest"]
    assert summary["finished"] and summary["ended_at"] == "longest time" and not rest["at_rest"], rest
    assert "The hole is not at rest: its depth grew at" in rest["sentence"] and rest["rate"] > 0.0 and "at its Longest Time." in said, said
    assert "Time/Longest Time = 1.2e-05 s ends the run before its hole is at rest" in said, said
    refused(program(barreno, 1, "resume", run_folder), "has reached its longest time", "--longest", "--until")
    must_work(program(barreno, 1, "resume", run_folder, "--longest", "500 us"))
    summary = summary_of(run_folder)
    assert summary["ended_at"] == "rest" and summary["end_time"] == 500e-6, summary["end_time"]
    return run_folder


def check_fixed_to_rest(barreno, folder):
    """A run with a fixed end says that its hole is not at rest, and goes on to rest."""
    fixed = folder / "fixed"
    said, summary = run(barreno, fixed, 1, "Time/End Time=6 us")
    assert summary["ended_at"] == "end time" and "The hole is not at rest" in summary["penetration"]["rest"]["sentence"], summary
    assert "of the jet's mass, which still digs, is on its way" in said, said
    must_work(program(barreno, 2, "resume", fixed, "--until", "at rest"))
    assert summary_of(fixed)["ended_at"] == "rest"


def check_plan(barreno, time):
    said = must_work(program(barreno, 1, "check", DECK, *words())).stdout
    line = next(line for line in said.splitlines() if line.startswith("Rest "))
    predicted = float(line.split("predicted at ")[1].split(" s:")[0])
    assert 0.3 * time < predicted < 1.5 * time and "3 slugs of at least 1200 m/s" in line, (line, time)
    assert f"Time      to rest, predicted at {predicted:.3g} s" in said and "ends the run before" not in said, said


def main():
    barreno = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        plain = folder / "plain"
        said, summary = run(barreno, plain)
        check_end(said, summary, plain)
        check_quantities(summary)
        check_plan(barreno, summary["time"])
        check_ranks_and_resume(barreno, folder, plain)
        check_longest(barreno, folder)
        check_fixed_to_rest(barreno, folder)
        check_going_on(barreno, folder, plain)
    print(f"at rest at {1e6 * summary['time']:.4g} us, depth {1e3 * summary['penetration']['depth']:.3g} mm, {summary['steps']} steps")


if __name__ == "__main__":
    main()
