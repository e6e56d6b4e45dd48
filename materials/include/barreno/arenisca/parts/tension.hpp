// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/real.hpp"

#include <string>

namespace barreno::arenisca {

/// Bound on the principal tension of rock with damage D: no principal (effective) stress exceeds
///
///   (1 - D) T
///
/// A surface in I1 and J2 alone lets rock that is squeezed along one axis bear far more tension
/// along another than its uniaxial strength. What exceeds the bound opens cracks: plastic strain
/// across them, along the elastic stiffness (W. J. M. Rankine's surface with the associated flow).
/// Opening damages like the plastic strain of parts/damage.hpp, whatever the pressure beside it:
/// a crack takes the fracture energy.
struct Tension {
  struct Parameters {
    double tension_cutoff;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
            &P::tension_cutoff,
            "Tension cutoff",
            d::stress,
            at_least(0.0),
            0.0,
            "T: no principal (effective) stress of rock with damage D exceeds (1 - D) T. 0: no "
            "bound but that of the limit surface, as published"
        )},
        {}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
  static Tension make(const Parameters& p) { return {p.tension_cutoff}; }

  double cutoff = 0.0;  ///< T [stress]; 0: no bound

  /// Whether a state may exceed a bound: no by its invariants, or within round-off of it.
  /// @param room  bound less mean stress [stress]
  /// @param J3    determinant of the deviator; asked for where J2 does not tell
  template <class R, class Determinant>
  BARRENO_FUNCTION static MaskOf<R> may_exceed(
      const MaskOf<R>& asked, const R& room, const R& J2, const Determinant& J3
  ) {
    // The largest principal deviator is at most 2 sqrt(J2/3).
    const MaskOf<R> near = asked & !((room > 0.0) & (J2 * (4.0 / 3.0) < room * room));
    if (!real::any(near)) return near;
    // All principal stresses are below the bound if the coefficients of the characteristic
    // polynomial of (room - s) are positive.
    constexpr double margin = 1e-13;  // beyond round-off
    const R square = room * room;
    const R third = room * (square - J2) - J3();
    return near &
           !((room > 0.0) & (J2 < (3.0 - margin) * square) & (third > margin * room * square));
  }
};

/// Opening of cracks along the principal axes, the largest first.
template <class R>
struct OpeningOf {
  R sum;
  R part[3];

  /// Half the square of the deviator.
  BARRENO_FUNCTION R squares() const {
    const R a = part[0] - part[1], b = part[1] - part[2], c = part[2] - part[0];
    return (a * a + b * b + c * c) * (1.0 / 6.0);
  }
};

/// Opening that brings principal stresses down to a bound f along the elastic stiffness: that of n
/// cracks has
///
///   sum = (sigma_1 + ... + sigma_n - n f)/(2 G + n lambda),
///   part_i = max(sigma_i - f - lambda sum, 0)/(2 G)
///
/// with as many cracks as the stress of the next axis exceeds f - lambda sum.
template <class R>
struct CracksOf {
  R stress[3];            ///< principal stresses that elastic rock would have, the largest first
  R lambda, twice_shear;  ///< moduli

  BARRENO_FUNCTION OpeningOf<R> opening(const R& bound) const {
    const R a = stress[0] - bound, b = stress[1] - bound, c = stress[2] - bound;
    OpeningOf<R> o;
    o.sum = real::larger(R(a / (twice_shear + lambda)), 0.0);
    const MaskOf<R> two = b > lambda * o.sum;
    o.sum = real::select(two, (a + b) / (twice_shear + 2.0 * lambda), o.sum);
    const MaskOf<R> three = two & (c > lambda * o.sum);
    o.sum = real::select(three, (a + b + c) / (twice_shear + 3.0 * lambda), o.sum);
    const R taken = lambda * o.sum;
    o.part[0] = real::larger(R(a - taken), 0.0) / twice_shear;
    o.part[1] = real::larger(R(b - taken), 0.0) / twice_shear;
    o.part[2] = real::larger(R(c - taken), 0.0) / twice_shear;
    return o;
  }
};

/// Principal values and axes of a symmetric tensor.
template <class R>
struct PrincipalOf {
  R value[3];
  R axis[3][3];  ///< axis[k] belongs to value[k]
};

}  // namespace barreno::arenisca
