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
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHORT = ("--set", "Time/End Time=1 us", "--set", "Output/Field Interval=0.5 us")
COMMANDS = ("run", "resume", "continue", "check", "report", "film", "join", "converge", "sweep", "uncertainty", "compare", "drive", "fit",
    "import-ups", "describe")
FILES = ("libexec/barreno/barreno", "include/barreno_material.h", "share/barreno/commands.sh", "share/barreno/cards/berea_sandstone.xml",
         "share/barreno/input_xml/perforation.xml", "share/barreno/input_xml/jets", "share/barreno/python/barreno/report/__main__.py",
         "share/barreno/python/barreno/fit/__main__.py", "share/barreno/python/barreno/materials/plot_drive.py",
         "share/barreno/measured/update_costs.csv",
         "share/barreno/measured/depths_of_cells.csv", "share/doc/barreno/LICENSE",
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
        result = subprocess.run(command, cwd=self.folder, env={**self.environment, **more}, capture_output=True, text=True, timeout=200,
            check=False)
        assert result.returncode == code, f"{' '.join(command)}: exit {result.returncode}: {result.stdout}{result.stderr}"
        return result.stdout if code == 0 else result.stderr

    def barreno(self, *words, **more):
        return self.call("barreno", *words, **more)

    def deck(self, name):
        return self.prefix / "share" / "barreno" / "input_xml" / name


def install(cmake, build, scratch):
    """The configured prefix need not be writable; DESTDIR would stage the same."""
    result = subprocess.run([cmake, "--install", build, "--prefix", scratch / "first"], capture_output=True, text=True, timeout=200,
        check=False)
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
    """Run, import and picture, with the ranks that the command starts and those that mpirun has started."""
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
        information = [b"".join(row).decode().strip()
            for row in netCDF4.chartostring(particles["info_records"][:]).astype("S").reshape(-1, 1)]
    assert f"<!-- commit: {summaries[0]['build']['commit']} -->" in information, information[-6:]
    # It has read the run, and knows its fields; what report and film draw, their own tests see.
    said = here.barreno("film", "one", "--field", "presure", code=1)
    assert "presure" in said and "pressure" in said and len(said.splitlines()) == 1, said
    here.barreno("import-ups", ROOT / "tests/decks/ups/projectile.ups")
    assert (here.folder / "projectile.xml").is_file()
    path = here.deck("paths/uniaxial_berea.csv")
    here.barreno("drive", "--material", "berea_sandstone", "--path", path, "--out", "answer.csv", "--plot", "answer.png")
    assert (here.folder / "answer.png").is_file()


def check_measured(here):
    """Costs and errors of depths come from the files of this prefix; where one is broken they are unknown, and the program says why."""
    quick, measured = here.deck("perforation_quick.xml"), here.prefix / "share" / "barreno" / "measured"
    said = here.barreno("check", quick)
    assert "\nCost      about " in said and "unknown" not in said, said
    for name, row, lost in (("update_costs.csv", "update_stress Arenisca,", "\nCost      unknown (the measured numbers of "),
                            ("steady_errors.csv", "Berea sandstone,1,", "unknown (the measured numbers of ")):  # fmt: skip
        text = (measured / name).read_text()
        (measured / name).write_text("".join(line for line in text.splitlines(keepends=True) if not line.startswith(row)))
        said = here.barreno("check", quick)
        assert f"{lost}'{measured / name}' cannot be used: it does not end with" in said, said
        (measured / name).write_text(text)


def job_script(here, system):
    """The one of docs/cluster.md, in a folder with its deck, and a batch system that notes how it is called."""
    page = (ROOT / "docs" / "cluster.md").read_text()
    section = page.split(f"\n## {system}\n")[1].split("\n## ")[0]
    script = here.folder / f"perforation.{system.lower()}"
    script.write_text("".join(f"{line}\n" for line in re.findall(r"^ {4}(.*)$|^$", section, re.MULTILINE)))
    tools = here.folder / "batch system"
    tools.mkdir(exist_ok=True)
    for name in ("scontrol", "qsub"):
        (tools / name).write_text(f'#!/bin/sh\necho "{name} $*" >>"{here.folder}/asked"\n')
        (tools / name).chmod(0o755)
    (here.folder / "asked").write_text("")
    if not (here.folder / "jets").exists():
        (here.folder / "jets").symlink_to(here.deck("jets"))
    return script, {"PATH": f"{tools}:{here.environment['PATH']}"}


def write_deck(here, end):
    text = re.sub(r'(name="End Time" type="string" value=)"[^"]*"', rf'\1"{end}"', here.deck("perforation_quick.xml").read_text())
    (here.folder / "perforation.xml").write_text(text)


def check_slurm(here):
    """USR1 to the script, as Slurm sends it: checkpoint, requeue; the job that comes then finishes the run."""
    script, more = job_script(here, "Slurm")
    write_deck(here, "6 us")
    more |= {"SLURM_NTASKS": "2", "SLURM_JOB_ID": "77", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    job = subprocess.Popen(["bash", script], cwd=here.folder, env={**here.environment, **more}, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, text=True)
    history = here.folder / "runs/perforation/history.csv"
    while job.poll() is None and not (history.exists() and len(history.read_text().splitlines()) > 10):
        time.sleep(0.01)
    job.send_signal(signal.SIGUSR1)
    said = job.communicate(timeout=200)[1]
    assert job.returncode == 138 and (here.folder / "asked").read_text() == "scontrol requeue 77\n", f"exit {job.returncode}: {said}"
    here.call("bash", script, **more)
    summary = json.loads((here.folder / "runs/perforation/summary.json").read_text())
    assert summary["finished"] and summary["ranks"] == 2, summary
    assert (
        (here.folder / "asked").read_text() == "scontrol requeue 77\n"
        and "resumed from" in (here.folder / "runs/perforation/run.log").read_text()
    )


def check_pbs(here):
    """The time of a job is over before the run is: the next is asked for."""
    script, more = job_script(here, "PBS")
    write_deck(here, "400 us")
    (here.folder / "nodes").write_text("node\n")
    more |= {"PBS_NODEFILE": str(here.folder / "nodes"), "PBS_O_WORKDIR": str(here.folder), "BARRENO_JOB_TIME": "1s"}
    shutil.rmtree(here.folder / "runs/perforation")
    here.call("bash", script, code=138, **more)
    assert (here.folder / "asked").read_text() == f"qsub {here.folder}/perforation.pbs\n"


def check_python(here):
    """Modules that Python lacks are named, once."""
    bare = here.folder / "bare python"
    bare.write_text('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')
    bare.chmod(0o755)
    said = here.barreno("report", "one", code=2, BARRENO_PYTHON=str(bare))
    assert said.startswith("barreno: Python lacks numpy matplotlib pandas netCDF4 jinja2 (") and len(said.splitlines()) == 1, said
    bare.write_text("#!/bin/sh\nexit 1\n")
    said = here.barreno("report", "one", code=2, BARRENO_PYTHON=str(bare))
    assert said.startswith("barreno: Python does not start (") and len(said.splitlines()) == 1, said


def check_package(here):
    """The package by the command python, with the program, library and launcher of the prefix."""
    show = "from barreno import places; print(places.program(), places.library(), places.launcher(), sep='\\n')"
    said = here.barreno("python", "-c", show)
    program, library, launcher = map(pathlib.Path, said.splitlines())
    assert program == here.prefix / "libexec/barreno/barreno" and launcher == here.prefix / "bin/barreno", said
    assert library.name == "libBARRENO.so" and here.prefix in library.parents, said


def check_manual(here):
    """A page for every command, with the options that its help shows; completion offers them."""
    completion = here.prefix / "share/bash-completion/completions/barreno"
    for command in COMMANDS:
        page = (here.prefix / f"share/man/man1/barreno-{command}.1").read_text().replace("\\-", "-")
        # Two are asked again, of each kind; the others must have some.
        shown = here.barreno(command, "--help") if command in ("run", "sweep") else page
        options = re.findall(r"^ +(?:-\w, ?)?(--[a-z][a-z-]*)", shown, re.MULTILINE)
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
        for check in (check_words, check_runs, check_measured, check_slurm, check_pbs, check_python, check_package, check_manual):
            check(here)
    print("the installation does what the source tree does")


if __name__ == "__main__":
    main()
