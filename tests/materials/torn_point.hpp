// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

/// The bound on principal tension (docs/method.md 22) written anew, for the tests of it.
namespace barreno::test {

/// Principal values by the angle of the deviator, in long double: the largest first.
inline std::array<long double, 3> principal_values(const Sym3& stress) {
  using Real = long double;
  const Real mean = (Real(stress.xx) + stress.yy + stress.zz) / 3;
  const Real xx = stress.xx - mean, yy = stress.yy - mean, zz = stress.zz - mean;
  const Real xy = stress.xy, yz = stress.yz, zx = stress.zx;
  const Real J2 = (xx * xx + yy * yy + zz * zz) / 2 + xy * xy + yz * yz + zx * zx;
  if (J2 == 0) return {mean, mean, mean};
  const Real J3 = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  const Real r = std::sqrt(J2 / 3);
  const Real cosine = std::clamp<Real>(J3 / (2 * r * r * r), -1, 1);
  const Real angle = std::acos(cosine) / 3, turn = 2 * std::acos(Real(-1)) / 3;
  std::array<Real, 3> t{
      mean + 2 * r * std::cos(angle),
      mean + 2 * r * std::cos(angle - turn),
      mean + 2 * r * std::cos(angle + turn)};
  std::sort(t.begin(), t.end(), std::greater<>());
  return t;
}

/// Whether a principal stress exceeds a limit, by the pivots of (limit I - stress): roots of the
/// polynomial lose half of the digits where two are equal.
inline bool exceeds(const Sym3& stress, double limit) {
  using Real = long double;
  const Real a = limit - Real(stress.xx);
  if (a < 0) return true;
  if (a == 0) return stress.xy != 0.0 || stress.zx != 0.0;
  const Real xy = -Real(stress.xy) / a, zx = -Real(stress.zx) / a;
  const Real b = limit - Real(stress.yy) - a * xy * xy;
  const Real yz = -Real(stress.yz) - a * xy * zx;
  if (b < 0) return true;
  const Real c = limit - Real(stress.zz) - a * zx * zx;
  return b == 0 ? yz != 0 || c < 0 : c - yz * yz / b < 0;
}

/// The law of the bound written anew for elastic rock of constant moduli: principal values from the
/// characteristic polynomial, axes from Sylvester's formula, cracks by trying all sets of them,
/// damage by halving.
class BrittlePoint {
public:
  using Real = long double;
  explicit BrittlePoint(const Arenisca::Parameters& p) : p_(p) {}

  std::array<std::array<Real, 3>, 3> stress{};
  Real damage = 0, opened = 0, sheared = 0, plastic_work = 0;

  void strain(const Sym3& by) {
    const Real mean = (Real(by.xx) + by.yy + by.zz) / 3;
    const Real e[3][3] = {{by.xx, by.xy, by.zx}, {by.xy, by.yy, by.yz}, {by.zx, by.yz, by.zz}};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Real unit = i == j ? 1 : 0;
        stress[i][j] += 2 * p_.G0 * (e[i][j] - unit * mean) + 3 * p_.B0 * unit * mean;
      }
    }
    const auto t = principal_values(tensor());
    const Real bound = (1 - damage) * p_.tension_cutoff;
    if (t[0] <= bound) return;
    const Real begin = damage;
    Real low = begin, high = 1;
    for (int i = 0; i < 200; ++i) {
      const Real middle = (low + high) / 2;
      (begin + grown(openings(t, middle)) > middle ? low : high) = middle;
    }
    damage = high;
    const auto parts = openings(t, damage);
    const Real sum = parts[0] + parts[1] + parts[2];
    take(t, parts, sum);
    opened += sum;
    sheared += std::sqrt(Real(2) / 3 * squares(parts));
    plastic_work += (bound + (1 - damage) * p_.tension_cutoff) / 2 * sum;
  }
  Sym3 tensor() const {
    const auto at = [this](int i, int j) { return static_cast<double>(stress[i][j]); };
    return {at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(1, 2), at(0, 2)};
  }

private:
  using Three = std::array<Real, 3>;

  /// Square of the deviator.
  static Real squares(const Three& e) {
    const Real mean = (e[0] + e[1] + e[2]) / 3;
    Real sum = 0;
    for (const Real part : e) sum += (part - mean) * (part - mean);
    return sum;
  }
  Real grown(const Three& e) const {
    const Real strain = std::sqrt(Real(2) / 3 * squares(e)) + (e[0] + e[1] + e[2]) / 3;
    return strain / p_.fracture_strain;
  }
  /// The set of cracks whose openings are positive and that leaves no other stress above the bound.
  Three openings(const Three& t, Real at) const {
    const Real bound = (1 - at) * p_.tension_cutoff, shear = 2 * p_.G0;
    const Real lambda = p_.B0 - shear / 3, slack = 1e-9L;
    Three found{};
    for (int set = 0; set < 8; ++set) {
      int count = 0;
      Real excess = 0;
      for (int i = 0; i < 3; ++i)
        if ((set >> i & 1) != 0) ++count, excess += t[i] - bound;
      const Real sum = excess / (shear + count * lambda);
      Three parts{};
      bool good = true;
      for (int i = 0; i < 3; ++i) {
        const Real over = t[i] - lambda * sum - bound;
        const bool cracks = (set >> i & 1) != 0;
        if (cracks) parts[i] = over / shear;
        good = good && (cracks ? over >= -slack : over <= slack);
      }
      if (good) found = parts;
    }
    return found;
  }
  void take(const Three& t, const Three& parts, Real sum) {
    const Real shear = 2 * p_.G0, lambda = p_.B0 - shear / 3;
    const auto trial = stress;
    for (int k = 0; k < 3; ++k) {
      const Real a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          Real product = 0;
          for (int m = 0; m < 3; ++m)
            product += (trial[i][m] - (i == m ? a : 0)) * (trial[m][j] - (m == j ? b : 0));
          stress[i][j] -= shear * parts[k] * product / ((t[k] - a) * (t[k] - b));
        }
      }
    }
    for (int i = 0; i < 3; ++i) stress[i][i] -= lambda * sum;
  }

  Arenisca::Parameters p_;
};

}  // namespace barreno::test
