# SPDX-License-Identifier: BSD-3-Clause
"""A set of files (Particle Files = "one per rank") as one.

SET is the folder of a run, its particles.e, which then stands for particles.e.N.0 and so on, or any file of the set. A file that has
the name of the new one stays as it is: then nothing is written.
"""
import argparse
import os
import pathlib
import sys

from barreno.runs.faults import FILE, Fault, exit_code, missing_package, on_one_line, say

try:
    from barreno.runs.exodus_sets import as_one_file, files_of, join  # noqa: F401
except ModuleNotFoundError as error:
    say(missing_package(error) or on_one_line(error))
    sys.exit(FILE)


def join_set(name, out):
    """Written under another name first, so that a full disk or Ctrl-C leaves no half file called OUT."""
    path = pathlib.Path(name)
    files = files_of(path / "particles.e" if path.is_dir() else path)
    out = pathlib.Path(out)
    if len(files) == 1:
        raise OSError(f"'{files[0]}' is a single file; nothing is to be joined")
    if out.exists() or out.is_symlink():
        raise OSError(f"'{out}' exists; choose another name")
    aside = out.with_name(out.name + ".tmp")
    try:
        join(files, aside)
        os.replace(aside, out)
    finally:
        aside.unlink(missing_ok=True)


def run(words):
    parser = argparse.ArgumentParser(prog="barreno join", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("set", metavar="SET", help="a run's folder, its particles.e or a file of the set")
    parser.add_argument("--out", required=True, metavar="FILE", help="the single file to be written")
    arguments = parser.parse_args(words)
    try:
        join_set(arguments.set, arguments.out)
    except (OSError, RuntimeError) as error:  # netCDF reports a full disk with the latter
        raise Fault(f"cannot join '{arguments.set}' ({error}).", FILE) from None
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise Fault(f"cannot join '{arguments.set}' (a file of it is truncated or was changed: {error}).", FILE) from None
    return 0


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)


if __name__ == "__main__":
    sys.exit(main())
