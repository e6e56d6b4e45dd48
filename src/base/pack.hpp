// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

#include <type_traits>

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

#ifdef __AVX512F__
inline constexpr int register_doubles = 8;
#else
inline constexpr int register_doubles = 4;
#endif

/// Eight doubles in two vectors. Of a vector wider than its registers gcc 12 moves the entries one
/// by one, with which the projection took six times as long.
struct TwoPacks {
  PackOf<4>::type low, high;

  double operator[](int i) const { return i < 4 ? low[i] : high[i - 4]; }
  friend TwoPacks operator+(const TwoPacks& a, const TwoPacks& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend TwoPacks operator-(const TwoPacks& a, const TwoPacks& b) {
    return {a.low - b.low, a.high - b.high};
  }
  friend TwoPacks operator*(double s, const TwoPacks& a) { return {s * a.low, s * a.high}; }
  friend TwoPacks operator*(const TwoPacks& a, const TwoPacks& b) {
    return {a.low * b.low, a.high * b.high};
  }
  TwoPacks& operator+=(const TwoPacks& other) { return *this = *this + other; }
  TwoPacks& operator*=(double s) { return *this = s * *this; }
};

template <int N>
using Pack = std::conditional_t<(N > register_doubles), TwoPacks, typename PackOf<N>::type>;

template <int A, int B, int C, int D, int E, int F, int G, int H>
inline TwoPacks select(const TwoPacks& pack) {
  return {
      __builtin_shufflevector(pack.low, pack.high, A, B, C, D),
      __builtin_shufflevector(pack.low, pack.high, E, F, G, H)};
}

/// The listed entries of a pack, in the order of the list.
template <int... Entries>
inline typename PackOf<sizeof...(Entries)>::type select(
    const typename PackOf<sizeof...(Entries)>::type& pack
) {
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
  KOKKOS_INLINE_FUNCTION Pack& operator*=(double s) {
    for (int i = 0; i < N; ++i) value[i] *= s;
    return *this;
  }
};
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator+(Pack<N> a, const Pack<N>& b) {
  return a += b;
}
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator-(Pack<N> a, const Pack<N>& b) {
  for (int i = 0; i < N; ++i) a.value[i] -= b.value[i];
  return a;
}
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator*(double s, Pack<N> a) {
  return a *= s;
}
template <int N>
KOKKOS_INLINE_FUNCTION Pack<N> operator*(Pack<N> a, const Pack<N>& b) {
  for (int i = 0; i < N; ++i) a.value[i] *= b.value[i];
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
