#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Carroll and Holt's shell: its command line.

    carroll_holt.py --table         load and unload of the standard shell, CSV on stdout
    carroll_holt.py --self-check    against stored numbers, a column of material points and limits

The closed form is shell_statics.py.
"""
import argparse
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from oracles import carroll_holt_selfcheck
from oracles.shell_statics import Shell, curve


def print_table():
    shell = Shell(fluid_modulus=2.2e9)
    strains = [-0.001 * i for i in range(121)] + [-0.12 + 0.0005 * i for i in range(1, 181)]
    print("strain,branch,phase,effective_pressure,fluid_pressure")
    for strain, branch, phase, value, fluid in curve(shell, strains, -0.12):
        print(f"{strain:.6g},{branch},{phase},{value!r},{fluid!r}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--table", action="store_true")
    what.add_argument("--self-check", action="store_true")
    if parser.parse_args().table:
        print_table()
        return 0
    return carroll_holt_selfcheck.main()


if __name__ == "__main__":
    sys.exit(main())
