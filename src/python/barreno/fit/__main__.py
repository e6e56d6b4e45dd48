# SPDX-License-Identifier: BSD-3-Clause
import sys

try:
    from barreno_fit.command import main
except ImportError as error:
    print(f"barreno: a fit needs NumPy, SciPy and Matplotlib ({error}); apt-get install python3-numpy python3-scipy python3-matplotlib, "
        "and use /usr/bin/python3.", file=sys.stderr)
    sys.exit(2)

sys.exit(main())
