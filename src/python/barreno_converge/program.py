# SPDX-License-Identifier: BSD-3-Clause
"""The program barreno, as the command starts it."""

import os
import re
import shutil
import signal
import subprocess

from barreno_converge.faults import Fault


class Program:
    """@param binary  the program  @param ranks  of its runs"""

    def __init__(self, binary, ranks):
        self.binary, self.ranks = str(binary), ranks
        self.asked = None  # the signal that asked for the end
        self.child = None

    def effective_deck(self, words):
        """What a run of these words would write as deck.xml, without its comment. A bad deck is refused as by `barreno check`."""
        result = subprocess.run([self.binary, "check", *words, "--print-deck"], capture_output=True, text=True, check=False)
        if result.returncode:
            raise Fault(result.stderr.strip().removeprefix("barreno: ") or "the deck cannot be checked.", result.returncode)
        return body_of(result.stdout)

    def is_newer_than(self, file):
        return os.path.getmtime(self.binary) > os.path.getmtime(file)

    def version(self):
        """The number that summary.json gives."""
        said = subprocess.run([self.binary, "--version"], capture_output=True, text=True, check=False).stdout
        found = re.search(r"\d+\.\d+\.\d+", said)
        return found.group(0) if found else ""

    def compute(self, words):
        """Runs to the end. @return exit code and the last line of its standard error"""
        command = [self.binary, *words]
        if self.ranks > 1:
            command = ["mpirun", "--quiet", "--oversubscribe", "-n", str(self.ranks), *command]
        if shutil.which("setpriv"):  # a run does not outlive the command
            command = ["setpriv", "--pdeathsig", "USR1", *command]
        # Apart from the terminal: a key there reaches the command alone, which passes it on once.
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True) as self.child:
            if self.asked:  # before there was a run to pass it on to
                self.child.send_signal(signal.SIGUSR1)
            said = self.child.stderr.read()
            code = self.child.wait()
        self.child = None
        lines = [line for line in said.splitlines() if line.strip()]
        return code, lines[-1].removeprefix("barreno: ") if lines else ""

    def pass_on(self, number, _frame=None):
        """The run ends behind a checkpoint; mpirun passes no other signal on. A second one is meant seriously."""
        first, self.asked = self.asked is None, self.asked or number
        if self.child is not None:
            self.child.send_signal(signal.SIGUSR1 if first else signal.SIGTERM)

    def watch_signals(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self.pass_on)


def body_of(text):
    """A deck without its first comment, which names the file."""
    return re.sub(r"\A<!--.*?-->\s*", "", text, count=1, flags=re.DOTALL).strip()


def as_set(settings):
    return [word for setting in settings for word in ("--set", setting)]


def default_binary():
    return os.environ.get("BARRENO_PROGRAM") or shutil.which("barreno")
