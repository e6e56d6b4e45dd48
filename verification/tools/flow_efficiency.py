# SPDX-License-Identifier: BSD-3-Clause
"""Core flow efficiency of a whole hole, as `barreno flow` finds it."""

RING = 0.5e-3  # m: cells of the flow


def efficiency_of(rings, permeability):
    """Radial flow through rock of this permeability over that through virgin rock.

    @param rings  barreno.flow.rings.rings_of(run, time, cell)
    """
    from barreno.flow.solve import solve

    return solve(rings, permeability, "radial").rate / solve(rings, rings.virgin_mobility, "radial").rate


def efficiency_of_run(folder):
    """The same of the hole at the end of a run, with rings of RING."""
    from barreno.flow.rings import rings_of
    from barreno.report.run import opened

    with opened(folder) as run:
        rings = rings_of(run, None, RING)
        return efficiency_of(rings, rings.permeability)
