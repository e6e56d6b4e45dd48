# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a run as pandas frames."""

import io

from barreno.interface.units import unit_of_column
from barreno.runs.faults import FILE, Fault, needed, on_one_line
from barreno.runs.regular_file import read_text


def whole_lines(text):
    """Without comments above the names, and without a last line that was cut off."""
    lines = text.replace("\r\n", "\n").split("\n")[:-1]
    first = next((i for i, line in enumerate(lines) if not line.startswith("#")), len(lines))
    return "".join(f"{line}\n" for line in lines[first:])


def read_frame(file, texts=False):
    """A CSV file as a frame.

    Parameters
    ----------
    file : pathlib.Path
    texts : bool
        Whether a column may hold texts.

    Raises
    ------
    Fault
        If the file is not there, or no table.
    """
    pandas = needed("pandas")
    try:
        frame = pandas.read_csv(io.StringIO(whole_lines(read_text(file))), index_col=False, float_precision="round_trip")
    except FileNotFoundError:
        raise Fault(f"{file} does not exist; docs/output.md says which runs write it.", FILE) from None
    except (OSError, ValueError) as error:
        raise Fault(f"{file} cannot be read as a table ({on_one_line(error)[:200]}); make the run again.", FILE) from None
    odd = [name for name in frame.columns if not texts and not pandas.api.types.is_numeric_dtype(frame[name])]
    if odd:
        raise Fault(f"{file} has something that is not a number in the column '{odd[0]}'; make the run again.", FILE)
    return frame


def read_columns(file):
    """A table of a run, with the units of its columns in `attrs["units"]`."""
    frame = read_frame(file)
    frame.attrs["units"] = {name: unit_of_column(name) for name in frame.columns}
    return frame
