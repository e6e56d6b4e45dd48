// SPDX-License-Identifier: BSD-3-Clause
#include "base/start_mpi.hpp"

#include <cstdlib>
#include <initializer_list>

namespace barreno {

bool is_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

void prepare_lone_mpi() {
  if (is_rank()) return;
  // Without the daemon all such processes have the same job number, and with it the same session
  // folder and shared memory: neither may be made. They send to themselves alone.
  setenv("OMPI_MCA_btl", "self", 1);
  constexpr const char* settings[][2] = {
      {"OMPI_MCA_ess_singleton_isolated", "1"},
      {"OMPI_MCA_orte_create_session_dirs", "0"},
      {"OMPI_MCA_pml", "ob1"}};
  for (const auto& [name, value] : settings) setenv(name, value, 0);
}

}  // namespace barreno
