// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <string>
#include <type_traits>
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

/// Kokkos::parallel_scan without a request for memory: kernel(row, sum of those before it, whether
/// this is the last pass, in which that sum is whole).
template <class Kernel>
void launch_scan(const char* label, const RowPolicy& policy, const Kernel& kernel) {
  Kokkos::parallel_scan(kernel_label<Kernel>(label), policy, kernel);
}

/// Whether one thread does all of a launch, row after row.
#ifdef KOKKOS_ENABLE_SERIAL
inline constexpr bool in_one_thread = std::is_same_v<ExecutionSpace, Kokkos::Serial>;
#else
inline constexpr bool in_one_thread = false;
#endif

/// Adds to a value that several rows of a launch add to. @return what it was before
template <class Number>
KOKKOS_INLINE_FUNCTION Number fetch_add(Number& to, Number amount) {
  if constexpr (in_one_thread) {
    const Number before = to;
    to += amount;
    return before;
  } else {
    return Kokkos::atomic_fetch_add(&to, amount);
  }
}

}  // namespace barreno
