# SPDX-License-Identifier: BSD-3-Clause
"""Slices of a CT scan across a hole: in each the hole is a region of pixels beyond a threshold, and its radius that of a disk of the same
area. The hole is the largest such region of the first slice that has one, and below it what overlaps the region above; regions that meet
the border of a slice, as the air around a core, are none. It ends at the first slice without it."""

import dataclasses
import io
import json

import numpy as np

from barreno.report.measured import Measured, fault
from barreno.runs.faults import Fault, needed, on_one_line
from barreno.runs.regular_file import read_bytes
from barreno.runs.words import LENGTH_UNITS, quantity_of

EXAMPLE = '{"pixel": "0.1 mm", "spacing": "0.5 mm", "first": "0 mm", "threshold": 90, "hole": "dark"}'
KEYS = ("pixel", "spacing", "first", "threshold", "hole")


@dataclasses.dataclass
class Scale:
    """What slices lack: their lengths, and what is hole in them."""

    pixel: float  # edge of a pixel [m]
    spacing: float  # from one slice to the next [m]
    first: float  # depth of the first slice [m]
    threshold: float  # grey value
    dark: bool  # whether the hole is below the threshold


def length_in(note, words, name, default, least):
    if name not in words and default is not None:
        return default
    try:
        value = quantity_of(str(words[name]), LENGTH_UNITS)
    except (KeyError, ValueError):
        value = float("nan")
    if not value >= least or name != "first" and value == 0.0:
        said = f"the {name} '{on_one_line(words[name])[:40]}'" if name in words else f"no {name}"
        raise fault(note, f"has {said}, where a length is needed; write for example {EXAMPLE}.")
    return value


def scale_of(note):
    """Of a file of JSON beside the slices."""
    if not note.exists():
        raise fault(note, f"is missing: slices have no lengths of their own. Write it, for example with {EXAMPLE} (docs/report.md).")
    try:
        words = json.loads(read_bytes(note).decode("utf-8"))
    except ValueError as error:
        raise fault(note, f"is no JSON ({on_one_line(error)[:100]}); write for example {EXAMPLE}.") from None
    if not isinstance(words, dict) or set(words) - set(KEYS):
        odd = ", ".join(sorted(set(words) - set(KEYS)))[:100] if isinstance(words, dict) else "a list or a number"
        raise fault(note, f"has {odd}, which is none of {', '.join(KEYS)}; write for example {EXAMPLE}.")
    threshold, hole = words.get("threshold"), words.get("hole", "dark")
    if isinstance(threshold, bool) or not isinstance(threshold, (int, float)):
        raise fault(note, f"has no number as threshold, the grey value between hole and rock; write for example {EXAMPLE}.")
    if hole not in ("dark", "light"):
        raise fault(note, f'has the hole "{on_one_line(hole)[:40]}"; write "dark" or "light".')
    pixel = length_in(note, words, "pixel", None, 0.0)
    return Scale(pixel, length_in(note, words, "spacing", pixel, 0.0), length_in(note, words, "first", 0.0, 0.0), float(threshold),
        hole == "dark")


def grey(picture):
    """Grey values of a picture; a coloured one by its brightness."""
    return np.asarray(picture.convert("L") if picture.mode in ("1", "P", "LA", "RGB", "RGBA", "CMYK", "YCbCr") else picture)


def pictures_in(file):
    """Grey values of the slices of a file with one picture or several, one after the other."""
    image, sequence = needed("PIL.Image"), needed("PIL.ImageSequence")
    try:
        with image.open(io.BytesIO(read_bytes(file))) as picture:
            for page in sequence.Iterator(picture):
                yield grey(page)
    except (image.DecompressionBombError, SyntaxError, ValueError, EOFError, OSError) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise
        raise fault(file, "is no picture that can be read; give slices as TIFF or PNG.") from None


def slices_of(path):
    """Files of a stack, and the file that says its lengths."""
    if not path.is_dir():
        return [path], path.with_suffix(".json")
    files = sorted(file for file in path.iterdir() if file.suffix.lower() in (".png", ".tif", ".tiff"))
    if not files:
        raise fault(path, "is a folder without PNG or TIFF files; give the folder of the slices.")
    return files, path / "stack.json"


def hole_in(mask, above):
    """The hole of a slice, as a mask; none where no region away from the border is hole.

    @param above  the hole of the slice above; None before the first
    """
    label = needed("scipy.ndimage").label
    labels, count = label(mask)
    at_border = np.unique(np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]]))
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    sizes[at_border] = 0
    sizes[0] = 0
    if above is not None:
        below = np.unique(labels[above])
        return np.isin(labels, below[sizes[below] > 0])
    return labels == sizes.argmax() if sizes.any() else np.zeros_like(mask)


def radii_of(path, files, scale):
    """Radius of every slice, down to the first below the hole [m]."""
    radii, above, shape = [], None, None
    for file in files:
        for picture in pictures_in(file):
            if picture.ndim != 2 or shape not in (None, picture.shape):
                size = " x ".join(map(str, picture.shape))
                raise fault(file, f"has a slice of {size} pixels, unlike the first of the stack; give slices of one size.")
            shape = picture.shape
            hole = hole_in(picture < scale.threshold if scale.dark else picture > scale.threshold, above)
            if above is not None and not hole.any():
                return radii
            above = hole if hole.any() else None
            radii.append(float(np.sqrt(hole.sum() / np.pi)) * scale.pixel)
    if above is None:
        side = "below" if scale.dark else "above"
        raise fault(path, f"contains no hole: no slice has a region {side} the grey value {scale.threshold:g} that is apart from its "
            "border; check the threshold, and whether the hole is dark or light.")
    return radii


def read_slices(path):
    """Slices of a TIFF file, or of a folder in the order of their names, with a file of JSON that says their lengths.  @raises Fault"""
    files, note = slices_of(path)
    scale = scale_of(note)
    radii = np.array(radii_of(path, files, scale))
    first = int(np.argmax(radii > 0.0))
    depth = scale.first + scale.spacing * np.arange(len(radii))
    if len(radii) - first < 2:
        raise Fault(f"--measured {path.name} has a hole in one slice only; a profile needs at least two.")
    return Measured(path.name, depth[first:], radii[first:], float(depth[-1] + 0.5 * scale.spacing))
