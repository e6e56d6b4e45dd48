# SPDX-License-Identifier: BSD-3-Clause
import sys

from barreno.runs.faults import start

sys.exit(start("barreno.uncertainties.command"))
