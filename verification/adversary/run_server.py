# SPDX-License-Identifier: BSD-3-Clause
"""Command lines of barreno, answered by serve_runs, which starts MPI once for all of them."""
import dataclasses
import pathlib
import subprocess

from tools.mpi_environment import mpi_environment

LIMIT = 120  # [s] that a tiny run may take, on a machine that does other work too


@dataclasses.dataclass
class Ended:
    kind: str  # "exit", "signal", "hang", "lost" (a rank ended the others)
    code: int
    seconds: float  # of processor
    out: str
    err: str
    words: list

    def text(self):
        return f"{self.kind} {self.code}"


class RunServer:
    """One rank, or several; begun again after a crash of ranks that have no process of their own.

    folder: of what is said; at, more: working folder and variables of the environment of the runs, if any
    """

    def __init__(self, program, folder, ranks=1, at=None, more=None):
        self.program, self.folder, self.ranks, self.process, self.seconds = program, pathlib.Path(folder), ranks, None, 0.0
        self.at, self.more = at, more or {}

    def begin(self):
        words = ["mpirun", "--quiet", "-n", str(self.ranks)] if self.ranks > 1 else []
        sanitizers = {"ASAN_OPTIONS": "detect_leaks=0:verify_asan_link_order=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
        environment = {**mpi_environment(self.ranks), **sanitizers, **self.more}
        log = open(self.folder / f"server{self.ranks}.log", "a")
        self.process = subprocess.Popen(
            [*words, str(self.program)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True, env=environment, cwd=self.at
        )

    def run(self, *words, signal=0, after=0.0, limit=LIMIT, variables=None):
        """Runs one command. @param signal  sent after so many seconds, 0: none; @param variables  of its environment, on one rank"""
        if self.process is None:
            self.begin()
        prefix = self.folder / f"said{self.ranks}"
        for ending in (".out", ".err"):
            pathlib.Path(f"{prefix}{ending}").unlink(missing_ok=True)
        words = [str(word) for word in words]
        settings = [f"{name}={value}" for name, value in (variables or {}).items()]
        request = [prefix, int(signal), int(1e6 * after), limit, *settings, *words]
        try:
            self.process.stdin.write("\t".join(map(str, request)) + "\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline().split()
        except BrokenPipeError:
            answer = []
        if len(answer) != 3:
            self.end()
            answer = ["lost", "0", "0"]
        self.seconds += float(answer[2])
        said = [self.text_of(f"{prefix}{ending}") for ending in (".out", ".err")]
        return Ended(answer[0], int(answer[1]), float(answer[2]), *said, words)

    @staticmethod
    def text_of(file):
        path = pathlib.Path(file)
        return path.read_text(errors="replace") if path.exists() else ""

    def end(self):
        if self.process is None:
            return
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process = None
