# SPDX-License-Identifier: BSD-3-Clause
import sys

from barreno_compare.command import main

sys.exit(main())
