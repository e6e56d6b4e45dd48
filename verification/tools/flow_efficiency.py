# SPDX-License-Identifier: BSD-3-Clause
"""Core flow efficiency of a whole hole, as `barreno flow` finds it."""


def efficiency_of(rings, permeability):
    """Radial flow through rock of this permeability over that through virgin rock.

    @param rings  barreno.flow.rings.rings_of(run, time, cell)
    """
    from barreno.flow.solve import solve

    return solve(rings, permeability, "radial").rate / solve(rings, rings.virgin_mobility, "radial").rate
