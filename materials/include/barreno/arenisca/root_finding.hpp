// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Inline minimum and maximum; std::fmin and std::fmax are library calls for the sake of NaN.
BARRENO_FUNCTION double smaller(double a, double b) {
  return a < b ? a : b;
}
BARRENO_FUNCTION double larger(double a, double b) {
  return a > b ? a : b;
}

/// End of a bracket: argument and function value.
struct BracketEnd {
  double x, f;
};

/// Root of f in a bracket whose ends differ in sign: Chandrupatla's method (Adv. Eng. Software 28,
/// 1997, 145-149), inverse quadratic interpolation where it is safe and bisection where not.
/// @param tolerance absolute, on the argument; the best point seen is returned
/// @param small     a function value that counts as zero
template <class Function>
BARRENO_FUNCTION double find_root(
    Function& f, BracketEnd a, BracketEnd b, double tolerance, double small
) {
  constexpr double round_off = 2.3e-16;
  constexpr int max_iterations = 120;  // bisection alone needs 60 to exhaust a double
  BracketEnd c = a;
  double t = a.f / (a.f - b.f);  // start by the secant
  for (int i = 0; i < max_iterations; ++i) {
    const double x = a.x + t * (b.x - a.x);
    const BracketEnd next{x, f(x)};
    if ((next.f > 0.0) == (a.f > 0.0)) {
      c = a;
    } else {
      c = b;
      b = a;
    }
    a = next;
    const BracketEnd& best = std::fabs(a.f) < std::fabs(b.f) ? a : b;
    const double half_width = 2.0 * round_off * std::fabs(best.x) + 0.5 * tolerance;
    const double limit = half_width / std::fabs(b.x - a.x);
    if (std::fabs(best.f) <= small || !(limit < 0.5)) return best.x;
    const double xi = (a.x - b.x) / (c.x - b.x);
    const double phi = (a.f - b.f) / (c.f - b.f);
    t = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      t = a.f / (b.f - a.f) * c.f / (b.f - c.f) +
          (c.x - a.x) / (b.x - a.x) * a.f / (c.f - a.f) * b.f / (c.f - b.f);
    }
    t = smaller(larger(t, limit), 1.0 - limit);
  }
  return a.x;
}

/// Root by bisection to the last bit of the argument; f < 0 at `below`, f > 0 at `above`.
template <class Function>
BARRENO_FUNCTION double bisect(Function& f, double below, double above, double tolerance) {
  constexpr int max_iterations = 200;
  for (int i = 0; i < max_iterations; ++i) {
    const double middle = 0.5 * (below + above);
    if (middle == below || middle == above || std::fabs(above - below) <= tolerance) break;
    (f(middle) < 0.0 ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

}  // namespace barreno::arenisca
