# SPDX-License-Identifier: BSD-3-Clause
"""The Python commands of Barreno, called in the test's own process: a process of its own takes a second to load what draws."""
import contextlib
import importlib
import io
import os
import pathlib
import signal
import sys
import unittest.mock

from tools.runs import mpi_environment


def environment_of_runs():
    """Of the program that the test was given."""
    return {**mpi_environment(), "BARRENO_PROGRAM": str(pathlib.Path(sys.argv[1]).resolve())}


def process_of(package, *words):
    """Arguments of subprocess for the same command in a process of its own, which can be interrupted."""
    return {"args": [sys.executable, "-m", package, *map(str, words)], "env": environment_of_runs(), "text": True}


@contextlib.contextmanager
def signals_kept():
    """Those that a command watches go back to whoever had them."""
    kept = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    try:
        yield
    finally:
        for number, handler in kept.items():
            signal.signal(number, handler)


def said_by(package, *words, code=0, **more):
    """What it prints on success, its sentences otherwise. @param more  variables of the environment"""
    out, err = io.StringIO(), io.StringIO()
    environment = unittest.mock.patch.dict(os.environ, {**environment_of_runs(), **more})
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), environment, signals_kept():
        try:
            found = importlib.import_module(f"{package}.command").main(list(map(str, words)))
        except SystemExit as end:
            found = end.code
    assert found == code, f"{words}: exit {found}\n{out.getvalue()}{err.getvalue()}"
    return out.getvalue() if code == 0 else err.getvalue()
