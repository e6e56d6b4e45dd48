# SPDX-License-Identifier: BSD-3-Clause
"""Whether a program works in a run folder: it holds a lock of the system on run.lock (src/output/folder_lock.hpp)."""

import fcntl
import os
import struct

FLOCK = "hhqqi"  # struct flock of Linux: type, whence, start, length, process


def is_running(folder):
    try:
        handle = os.open(folder / "run.lock", os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return False
    try:
        asked = struct.pack(FLOCK, fcntl.F_WRLCK, os.SEEK_SET, 0, 2, 0)
        found = struct.unpack(FLOCK, fcntl.fcntl(handle, fcntl.F_OFD_GETLK, asked))
        return found[0] != fcntl.F_UNLCK
    except OSError:  # a disk without locks
        return False
    finally:
        os.close(handle)
