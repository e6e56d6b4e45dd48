#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files that would take memory, stack or time without end are refused with one sentence, soon: entities, a hundred
thousand lists in each other, gigabytes, devices, pipes, folders; as deck, card, table, path and surface.

    test_hostile_files.py BARRENO
"""
import concurrent.futures
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

from tools.runs import mpi_environment

BAD = pathlib.Path(__file__).resolve().parent / "bad"
CARD = BAD.parents[2] / "materials" / "cards" / "copper.xml"
LIST = '<ParameterList name="a">'
MOST_MEMORY = 700e6  # resident; the largest surface that is read is of 256 MB
MOST_SECONDS = 5  # of processor

TEXTS = {
    "entities": '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">'
    + "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij"))
    + ']><ParameterList name="&j;"/>',
    "external": '<!DOCTYPE a [<!ENTITY a SYSTEM "file:///dev/zero">]><ParameterList name="&a;"/>',
    "undeclared": '<ParameterList name="&a;"/>',
    "deep": LIST * 100000 + "</ParameterList>" * 100000,
    "deep_unclosed": LIST * 300000,
    "less_signs": "<" * 5000000 + ">",
    "long_tag": "<" + "a" * 5000000 + "></b>",
    "brackets": LIST + '<Parameter name="Schema Version" value="1 ' + "(" * 5000000 + '"/></ParameterList>',
}
TRAPS = {  # as any file; exit code
    "a_folder": 2, "a_pipe": 2, "a_device": 2, "a_gigabyte": 1, "missing": 2, "x" * 300: 2, "a\nb": 2}


def prepare(folder):
    for name, text in TEXTS.items():
        (folder / f"{name}.xml").write_text(text)
    (folder / "a_folder").mkdir()
    os.mkfifo(folder / "a_pipe")
    (folder / "a_device").symlink_to("/dev/zero")
    with open(folder / "a_gigabyte", "wb") as file:
        file.truncate(1 << 30)
    jet = (BAD / "jet_header.xml").read_text()
    surface = (BAD / "stl_cut_short.xml").read_text()
    card = (BAD / "missing_card.xml").read_text()
    word = card.split('name="Card"')[1].split('value="')[1].split('"')[0]
    for number, trap in enumerate(TRAPS):
        (folder / f"jet{number}.xml").write_text(jet.replace("header.csv", trap))
        (folder / f"surface{number}.xml").write_text(surface.replace("short.stl", trap))
        (folder / f"card{number}.xml").write_text(card.replace(word, trap))


def cases():
    """(arguments, what the sentence begins with, exit code)"""
    for name in TEXTS:
        yield ["check", f"{name}.xml"], f"{name}.xml", 1
    for number, (trap, code) in enumerate(TRAPS.items()):
        shown = trap.replace("\n", " ")
        yield ["check", trap], shown, code
        yield ["drive", "--material", str(CARD), "--path", trap, "--out", "out.csv"], shown, code
        for kind in ("jet", "surface", "card"):
            # A folder or a missing name is no card; whatever else has the name is read.
            yield ["check", f"{kind}{number}.xml"], f"{kind}{number}.xml: ", code


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (4 * MOST_SECONDS, 4 * MOST_SECONDS))


def problems_of(barreno, folder, arguments, begin, code):
    words = [barreno, *arguments]
    process = subprocess.Popen(
        words, cwd=folder, env={**mpi_environment(), "BARRENO_MATERIALS": ""}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, preexec_fn=limit, text=True, errors="replace")
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    found = []
    if process.returncode != code:
        found.append(f"exit {process.returncode}, not {code}")
    if not said.startswith("barreno: " + begin[:200]) or said.count("\n") != 1 or "; " not in said or len(said) > 3000:
        found.append("not one sentence about that file")
    if usage.ru_utime + usage.ru_stime > MOST_SECONDS:
        found.append(f"{usage.ru_utime + usage.ru_stime} s")
    if usage.ru_maxrss * 1024 > MOST_MEMORY:
        found.append(f"{usage.ru_maxrss} kB")
    return [f"{str(arguments)[:150]}: {problem}: {said[:500]}" for problem in found]


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        prepare(folder)
        jobs = list(cases())
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            found = [problem for problems in pool.map(lambda job: problems_of(barreno, folder, *job), jobs) for problem in problems]
    print("\n".join(found + [f"{len(jobs)} hostile files: {len(found)} problems"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
