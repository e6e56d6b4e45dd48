# SPDX-License-Identifier: BSD-3-Clause
"""What ends a command, as one sentence and an exit code."""

import importlib
import os
import pathlib
import sys
import traceback

USAGE, FILE, NUMERICAL, INTERNAL = 1, 2, 3, 4
PACKAGE = str(pathlib.Path(__file__).parents[1])
INTERRUPTED, UNREAD = 130, 141  # as a shell says of SIGINT and SIGPIPE
PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "netCDF4": "python3-netcdf4", "scipy": "python3-scipy",
    "PIL": "python3-pil", "jinja2": "python3-jinja2",
    "markupsafe": "python3-markupsafe", "pandas": "python3-pandas", "xarray": "python3-xarray"}


class Fault(Exception):
    """A whole sentence on what cannot be done, and why.

    Parameters
    ----------
    sentence : str
    code : int
        Exit code of the command that says the same.
    """

    def __init__(self, sentence, code=USAGE):
        super().__init__(on_one_line(sentence))
        self.code = code


class BadRun(Exception):
    """What keeps a run folder from being read, as the part of a sentence that stands in brackets."""


class NothingToDraw(Exception):
    """Why a picture is left out, as a clause."""


def on_one_line(text):
    """Also of a text with letters that no file can hold, as JSON may spell them."""
    return " ".join(str(text).split()).encode("utf-8", "backslashreplace").decode()


def printable(text):
    """A name with its line ends, control characters and undecoded bytes spelled out, so that it stays one name wherever it is shown."""
    return "".join(letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii") for letter in str(text))


def missing_package(error):
    """A sentence on a module that Python lacks; None for one of the command's own."""
    name = (error.name or "").split(".")[0]
    if not name or name == "barreno":
        return None
    package = f" (Debian: apt-get install {PACKAGES[name]})" if name in PACKAGES else ""
    return f"Python lacks {name} ('{sys.executable}' runs this); install it{package}, or use another Python, as /usr/bin/python3."


def needed(name):
    """A module that a call cannot do without.  @raises Fault  that names its package"""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        raise Fault(missing_package(error) or error, FILE) from None


def place_of(error):
    """The innermost line of the package's own code."""
    lines = traceback.extract_tb(error.__traceback__)
    own = [line for line in lines if line.filename.startswith(PACKAGE) and line.filename != __file__] or lines
    return f"{'/'.join(pathlib.Path(own[-1].filename).parts[-2:])}, line {own[-1].lineno}" if own else "an unknown place"


def internal(error):
    """A sentence on what nobody foresaw."""
    what = on_one_line(f"{type(error).__name__}: {error}")[:300]
    return (
        f"internal error at {place_of(error)} ({what}); please report it with the command and the files that it reads (BARRENO_TRACEBACK=1 "
        "prints all of it)."
    )


def sentence_of(error):
    """(sentence, exit code) of whatever a command did not foresee."""
    if isinstance(error, ModuleNotFoundError) and missing_package(error):
        return missing_package(error), FILE
    if isinstance(error, MemoryError):
        return "there is not enough memory for this command; free some, or give it less to read.", FILE
    if isinstance(error, OSError) and error.strerror:
        name = f"'{error.filename}'" if error.filename is not None else "what is printed"
        return f"{name} cannot be read or written ({error.strerror}); make room or check the permissions, and try again.", FILE
    return internal(error), INTERNAL


def say(sentence):
    print(f"barreno: {sentence}", file=sys.stderr)


def drop_output():
    """Nothing more is printed: its reader has left, or its disk is full."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError):
        pass  # a test reads what is printed


def spell_out_odd_letters():
    """A terminal that cannot show a letter of a name shows its number instead."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def exit_code(run, words):
    """Of a command, whose faults are said: each in a sentence, never as a traceback.  @param run  words to exit code"""
    spell_out_odd_letters()
    try:
        code = run(words)
        sys.stdout.flush()
        return code
    except Fault as fault:
        say(fault)
        return fault.code
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # whoever read the lines has left (| head)
        drop_output()
        return UNREAD
    except Exception as error:  # noqa: BLE001
        if os.environ.get("BARRENO_TRACEBACK"):
            traceback.print_exc()
        sentence, code = sentence_of(error)
        if isinstance(error, OSError) and error.filename is None:
            drop_output()
        say(sentence)
        return code


def start(module):
    """Exit code of the command of a module, whose packages this Python may lack."""
    return exit_code(lambda words: importlib.import_module(module).main(words), sys.argv[1:])
