#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The built tree installed into a new prefix, which is then moved: every command works from another folder, on what stands in
the prefix, and says what is missing.

    test_installation.py CMAKE BUILD_FOLDER
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHORT = ("--set", "Time/End Time=1 us", "--set", "Output/Field Interval=0.5 us")
COMMANDS = ("run", "resume", "check", "report", "film", "converge", "sweep", "compare", "drive", "fit", "import-ups", "describe")
FILES = ("libexec/barreno/barreno", "include/barreno_material.h", "share/barreno/commands.sh", "share/barreno/cards/berea_sandstone.xml",
         "share/barreno/input_xml/perforation.xml", "share/barreno/input_xml/jets", "share/barreno/python/barreno_report/__main__.py",
         "share/barreno/python/barreno_fit/__main__.py", "share/barreno/tools/plot_drive.py", "share/doc/barreno/LICENSE",
         "share/doc/barreno/docs/deck.md", "share/man/man1/barreno.1", "share/bash-completion/completions/barreno")  # fmt: skip


class Installation:
    def __init__(self, prefix, folder):
        self.prefix, self.folder = prefix, folder
        folder.mkdir()
        # Nothing of the caller's leads to the source tree.
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith(("BARRENO", "PYTHON"))}
        self.environment["PATH"] = f"{prefix / 'bin'}:/usr/local/bin:/usr/bin:/bin"

    def call(self, *words, code=0, **more):
        command = [str(word) for word in words]
        result = subprocess.run(command, cwd=self.folder, env={**self.environment, **more}, capture_output=True, text=True, timeout=200, check=False)
        assert result.returncode == code, f"{' '.join(command)}: exit {result.returncode}: {result.stdout}{result.stderr}"
        return result.stdout if code == 0 else result.stderr

    def barreno(self, *words, **more):
        return self.call("barreno", *words, **more)

    def deck(self, name):
        return self.prefix / "share" / "barreno" / "input_xml" / name


def install(cmake, build, scratch):
    """The configured prefix need not be writable; DESTDIR would stage the same."""
    result = subprocess.run([cmake, "--install", build, "--prefix", scratch / "first"], capture_output=True, text=True, timeout=200, check=False)
    assert result.returncode == 0 and "Warning" not in result.stderr, result.stdout + result.stderr
    prefix = (scratch / "first").rename(scratch / "a prefix")
    missing = [file for file in FILES if not (prefix / file).exists()]
    assert not missing, f"not installed: {missing}"
    return Installation(prefix, scratch / "elsewhere")


def check_words(here):
    """What cannot be is said in one sentence by whoever knows it; names of this installation, not of the source tree."""
    for words, code, said in (
        (("rnu",), 1, '"rnu" is not a command; it is one of run, '),
        (("report",), 1, "write for example barreno report runs/perforation-1"),
        (("sweep", "nowhere.xml"), 2, "nowhere.xml does not exist"),
        (("fit", "nowhere.csv"), 2, "nowhere.csv does not exist"),
        (("check", "nowhere.xml"), 2, "nowhere.xml"),
        (("run", "x.xml", "--ranks", "0"), 1, "is not a number of ranks"),
    ):
        answer = here.barreno(*words, code=code)
        assert said in answer and len(answer.splitlines()) == 1 and "./barreno" not in answer, f"{words}: {answer}"
    for words in (["help"], ["--help"], []):
        listed = re.findall(r"^barreno ([a-z-]+)", here.barreno(*words), re.MULTILINE)
        assert set(COMMANDS) <= set(listed), listed
    assert str(here.deck("perforation.xml")) in here.barreno("decks").splitlines()
    assert re.match(r"barreno \d+\.\d+\.\d+\ncommit ", here.barreno("--version"))


def check_runs(here):
    """Run, plan, page, comparison and picture, with the ranks that the command starts and those that mpirun has started."""
    quick = here.deck("perforation_quick.xml")
    shared = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    said = here.barreno("run", quick, *SHORT, "--ranks", "1", "--out", "one")
    assert said.rstrip().endswith("Next: barreno report one"), said
    here.call("mpirun", "-n", "2", "barreno", "run", quick, *SHORT, "--out", "two", **shared)
    summaries = [json.loads((here.folder / run / "summary.json").read_text()) for run in ("one", "two")]
    assert [summary["ranks"] for summary in summaries] == [1, 2], summaries
    version = here.barreno("--version").splitlines()
    for summary in summaries:
        assert version[0] == f"barreno {summary['version']}"
        assert version[1:] == [f"{name:<12}{value}" for name, value in summary["build"].items()], summary["build"]
    import netCDF4

    with netCDF4.Dataset(here.folder / "one" / "particles.e") as particles:
        information = [b"".join(row).decode().strip() for row in netCDF4.chartostring(particles["info_records"][:]).astype("S").reshape(-1, 1)]
    assert f"<!-- commit: {summaries[0]['build']['commit']} -->" in information, information[-6:]
    here.barreno("report", "one")
    assert (here.folder / "one" / "report" / "index.html").is_file()
    here.barreno("compare", "one", "two", "--out", "compared")
    assert (here.folder / "compared" / "compare.json").is_file()
    here.barreno("import-ups", ROOT / "tests/decks/ups/projectile.ups")
    assert (here.folder / "projectile.xml").is_file()
    path = here.deck("paths/uniaxial_berea.csv")
    here.barreno("drive", "--material", "berea_sandstone", "--path", path, "--out", "answer.csv", "--plot", "answer.png")
    assert (here.folder / "answer.png").is_file()


def check_python(here):
    """Modules that Python lacks are named, once."""
    bare = here.folder / "bare python"
    bare.write_text('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')
    bare.chmod(0o755)
    said = here.barreno("report", "one", code=2, BARRENO_PYTHON=str(bare))
    assert said.startswith("barreno: Python lacks numpy matplotlib netCDF4 (") and len(said.splitlines()) == 1, said
    bare.write_text("#!/bin/sh\nexit 1\n")
    said = here.barreno("report", "one", code=2, BARRENO_PYTHON=str(bare))
    assert said.startswith("barreno: Python does not start (") and len(said.splitlines()) == 1, said


def check_manual(here):
    """A page for every command, with the options that its help shows; completion offers them."""
    completion = here.prefix / "share/bash-completion/completions/barreno"
    for command in COMMANDS:
        options = re.findall(r"^ +(?:-\w, ?)?(--[a-z][a-z-]*)", here.barreno(command, "--help"), re.MULTILINE)
        page = (here.prefix / f"share/man/man1/barreno-{command}.1").read_text().replace("\\-", "-")
        assert options and page.startswith(f".TH BARRENO-{command.upper()} 1 "), command
        assert not [option for option in options if option not in page], f"{command}: {options}"
        complete = f'source "{completion}"; COMP_WORDS=(barreno {command} --); COMP_CWORD=2; _barreno; echo "${{COMPREPLY[@]}}"'
        assert set(options) == set(here.call("bash", "-c", complete).split()), command
    complete = f'source "{completion}"; COMP_WORDS=(barreno re); COMP_CWORD=1; _barreno; echo "${{COMPREPLY[@]}}"'
    assert here.call("bash", "-c", complete).split() == ["resume", "report"]


def main():
    cmake, build = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        here = install(cmake, build, pathlib.Path(name).resolve())
        for check in (check_words, check_runs, check_python, check_manual):
            check(here)
    print("the installation does what the source tree does")


if __name__ == "__main__":
    main()
