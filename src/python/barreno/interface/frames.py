# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a run as pandas frames."""

from barreno.interface.units import unit_of_column
from barreno.runs.csv_table import MIXED, NUMBERS, BadTable, read_csv
from barreno.runs.faults import FILE, Fault, needed, on_one_line


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
    needed("pandas")
    try:
        return read_csv(file, cells=MIXED if texts else NUMBERS, cut=True)
    except FileNotFoundError:
        raise Fault(f"{file} does not exist; docs/output.md says which runs write it.", FILE) from None
    except (OSError, BadTable) as error:
        if getattr(error, "column", ""):
            raise Fault(f"{file} has something that is not a number in the column '{error.column}'; make the run again.", FILE) from None
        raise Fault(f"{file} cannot be read as a table ({on_one_line(error)[:200]}); make the run again.", FILE) from None


def read_columns(file):
    """A table of a run, with the units of its columns in `attrs["units"]`."""
    frame = read_frame(file)
    frame.attrs["units"] = {name: unit_of_column(name) for name in frame.columns}
    return frame
