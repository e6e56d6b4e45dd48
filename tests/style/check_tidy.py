#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every compiled file passes clang-tidy (.clang-tidy).

    check_tidy.py BUILD [--recent | FILE ...]

With --recent, files are left out that were last changed more than five hours before the newest commit, and, of the code itself,
so was every header of this repository that they name.

Most of clang-tidy's time goes into the headers of the libraries, so files are looked at together, in few translation
units that include them. The same name in two unnamed namespaces cannot stand in one: such files are dealt out to
different units, and what a first look at the text misses, clang's own errors tell. A unit whose text, headers and rules
are those of its last clean pass is skipped: what passed is kept in BUILD/tidy.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECENT = 5 * 3600  # s
SKIPPED = 77  # what ctest counts as skipped
RULES = ROOT / ".clang-tidy"
TOGETHER = 75  # files, at most
PRECOMPILED = "cmake_pch.hxx.cxx"  # CMake's own, with which it precompiles headers
TOGETHER_BY_CMAKE = "/Unity/unity_"  # CMake's own, which include the sources of a folder or of a test program
INCLUDED = re.compile(r'^#include "(.*)"$', re.MULTILINE)
# What a file means does not depend on these; without them files of many targets have the same options. Checked indices
# are code of the libraries' headers.
WITHOUT_MEANING = re.compile(
    r"-(f(PIC|no-omit-frame-pointer|no-sanitize.*|sanitize.*|pch-preprocess)|g\d?|O\d|Winvalid-pch"
    r"|D(\w+_EXPORTS|KOKKOS_ENABLE_DEBUG_BOUNDS_CHECK|_GLIBCXX_ASSERTIONS))$"
)
APART = re.compile(r"^(?:TEST(?:_F|_P)?\((\w+, \w+)\)|int (main)\()", re.MULTILINE)
UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# At the beginning of a line, as clang-format leaves them: types, constants, functions.
NAMES = re.compile(
    r"^(?:(?:struct|class|enum|enum class) (\w+)|using (\w+) ="
    r"|(?!return|using|namespace|#)[\w:]+[\w:<>,&* ]*[ &*](\w+)(?:\[|\{| =|;))",
    re.MULTILINE,
)
FUNCTIONS = re.compile(r"^(?!return|#)[\w:][\w:<>,&*\s]*?[ &*](\w+)\(([^)]*)\)", re.MULTILINE)
PARAMETER = re.compile(r" ?\w+(?=,|$)")
CONSTANTS = re.compile(r"^(?:const|constexpr) .*?;", re.MULTILINE | re.DOTALL)
USED = re.compile(r"^using [\w:]+::(\w+);", re.MULTILINE)


def compilations(build):
    """The database of compilations, with what CMake compiles as one file taken apart again."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        if TOGETHER_BY_CMAKE in str(file):
            yield from ({**entry, "file": source} for source in INCLUDED.findall(file.read_text()))
        elif file.name != PRECOMPILED:
            yield entry


def options_of(entry):
    """Compiler options that change what a file means, each with its argument."""
    words = shlex.split(entry["command"])[1:]
    options = []
    while words:
        word = words.pop(0)
        if word in ("-o", "-c", "-include"):
            words.pop(0)
        elif word == "-isystem":
            options.append((word, words.pop(0)))
        elif not WITHOUT_MEANING.match(word):
            options.append((word,))
    return tuple(options)


def defined(options):
    return dict(word[0][2:].partition("=")[::2] for word in options if word[0].startswith("-D"))


def merged(options):
    """Files by options, where options that do not contradict each other are taken together."""
    sets = []
    for words, files in sorted(options.items(), key=lambda item: -len(item[1])):
        for known in sets:
            own, other = defined(known[0]), defined(words)
            if all(own[name] == other[name] for name in own.keys() & other.keys()):
                known[0] += tuple(word for word in words if word not in known[0])
                known[1] |= files
                break
        else:
            sets.append([words, set(files)])
    return [([part for word in words for part in word], sorted(files)) for words, files in sets]


def names_of(file):
    """What a file may have in an unnamed namespace or as a test: names and signatures; names alone; those it uses."""
    text = pathlib.Path(file).read_text()
    own = {test or main for test, main in APART.findall(text)}
    functions = set()
    for block in UNNAMED.findall(text):
        own.update(name for match in NAMES.findall(block) for name in match if name)
        own.update(name for line in CONSTANTS.findall(block) for name in re.findall(r"(\w+) =", line))
        functions.update((name, PARAMETER.sub("", " ".join(words.split()))) for name, words in FUNCTIONS.findall(block))
    names = own | {name for name, _ in functions}
    return own | functions, names, set(USED.findall(text))


def deal(files):
    """Units of files without names that stand twice. Neighbours stay together: they read the same headers."""
    count = -(-len(files) // TOGETHER)
    size = -(-len(files) // count)
    units = [([], set(), set(), set()) for _ in range(count)]
    for at, file in enumerate(files):
        own, names, used = names_of(file)
        order = sorted(units, key=lambda unit: (unit is not units[at // size], len(unit[0])))
        fits = [u for u in order if not (own & (u[1] | u[2]) or names & (u[1] | u[3]) or used & u[2])]
        if not fits:
            fits = [([], set(), set(), set())]
            units += fits
        fits[0][0].append(file)
        for known, new in zip(fits[0][1:], (own, names, used)):
            known.update(new)
    return [unit[0] for unit in units if unit[0]]


def units_of(entries):
    by_options = {}
    for entry in entries:
        by_options.setdefault(options_of(entry), set()).add(entry["file"])
    for options, files in merged(by_options):
        for unit in deal(files):
            yield options, unit


def recently_changed():
    """Names of the files of the commits of five hours, and of what is not committed; None without a repository."""
    git = ["git", "-C", str(ROOT)]
    newest = subprocess.run([*git, "log", "-1", "--format=%ct"], capture_output=True, text=True)
    if newest.returncode != 0:
        return None
    since = f"--since={int(newest.stdout) - RECENT}"
    listings = ([*git, "log", since, "--name-only", "--format="], [*git, "diff", "--name-only", "HEAD"],
        [*git, "ls-files", "--others", "--exclude-standard"])
    return {name for words in listings for name in subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()}


def include_folders(entries):
    """Those of this repository, in which its headers are looked for."""
    words = {word for entry in entries for word in shlex.split(entry["command"]) if word.startswith("-I" + str(ROOT) + "/")}
    return tuple(pathlib.Path(word[2:]) for word in sorted(words))


@functools.lru_cache(maxsize=None)
def headers_of(file, folders):
    """The headers of this repository that a file names."""
    places = ([folder / name for folder in (file.parent, *folders)] for name in INCLUDED.findall(file.read_text()))
    found = (next((path.resolve() for path in paths if path.exists()), None) for paths in places)
    return {path for path in found if path is not None and ROOT in path.parents}


def is_recent(file, folders, changed):
    """Whether a file was changed or, of the code itself, a header that it names."""
    path = pathlib.Path(file).resolve()
    name = str(path.relative_to(ROOT))
    if not name.startswith(("src/", "materials/")):
        return name in changed
    return any(str(one.relative_to(ROOT)) in changed for one in {path} | headers_of(path, folders))


def own_files(options, files):
    """The files of this repository that a compilation reads, as the compiler lists them."""
    listing = subprocess.run(["c++", *options, "-M", *files], capture_output=True, text=True, check=True)
    words = listing.stdout.replace("\\\n", " ").split()
    return sorted({word for word in words if word.startswith(str(ROOT) + "/") and not word.endswith(":")})


def fingerprint(options, files):
    digest = hashlib.sha256(RULES.read_bytes() + " ".join(options).encode())
    for name in own_files(options, files):
        digest.update(name.encode() + pathlib.Path(name).read_bytes())
    return digest.hexdigest()


def tidy(options, path, *words):
    # GCC's warnings that clang does not know must not count as findings.
    command = ["clang-tidy", "--quiet", *words, str(path), "--", *options, "-Wno-unknown-warning-option"]
    return subprocess.run(command, capture_output=True, text=True)


def clashing(options, unit, files):
    """The files that cannot stand behind those before them: clang's errors are in them. A single check costs little."""
    result = tidy(options + ["-w", "-ferror-limit=0"], unit, "--checks=-*,bugprone-posix-return")
    wrong = {line.split(":")[0] for line in result.stdout.splitlines() if ": error: " in line}
    if not wrong:
        return []
    return [file for file in files[1:] if file in wrong] or files[len(files) // 2 :]


def findings_of(options, files, folder):
    """Findings of a unit; an empty text if there are none."""
    unit, apart = files[0], []
    if len(files) > 1:
        unit = folder / (hashlib.sha256(" ".join(options + files).encode()).hexdigest()[:16] + ".cpp")
        unit.write_text("".join(f'#include "{file}"  // NOLINT\n' for file in files))
        apart = clashing(options, unit, files)
    if apart:
        print("apart: " + ", ".join(pathlib.Path(file).name for file in apart), flush=True)
        rest = [file for file in files if file not in apart]
        return findings_of(options, rest, folder) + findings_of(options, apart, folder)
    result = tidy(options, unit)
    if result.returncode == 0:
        return ""
    return f"clang-tidy ended with {result.returncode}\n{result.stdout}{result.stderr}"


def check(options, files, folder):
    """True if the unit is clean."""
    start = time.time()
    stamp = folder / (hashlib.sha256(" ".join(options + files).encode()).hexdigest()[:16] + ".passed")
    now = fingerprint(options, files)
    if stamp.exists() and stamp.read_text() == now:
        return True
    findings = findings_of(options, files, folder)
    if not findings:
        stamp.write_text(now)
    names = ", ".join(pathlib.Path(file).name for file in files)
    print(f"{findings}{time.time() - start:.1f} s: {names}", flush=True)
    return not findings


def main():
    if shutil.which("clang-tidy") is None:
        print("clang-tidy is missing: install the package clang-tidy.")
        return SKIPPED
    build = pathlib.Path(sys.argv[1]).resolve()
    entries = list(compilations(build))
    words = sys.argv[2:]
    if words == ["--recent"]:
        changed = recently_changed()
        folders = include_folders(entries)
        entries = [e for e in entries if changed is None or is_recent(e["file"], folders, changed)]
    elif words:
        entries = [e for e in entries if any(word in e["file"] for word in words)]
    assert entries or words == ["--recent"], f"no compilation in {build} matches {words}"
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)

    units = sorted(units_of(entries), key=lambda unit: -len(unit[1]))
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        clean = list(pool.map(lambda unit: check(*unit, folder), units))
    print(f"{len(entries)} files, {len(clean) - sum(clean)} of {len(clean)} units with findings")
    return 0 if all(clean) else 1


if __name__ == "__main__":
    sys.exit(main())
