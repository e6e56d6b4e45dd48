# SPDX-License-Identifier: BSD-3-Clause
"""Two processes that want one run folder, and ranks that live on for a moment after their mpirun was killed."""
import os
import signal
import subprocess
import threading
import time

from adversary.one_set import FILE, FINISHED, REFUSED, Finding, must_end, tolerance_of
from adversary.run_server import mpi_environment
from adversary.same_runs import different

LAUNCH = 30.0  # [s] that mpirun may take to bring a run to its first checkpoint


def try_two(one, servers, straight, seconds, tally):
    """A second process resumes a live run, or overwrites its folder: it waits for the first, and the result is that of one run."""
    folder = one.folder / "two"
    first = []
    live = threading.Thread(target=lambda: first.append(servers["plain"].run("run", one.file, "--out", folder)))
    live.start()
    time.sleep(one.rng.uniform(0.0, 1.5) * seconds)
    words = ("resume", folder) if one.rng.random() < 0.5 else ("run", one.file, "--out", folder, "--overwrite")
    second = servers["other"].run(*words)
    live.join()
    # The one that comes second to the folder may find the other's result in it.
    codes = [must_end(ended, FINISHED, REFUSED, FILE) for ended in (first[0], second)]
    if FINISHED not in codes:
        raise Finding(f"neither of two processes on one folder finished: {first[0].err} {second.err}")
    wrong = different(straight, folder, tolerance_of(one.deck))
    if wrong:
        raise Finding(f"two processes on one folder (exits {codes}, {words[0]}) left another result: {'; '.join(wrong[:8])}")
    tally.add("two processes on one folder")


def try_group(one, servers, straight, program, tally):
    """mpirun's process group is killed, and the run is resumed at once."""
    folder = one.folder / "group"
    words = ["mpirun", "--quiet", "-n", "2", str(program), "run", str(one.file), "--out", str(folder)]
    with subprocess.Popen(
        words, env=mpi_environment(2), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
    ) as run:
        end = time.time() + LAUNCH
        while run.poll() is None and not (folder / "checkpoint.h5").exists() and time.time() < end:
            time.sleep(0.001)
        time.sleep(one.rng.uniform(0.0, 0.02))
        alive = run.poll() is None
        if alive:
            os.killpg(run.pid, signal.SIGKILL)
        tally.add("kills")
        tally.add("kills placed at a checkpoint")
        if not (folder / "checkpoint.h5").exists():
            tally.add("killed before the first checkpoint")
            return
        tally.add("kills placed at a checkpoint that met one" if alive else "kills that came too late")
        # The ranks may finish what the resumed run then finds finished.
        must_end(servers["plain"].run("resume", folder), FINISHED, REFUSED)
    wrong = different(straight, folder, tolerance_of(one.deck), same_ranks=False)
    if wrong:
        raise Finding(f"after the kill of mpirun's process group and a resume at once it differs: {'; '.join(wrong[:8])}")
    tally.add("process group killed, resumed at once and the same")
