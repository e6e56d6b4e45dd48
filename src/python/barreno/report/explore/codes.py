# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as small whole numbers, and those as text: what the explorable view of a page holds of particles (docs/report.md)."""

import base64
import zlib

import numpy as np

FEW = 200  # distinct values that a field may have to be kept as they are
LINEAR = 0.1  # part of the range of colours up to which, from the middle, steps between codes are about equal
TYPES = {"u8": np.uint8, "i8": np.int8, "u16": np.uint16, "u32": np.uint32}


def few_values(finite):
    """The distinct values where there are few, else None."""
    found = np.unique(finite[:: max(1, len(finite) // 10000)])
    found = np.unique(finite) if len(found) <= FEW else found
    return found if len(found) <= FEW else None


def scale_of(values, middle, span, levels):
    """How a field is coded: 0 is no value, code i from 1 on is a value of a table, or

        v_i = middle + width sinh(step (i - zero)).

    Steps are even near the middle, which a code meets exactly, and grow with the distance from it; codes reach the extremes.

    @param span    of the colours
    @param levels  number of codes for values
    """
    finite = np.asarray(values, float)[np.isfinite(values)]
    few = few_values(finite)
    if few is not None:
        return {"table": [float(value) for value in few]}
    width = LINEAR * span
    low, high = np.arcsinh((finite.min() - middle) / width), np.arcsinh((finite.max() - middle) / width)
    low, high = min(low, 0.0), max(high, 0.0)
    step = float(high - low) / (levels - 2)
    return {"middle": float(middle), "width": width, "step": step, "zero": 1 + int(np.ceil(-low / step))}


def codes_of(values, scale, levels):
    """Codes of values; 0 where a value is not finite."""
    finite = np.isfinite(values)
    known = np.where(finite, values, 0.0)
    if "table" in scale:
        codes = 1 + np.searchsorted(scale["table"], known)
    else:
        codes = scale["zero"] + np.rint(np.arcsinh((known - scale["middle"]) / scale["width"]) / scale["step"])
    return np.where(finite, np.clip(codes, 1, levels), 0).astype(np.uint8 if levels < 256 else np.uint16)


def values_of_codes(codes, scale):
    """Values that codes stand for; nan for 0. The page does the same (page/numbers.js)."""
    codes = np.asarray(codes, float)
    if "table" in scale:
        values = np.array([np.nan, *scale["table"]])[codes.astype(int)]
    else:
        values = scale["middle"] + scale["width"] * np.sinh(scale["step"] * (codes - scale["zero"]))
    return np.where(codes > 0, values, np.nan)


def planes(numbers):
    """Bytes of whole numbers, all lowest ones first: high bytes are often equal, and so take little room when compressed."""
    flat = np.ascontiguousarray(numbers).ravel()
    little = flat.astype(flat.dtype.newbyteorder("<"))
    return little.view(np.uint8).reshape(len(flat), flat.dtype.itemsize).T.tobytes()


def packed(rows):
    """Whole numbers, (output, column), as text: which columns ever change, the first row, and of columns that change the differences from
    one output to the next, modulo their type; compressed by deflate, in base64."""
    rows = np.atleast_2d(rows)
    kind = next(name for name, dtype in TYPES.items() if rows.dtype == dtype)
    changed = (rows != rows[0]).any(axis=0)
    plain = rows.view(f"u{rows.dtype.itemsize}")
    differences = np.diff(plain[:, changed], axis=0)
    raw = np.packbits(changed, bitorder="little").tobytes() + planes(plain[0]) + planes(differences)
    return {
        "type": kind, "rows": len(rows), "columns": rows.shape[1], "changed": int(changed.sum()),
        "data": base64.b64encode(zlib.compress(raw, 6)).decode("ascii"),
    }  # fmt: skip
