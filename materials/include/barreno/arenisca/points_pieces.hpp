// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/rock.hpp"

namespace barreno::arenisca {

// Rock of which every piece has a strength of its own (parts/scatter.hpp): the limit surface is
// that of PEAKI1 times the piece's coherence, all else is the card's.

/// Dry or wet rock whose pieces differ; which surface a point has is known with its coherence.
template <class Whole>
struct ScatteredRock : Whole {
  using Base = Whole;
  static constexpr bool scattered = true;

  using Limit = typename Whole::Parts::ShearLimit;
  typename Limit::Parameters strength{};  ///< of pieces of coherence 1
  SurfaceOf<double, Limit> mean;          ///< theirs, to the bits that lanes have
  Cap mean_first_cap;
};

/// The surface of pieces.
template <class R, class Whole>
BARRENO_ALIKE auto surface_of_pieces(const ScatteredRock<Whole>& rock, const R& coherence) {
  using Limit = typename Whole::Parts::ShearLimit;
  const R peak = Limit::peak(rock.strength) * coherence;
  return make_surface<Limit>(rock.strength, peak, rock.surface.CR);
}

/// The rock of several pieces.
template <class R, class Whole>
struct PiecesOf : Whole {
  SurfaceOf<R, typename Whole::Parts::ShearLimit> surface;  ///< instead of that of the whole
  CapOf<R> first_cap;

  BARRENO_FUNCTION PiecesOf(const ScatteredRock<Whole>& rock, const R& coherence)
      : Whole(static_cast<const Whole&>(rock)) {
    // Rock that does not scatter, but has a feature whose form scatters too.
    if (!real::any(coherence != 1.0)) {
      surface = same_surface<R>(rock.mean);
      first_cap = same_cap<R>(rock.mean_first_cap);
      return;
    }
    surface = surface_of_pieces(rock, coherence);
    first_cap = cap_of(*this, R{});
  }
};

/// The rock that the parts of a substep are given: the law itself, or its pieces.
template <class R, class Law>
struct RockFor {
  using type = Law;
};
template <class R, class Whole>
struct RockFor<R, ScatteredRock<Whole>> {
  using type = PiecesOf<R, Whole>;
};
template <class R, class Law>
using RockOf = typename RockFor<R, Law>::type;

/// @param holder of the points' coherence: a history or a step
/// @param damage of the points, that of the holder or another
template <class R, class Law, class Holder>
BARRENO_FUNCTION RockOf<R, Law> rock_with_damage(
    const Law& law, const Holder& holder, const R& damage
) {
  if constexpr (Law::heated)
    return RockOf<R, Law>(law, holder.coherence, damage, law.heat.softened(holder.temperature));
  else
    return RockOf<R, Law>(law, holder.coherence, damage);
}
/// @param holder of the points' coherence: a history or a step
template <class R, class Law, class Holder>
BARRENO_FUNCTION decltype(auto) rock_of(const Law& law, const Holder& holder) {
  if constexpr (Law::about_centre)
    return RockOf<R, Law>(law, holder.coherence, holder.fluid_mass_ratio);
  else if constexpr (Law::damaged)
    return rock_with_damage<R>(law, holder, holder.damage);
  else if constexpr (Law::scattered)
    return RockOf<R, Law>(law, holder.coherence);
  else
    return (law);
}

/// What a cap depends on.
template <class Crush, class Surface>
struct CrushedSurface {
  const Crush& crush;
  Surface surface;
};
/// What the surface of a piece is made of.
template <class Whole>
void set_strength(
    const typename Whole::Parts::ShearLimit::Parameters& p, ScatteredRock<Whole>& rock
) {
  using Limit = typename Whole::Parts::ShearLimit;
  rock.strength = p;
  // By the arithmetic of lanes, so that a point's bits do not depend on the others with it.
  const auto mean = surface_of_pieces(rock, Lanes{} + 1.0);
  rock.mean = rock.surface;
  static_cast<typename Limit::template Of<double>&>(rock.mean) = Limit::lane(mean, 0);
  const CrushedSurface<decltype(rock.crush), decltype(mean)> crushed = {rock.crush, mean};
  const CapOf<Lanes> cap = cap_of(crushed, Lanes{});
  rock.mean_first_cap = {cap.present[0] != 0, cap.X[0], cap.kappa[0], cap.slope[0]};
}

/// What a step keeps of points whose strength, or whose mass of fluid, is their own.
template <class R, bool scattered, bool about_centre>
struct OfPieces {};
template <class R>
struct OfPieces<R, true, false> {
  R coherence = R{} + 1.0;
};
template <class R>
struct OfPieces<R, true, true> {
  R coherence = R{} + 1.0, fluid_mass_ratio = R{} + 1.0;
};

}  // namespace barreno::arenisca
