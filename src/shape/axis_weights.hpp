// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <cmath>

namespace barreno {

/// Weights of N nodes along one axis, from node `first` on.
template <unsigned N>
struct AxisWeights {
  static constexpr int n = N;
  int first = 0;
  double s[N]{};  ///< of the value
  double g[N]{};  ///< of the derivative [1/length]
  double t[N]{};  ///< of the hoop strain; radial axis only [1/length]
};

/// Integrals of linear hat functions over the interval [a, b], divided by its size: the averages
///
///   s_i = <N_i>,   g_i = <dN_i/dx>,   and on a radial axis   t_i = int N_i dr / int r dr
///
/// with <f> = int f r dr / int r dr there, else int f dx / (b - a). Exact for every interval inside
/// the N nodes. Lengths in cells; `axis` is the radius of node 0.
///
/// @pre 0 <= first, first <= a < b <= first + N - 1
template <bool Radial, unsigned N>
KOKKOS_INLINE_FUNCTION AxisWeights<N> average_hats(
    double a, double b, int first, double axis, double per_cell
) {
  AxisWeights<N> out;
  out.first = first;
  double size = 0.0;
  for (int k = 0; k + 1 < out.n; ++k) {
    // The part [from, to] of the interval in cell k; selections, because fmin does not vectorise.
    const double node = first + k;
    const double from = a > node ? a : node;
    const double to = b < node + 1.0 ? b : node + 1.0;
    const double w = to > from ? to - from : 0.0;
    const double m = 0.5 * ((from - node) + (to - node));
    // Not 1 - m, nor the rest of the sum: of a part that just touches the cell little would be left
    // but round-off, and a node with a force and no mass.
    const double l = 0.5 * ((node + 1.0 - from) + (node + 1.0 - to));
    const double r = Radial ? axis + node + m : 1.0;
    const double curved = Radial ? w * w * w / 12.0 : 0.0;
    size += w * r;
    out.s[k] += w * l * r - curved;
    out.s[k + 1] += w * m * r + curved;
    out.g[k] -= w * r;
    out.g[k + 1] += w * r;
    if constexpr (Radial) {
      out.t[k] += w * l;
      out.t[k + 1] += w * m;
    }
  }
  const double inverse = 1.0 / size;
  for (int i = 0; i < out.n; ++i) {
    out.s[i] *= inverse;
    out.g[i] *= inverse * per_cell;
    if constexpr (Radial) out.t[i] *= inverse * per_cell;
  }
  return out;
}

/// B-splines of degree 1, 2 or 3 at a point: s_i = N_i(x), g_i = N_i'(x), t_i = N_i / r. The nodes
/// 0 ... of the grid end at `low` and `high`; the node that a quadratic or cubic spline would want
/// beyond an end is extrapolated from the last two,
///
///   v_-1 = 2 v_0 - v_1,   so   N_0 += 2 N_-1,   N_1 -= N_-1,
///
/// which keeps sum N = 1 and sum x_i N_i = x up to the end, N >= 0, and gives the end node its own
/// value there (the spline's second derivative is zero at the end, or over the last half cell).
///
/// Source: M. Steffen, R. Kirby, M. Berzins, IJNME 76 (2008) 922-948, whose boundary functions
/// these are.
template <bool Radial, unsigned Degree>
KOKKOS_INLINE_FUNCTION AxisWeights<Degree + 1> spline_weights(
    double x, double low, double high, double axis, double per_cell
) {
  static_assert(Degree >= 1 && Degree <= 3, "linear, quadratic and cubic splines");
  AxisWeights<Degree + 1> out;
  constexpr int n = Degree + 1;
  double(&s)[Degree + 1] = out.s;
  double(&g)[Degree + 1] = out.g;
  // The knots are the nodes, for even degrees the centres of the cells.
  const double shift = Degree == 2 ? 0.5 : 0.0;
  const double knot = std::floor(x - shift);
  const double first = Degree == 3 ? knot - 1.0 : knot;
  const double u = x - shift - knot;
  const double v = 1.0 - u;
  if constexpr (Degree == 1) {
    s[0] = v;
    s[1] = u;
    g[0] = -1.0;
    g[1] = 1.0;
  } else if constexpr (Degree == 2) {
    s[0] = 0.5 * v * v;
    s[1] = 0.5 + u * v;
    s[2] = 0.5 * u * u;
    g[0] = -v;
    g[1] = v - u;
    g[2] = u;
  } else {
    s[0] = v * v * v / 6.0;
    s[1] = 2.0 / 3.0 - u * u * (1.0 - 0.5 * u);
    s[2] = 2.0 / 3.0 - v * v * (1.0 - 0.5 * v);
    s[3] = u * u * u / 6.0;
    g[0] = -0.5 * v * v;
    g[1] = u * (1.5 * u - 2.0);
    g[2] = -v * (1.5 * v - 2.0);
    g[3] = 0.5 * u * u;
  }
  if constexpr (Degree > 1) {
    const double below = first < low ? 1.0 : 0.0;
    const double above = first + (n - 1) > high ? 1.0 : 0.0;
    for (double* const w : {s, g}) {
      const double before = below * w[0];
      const double after = above * w[n - 1];
      w[0] -= before;
      w[1] += 2.0 * before;
      w[2] -= before;
      w[n - 1] -= after;
      w[n - 2] += 2.0 * after;
      w[n - 3] -= after;
    }
  }
  out.first = static_cast<int>(first);
  const double hoop = per_cell / (axis + x);
  for (int i = 0; i < n; ++i) {
    g[i] *= per_cell;
    if constexpr (Radial) out.t[i] = s[i] * hoop;
  }
  return out;
}

}  // namespace barreno
