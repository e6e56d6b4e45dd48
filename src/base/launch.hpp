// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <string>
#include <utility>

namespace barreno {

/// The name of a type of kernel, made once: Kokkos wants a string, which would ask for memory at
/// every launch.
/// @param label  the same in all calls for one type
template <class Kernel>
const std::string& kernel_label(const char* label) {
  static const std::string name(label);
  return name;
}

/// Kokkos::parallel_for without a request for memory.
template <class Kernel>
void launch(const char* label, const RowPolicy& policy, const Kernel& kernel) {
  Kokkos::parallel_for(kernel_label<Kernel>(label), policy, kernel);
}

/// Kokkos::parallel_reduce without a request for memory.
template <class Kernel, class... Results>
void launch_reduction(
    const char* label, const RowPolicy& policy, const Kernel& kernel, Results&&... results
) {
  Kokkos::parallel_reduce(
      kernel_label<Kernel>(label), policy, kernel, std::forward<Results>(results)...
  );
}

}  // namespace barreno
