# SPDX-License-Identifier: BSD-3-Clause
import sys

from barreno_runs.faults import start

sys.exit(start("barreno_import.command"))
