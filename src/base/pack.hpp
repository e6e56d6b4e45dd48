// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

namespace barreno {

/// N doubles that are added and scaled together: the values of one node. Compilers left to
/// themselves split such short loops when some entries are known zeros, which doubled the time of
/// the projection.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(__CUDACC__) && !defined(__HIP__)
template <int N>
struct PackOf {
  // NOLINTNEXTLINE(modernize-use-using): the attribute needs it
  typedef double type __attribute__((vector_size(N * sizeof(double))));
};
template <int N>
using Pack = typename PackOf<N>::type;

/// The listed entries of a pack, in the order of the list.
template <int... Entries>
inline Pack<sizeof...(Entries)> select(const Pack<sizeof...(Entries)>& pack) {
  return __builtin_shufflevector(pack, pack, Entries...);
}
#else
template <int N>
struct Pack {
  double value[N];
  KOKKOS_INLINE_FUNCTION double& operator[](int i) { return value[i]; }
  KOKKOS_INLINE_FUNCTION double operator[](int i) const { return value[i]; }
  KOKKOS_INLINE_FUNCTION Pack& operator+=(const Pack& other) {
    for (int i = 0; i < N; ++i) value[i] += other.value[i];
    return *this;
  }
};
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator+(Pack<N> a, const Pack<N>& b) {
  return a += b;
}
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator*(double s, Pack<N> a) {
  for (int i = 0; i < N; ++i) a.value[i] *= s;
  return a;
}
template <int... Entries>
KOKKOS_INLINE_FUNCTION Pack<sizeof...(Entries)> select(const Pack<sizeof...(Entries)>& pack) {
  return {{pack.value[Entries]...}};
}
#endif

/// The packs of a node array; the arrays are aligned to them.
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N>* as_packs(double* values) {
  return reinterpret_cast<Pack<N>*>(values);
}
template <int N>
KOKKOS_INLINE_FUNCTION const Pack<N>* as_packs(const double* values) {
  return reinterpret_cast<const Pack<N>*>(values);
}

}  // namespace barreno
