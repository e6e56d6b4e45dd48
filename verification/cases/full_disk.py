# SPDX-License-Identifier: BSD-3-Clause
"""A disk that is full from one write call on, while a run is resumed."""
import pathlib
import shutil
import subprocess

from tools.case import Result
from tools.resumed import at_previous, different_fields, different_files, must_work, program
from tools.runs import DECKS, scratch_folder

SHORT = ("--set", "Time/End Time=6 us", "--set", "Output/Field Interval=3 us", "--set", "Output/Checkpoint Steps=60")
SOURCE = pathlib.Path(__file__).resolve().parents[1] / "tools" / "full_disk.c"


def build(scratch):
    library = scratch / "full_disk.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, SOURCE, "-ldl"], check=True)
    return library


def run(barreno, full):
    result = Result(
        "Full disk",
        "A disk that fills up ends the run with one sentence, or causes a warning if only a checkpoint found no room. Once there is room "
        "again, the resumed run ends as if nothing had happened.",
        "the undisturbed run, its tables byte for byte and its fields bit for bit. All write calls fail from the one in the first column "
        "on (tools/full_disk.c, preloaded); the run is a resumed one, so that older files exist that could be damaged.",
        ["write call", "exit code", "lines on stderr", "resumed", "ended differently"],
        [],
    )
    scratch = pathlib.Path(scratch_folder())
    library = build(scratch)
    plain = scratch / "plain"
    must_work(program(barreno, 1, "run", DECKS / "perforation_quick.xml", *SHORT, "--out", plain))
    calls = (1, 2, 3, 5, 8, 12, 20, 30, 45, 60, 80, 110, 150, 200, 260, 330, 410, 500, 600, 700) if full else (1, 30, 200)
    for call in calls:
        folder = scratch / "filled"
        shutil.rmtree(folder, ignore_errors=True)
        at_previous(pathlib.Path(shutil.copytree(plain, folder)))
        environment = {"LD_PRELOAD": str(library), "BARRENO_FULL_FOLDER": str(folder.resolve()), "BARRENO_FULL_CALL": str(call)}
        ended = program(barreno, 1, "resume", folder, environment=environment)
        again = program(barreno, 1, "resume", folder) if ended.returncode != 0 else ended
        different = again.returncode != 0 or bool(different_fields(plain, folder) or different_files(plain, folder))
        result.rows.append([call, ended.returncode, ended.stderr.count("\n"), again is not ended, different])
    result.demand("calls that filled the disk", sum(r[1] == 2 for r in result.rows), 0.6 * len(calls), at_least=True)
    result.demand("ended with neither 0 nor 2", sum(r[1] not in (0, 2) for r in result.rows), 0)
    result.demand("failed with other than one line", sum(r[1] != 0 and r[2] != 1 for r in result.rows), 0)
    result.demand("ended differently", sum(r[4] for r in result.rows), 0)
    return result
