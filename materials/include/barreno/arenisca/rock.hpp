// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/constituents.hpp"
#include "barreno/arenisca/parts/list.hpp"
#include "barreno/arenisca/yield_surface.hpp"
#include "barreno/real.hpp"

namespace barreno::arenisca {

/// Cap at a plastic volume strain, of one point or several.
/// @param rock  with `crush` and `surface`
template <class R, class Law>
BARRENO_FUNCTION CapOf<R> cap_of(const Law& rock, const R& evp) {
  CapOf<R> cap{none_of<R>()};
  if (!rock.crush.porous()) return cap;
  const CrushedOf<R> crushed = rock.crush.at(evp);
  cap.present = crushed.open;
  cap.X = crushed.X;
  cap.slope = crushed.slope;
  cap.kappa = branch_point(rock.surface, cap.X);
  return cap;
}

/// Everything about the material that a point update reads.
/// @param Parts_  which parts it is made of (parts/list.hpp)
template <class Parts_>
struct DryRock {
  using Parts = Parts_;
  static constexpr bool wet = false;           ///< no pore fluid
  static constexpr bool scattered = false;     ///< every piece has the same strength
  static constexpr bool angled = false;        ///< no dependence on the third invariant
  static constexpr bool rated = false;         ///< no overstress
  static constexpr bool about_centre = false;  ///< I1 is not counted from an elastic centre
  static constexpr bool damaged = false;       ///< its strength does not fall
  static constexpr bool heated = false;        ///< no heat

  Elasticity elasticity;
  SurfaceOf<double, typename Parts::ShearLimit> surface;
  typename Parts::CrushCurve crush;
  typename Parts::FlowRule flow;
  Cap first_cap;            ///< cap of the virgin rock; compaction only widens it
  double tolerance;         ///< relative local error of a substep
  double stress_floor;      ///< below this the local error is measured against it [stress]
  bool bisection;           ///< the paper's return instead of the fast one
  double resolution = 0.0;  ///< of the bisections; 0: the last bit. Benchmarks set it
  /// Compacted by less than this, rock counts as at the jump of its moduli: the stress that such a
  /// strain is worth is a hundredth of the smallest allowed error.
  double jump_width = Elasticity::at_jump;

  BARRENO_FUNCTION Cap cap_at(double evp) const { return cap_of(*this, evp); }
};
using Rock = DryRock<PublishedParts>;

/// Not dilated, and compacted by nothing that counts (DryRock::jump_width): flow that dilates
/// crosses the jump of the moduli where it begins.
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> is_at_jump(const Law& rock, const R& evp) {
  return (evp >= -rock.jump_width) & !rock.elasticity.dilated(evp);
}

/// Rock with fluid in its pores: the dry rock for the effective stress, and what fills the rest.
template <class Parts_>
struct SaturatedRock : DryRock<Parts_> {
  static constexpr bool wet = true;

  Constituents constituents;
  double initial_pressure = 0.0;  ///< of the fluid in virgin rock [stress]
  double porosity = 0.0;          ///< of virgin rock
};
using WetRock = SaturatedRock<PublishedParts>;

/// Size of a stress: sqrt(sigma : sigma).
template <class R>
BARRENO_FUNCTION R size_of_stress(const R& x, const R& J2) {
  return real::sqrt(R(x * x * (1.0 / 3.0) + 2.0 * J2));
}

}  // namespace barreno::arenisca
