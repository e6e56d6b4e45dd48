#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of `./barreno test` start is what their target, user_tests, builds: a program that only a build of everything makes would
be missing in a fresh clone. Also: what .ci/run leaves to its second pass is all that the first leaves out, but for the label slow.

    check_user_tests.py BUILD_FOLDER CTEST NINJA
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = "user_tests"
SEPARATORS = re.compile(r"[=:;,\s]")


def output_of(*words):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, check=True).stdout


def tests_in(ctest, build, *labels):
    """{name: (words of its command, its environment)}"""
    shown = json.loads(output_of(ctest, "--test-dir", build, "--show-only=json-v1", *labels))
    found = {}
    for test in shown["tests"]:
        environment = [text for one in test.get("properties", []) if one["name"] == "ENVIRONMENT" for text in one["value"]]
        found[test["name"]] = (test.get("command", []), environment)
    return found


def built_files(ninja, build):
    """Programs and libraries that the whole build links, as absolute paths."""
    found = set()
    for line in output_of(ninja, "-C", build, "-t", "targets", "all").splitlines():
        name, _, rule = line.rpartition(": ")
        if re.match(r"(CXX|C)_(EXECUTABLE|MODULE_LIBRARY|SHARED_LIBRARY)_LINKER", rule):
            found.add((build / name).resolve())
    return found


def inputs_of(ninja, build, target):
    """All files that a target is made of, and what those are made of."""
    found, waiting = set(), [target]
    while waiting:
        said, waiting, reading = output_of(ninja, "-C", build, "-t", "query", *waiting), [], False
        for line in said.splitlines():
            if re.match(r"  (input|outputs):", line):
                reading = line.startswith("  input:")
            elif reading and line.startswith("    "):
                name = line.strip().removeprefix("| ").removeprefix("|| ")
                if name not in found:
                    found.add(name)
                    waiting.append(name)
    return {(build / name).resolve() for name in found}


def named_files(words, environment, linked):
    """Of the linked files those that a test names: in its command, in its environment, or by its name in quotes in the script that it runs,
    which gets the build folder alone."""
    texts = [part for word in [*words, *environment] for part in [word, *SEPARATORS.split(word)]]
    found = {pathlib.Path(text).resolve() for text in texts if text.startswith("/")} & linked
    for word in words:
        if word.endswith(".py") and word.startswith("/"):
            source = pathlib.Path(word).read_text()
            found |= {file for file in linked if re.search(rf"[\"'/]{re.escape(file.name)}[\"']", source) and "sanitized" not in file.name}
    return found


def missing_of(tests, linked, built):
    """A sentence for each file that a test needs and its target does not make."""
    lacking = {}
    for name, (words, environment) in tests.items():
        for file in named_files(words, environment, linked) - built:
            lacking.setdefault(file, []).append(name)
    return [f"{', '.join(sorted(names))} needs {file}, which the target {TARGET} does not build; add it in tests/CMakeLists.txt"
        for file, names in sorted(lacking.items())]


def launcher_labels():
    return re.search(r"left_out='([^']+)'", (ROOT / "barreno").read_text()).group(1)


def second_pass_labels():
    return re.search(r"barreno test -L '([^']+)'", (ROOT / ".ci" / "run").read_text()).group(1)


def left_by_both(ctest, build, labels):
    """Tests that neither pass of .ci/run has, and those that both have."""
    first = set(tests_in(ctest, build, "-LE", labels))
    second = set(tests_in(ctest, build, "-LE", "slow", "-L", second_pass_labels()))
    wanted = set(tests_in(ctest, build, "-LE", "slow"))
    out = [f"{name}: neither pass of .ci/run has it" for name in sorted(wanted - first - second)]
    return out + [f"{name}: both passes of .ci/run have it" for name in sorted(first & second)]


def check_itself(tests, linked, built):
    """A program that is not built is found, whether the command, the environment or a script names it."""
    for name, file in (("deck.bad_decks", "serve_runs"), ("verification.paper", "barreno_scaled_domains"),
            ("deck.launcher_signals", "barreno")):
        (gone,) = (one for one in linked if one.name == file)
        found = missing_of({name: tests[name]}, linked, built - {gone})
        if len(found) != 1 or str(gone) not in found[0]:
            return [f"this script does not see that {name} needs {file}: {found}"]
    return []


def main():
    build, ctest, ninja = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
    labels = launcher_labels()
    tests, linked, built = tests_in(ctest, build, "-LE", labels), built_files(ninja, build), inputs_of(ninja, build, TARGET)
    problems = missing_of(tests, linked, built) + check_itself(tests, linked, built) + left_by_both(ctest, build, labels)
    print("\n".join(problems) or f"the {len(tests)} tests of a user start nothing but what {TARGET} builds")
    return 1 if problems or not tests or not linked else 0


if __name__ == "__main__":
    sys.exit(main())
