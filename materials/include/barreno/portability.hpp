// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// BARRENO_FUNCTION marks point functions that run on the host and, when Kokkos is included first,
/// on the device. Without Kokkos it is empty, so the models compile as plain C++17.
#if __has_include(<Kokkos_Macros.hpp>)
#include <Kokkos_Macros.hpp>
#define BARRENO_FUNCTION KOKKOS_INLINE_FUNCTION
#else
#define BARRENO_FUNCTION inline
#endif

/// BARRENO_ALIKE marks those that several callers must get the same bits of: compiled once, so that
/// a compiler does not contract products and sums in another way for each caller.
#if defined(__CUDACC__) || defined(__HIP__)
#define BARRENO_ALIKE BARRENO_FUNCTION
#elif defined(__GNUC__)
#define BARRENO_ALIKE inline __attribute__((noinline))
#else
#define BARRENO_ALIKE inline
#endif

/// BARRENO_ONCE marks long function templates that are compiled once for the forms of the library
/// (arenisca/compiled_once.hpp).
#if defined(__CUDACC__) || defined(__HIP__)
#define BARRENO_ONCE BARRENO_FUNCTION
#elif defined(__GNUC__)
#define BARRENO_ONCE __attribute__((noinline))
#else
#define BARRENO_ONCE
#endif

/// BARRENO_INLINED marks a short point function that must stand within its callers: tensors of
/// lanes that go through a call leave their registers.
#if defined(__CUDACC__) || defined(__HIP__) || !defined(__GNUC__)
#define BARRENO_INLINED BARRENO_FUNCTION
#else
#define BARRENO_INLINED __attribute__((always_inline)) BARRENO_FUNCTION
#endif

/// BARRENO_FLAT marks a long point function whose parts must stand within it: points in lanes that
/// go through a call leave all of their registers in memory.
#if defined(__CUDACC__) || defined(__HIP__) || !defined(__GNUC__)
#define BARRENO_FLAT BARRENO_FUNCTION
#else
#define BARRENO_FLAT __attribute__((flatten)) BARRENO_FUNCTION
#endif
