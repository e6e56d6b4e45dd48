# SPDX-License-Identifier: BSD-3-Clause
"""Files of a run folder, opened only if they are ordinary files: a named pipe or a terminal, which anybody may have laid there under the
name of a file, would be waited for without end. Every reader of the commands opens here (tests/layout/check_pictures.py)."""

import os
import stat

KINDS = ((stat.S_ISFIFO, "a named pipe"), (stat.S_ISSOCK, "a socket"), (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"),
    (stat.S_ISDIR, "a folder"))


class NotRegular(OSError):
    """A whole clause on what stands there instead of a file."""


def refuse_others(mode):
    """@param mode  of a file, with its kind"""
    if not stat.S_ISREG(mode):
        kind = next((name for test, name in KINDS if test(mode)), "no ordinary file")
        raise NotRegular(f"it is {kind}, and only ordinary files are read")


def checked(path):
    """The same path, for a library that opens by name.  @raises OSError"""
    refuse_others(os.stat(path).st_mode)
    return path


def open_regular(path, mode="r", **more):
    """As open() to read.  @raises OSError"""

    def opener(name, flags):
        handle = os.open(checked(name), flags | os.O_NONBLOCK | os.O_CLOEXEC)
        try:
            refuse_others(os.fstat(handle).st_mode)  # what lies there may have been exchanged meanwhile
        except OSError:
            os.close(handle)
            raise
        return handle

    if "b" not in mode:
        more.setdefault("encoding", "utf-8")
    return open(path, mode, opener=opener, **more)


def read_text(path):
    with open_regular(path) as stream:
        return stream.read()


def read_bytes(path):
    with open_regular(path, "rb") as stream:
        return stream.read()
