#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every bad deck fails with its own sentence and exit code, on every rank count, and leaves nothing behind.

    test_bad_decks.py BARRENO [--server SERVE_RUNS] [--ranks 1 2] [--update] [NAME ...]

Beside each bad/NAME.xml stands NAME.expected: a line "exit CODE", then the sentence as stderr shows it. Nearly all of the
time goes into the start of MPI: with a server (verification/adversary/serve_runs.cpp), which starts it once, one of
EVERY inputs is given to the program itself and the others to the server. --update writes the .expected files from what the program says
now; read the difference before it is kept.
"""

import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from adversary.run_server import RunServer
from tools.runs import mpi_environment

EVERY = 8
NO_CARDS = {"BARRENO_MATERIALS": ""}
BAD = pathlib.Path(__file__).resolve().parent / "bad"
GOOD = BAD / "good.deck"


def prepare(folder, decks):
    """What the decks take from beside them, and the decks of those names."""
    for file in BAD.iterdir():
        if file.suffix != ".expected" and (file.suffix != ".xml" or file.name in decks):
            shutil.copy(file, folder)
    shutil.copy(GOOD, folder / "good.xml")
    (folder / "a_file").write_text("not a folder\n")
    (folder / "a_result").mkdir()
    (folder / "a_result" / "summary.json").write_text("{}\n")


def listing(folder):
    """Everything in a folder: sizes, and times of the last change."""
    found = {}
    for place, folders, files in os.walk(folder):
        found.update(dict.fromkeys((os.path.relpath(os.path.join(place, name), folder) for name in folders)))
        for name in files:
            facts = os.stat(os.path.join(place, name))
            found[os.path.relpath(os.path.join(place, name), folder)] = (facts.st_size, facts.st_mtime_ns)
    return found


def run(barreno, ranks, folder, arguments):
    command = [barreno, "run", *arguments]
    if ranks > 1:
        command = ["mpirun", "--quiet", "-n", str(ranks), *command]
    result = subprocess.run(command, cwd=folder, env={**mpi_environment(), **NO_CARDS}, capture_output=True, text=True, timeout=120)
    return f"exit {result.returncode}\n{result.stderr}"


def expected_of(name):
    file = BAD / f"{name}.expected"
    return file.read_text() if file.exists() else "(no .expected file)"


def problems_of(name, answer, before, left):
    """What is wrong, or nothing."""
    problems = []
    if answer != expected_of(name):
        problems.append(f"expected\n{expected_of(name)}but got\n{answer}")
    if answer.startswith("exit 0"):
        problems.append("it did not fail")
    if answer.count("\n") != 2:
        problems.append(f"stderr is not one sentence on one line:\n{answer}")
    if left != before:
        changed = sorted(set(left) ^ set(before)) or "contents of a file"
        problems.append(f"left behind or changed: {changed}")
    return problems


def check(barreno, ranks, name, arguments, update):
    """One input, given to a process of its own."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        prepare(folder, arguments)
        before = listing(folder)
        answer = run(barreno, ranks, folder, arguments)
        left = listing(folder)
    if update:
        (BAD / f"{name}.expected").write_text(answer)
    return problems_of(name, answer, before, left)


def check_served(program, ranks, cases):
    """All given inputs, one after the other. @return problems by name"""
    found = {}
    with tempfile.TemporaryDirectory() as scratch, tempfile.TemporaryDirectory() as said:
        folder = pathlib.Path(scratch)
        prepare(folder, {word for words in cases.values() for word in words})
        before, names = listing(folder), sorted(os.listdir(folder))
        server = RunServer(program, said, ranks, at=folder, more=NO_CARDS)
        for name, arguments in cases.items():
            ended = server.run("run", *arguments, limit=120)
            found[name] = problems_of(name, f"{ended.text()}\n{ended.err}", names, sorted(os.listdir(folder)))
        server.end()
        # Times and sizes of all of the files take longer than a case: once, behind the last.
        if listing(folder) != before:
            found[name].append("one of the inputs has changed a file")
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("barreno", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--server", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_intermixed_args()
    cases = {file.stem: [file.name] for file in sorted(BAD.glob("*.xml"))}
    cases.update(
        out_is_a_file=["good.xml", "--out", "a_file"],
        out_below_a_file=["good.xml", "--out", "a_file/results"],
        out_holds_a_result=["good.xml", "--out", "a_result"],
        missing_deck=["nowhere.xml"],
        bad_override=["good.xml", "--set", "Time/End Tim=1 us"],
        override_of_misspelt_list=["good.xml", "--set", "Bodies/Blok/Upper={4 mm, 4 mm}"],
        override_without_value=["good.xml", "--set", "Time/End Time"],
        unknown_fidelity=["good.xml", "--fidelity", "quick"],
        fidelity_without_word=["good.xml", "--fidelity"],
        unknown_fidelity_word=["good.xml", "--set", "Fidelity=quick"],
    )
    chosen = [name for name in cases if not options.names or name in options.names]
    alone = chosen[::EVERY] if options.server and not options.update else chosen
    jobs = [(name, ranks) for name in alone for ranks in options.ranks]
    found = []
    # Starting MPI is mostly waiting, so several at once cost no more processor.
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        apart = pool.map(lambda job: check(options.barreno, job[1], job[0], cases[job[0]], options.update), jobs)
        found += [(name, ranks, problems) for (name, ranks), problems in zip(jobs, apart)]
    served = {name: cases[name] for name in chosen if name not in alone}
    for ranks in options.ranks if served else ():
        found += [(name, ranks, problems) for name, problems in check_served(options.server, ranks, served).items()]
    failed = sum(len(problems) for _, _, problems in found)
    for name, ranks, problems in found:
        for problem in problems:
            print(f"{name}, {ranks} ranks: {problem}")
    print(f"{len(chosen)} bad inputs on {options.ranks} ranks: {failed} problems")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
