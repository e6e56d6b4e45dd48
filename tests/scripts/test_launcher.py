#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The launcher ./barreno on machines that it does not have here: package manager, CMake, ninja and mpirun are played by
small scripts that note how they are called.

    test_launcher.py BUILD_FOLDER
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOCKED = "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt-get)"

# Name of a program: what it does after it has noted its name and words. $notes is the folder of notes.
PROGRAMS = {
    "dpkg-query": '[[ -e $notes/installed ]] && for p in "${@:4}"; do echo "installed $p"; done; exit 0',
    "apt-get": f"""if [[ $* == *update* && -e $notes/locks ]]; then
  left=$(<"$notes/locks"); ((left > 0)) && {{ echo $((left - 1)) >"$notes/locks"; echo "{LOCKED}" >&2; exit 100; }}
fi
[[ -e $notes/no_network && $* == *update* ]] && {{ echo "E: no network" >&2; exit 100; }}
exit 0""",
    "sudo": 'exec "$@"',
    "cmake": "exit 0",
    "ninja": '[[ $* == *" -n "* ]] && echo "ninja: work to do"; exit 0',
    "mpirun": "exit 0",
    "ctest": "exit 0",
}

REPORT_PACKAGES = ["python3", "python3-jinja2", "python3-matplotlib", "python3-netcdf4", "python3-numpy", "python3-pandas"]


class Machine:
    """A tree with the launcher, and programs that note their calls."""

    def __init__(self, folder):
        self.tree, self.notes, bin_folder = folder / "a tree", folder / "notes", folder / "bin"
        for made in (self.tree, self.notes, bin_folder):
            made.mkdir()
        (self.tree / "src").mkdir()
        for name in ("barreno", "src/commands.sh"):
            shutil.copy(ROOT / name, self.tree / name)
        for name, does in PROGRAMS.items():
            file = bin_folder / name
            file.write_text(f'#!/usr/bin/env bash\nnotes="{self.notes}"\necho "{name} $*" >>"$notes/calls"\n{does}\n')
            file.chmod(0o755)
        inherited = {name: value for name, value in os.environ.items() if not name.startswith(("BARRENO_", "PYTHON"))}
        self.environment = {**inherited, "PATH": f"{bin_folder}:{os.environ['PATH']}", "BARRENO_LOCK_PAUSE": "0"}

    def note(self, name, text=""):
        (self.notes / name).write_text(text)

    def file(self, name, text, executable=False):
        path = self.tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755 if executable else 0o644)

    def built(self, home=None):
        """As after a build of that tree."""
        self.note("installed")
        self.file("build/release/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={home or self.tree}\nBARRENO_TESTS:BOOL=OFF\n")
        self.file("build/release/build.ninja", "")
        self.file("build/release/src/barreno", '#!/bin/sh\necho "program $*"\n', executable=True)

    def run(self, *words, **more):
        """What it says, and the calls that it made."""
        (self.notes / "calls").write_text("")
        command = [str(self.tree / "barreno"), *map(str, words)]
        result = subprocess.run(command, env={**self.environment, **more}, capture_output=True, text=True, timeout=60, check=False)
        return result, (self.notes / "calls").read_text().splitlines()


def refused(result, calls, code, *said):
    lines = result.stderr.splitlines()
    fine = result.returncode == code and len(lines) == 1 and all(words in result.stderr for words in said) and not calls
    assert fine, f"exit {result.returncode}, calls {calls}: {result.stderr}"


def check_copied_tree(machine, folder):
    machine.built()
    result, calls = machine.run("describe")
    assert result.stdout == "program describe\n" and not any(call.startswith("cmake") for call in calls), calls
    (folder / "first").mkdir()
    machine.built(home=folder / "first")
    result, calls = machine.run("describe")
    assert any(re.match(r"cmake --fresh --preset release", call) for call in calls), calls
    assert f"copy of '{folder / 'first'}'" in result.stderr and result.stdout == "program describe\n", result.stderr
    machine.built(home=folder / "moved away")
    assert any("--fresh" in call for call in machine.run("describe")[1])


def check_locks(machine):
    """Another process has the package manager: it is waited for. Other faults end at once."""
    machine.note("locks", "3")
    result, calls = machine.run("check", "deck.xml")
    updates = [call for call in calls if call.startswith("apt-get") and "update" in call]
    installs = [call for call in calls if call.startswith("apt-get") and " install " in call]
    assert len(updates) == 4 and len(installs) == 1 and "DPkg::Lock::Timeout=" in installs[0], calls
    assert result.stderr.count("another process uses the package manager") == 1, result.stderr
    machine.note("no_network")
    result, calls = machine.run("check", "deck.xml")
    assert result.returncode == 2 and "E: no network" in result.stderr and "could not be installed" in result.stderr, result.stderr
    assert len([call for call in calls if call.startswith("apt-get")]) == 1, calls
    (machine.notes / "no_network").unlink()


def check_report(machine, folder):
    """Its words are looked at first, and only what it needs is installed; a film is made by the same package."""
    refused(*machine.run("report"), 1, "report takes the folder of one run")
    refused(*machine.run("report", "--pdf"), 1, "report takes the folder of one run")
    refused(*machine.run("report", folder / "nowhere"), 2, "is not a folder")
    refused(*machine.run("film"), 1, "film takes the folder of one run", "--field pressure")
    refused(*machine.run("film", folder / "nowhere", "--field", "pressure"), 2, "is not a folder")
    machine.file("src/python/barreno/report/__main__.py", "import sys; print('made', sys.argv[1:])")
    (folder / "a run").mkdir()
    for words in (("report", folder / "a run", "--time", "30 us"), ("film", folder / "a run", "--field", "pressure")):
        result, calls = machine.run(*words)
        assert result.returncode == 0 and f"made {list(map(str, words))}" in result.stdout, result.stderr
        (install,) = [call for call in calls if " install " in call]
        packages = install.split("--no-install-recommends ")[1].split()
        assert sorted(packages) == REPORT_PACKAGES, packages


def check_plot(machine):
    """A picture needs Matplotlib, the rest of drive does not."""
    machine.built()
    (machine.notes / "installed").unlink()
    for words, plots in ((["--plot", "a.png"], True), (["--plot=a.png"], True), ([], False)):
        result, calls = machine.run("drive", "--out", "a.csv", *words)
        assert result.returncode == 0 and result.stdout.startswith("program drive --out a.csv"), result.stderr
        installs = [call for call in calls if " install " in call]
        assert any(call.endswith(" python3 python3-numpy python3-matplotlib") for call in installs) == plots, f"{words}: {calls}"


def check_converge(machine, folder):
    """A deck that is missing is said before anything is installed; then packages, build, and the program with its ranks."""
    refused(*machine.run("converge"), 1, "converge takes a deck")
    refused(*machine.run("converge", "--levels", "3"), 1, "converge takes a deck")
    refused(*machine.run("converge", folder / "nowhere.xml"), 2, "nowhere.xml does not exist")
    machine.file("src/python/barreno/converge/__main__.py",
        "import os, sys; print('converged', sys.argv[1:], os.environ['BARRENO_PROGRAM'])")
    (folder / "a deck.xml").write_text("")
    result, calls = machine.run("converge", folder / "a deck.xml", "--ranks", "3")
    assert result.returncode == 0 and f"converged ['{folder / 'a deck.xml'}', '--ranks', '3']" in result.stdout, result.stderr
    assert result.stdout.strip().endswith("a tree/build/release/src/barreno"), result.stdout
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == ["python3", "python3-matplotlib", "python3-numpy", "python3-pandas"], packages
    result, _ = machine.run("converge", folder / "a deck.xml")
    assert re.search(r"'--ranks', '[1-9][0-9]*'\]", result.stdout), result.stdout


def check_sweep(machine, folder):
    """As converge, with one rank per run unless told otherwise, the cores, and how it was called."""
    refused(*machine.run("sweep"), 1, "sweep takes a deck")
    refused(*machine.run("sweep", folder / "nowhere.xml"), 2, "nowhere.xml does not exist")
    machine.file("src/python/barreno/sweeps/__main__.py",
        "import os, sys; print('swept', sys.argv[1:], os.environ['BARRENO_PROGRAM'], os.environ['BARRENO_CORES'], "
        "os.environ['BARRENO_COMMAND'])")
    (folder / "a deck.xml").write_text("")
    result, calls = machine.run("sweep", folder / "a deck.xml", "--vary", "A/B C=1,2 mm")
    assert result.returncode == 0 and f"swept ['{folder / 'a deck.xml'}', '--vary', 'A/B C=1,2 mm']" in result.stdout, result.stderr
    assert re.search(r"a tree/build/release/src/barreno [1-9][0-9]* .*a\\ tree/barreno sweep$", result.stdout.strip()), result.stdout
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == REPORT_PACKAGES, packages
    _, calls = machine.run("sweep", folder / "a deck.xml", "--vary", "A/B C=1..2 mm", "--sample", "latin", "--samples", "4")
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == sorted([*REPORT_PACKAGES, "python3-scipy"]), packages


def check_uncertainty(machine, folder):
    """As sweep, with SciPy and without netCDF4; its help needs neither packages nor a build."""
    refused(*machine.run("uncertainty"), 1, "uncertainty takes a deck")
    refused(*machine.run("uncertainty", folder / "nowhere.xml"), 2, "nowhere.xml does not exist")
    machine.file("src/python/barreno/uncertainties/__main__.py",
        "import os, sys; print('sure', sys.argv[1:], os.environ['BARRENO_PROGRAM'], os.environ['BARRENO_CORES'], "
        "os.environ['BARRENO_COMMAND'])")
    (folder / "a deck.xml").write_text("")
    result, calls = machine.run("uncertainty", folder / "a deck.xml", "--runs", "5")
    assert result.returncode == 0 and f"sure ['{folder / 'a deck.xml'}', '--runs', '5']" in result.stdout, result.stderr
    assert result.stdout.strip().endswith(r"a\ tree/barreno uncertainty"), result.stdout
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == ["python3", "python3-matplotlib", "python3-numpy", "python3-pandas", "python3-scipy"], packages
    _, calls = machine.run("uncertainty", folder / "a deck.xml", "--flow", "radial")
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == sorted([*REPORT_PACKAGES, "python3-scipy"]), packages


def check_compare(machine, folder):
    """Nothing is built to look at runs; its own help needs no packages either."""
    refused(*machine.run("compare"), 1, "compare takes the folders of two runs or more")
    refused(*machine.run("compare", folder / "a run"), 1, "compare takes the folders of two runs or more")
    machine.file("src/python/barreno/compare/__main__.py", "import sys; print('compared', sys.argv[1:])")
    result, calls = machine.run("compare", folder / "a run", folder / "b")
    assert result.returncode == 0 and f"compared ['{folder / 'a run'}', '{folder / 'b'}']" in result.stdout, result.stderr
    assert not any(call.startswith(("cmake", "ninja")) for call in calls), calls
    result, calls = machine.run("compare", "--help")
    assert result.returncode == 0 and result.stdout == "compared ['--help']\n" and not calls, result.stdout


def check_fit(machine, folder):
    """Files that are missing are said before anything is installed; then the packages of a fit, the build, the program."""
    refused(*machine.run("fit"), 1, "fit takes the files of tests")
    refused(*machine.run("fit", folder / "nowhere.csv", "--out", "card.xml"), 2, "nowhere.csv does not exist")
    machine.file("src/python/barreno/fit/__main__.py", "import os, sys; print('fitted', sys.argv[1:], os.environ['BARRENO_LIBRARY'])")
    (folder / "a test.csv").write_text("")
    result, calls = machine.run("fit", folder / "a test.csv", "--out", "card.xml")
    assert result.returncode == 0 and f"fitted ['{folder / 'a test.csv'}', '--out', 'card.xml']" in result.stdout, result.stderr
    assert result.stdout.strip().endswith("a tree/build/release/materials/libBARRENO.so"), result.stdout
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == ["python3", "python3-matplotlib", "python3-numpy", "python3-scipy"], packages
    assert any(call.startswith("ninja") and "BARRENO" in call for call in calls), calls


def check_import(machine, folder):
    """Python alone, and the program that checks the deck."""
    refused(*machine.run("import-ups"), 1, "import-ups takes an input file of Uintah")
    refused(*machine.run("import-ups", folder / "nowhere.ups"), 2, "nowhere.ups does not exist")
    machine.file("src/python/barreno/imports/__main__.py", "import os, sys; print('imported', sys.argv[1:], os.environ['BARRENO_PROGRAM'])")
    (folder / "an input.ups").write_text("")
    result, calls = machine.run("import-ups", folder / "an input.ups", "--out", "deck.xml")
    assert result.returncode == 0 and f"imported ['{folder / 'an input.ups'}', '--out', 'deck.xml']" in result.stdout, result.stderr
    assert [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1] == "python3", calls


def check_join(machine, folder):
    """Of a folder without a set one sentence; of its words the same."""
    refused(*machine.run("join"), 1, "join takes the folder of one run, before its options")
    machine.file("src/python/barreno/runs/join_exodus.py", "import sys; print('joined', sys.argv[1:])")
    result, calls = machine.run("join", folder / "a run", "--out", "one.e")
    assert result.returncode == 0 and f"joined ['{folder / 'a run'}', '--out', 'one.e']" in result.stdout, result.stderr
    packages = [call for call in calls if " install " in call][0].split("--no-install-recommends ")[1].split()
    assert sorted(packages) == ["python3", "python3-netcdf4", "python3-numpy"], packages


def check_python(machine, folder):
    """Scripts find the package and the folders of verification; their own --help is theirs."""
    machine.file("src/python/barreno/__init__.py", "")
    machine.file("verification/tools/runs.py", "")
    (folder / "a script.py").write_text("import barreno, sys, tools.runs\nprint('scripted', sys.argv[1:])\n")
    result, calls = machine.run("python", folder / "a script.py", "--help", "x")
    assert result.returncode == 0 and result.stdout.endswith("scripted ['--help', 'x']\n"), result.stdout + result.stderr
    assert not any(call.startswith(("cmake", "ninja")) for call in calls), calls
    result, _ = machine.run("python", "--help")
    assert result.returncode == 0 and "./barreno python [SCRIPT]" in result.stdout, result.stdout


def check_words(machine):
    """What cannot be is said before anything is installed or built."""
    refused(*machine.run("run", "deck.xml", "--ranks", "100000000"), 1, "--ranks 100000000 is more than this machine can start")
    refused(*machine.run("resume", "run", "--ranks", "9" * 30), 1, "is more than this machine can start")
    refused(*machine.run("run", "deck.xml", "--ranks", "0"), 1, "is not a number of ranks")
    machine.file("deck.xml", "")
    for command in ("sweep", "uncertainty", "converge"):
        for words in (["--ranks", "1000000000"], ["--ranks=1000000000"]):
            refused(*machine.run(command, machine.tree / "deck.xml", *words), 1, "--ranks 1000000000 is more than this machine can start")
    refused(*machine.run("rnu", "deck.xml"), 1, '"rnu" is not a command')
    for words in ([], ["-h"], ["--help"], ["run", "-h"], ["report", "--help"], ["film", "-h"], ["test", "-h"], ["drive", "--help"]):
        result, calls = machine.run(*words)
        assert result.returncode == 0 and not calls and not result.stderr, f"{words}: {result.stderr}"
        missing = [word for word in ("report", "film", "converge", "sweep", "uncertainty", "compare", "fit", "import-ups", "--set",
            "--fidelity", "--out", "--until", "--overwrite") if word not in result.stdout]
        assert not missing, f"{words}: the help lacks {missing}"


def check_tests(machine):
    """A user's tests leave out what .ci/run adds, and its packages."""
    for more, left_out in (({}, "slow|style|sanitized|hosts"), ({"BARRENO_ALL_TESTS": "1"}, "slow")):
        result, calls = machine.run("test", "-R", "deck", **more)
        assert result.returncode == 0, result.stderr
        (tests,) = [call for call in calls if call.startswith("ctest")]
        assert f" -LE {left_out} " in tests and tests.endswith(" -R deck"), tests
        packages = [call for call in calls if " install " in call][0].split()
        assert (
            ("clang-tidy" in packages) == ("gfortran" in packages) == ("mkdocs" in packages) == bool(more) and "libgtest-dev" in packages
        ), packages
        assert any("-DBARRENO_TESTS=ON" in call
            for call in calls) and any(call.endswith("build/release " + ("all" if more else "user_tests")) for call in calls), calls

    _, calls = machine.run("test", SLURM_NTASKS="4")
    assert any(call.startswith("ctest") and call.endswith(" -j 4") for call in calls), calls  # as many as cores


def check_ci(machine):
    """.ci/run: first the tests of a user, with nothing set and from an empty build folder, then the rest of a build of everything."""
    machine.built()
    machine.file(".ci/run", (ROOT / ".ci" / "run").read_text(), executable=True)
    (machine.notes / "calls").write_text("")
    environment = {**machine.environment, "BARRENO_ALL_TESTS": "1", "BARRENO_HOSTS": "required"}
    result = subprocess.run([machine.tree / ".ci" / "run"], env=environment, capture_output=True, text=True, timeout=60, check=False)
    calls = (machine.notes / "calls").read_text().splitlines()
    assert result.returncode == 0 and not (machine.tree / "build/release/CMakeCache.txt").exists(), result.stderr
    builds = [call.split()[-1] for call in calls if call.startswith("ninja") and " -n " not in call]
    first, second = [call for call in calls if call.startswith("ctest")]
    assert builds == ["user_tests", "all"] and " -LE slow|style|sanitized|hosts " in first and " -L " not in first, calls
    assert " -LE slow " in second and second.endswith(" -L style|sanitized|hosts"), second


def check_batch_job(machine):
    """In a job of Slurm or PBS the ranks are those of the job."""
    machine.built()
    for more, ranks in (({"SLURM_NTASKS": "48"}, 48), ({"PBS_NODEFILE": str(machine.notes / "nodes")}, 3)):
        machine.note("nodes", "a\na\nb\n")
        result, calls = machine.run("run", "deck.xml", **more)
        assert result.returncode == 0 and any(call.startswith(f"mpirun --quiet -n {ranks} ") for call in calls), f"{calls}: {result.stderr}"


def check_install(machine, build):
    """What a launcher's build makes is all that cmake --install takes from the build folder."""
    machine.built()
    _, calls = machine.run("describe")
    (targets,) = {call.split(f"{machine.tree}/build/release ")[1] for call in calls if call.startswith("ninja") and " -n " not in call}
    commands = subprocess.run(["ninja", "-C", build, "-t", "commands", *targets.split()], capture_output=True, text=True, check=True).stdout
    listed = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], capture_output=True, text=True, check=True).stdout
    made = {line.split(":")[0] for line in listed.splitlines()}
    taken = set()
    for script in [build / "cmake_install.cmake", *(build / part / "cmake_install.cmake" for part in ("materials", "src"))]:
        taken |= set(re.findall(re.escape(f'"{build}/') + r'([^"]+)"', script.read_text()))
    wanted = sorted(name for name in taken & made if not name.endswith(".cmake"))
    assert {"src/barreno", "materials/libBARRENO.so"} <= set(wanted), wanted
    missing = [name for name in wanted if name not in commands]
    assert not missing, f"ninja {targets} does not make {missing}, which cmake --install takes"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    checks = [check_copied_tree, lambda m, f: check_locks(m), check_report, lambda m, f: check_plot(m), check_converge, check_sweep,
        check_uncertainty, check_compare, check_fit, check_import, check_join, check_python, lambda m, f: check_words(m),
        lambda m, f: check_tests(m),
        lambda m, f: check_ci(m), lambda m, f: check_batch_job(m), lambda m, f: check_install(m, build)]
    for check in checks:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            check(Machine(folder), folder)
    print("the launcher does as it says")


if __name__ == "__main__":
    main()
