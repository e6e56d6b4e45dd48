# SPDX-License-Identifier: BSD-3-Clause
"""GetFEM's Python module, or the end of the test without it."""

import calculix


def module():
    try:
        import getfem
    except ImportError:
        calculix.skip("no GetFEM for Python (Debian package python3-getfem).")
    getfem.util("trace level", 0)
    getfem.util("warning level", 0)
    return getfem
