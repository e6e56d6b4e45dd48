# SPDX-License-Identifier: BSD-3-Clause
"""The points of a sweep: which values go together."""

import itertools

from barreno.runs.faults import Fault, needed
from barreno.sweeps.variation import Value

MOST_RUNS = 10000  # of an array job, too


def full_grid(variations):
    """Every value with every other; those of the last parameter change fastest."""
    return list(itertools.product(*(variation.values for variation in variations)))


def together(variations):
    """The first values, the second values and so on."""
    counts = [len(variation.values) for variation in variations]
    if len(set(counts)) > 1:
        said = " and ".join(f"{count} of {variation.path}" for count, variation in zip(counts, variations))
        raise Fault(f"--sample list takes values position by position, and there are {said}; give every --vary as many values, or take "
            "--sample grid.")
    return list(zip(*(variation.values for variation in variations)))


def hypercube(dimensions, samples, seed):
    """A row of shares of the ranges for each sample: each range in as many equal parts as there are samples, and one value in every part,
    in an order drawn anew for every parameter (McKay, Beckman and Conover, Technometrics 21, 239, 1979), as SciPy draws them."""
    return needed("scipy.stats.qmc").LatinHypercube(d=dimensions, seed=seed).random(samples)


def latin_hypercube(variations, samples, seed):
    """Numbers have six digits, which make the same deck wherever they are drawn."""
    for variation, column in zip(variations, hypercube(len(variations), samples, seed).T):
        texts = [f"{variation.low + share * (variation.high - variation.low):.6g}" for share in column]
        variation.values = [Value(f"{text} {variation.unit}".strip(), float(text), variation.unit) for text in texts]
    return list(zip(*(variation.values for variation in variations)))


def points_of(variations, sample, samples, seed):
    """[(Value of each parameter)], one for every run"""
    count = samples
    if sample == "grid":
        count = 1
        for variation in variations:
            count *= len(variation.values)
    if count is not None and count > MOST_RUNS:
        raise Fault(f"the sweep has {count} runs, more than {MOST_RUNS}; give fewer values, or draw some with --sample latin --samples "
            "100.")
    if sample == "grid":
        return full_grid(variations)
    return together(variations) if sample == "list" else latin_hypercube(variations, samples, seed)
