#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every bad deck fails with its own sentence and exit code, on every rank count, and leaves nothing behind.

    test_bad_decks.py BARRENO [--ranks 1 2] [--update] [NAME ...]

Beside each bad/NAME.xml stands NAME.expected: a line "exit CODE", then the sentence as stderr shows it.
--update writes the .expected files from what the program says now; read the difference before it is kept.
"""

import argparse
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "verification" / "tools"))
from runs import mpi_environment  # noqa: E402

BAD = pathlib.Path(__file__).resolve().parent / "bad"
GOOD = BAD / "good.deck"


def prepare(folder):
    shutil.copytree(BAD, folder, dirs_exist_ok=True)
    shutil.copy(GOOD, folder / "good.xml")
    (folder / "a_file").write_text("not a folder\n")
    (folder / "a_result").mkdir()
    (folder / "a_result" / "summary.json").write_text("{}\n")


def listing(folder):
    return {str(path.relative_to(folder)): path.is_file() and path.read_bytes() for path in folder.rglob("*")}


def run(barreno, ranks, folder, arguments):
    command = [barreno, "run", *arguments]
    if ranks > 1:
        command = ["mpirun", "--quiet", "-n", str(ranks), *command]
    result = subprocess.run(
        command, cwd=folder, env={**mpi_environment(), "BARRENO_MATERIALS": ""}, capture_output=True, text=True, timeout=120
    )
    return f"exit {result.returncode}\n{result.stderr}"


def expected_of(name):
    file = BAD / f"{name}.expected"
    return file.read_text() if file.exists() else "(no .expected file)"


def check(barreno, ranks, name, arguments, update):
    """What is wrong, or nothing."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        prepare(folder)
        before = listing(folder)
        answer = run(barreno, ranks, folder, arguments)
        left = listing(folder)
    problems = []
    if update:
        (BAD / f"{name}.expected").write_text(answer)
    elif answer != expected_of(name):
        problems.append(f"expected\n{expected_of(name)}but got\n{answer}")
    if answer.startswith("exit 0"):
        problems.append("it did not fail")
    if answer.count("\n") != 2:
        problems.append(f"stderr is not one sentence on one line:\n{answer}")
    if left != before:
        changed = sorted(set(left) ^ set(before)) or "contents of a file"
        problems.append(f"left behind or changed: {changed}")
    return problems


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("barreno", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
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
    jobs = [(name, ranks) for name in chosen for ranks in options.ranks]
    # Starting MPI is mostly waiting, so several at once cost no more processor.
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        found = pool.map(lambda job: check(options.barreno, job[1], job[0], cases[job[0]], options.update), jobs)
    failed = 0
    for (name, ranks), problems in zip(jobs, found):
        for problem in problems:
            failed += 1
            print(f"{name}, {ranks} ranks: {problem}")
    print(f"{len(chosen)} bad inputs on {options.ranks} ranks: {failed} problems")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
