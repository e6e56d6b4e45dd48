// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/axis_weights.hpp"

namespace barreno {

/// What the nodes say to a particle: sums over its support of S v, grad S v and T v.
template <class Value, unsigned D>
struct Interpolated {
  Value value{}, d[D]{}, hoop{};
};

/// Nodes and weights of a shape function that is a product of one function along each of D axes,
/// with N nodes along each; in two dimensions
///
///   S = s_i s_j,   dS/dx = g_i s_j,   dS/dy = s_i g_j,   T = t_i s_j
///
/// Sums over the nodes use the product form: two multiplications per node instead of eight.
template <unsigned D, unsigned N>
struct TensorSupport;

template <unsigned N>
struct TensorSupport<2, N> {
  static constexpr int n = N;
  static constexpr unsigned values = 5 * N;
  static constexpr unsigned slots = 1;

  int first = 0;   ///< slot of the lowest node in the patch
  double sx[N]{};  ///< averages of N along x
  double gx[N]{};  ///< averages of dN/dx [1/length]
  double tx[N]{};  ///< hoop weights; axisymmetry only [1/length]
  double sy[N]{}, gy[N]{};

  /// f(weight) for every weight, in the order in which batches store them.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_value(F&& f) {
    for (int i = 0; i < n; ++i) {
      f(sx[i]);
      f(gx[i]);
      f(tx[i]);
      f(sy[i]);
      f(gy[i]);
    }
  }

  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_slot(F&& f) {
    f(first);
  }

  /// visit(slot, S, gradient of S, T) for every node of the support.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_node(const Patch& sizes, Visitor&& visit) const {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double gradient[2] = {gx[i] * sy[j], sx[i] * gy[j]};
        visit(first + j * sizes.nodes + i, sx[i] * sy[j], gradient, tx[i] * sy[j]);
      }
  }

  /// patch += S a + dS/dx b[0] + dS/dy b[1] + T d.
  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION void add_to(
      Value* patch, const Patch& sizes, const Value& a, const Value (&b)[2], const Value& d
  ) const {
    Value along_x[N];
    for (int i = 0; i < n; ++i) along_x[i] = Hoop ? gx[i] * b[0] + tx[i] * d : gx[i] * b[0];
    for (int j = 0; j < n; ++j) {
      const Value along_y = sy[j] * a + gy[j] * b[1];
      Value* const row = patch + first + j * sizes.nodes;
      for (int i = 0; i < n; ++i) row[i] = row[i] + sx[i] * along_y + sy[j] * along_x[i];
    }
  }

  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION Interpolated<Value, 2> interpolate(const Value* patch, const Patch& sizes)
      const {
    Interpolated<Value, 2> out;
    for (int i = 0; i < n; ++i) {
      Value mean{};
      Value slope{};
      for (int j = 0; j < n; ++j) {
        const Value& node = patch[first + j * sizes.nodes + i];
        mean += sy[j] * node;
        slope += gy[j] * node;
      }
      out.value += sx[i] * mean;
      out.d[0] += gx[i] * mean;
      out.d[1] += sx[i] * slope;
      if constexpr (Hoop) out.hoop += tx[i] * mean;
    }
    return out;
  }
};

/// In three dimensions S = s_i s_j s_k, dS/dx = g_i s_j s_k and so on; there is no hoop direction.
template <unsigned N>
struct TensorSupport<3, N> {
  static constexpr int n = N;
  static constexpr unsigned values = 6 * N;
  static constexpr unsigned slots = 1;

  int first = 0;
  double sx[N]{}, gx[N]{};
  double sy[N]{}, gy[N]{};
  double sz[N]{}, gz[N]{};

  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_value(F&& f) {
    for (int i = 0; i < n; ++i) {
      f(sx[i]);
      f(gx[i]);
      f(sy[i]);
      f(gy[i]);
      f(sz[i]);
      f(gz[i]);
    }
  }

  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_slot(F&& f) {
    f(first);
  }

  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_node(const Patch& sizes, Visitor&& visit) const {
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const double gradient[3] = {
              gx[i] * sy[j] * sz[k], sx[i] * gy[j] * sz[k], sx[i] * sy[j] * gz[k]};
          visit(
              first + (k * sizes.nodes + j) * sizes.nodes + i, sx[i] * sy[j] * sz[k], gradient, 0.0
          );
        }
  }

  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION void add_to(
      Value* patch, const Patch& sizes, const Value& a, const Value (&b)[3], const Value& /*d*/
  ) const {
    static_assert(!Hoop, "only the axisymmetric mode has a hoop direction");
    for (int k = 0; k < n; ++k) {
      const Value in_plane = sz[k] * a + gz[k] * b[2];
      const Value slope_y = sz[k] * b[1];
      const Value slope_x = sz[k] * b[0];
      Value* const plane = patch + first + k * sizes.nodes * sizes.nodes;
      for (int j = 0; j < n; ++j) {
        const Value in_row = sy[j] * in_plane + gy[j] * slope_y;
        const Value slope = sy[j] * slope_x;
        Value* const row = plane + j * sizes.nodes;
        for (int i = 0; i < n; ++i) row[i] = row[i] + sx[i] * in_row + gx[i] * slope;
      }
    }
  }

  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION Interpolated<Value, 3> interpolate(const Value* patch, const Patch& sizes)
      const {
    static_assert(!Hoop, "only the axisymmetric mode has a hoop direction");
    Interpolated<Value, 3> out;
    for (int k = 0; k < n; ++k) {
      Value mean{};  // of the plane, and its slopes along x and y
      Value slope_x{};
      Value slope_y{};
      const Value* const plane = patch + first + k * sizes.nodes * sizes.nodes;
      for (int j = 0; j < n; ++j) {
        Value in_row{};
        Value slope{};
        const Value* const row = plane + j * sizes.nodes;
        for (int i = 0; i < n; ++i) {
          in_row += sx[i] * row[i];
          slope += gx[i] * row[i];
        }
        mean += sy[j] * in_row;
        slope_x += sy[j] * slope;
        slope_y += gy[j] * in_row;
      }
      out.value += sz[k] * mean;
      out.d[0] += sz[k] * slope_x;
      out.d[1] += sz[k] * slope_y;
      out.d[2] += gz[k] * mean;
    }
    return out;
  }
};

/// The product of weights along each axis; `row` slots lie between rows of the patch.
template <unsigned N>
KOKKOS_INLINE_FUNCTION TensorSupport<2, N> tensor_product(const AxisWeights<N> (&w)[2], int row) {
  TensorSupport<2, N> out;
  out.first = w[1].first * row + w[0].first;
  for (int i = 0; i < out.n; ++i) {
    out.sx[i] = w[0].s[i];
    out.gx[i] = w[0].g[i];
    out.tx[i] = w[0].t[i];
    out.sy[i] = w[1].s[i];
    out.gy[i] = w[1].g[i];
  }
  return out;
}
template <unsigned N>
KOKKOS_INLINE_FUNCTION TensorSupport<3, N> tensor_product(const AxisWeights<N> (&w)[3], int row) {
  TensorSupport<3, N> out;
  out.first = (w[2].first * row + w[1].first) * row + w[0].first;
  for (int i = 0; i < out.n; ++i) {
    out.sx[i] = w[0].s[i];
    out.gx[i] = w[0].g[i];
    out.sy[i] = w[1].s[i];
    out.gy[i] = w[1].g[i];
    out.sz[i] = w[2].s[i];
    out.gz[i] = w[2].g[i];
  }
  return out;
}

}  // namespace barreno
