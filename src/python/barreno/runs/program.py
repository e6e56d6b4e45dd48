# SPDX-License-Identifier: BSD-3-Clause
"""The program barreno, as a command starts it."""

import contextlib
import contextvars
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading

from barreno import places
from barreno.runs.faults import FILE, Fault
from barreno.runs.ranks import with_mpi_environment


DECK_NAME = contextvars.ContextVar("deck_name", default=None)  # of a deck in a temporary file, for summary.json and the screen


@contextlib.contextmanager
def named(name):
    """Programs that are started within call their deck so, instead of by its path."""
    token = DECK_NAME.set(name)
    try:
        yield
    finally:
        DECK_NAME.reset(token)


def environment():
    """Of a program that computes."""
    return os.environ if DECK_NAME.get() is None else {**os.environ, "BARRENO_DECK_NAME": DECK_NAME.get()}


class Child:
    """A started program. What it says of an error goes to a file, where it cannot fill a pipe that nobody reads."""

    def __init__(self, command, output=subprocess.DEVNULL):
        self.errors = tempfile.TemporaryFile()
        # Apart from the terminal: a key there reaches the command alone, which passes it on once.
        self.process = subprocess.Popen(command, stdout=output, stderr=self.errors, env=environment(),
            start_new_session=True)

    def code(self):
        """Its exit code, None while it runs."""
        return self.process.poll()

    def said(self):
        """The last line of its standard error."""
        self.errors.seek(0)
        lines = [line for line in self.errors.read().decode("utf-8", "replace").splitlines() if line.strip()]
        self.errors.close()
        return lines[-1].removeprefix("barreno: ") if lines else ""


class Program:
    """@param binary  the program  @param ranks  of its runs"""

    def __init__(self, binary, ranks):
        self.binary, self.ranks = str(binary), ranks
        self.asked = None  # the signal that asked for the end
        self.children = []

    def call(self, words):
        """What the program prints.  @raises Fault  with its sentence"""
        try:
            result = subprocess.run([self.binary, *words], capture_output=True, text=True, check=False)
        except OSError as error:
            raise Fault(f"the program {self.binary} cannot be started ({error.strerror}); name it in BARRENO_PROGRAM.", FILE) from None
        if result.returncode:
            raise Fault(result.stderr.strip().removeprefix("barreno: ") or f"{words[0]} ended without a word.", result.returncode)
        return result.stdout

    def effective_deck(self, words):
        """What a run of these words would write as deck.xml, without its comment. A bad deck is refused as by `barreno check`."""
        return body_of(self.call(["check", *words, "--print-deck"]))

    def is_newer_than(self, file):
        return os.path.getmtime(self.binary) > os.path.getmtime(file)

    def version(self):
        """The number that summary.json gives."""
        said = subprocess.run([self.binary, "--version"], capture_output=True, text=True, check=False).stdout
        found = re.search(r"\d+\.\d+\.\d+", said)
        return found.group(0) if found else ""

    def start(self, words, output=subprocess.DEVNULL):
        """@return the Child, which pass_on reaches from now on"""
        command = [self.binary, *words]
        if self.ranks > 1:
            command = with_mpi_environment(["mpirun", "--quiet", "--oversubscribe", "-n", str(self.ranks), *command])
        if shutil.which("setpriv"):  # a run does not outlive the command
            command = ["setpriv", "--pdeathsig", "USR1", *command]
        child = Child(command, output)
        self.children = [one for one in self.children if one.code() is None] + [child]
        if self.asked:  # before there was a run to pass it on to
            child.process.send_signal(signal.SIGUSR1)
        return child

    def pass_on(self, number, _frame=None):
        """The runs end behind a checkpoint; mpirun passes no other signal on. A second one is meant seriously."""
        first, self.asked = self.asked is None, self.asked or number
        for child in self.children:
            child.process.send_signal(signal.SIGUSR1 if first else signal.SIGTERM)

    def watch_signals(self):
        if threading.current_thread() is not threading.main_thread():  # Python lets no other take them
            return
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self.pass_on)


def body_of(text):
    """A deck without its first comment, which names the file."""
    return re.sub(r"\A<!--.*?-->\s*", "", text, count=1, flags=re.DOTALL).strip()


def setting_words(settings, example):
    """PATH=value of each; None removes a value or a list.

    @param example  what a caller who gave no dictionary could have written"""
    if settings is not None and not isinstance(settings, dict):
        raise Fault(f"set={settings!r} is not a dictionary; write for example set={example}.")
    return [f"{path}={'' if value is None else value}" for path, value in (settings or {}).items()]


def as_set(settings):
    return [word for setting in settings for word in ("--set", setting)]


def found_program(command, ranks):
    """@param command  whose name the sentence gives"""
    binary = places.program()
    if not binary:
        raise Fault(f"the program barreno is not found; name it in BARRENO_PROGRAM, or use ./barreno {command} of the source tree, which "
            "builds it.", FILE)
    return Program(binary, ranks)
