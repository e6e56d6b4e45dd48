# SPDX-License-Identifier: BSD-3-Clause
"""Changed decks, cards, tables and surfaces: no crash, no hang, every refusal one sentence."""
import concurrent.futures
import pathlib
import re
import subprocess

from tools.case import Result
from tools.runs import scratch_folder

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("input_xml", "input_xml/jets", "input_xml/paths", "materials/cards", "tests/decks/bad", "tests/fuzz/corpus")
# Rounds in a run of the tests and in full; a seed for every process.
ROUNDS = {"deck": (2000, 100000), "card": (500, 20000), "jet": (500, 20000), "path": (500, 20000), "surface": (500, 20000)}
SEEDS = (1, 2)


def begin_from():
    files = [file for folder in FOLDERS for file in sorted((ROOT / folder).glob("*.*"))]
    return [file for file in files if file.suffix in (".xml", ".csv", ".stl", ".card")]


def fuzz(program, folder, reader, rounds, seed):
    words = [program, folder / f"{reader}{seed}", reader, str(rounds), str(seed), *begin_from()]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace")
    told = re.search(rf"^{reader} (inputs .*)$", done.stdout, re.MULTILINE)
    numbers = dict(zip(*[iter(told.group(1).split())] * 2)) if told else {}
    said = (done.stdout + done.stderr)[-2000:]
    return {"crashed": not told or done.returncode not in (0, 1), "said": said, **{key: float(text) for key, text in numbers.items()}}


def run(barreno, full):
    result = Result(
        "Changed input",
        "Whatever the input, reading a deck, a card, a jet table, a path or an STL surface ends with a scene, a material, a table or one "
        "sentence.",
        "the rule that a refusal is one line that begins with the file's name, states a reason and says what to do. The inputs are "
        "changed at random (tests/fuzz): values, names, types and lists of the decks and cards of this repository, cells of tables, "
        "corners of surfaces, bytes. The address and undefined-behaviour sanitizers watch, on a machine of 64 MB. "
        "A deck is processed completely: text, included files, tables, scene.",
        ["reader", "inputs", "seeds", "accepted", "kinds of sentences", "crashes", "not one sentence", "over 1 s",
            "longest [s of processor]"],
        [],
    )
    # In the build folder of the program, with the tests.
    program = pathlib.Path(barreno).resolve().parents[1] / "tests" / "fuzz" / "fuzz_readers"
    folder = pathlib.Path(scratch_folder())
    for reader, (few, many) in ROUNDS.items():
        rounds = (many if full else few) // len(SEEDS)
        with concurrent.futures.ThreadPoolExecutor(len(SEEDS)) as pool:
            found = list(pool.map(lambda seed: fuzz(program, folder, reader, rounds, seed), SEEDS))
        sums = {key: sum(part.get(key, 0) for part in found) for key in ("inputs", "accepted", "faults", "slow")}
        crashes = sum(part["crashed"] for part in found)
        kinds = max(part.get("kinds", 0) for part in found)
        longest = max(part.get("slowest", 0) for part in found)
        seeds = " and ".join(map(str, SEEDS))
        result.rows.append([reader, int(sums["inputs"]), seeds, int(sums["accepted"]), int(kinds), crashes, int(sums["faults"]),
            int(sums["slow"]), longest])
        result.demand(f"{reader}: inputs", sums["inputs"], rounds * len(SEEDS), at_least=True)
        result.demand(f"{reader}: some are accepted", sums["accepted"], 1, at_least=True)
        result.demand(f"{reader}: some are refused", sums["inputs"] - sums["accepted"], 1, at_least=True)
        result.demand(f"{reader}: crashes", crashes, 0)
        result.demand(f"{reader}: not one sentence", sums["faults"], 0)
        result.demand(f"{reader}: over 1 s", sums["slow"], 0)
        if crashes or sums["faults"] or sums["slow"]:
            print("\n".join(part["said"] for part in found))
    result.notes = (
        "Kinds are sentences that differ in more than their numbers and quoted words (of the seed that produced more of them)."
    )
    return result
