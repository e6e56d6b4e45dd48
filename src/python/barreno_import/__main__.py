# SPDX-License-Identifier: BSD-3-Clause
import sys

from barreno_import.command import main

sys.exit(main())
