#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every compiled file passes clang-tidy (.clang-tidy).

    check_tidy.py BUILD [FILE ...]

Most of clang-tidy's time goes into the headers of the libraries, so files with the same compiler options are looked at
together, in one translation unit that includes them, but for those that cannot stand together (the same name in
two unnamed namespaces): they make groups of their own. A group whose text, headers and rules are those of its last clean
pass is skipped: what passed is kept in BUILD/tidy.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOT_COMPILED = "[clang-diagnostic-error"
SKIPPED = 77  # what ctest counts as skipped
RULES = ROOT / ".clang-tidy"
TOGETHER = 40  # files
PRECOMPILED = "cmake_pch.hxx.cxx"  # CMake's own, with which it precompiles headers


def options_of(entry):
    """Compiler options without the file itself and the precompiled headers, which are another compiler's."""
    words = shlex.split(entry["command"])[1:]
    while "-include" in words:
        where = words.index("-include")
        del words[where : where + 2]
    words = [word for word in words if word not in ("-Winvalid-pch", "-fpch-preprocess")]
    for option in ("-o", "-c"):
        where = words.index(option)
        del words[where : where + 2]
    return tuple(words)


def groups_of(entries):
    by_options = {}
    for entry in entries:
        by_options.setdefault(options_of(entry), set()).add(entry["file"])
    for options, found in by_options.items():
        files = sorted(found)
        for start in range(0, len(files), TOGETHER):
            yield list(options), files[start : start + TOGETHER]


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


def tidy(options, path):
    # GCC's warnings that clang does not know must not count as findings.
    command = ["clang-tidy", "--quiet", str(path), "--", *options, "-Wno-unknown-warning-option"]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode == 0:
        return ""
    return f"clang-tidy ended with {result.returncode}\n{result.stdout}{result.stderr}"


def clashing(options, unit, files):
    """The files that cannot stand behind those before them: the compiler's errors are in them."""
    result = subprocess.run(["c++", *options, "-fsyntax-only", "-w", str(unit)], capture_output=True, text=True)
    if result.returncode == 0:
        return []
    wrong = {line.split(":")[0] for line in result.stderr.splitlines() if ": error: " in line}
    found = [file for file in files[1:] if file in wrong]
    return found or files[len(files) // 2 :]


def findings_of(options, files, folder):
    """Findings of a group; an empty text if there are none. The compiler, which is quicker, says what stands together."""
    if len(files) == 1:
        return tidy(options, files[0])
    unit = folder / (hashlib.sha256(" ".join(options + files).encode()).hexdigest()[:16] + ".cpp")
    unit.write_text("".join(f'#include "{file}"  // NOLINT\n' for file in files))
    apart = clashing(options, unit, files)
    if not apart:
        findings = tidy(options, unit)
        if NOT_COMPILED not in findings:
            return findings
        apart = files[len(files) // 2 :]
    rest = [file for file in files if file not in apart]
    return findings_of(options, rest, folder) + findings_of(options, apart, folder)


def check(options, files, folder):
    """True if the group is clean."""
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
    entries = json.loads((build / "compile_commands.json").read_text())
    entries = [e for e in entries if pathlib.Path(e["file"]).name != PRECOMPILED]
    entries = [e for e in entries if not sys.argv[2:] or any(word in e["file"] for word in sys.argv[2:])]
    assert entries, f"no compilation in {build} matches {sys.argv[2:]}"
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        # the last groups take longest: tests, which share names
        clean = list(pool.map(lambda group: check(*group, folder), reversed(list(groups_of(entries)))))
    print(f"{len(entries)} files, {len(clean) - sum(clean)} of {len(clean)} groups with findings")
    return 0 if all(clean) else 1


if __name__ == "__main__":
    sys.exit(main())
