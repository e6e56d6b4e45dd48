#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables in files: what is read as numbers, texts and units, and what is said of a file that is no table."""
import math
import pathlib
import subprocess
import sys
import tempfile

from barreno.runs.csv_table import MIXED, WORDS, BadTable, arrays_of, read_csv

GOOD = "# made by hand\ntime [us],depth [mm],count\n0.1, 1 ,3\n\n# between rows\n0.30000000000000004,nan,4\n1e400,-inf,5\n"
BAD = {  # text: of the sentence, and the column
    "": ("it has no line of names", ""),
    "# comment alone\n": ("it has no line of names", ""),
    "a,b\n1,2\n3\n": ("line 3 has 1 columns instead of 2", ""),
    "a,b\n1,2,3\n": ("line 2 has 3 columns instead of 2", ""),
    "a,b\n1,2\n\n# more\n3,deep\n": ("line 5 contains something that is not a number: could not convert string to float: 'deep'", "b"),
    "a,b\n1,x\ny,2\n": ("line 2 contains something that is not a number", "b"),  # the first of two
    "a,b\n1,\n": ("line 2 contains something that is not a number", "b"),
    "a,b\n1,True\n": ("line 2 contains something that is not a number", "b"),
    "a,b\n1,0x10\n": ("line 2 contains something that is not a number", "b"),
    "a,b\n1,2\r3\n": ("line 2 contains something that is not a number", "b"),
    "a,b\n1\0,2\n": ("it is no text: it has bytes of value 0", ""),
    'a,b\n"1,2\n3,4\n': ("EOF inside string", ""),
    b"a,b\n\xff,2\n": ("can't decode byte 0xff", ""),
}


def read(file, text, **more):
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_csv(file, **more)


def check_numbers(file):
    for text in (GOOD, GOOD.replace("\n", "\r\n")):
        frame = read(file, text)
        assert frame.attrs["units"] == {"time [us]": "us", "depth [mm]": "mm"}, frame.attrs
        assert frame.attrs["comments"] == ["# made by hand", "# between rows"], frame.attrs
        assert frame["time [us]"].tolist() == [0.1, 0.30000000000000004, math.inf] and frame["count"].tolist() == [3, 4, 5], frame
        assert frame["count"].dtype.kind == "i" and math.isnan(frame["depth [mm]"][1]) and frame["depth [mm]"][2] == -math.inf, frame
    assert {name: values.dtype.kind for name, values in arrays_of(frame).items()} == dict.fromkeys(frame.columns, "f")
    empty = read(file, "a,b\n")
    assert len(empty) == 0 and arrays_of(empty)["b"].shape == (0,), empty


def check_cut(file):
    """A last line without its end may be half a number."""
    assert read(file, "a\n1\n2")["a"].tolist() == [1, 2] and read(file, "a\n1\n2", cut=True)["a"].tolist() == [1]
    assert read(file, "a,b\n1,2\n3", cut=True)["b"].tolist() == [2]


def check_texts(file):
    text = 'run;value;word\n"a;b";;NA\nc;2.50;None\n'
    mixed, words = read(file, text, cells=MIXED, separator=";"), read(file, text, cells=WORDS, separator=";")
    assert mixed["run"].tolist() == ["a;b", "c"] and mixed["word"].tolist() == ["NA", "None"], mixed
    assert math.isnan(mixed["value"][0]) and mixed["value"][1] == 2.5, mixed
    assert words["value"].tolist() == ["", "2.50"], words


def check_bad(file):
    for text, (sentence, column) in BAD.items():
        try:
            found = read(file, text)
        except BadTable as fault:
            assert sentence in str(fault) and fault.column == column, f"{text!r}: {fault}, column {fault.column!r}"
        else:
            raise AssertionError(f"{text!r} was read as {found}")


def check_lazy():
    """pandas takes half a second: whoever reads no table does not wait for it."""
    names = ("report.command", "sweeps.command", "compare.command", "converge.command", "flow.command", "jet.command", "interface.opened")
    program = "import sys, " + ", ".join(f"barreno.{name}" for name in names) + "; print('pandas' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout == "False\n"


def main():
    with tempfile.TemporaryDirectory() as scratch:
        for check in (check_numbers, check_cut, check_texts, check_bad):
            check(pathlib.Path(scratch) / "table.csv")
    check_lazy()
    print("tables are read as they stand, and what is no table is said")


if __name__ == "__main__":
    main()
