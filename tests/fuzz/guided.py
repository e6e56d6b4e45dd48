#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The readers of a user's files under libFuzzer, guided by the code that inputs reach.

    cmake --preset guided && cmake --build build/guided --target fuzz_guided
    guided.py build/guided/tests/fuzz/fuzz_guided FOLDER [--minutes N] [READER...]

Every reader gets so many minutes of one processor, two at a time. FOLDER keeps the inputs that reached something new, and
crashes, inputs over five seconds of processor and refusals that are not one sentence, as READER/crash-*. Prints a table; exit
code 1 if anything was found.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("input_xml", "input_xml/jets", "input_xml/paths", "materials/cards", "tests/decks/bad", "tests/fuzz/corpus")
READERS = ("deck", "card", "jet", "path", "surface")


def reader_of(file):  # as fuzz_readers has it
    if file.suffix == ".csv":
        return "path" if b"F11" in file.read_bytes() else "jet"
    if file.suffix == ".card" or (file.suffix == ".xml" and file.parent.name == "cards"):
        return "card"
    return {".stl": "surface", ".xml": "deck"}.get(file.suffix)


def collect(reader, corpus):
    corpus.mkdir(parents=True, exist_ok=True)
    for file in (file for folder in FOLDERS for file in (ROOT / folder).glob("*.*")):
        if reader_of(file) == reader:
            shutil.copy(file, corpus / f"{file.parent.name}_{file.name}")


def fuzz(program, folder, reader, minutes):
    """Executions, edges of the program that they reached, inputs that reached a new one, and what was found."""
    place = folder / reader
    collect(reader, place / "corpus")
    environment = {**os.environ, "BARRENO_READER": reader, "BARRENO_FOLDER": str(place / "work")}
    environment["ASAN_OPTIONS"] = "max_allocation_size_mb=1200:detect_leaks=0"
    words = [program, place / "corpus", f"-max_total_time={60 * minutes:.0f}", "-timeout=5", "-rss_limit_mb=3000", "-max_len=65536",
             "-print_final_stats=1", f"-artifact_prefix={place}/"]  # fmt: skip
    done = subprocess.run(words, env=environment, capture_output=True, text=True, errors="replace")
    (place / "log").write_text(done.stderr)
    runs = re.findall(r"stat::number_of_executed_units: (\d+)", done.stderr)
    edges = re.findall(r"cov: (\d+)", done.stderr)
    found = sorted(file.name for kind in ("crash", "timeout", "oom") for file in place.glob(f"{kind}-*"))
    if done.returncode and not found:
        found = [f"exit {done.returncode}: {done.stderr[-500:]}"]
    return [reader, runs[-1] if runs else "?", edges[0] if edges else "?", edges[-1] if edges else "?",
        len(list((place / "corpus").iterdir())), found]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("readers", nargs="*", default=READERS)
    parser.add_argument("--minutes", type=float, default=5)
    arguments = parser.parse_args()
    program, folder = pathlib.Path(arguments.program).resolve(), arguments.folder.resolve()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        rows = list(pool.map(lambda reader: fuzz(program, folder, reader, arguments.minutes), arguments.readers))
    print("| reader | inputs | edges reached by the files of the repository | in the end | inputs kept | found "
        "|\n|---|---|---|---|---|---|")
    for row in rows:
        print("| " + " | ".join(map(str, row[:-1])) + f" | {', '.join(row[-1]) or 'nothing'} |")
    sys.exit(any(row[-1] for row in rows))


if __name__ == "__main__":
    main()
