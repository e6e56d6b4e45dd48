// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include <cstddef>

namespace barreno {

/// Spaces of kernels and state. Another Kokkos backend is a build option of Trilinos, not of this
/// code.
using ExecutionSpace = Kokkos::DefaultExecutionSpace;
using MemorySpace = ExecutionSpace::memory_space;

/// One column per component, unit stride over particles.
using FieldView = Kokkos::View<double**, Kokkos::LayoutLeft, MemorySpace>;
template <class T>
using ArrayView = Kokkos::View<T*, MemorySpace>;

using ParticleId = long long;

/// A small count as the length of an array.
template <int N>
inline constexpr std::size_t extent = N;

/// Rows or tiles [0, count) for a kernel.
using RowPolicy = Kokkos::RangePolicy<ExecutionSpace, Kokkos::IndexType<int>>;
inline RowPolicy range(int count) {
  return {0, count};
}

}  // namespace barreno
