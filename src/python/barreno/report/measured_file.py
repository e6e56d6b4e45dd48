# SPDX-License-Identifier: BSD-3-Clause
"""The file that --measured names: a profile, or slices of a CT scan."""

import pathlib

from barreno.report.measured import fault
from barreno.report.profile import read_profile
from barreno.report.slices import read_slices
from barreno.runs.faults import FILE, Fault, on_one_line

PICTURES = (".tif", ".tiff", ".png")


def read_measured(text):
    """@return a Measured  @raises Fault"""
    file = pathlib.Path(text)
    if not file.exists():
        raise Fault(f"--measured {text} does not exist; check the path.", FILE)
    try:
        return read_slices(file) if file.is_dir() or file.suffix.lower() in PICTURES else read_profile(file)
    except OSError as error:
        raise fault(file, f"cannot be read ({on_one_line(error.strerror or error)}).") from None
