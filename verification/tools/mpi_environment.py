# SPDX-License-Identifier: BSD-3-Clause
"""What every rank of a test or measurement needs from Open MPI."""
import os


def mpi_environment(ranks=1):
    """Open MPI as root, unbound, more ranks than cores allowed; waiting ranks give way (unless told otherwise, if there are
    cores for all); all ranks are on this machine, and a start does not look for networks, which takes a quarter of its time."""
    environment = dict(os.environ)
    environment.update(
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_rmaps_base_oversubscribe="1",
        OMPI_MCA_hwloc_base_binding_policy="none",
        OMPI_MCA_btl_vader_single_copy_mechanism="none",
    )
    if ranks > os.cpu_count():
        environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    here = {"mpi_yield_when_idle": "1", "pml": "ob1", "btl": "self,vader"}
    for name, value in here.items():
        environment.setdefault(f"OMPI_MCA_{name}", value)
    return environment
