# SPDX-License-Identifier: BSD-3-Clause
"""Drive one material point with `barreno drive`: the way in which verification cases use a model without a grid."""
import pathlib
import tempfile

import numpy as np
from barreno.runs.csv_table import arrays_of, read_csv
from tools.runs import call

HEADER = "time,F11,F12,F13,F21,F22,F23,F31,F32,F33"


def write_card(file, model, density, parameters):
    entries = {"Model": model, "Density": density, **parameters}
    lines = [f'  <Parameter name="{name}" type="string" value="{value}"/>' for name, value in entries.items()]
    file.write_text("\n".join(['<ParameterList name="Card">', *lines, "</ParameterList>"]) + "\n")


def write_path(file, rows):
    """Rows of (time, 3x3 deformation gradient)."""
    lines = [",".join([repr(float(t))] + [repr(float(x)) for x in np.asarray(f, float).ravel()]) for t, f in rows]
    file.write_text("\n".join([HEADER, *lines]) + "\n")


def drive(barreno, model, parameters, rows, steps=1, density=1000.0):
    """Columns of the answer as arrays; SI. An error of the code is an error here."""
    with tempfile.TemporaryDirectory(prefix="drive-") as scratch:
        card, path, out = (pathlib.Path(scratch) / name for name in ("card.xml", "path.csv", "answer.csv"))
        write_card(card, model, density, parameters)
        write_path(path, rows)
        result = call(barreno, ["drive", "--material", card, "--path", path, "--out", out, "--steps-per-row", steps])
        if result.returncode != 0:
            raise RuntimeError(f"{' '.join(result.args)} ended with {result.returncode}: {result.stderr.strip()}")
        return arrays_of(read_csv(out))


def drive_card(barreno, card, lines, steps, settings=()):
    """The same of a card along a path of lines, header first, with a row for every step."""
    with tempfile.TemporaryDirectory(prefix="drive-") as scratch:
        path, out = (pathlib.Path(scratch) / name for name in ("path.csv", "answer.csv"))
        path.write_text("\n".join(lines) + "\n")
        words = ["drive", "--material", card, "--path", path, "--out", out, "--steps-per-row", steps, "--every-step"]
        result = call(barreno, words + [word for setting in settings for word in ("--set", setting)])
        if result.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, result.args))} ended with {result.returncode}: {result.stderr.strip()}")
        return arrays_of(read_csv(out))


def knows(barreno, model, parameter):
    """Whether this build's model has a parameter of that name."""
    described = call(barreno, ["describe", model])
    described.check_returncode()
    return parameter in (line.strip() for line in described.stdout.splitlines())
