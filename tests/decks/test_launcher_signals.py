#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What ./barreno run does on two ranks when it is told to end: test_launcher_signals.py BUILD_FOLDER."""
import pathlib
import shlex
import signal
import subprocess
import sys
import tempfile
import time

from tools.resumed import different_fields, different_files, lines_of
from tools.runs import DECKS

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAUNCHER = [str(ROOT / "barreno"), "--no-install"]
SHORT = ("--set", "Time/End Time=15 us", "--set", "Output/Field Interval=5 us", "--ranks", "2")


def launched(folder, **more):
    words = [*LAUNCHER, "run", str(DECKS / "perforation_quick.xml"), "--out", str(folder), *SHORT]
    return subprocess.Popen(words, stderr=subprocess.PIPE, text=True, **more)


def wait_for(run, folder, rows=12):
    while run.poll() is None and lines_of(folder / "history.csv") < rows:
        time.sleep(0.005)


def resumed(folder):
    done = subprocess.run([*LAUNCHER, "resume", str(folder), "--ranks", "2"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def check_signals(folder, plain):
    """Each signal ends the run behind a checkpoint of its step, with its own exit code; resumed, it is the straight run."""
    for kind in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        run = folder / kind.name
        process = launched(run, stdout=subprocess.DEVNULL)
        wait_for(process, run)
        process.send_signal(kind)
        said = process.communicate()[1]
        assert process.returncode == 128 + kind, f"{kind.name}: exit {process.returncode}: {said}"
        assert (run / "run.log").read_text().rstrip().endswith(f"Next: ./barreno resume {run}"), kind.name
        resumed(run)
        assert not different_fields(plain, run) and not different_files(plain, run), kind.name


def check_reader_leaves(folder, plain):
    """| head: the reader's end is the run's, behind a checkpoint."""
    run = folder / "pipe"
    words = shlex.join([*LAUNCHER, "run", str(DECKS / "perforation_quick.xml"), "--out", str(run), *SHORT])
    done = subprocess.run(["bash", "-c", f"{words} | head -3; echo ${{PIPESTATUS[0]}}"], capture_output=True, text=True, check=False)
    lines = done.stdout.splitlines()
    assert len(lines) == 4 and lines[-1] == str(128 + signal.SIGPIPE), done.stdout + done.stderr
    resumed(run)
    assert not different_fields(plain, run) and not different_files(plain, run)


def check_launcher_dies(folder):
    """A launcher that is killed leaves no ranks behind that nobody can stop."""
    run = folder / "killed"
    process = launched(run, stdout=subprocess.DEVNULL)
    wait_for(process, run)
    process.kill()
    process.wait()
    for _ in range(200):
        if "Next: ./barreno resume" in (run / "run.log").read_text():
            return
        time.sleep(0.05)
    raise AssertionError("the ranks go on without their launcher")


def main():
    if pathlib.Path(sys.argv[1]).resolve() != (ROOT / "build" / "release").resolve():
        print("the launcher builds in build/release alone")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plain = folder / "plain"
        process = launched(plain, stdout=subprocess.DEVNULL)
        assert process.communicate() and process.returncode == 0
        check_signals(folder, plain)
        check_reader_leaves(folder, plain)
        check_launcher_dies(folder)


if __name__ == "__main__":
    main()
