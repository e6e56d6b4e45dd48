# SPDX-License-Identifier: BSD-3-Clause
"""Particles of several outputs in one table of whole numbers: places, shapes, which of them are there."""

import dataclasses

import numpy as np

PLACES = 65535  # steps along the longer edge of what particles ever cover
SHAPE = 20.0  # steps in half the first size of a particle


@dataclasses.dataclass
class Output:
    """What is drawn of one output."""

    frame: object
    of: np.ndarray  # particles among those of the frame
    columns: np.ndarray  # their columns in the table


def steps_between(count, most):
    """Numbers of outputs, evenly spaced, the first and the last among them."""
    return np.unique(np.rint(np.linspace(0, count - 1, min(count, max(most, 2)))).astype(int))


def edges_of(shapes):
    """(shape, 4): half of the two edges of a quadrangle, as of the parallelogram that is nearest to it."""
    right = 0.25 * (shapes[:, 1] - shapes[:, 0] + shapes[:, 2] - shapes[:, 3])
    up = 0.25 * (shapes[:, 3] - shapes[:, 0] + shapes[:, 2] - shapes[:, 1])
    return np.concatenate([right, up], axis=1)


def drawn(frame):
    """Centres, half edges and particles of the shapes whose numbers are finite."""
    shapes, of = frame.shapes
    fine = np.isfinite(shapes).all(axis=(1, 2))
    return shapes[fine].mean(axis=1), edges_of(shapes[fine]), of[fine]


class Stack:
    """Outputs of a run; columns are the particles that any of them shows."""

    def __init__(self, file, steps):
        self.file, self.steps, self.times = file, steps, file.times[steps]
        shown, low, high = [], np.full(2, np.inf), np.full(2, -np.inf)
        for step in steps:
            frame = file.frame(step)
            centres, _, of = drawn(frame)
            shown.append((of, np.flatnonzero(frame.alive)[of]))
            low, high = np.minimum(low, centres.min(axis=0, initial=np.inf)), np.maximum(high, centres.max(axis=0, initial=-np.inf))
        self.elements = np.unique(np.concatenate([elements for _, elements in shown]))
        self.outputs = [Output(file.frame(step), of, np.searchsorted(self.elements, elements))
            for step, (of, elements) in zip(steps, shown)]
        self.low, self.quantum = low, max(float((high - low).max(initial=0.0)) / PLACES, 1e-12)

    @property
    def shape(self):
        return len(self.steps), len(self.elements)

    def table(self, values_at, fill=np.nan, dtype=float):
        """(output, column) of a quantity, values_at(frame) for the particles that exist."""
        found = np.full(self.shape, fill, dtype)
        for row, output in zip(found, self.outputs):
            row[output.columns] = values_at(output.frame)[output.of]
        return found

    def there(self):
        """(output, column): 1 where a particle is drawn."""
        return self.table(lambda frame: np.ones(int(frame.alive.sum()), np.uint8), 0, np.uint8)

    def places(self):
        """Places (output, 2 column), shapes (output, 4 column) and first sizes (column) as whole numbers, the largest first size in m, and
        the areas (output, column).

        A place stays where a particle was last while it is not there: what does not change takes no room."""
        rows, columns = self.shape
        places, shapes = np.zeros((rows, columns, 2), np.uint16), np.zeros((rows, columns, 4), np.int8)
        sizes, areas = np.zeros(columns), np.zeros((rows, columns))
        for row, output in enumerate(self.outputs):
            centres, edges, _ = drawn(self.file.frame(self.steps[row]))
            if row > 0:
                places[row], shapes[row] = places[row - 1], shapes[row - 1]
            at, half = output.columns, np.abs(edges).max(axis=1)
            sizes[at] = np.where(sizes[at] > 0.0, sizes[at], np.maximum(half, 1e-12))
            places[row, at] = np.rint((centres - self.low) / self.quantum)
            shapes[row, at] = np.clip(np.rint(edges / sizes[at, None] * SHAPE), -127, 127)
            areas[row, at] = 4.0 * np.abs(edges[:, 0] * edges[:, 3] - edges[:, 1] * edges[:, 2])
        largest = float(sizes.max(initial=1e-12))
        first = np.maximum(np.rint(sizes / largest * PLACES), 1).astype(np.uint16)
        return places.reshape(rows, -1), shapes.reshape(rows, -1), first, largest, areas
