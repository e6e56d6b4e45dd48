// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "grid/patch.hpp"
#include "shape/domain.hpp"
#include "shape/tensor_support.hpp"

namespace barreno {

/// What a domain sees of the grid: linear functions at its 2^D corners, nodes of one cell each.
/// Between the corners a field is interpolated in the domain's own coordinates xi (-1 to 1); with
/// the sums of corner values v_c and their signs
///
///   m_0 = 2^-D sum v_c,   m_i = 2^-D sum xi_ic v_c,   in axisymmetry m_01 = 1/4 sum xi_0c xi_1c
///   v_c
///
/// its means over the domain are
///
///   value     m_0 + sum_i skew_i m_i
///   gradient  sum_i grad xi_i (m_i + skew_(1-i) m_01)
///   hoop      m_0 / r_p
///
/// skew_i = e_i,r / (3 r_p) are the first moments of the weight r over the domain, zero where
/// nothing is weighted with r. Each corner is gathered once; giving to the nodes is the transpose.
template <int D>
struct CornerSupport {
  static constexpr unsigned dimensions = D;
  static constexpr int corners = 1 << D;
  static constexpr unsigned values = corners * D + D * D + 3;
  static constexpr unsigned slots = corners;
  static constexpr double share = 1.0 / corners;

  int slot[extent<corners>] = {};              ///< lowest node of each corner's cell
  double at[extent<corners>][extent<D>] = {};  ///< position in that cell, 0 to 1
  double slope[extent<D>][extent<D>] = {};     ///< grad xi_i [1/length]
  double skew[2] = {};                         ///< axisymmetry only
  double per_radius = 0.0;                     ///< 1 / r_p [1/length]; axisymmetry only

  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_value(F&& f) {
    for (int c = 0; c < corners; ++c) BARRENO_UNROLL
    for (int d = 0; d < D; ++d) f(at[c][d]);
    BARRENO_UNROLL
    for (int i = 0; i < D; ++i) BARRENO_UNROLL
    for (int d = 0; d < D; ++d) f(slope[i][d]);
    f(skew[0]);
    f(skew[1]);
    f(per_radius);
  }
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_slot(F&& f) {
    BARRENO_UNROLL
    for (int c = 0; c < corners; ++c) f(slot[c]);
  }

  /// Sign of xi_i at a corner: bit i of its number.
  KOKKOS_INLINE_FUNCTION static constexpr double sign(int corner, int i) {
    return (corner >> i & 1) != 0 ? 1.0 : -1.0;
  }

  /// visit(slot, weight) for the nodes of one corner's cell.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_corner_nodes(const Patch& sizes, int c, Visitor&& visit) const {
    BARRENO_UNROLL
    for (int k = 0; k < (D == 3 ? 2 : 1); ++k) {
      const double wz = D == 3 ? (k == 0 ? 1.0 - at[c][D - 1] : at[c][D - 1]) : 1.0;
      const int layer = slot[c] + k * sizes.nodes * sizes.nodes;
      BARRENO_UNROLL
      for (int j = 0; j < 2; ++j) {
        const double wy = wz * (j == 0 ? 1.0 - at[c][1] : at[c][1]);
        const double upper = wy * at[c][0];
        visit(layer + j * sizes.nodes, wy - upper);
        visit(layer + j * sizes.nodes + 1, upper);
      }
    }
  }

  /// visit(slot, S, gradient of S, T) for every node of every corner; a node may come more than
  /// once, and its weights are the sums.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_node(const Patch& sizes, Visitor&& visit) const {
    BARRENO_UNROLL
    for (int c = 0; c < corners; ++c) {
      double s = 1.0;
      double g[extent<D>] = {};
      BARRENO_UNROLL
      for (int i = 0; i < D; ++i) {
        if (D == 2) s += sign(c, i) * skew[i];
        double weight = sign(c, i);
        if (D == 2) weight += sign(c, 0) * sign(c, 1) * skew[1 - i];
        BARRENO_UNROLL
        for (int d = 0; d < D; ++d) g[d] += share * slope[i][d] * weight;
      }
      for_corner_nodes(sizes, c, [&](int node, double w) {
        double gradient[extent<D>];
        BARRENO_UNROLL
        for (int d = 0; d < D; ++d) gradient[d] = w * g[d];
        visit(node, w * share * s, gradient, w * share * per_radius);
      });
    }
  }

  /// patch += S a + grad S . b + T t.
  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION void add_to(
      Value* patch, const Patch& sizes, const Value& a, const Value (&b)[extent<D>], const Value& t
  ) const {
    Value m[extent<D>];
    BARRENO_UNROLL
    for (int i = 0; i < D; ++i) {
      m[i] = slope[i][0] * b[0];
      BARRENO_UNROLL
      for (int d = 1; d < D; ++d) m[i] += slope[i][d] * b[d];
      m[i] *= share;
    }
    Value m0 = share * a;
    Value m01{};
    if constexpr (Hoop) {
      m01 = skew[1] * m[0] + skew[0] * m[1];
      BARRENO_UNROLL
      for (int i = 0; i < 2; ++i) m[i] += skew[i] * m0;
      m0 += (share * per_radius) * t;
    }
    BARRENO_UNROLL
    for (int c = 0; c < corners; ++c) {
      Value corner = m0;
      BARRENO_UNROLL
      for (int i = 0; i < D; ++i) corner = (c >> i & 1) != 0 ? corner + m[i] : corner - m[i];
      if constexpr (Hoop) corner = c == 0 || c == 3 ? corner + m01 : corner - m01;
      for_corner_nodes(sizes, c, [&](int node, double w) {
        patch[node] = patch[node] + w * corner;
      });
    }
  }

  template <bool Hoop, class Value>
  KOKKOS_INLINE_FUNCTION Interpolated<Value, dimensions> interpolate(
      const Value* patch, const Patch& sizes
  ) const {
    Value m0{};
    Value m[extent<D>]{};
    Value m01{};
    BARRENO_UNROLL
    for (int c = 0; c < corners; ++c) {
      Value v{};
      for_corner_nodes(sizes, c, [&](int node, double w) { v += w * patch[node]; });
      m0 += v;
      BARRENO_UNROLL
      for (int i = 0; i < D; ++i) m[i] = (c >> i & 1) != 0 ? m[i] + v : m[i] - v;
      if constexpr (Hoop) m01 = c == 0 || c == 3 ? m01 + v : m01 - v;
    }
    Interpolated<Value, dimensions> out;
    out.value = share * m0;
    if constexpr (Hoop) {
      out.hoop = (share * per_radius) * m0;
      out.value += (share * skew[0]) * m[0] + (share * skew[1]) * m[1];
      m[0] += skew[1] * m01;
      m[1] += skew[0] * m01;
    }
    BARRENO_UNROLL
    for (int d = 0; d < D; ++d) {
      out.d[d] = (share * slope[0][d]) * m[0];
      BARRENO_UNROLL
      for (int i = 1; i < D; ++i) out.d[d] += (share * slope[i][d]) * m[i];
    }
    return out;
  }
};

}  // namespace barreno
