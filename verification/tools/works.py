# SPDX-License-Identifier: BSD-3-Clause
"""Works of material points, as the ledger of a run counts them: what the update itself says, per reference volume."""
import ctypes

import numpy as np
from barreno.materials import STRESS, _Batch, _pointer


def works_along(material, increments, stress, state, dt=1.0):
    """Points along steps of strain.

    @param increments  (steps, points, 6)
    @return stresses after every step (steps, points, 6); state at the end; recoverable and dissipated work of every step
            (steps, points, 2) [J/m3]
    """
    works = np.zeros((*increments.shape[:2], 2))
    stresses = np.empty_like(increments)
    status = np.zeros(len(stress), dtype=np.intc)
    for strain, new_stress, work in zip(np.ascontiguousarray(increments), stresses, works):
        new_state = np.empty_like(state)
        arrays = (strain, stress, new_stress, state, new_state)
        batch = _Batch(len(stress), STRESS, dt, *map(_pointer, arrays), None, _pointer(work), _pointer(status))
        assert material.library.barreno_material_update(material.handle, ctypes.byref(batch)) == 0, material.why()
        stress, state = new_stress, new_state
    return stresses, state, works
