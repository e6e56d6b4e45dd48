// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/breakage.hpp"
#include "barreno/arenisca/parts/damage.hpp"
#include "barreno/arenisca/parts/tension.hpp"
#include "barreno/arenisca/points_pieces.hpp"

namespace barreno::arenisca {

// Rock that loses cohesion (parts/damage.hpp), of one or several points: a piece has the limit
// surface of its damage. Its grains can break (parts/breakage.hpp), which changes no stress.

/// Dry or wet rock whose pieces can have a strength of their own and lose it.
template <class Whole>
struct DamagedRock : ScatteredRock<Whole> {
  static constexpr bool damaged = true;

  Damage damage;
  Tension tension;
  Breakage breakage;
};

/// The surface of its pieces, the same to the last bit for every caller.
template <class R, class Whole>
BARRENO_ALIKE auto surface_of_damage(
    const DamagedRock<Whole>& rock, const R& coherence, const R& intact
) {
  using Limit = typename Whole::Parts::ShearLimit;
  const R peak = Limit::peak(rock.strength) * coherence * intact;
  const R slope = rock.damage.slope + rock.damage.loss * intact;
  SurfaceOf<R, Limit> surface;
  static_cast<typename Limit::template Of<R>&>(surface) = Limit::make(rock.strength, peak, slope);
  surface.CR = rock.surface.CR;
  return surface;
}

/// What the surface of whole rock is made of, to the bits that damaged pieces would have.
/// @param[in,out] rock  with its damage, after set_strength()
template <class Whole>
void set_damage(DamagedRock<Whole>& rock) {
  using Limit = typename Whole::Parts::ShearLimit;
  const Lanes one = Lanes{} + 1.0;
  const auto mean = surface_of_damage(rock, one, one);
  static_cast<typename Limit::template Of<double>&>(rock.mean) = Limit::lane(mean, 0);
  rock.mean_first_cap.kappa = branch_point(rock.mean, rock.mean_first_cap.X);
}

/// Its pieces.
template <class R, class Whole>
struct DamagedPiecesOf : Whole {
  SurfaceOf<R, typename Whole::Parts::ShearLimit> surface;  ///< instead of that of the whole
  CapOf<R> first_cap;
  R intact;  ///< 1 - D
  Breakage breakage;

  BARRENO_FUNCTION DamagedPiecesOf(
      const DamagedRock<Whole>& rock, const R& coherence, const R& damage
  )
      : Whole(static_cast<const Whole&>(rock)), intact(1.0 - damage), breakage(rock.breakage) {
    if (!real::any((coherence != 1.0) | (damage != 0.0))) {
      surface = same_surface<R>(rock.mean);
      first_cap = same_cap<R>(rock.mean_first_cap);
      return;
    }
    surface = surface_of_damage(rock, coherence, intact);
    // X of virgin rock does not depend on its strength.
    first_cap = same_cap<R>(rock.mean_first_cap);
    first_cap.kappa = branch_point(surface, first_cap.X);
  }
};
template <class R, class Whole>
struct RockFor<R, DamagedRock<Whole>> {
  using type = DamagedPiecesOf<R, Whole>;
};

/// What a step keeps of points that are damaged.
template <class R, bool damaged>
struct DamageOfStep {};
template <class R>
struct DamageOfStep<R, true> {
  R damage{}, fracture_strain = R{} + 1.0;
  Sym3Of<R> strain{};  ///< deviator that the law is given: without the opening of cracks
  R breaking_work{};   ///< of the substeps so far (parts/breakage.hpp) [stress]
};

/// What an attempt tells of rock whose grains can break.
template <class R, bool damaged>
struct WithBreaking {};
template <class R>
struct WithBreaking<R, true> {
  R breaking_work{};
};
template <class Law, class Mask, class From, class To>
BARRENO_FUNCTION void assign_breaking(const Mask& choice, const From& from, To& to) {
  if constexpr (Law::damaged)
    to.breaking_work = real::select(choice, from.breaking_work, to.breaking_work);
}

}  // namespace barreno::arenisca
