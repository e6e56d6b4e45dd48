// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points.hpp"

namespace barreno::arenisca {

// Rock of which every piece has a strength of its own (weibull.hpp): the limit surface is that of
// PEAKI1 times the piece's coherence, all else is the card's.

/// YieldSurface of several pieces. CR, the slope at the vertex and whether the surface is straight
/// are the same for all of them.
template <class R>
struct SurfaceOf {
  R a1{}, a2{}, a3{}, a4{};
  R peak{}, vertex{};  ///< [stress]
  R steepest{};
  double CR = 0.0;
  bool straight = true;

  BARRENO_FUNCTION bool linear() const { return straight; }
};

/// make_yield_surface() of several peaks.
template <class R>
BARRENO_FUNCTION SurfaceOf<R> make_surfaces(
    const R& peak, double FSLOPE, double STREN, double YSLOPE, double CR
) {
  SurfaceOf<R> s;
  s.peak = s.vertex = peak;
  s.CR = CR;
  s.steepest = R{} + FSLOPE;
  s.straight = STREN == 0.0 || FSLOPE == 0.0;
  if (STREN == 0.0) {
    s.a1 = peak * FSLOPE;
    s.a4 = R{} + FSLOPE;
  } else if (FSLOPE == 0.0) {
    s.a1 = R{} + STREN;
    s.vertex = R{} + std::numeric_limits<double>::infinity();
  } else {
    const R room = STREN - YSLOPE * peak;
    s.a1 = R{} + STREN;
    s.a2 = (FSLOPE - YSLOPE) / room;
    s.a3 = room * real::exp(R(-s.a2 * peak));
    s.a4 = R{} + YSLOPE;
  }
  return s;
}

/// Dry or wet rock whose pieces differ; which surface a point has is known with its coherence.
template <class Whole>
struct ScatteredRock : Whole {
  using Base = Whole;
  static constexpr bool scattered = true;

  double PEAKI1 = 0.0, FSLOPE = 0.0, STREN = 0.0, YSLOPE = 0.0;
};

/// The rock of several pieces.
template <class R, class Whole>
struct PiecesOf : Whole {
  SurfaceOf<R> surface;  ///< instead of that of the whole
  CapOf<R> first_cap;

  BARRENO_FUNCTION PiecesOf(const ScatteredRock<Whole>& rock, const R& coherence)
      : Whole(static_cast<const Whole&>(rock)),
        surface(make_surfaces(
            R(rock.PEAKI1 * coherence), rock.FSLOPE, rock.STREN, rock.YSLOPE, rock.surface.CR
        )),
        first_cap(cap_of(*this, R{})) {}
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
template <class R, class Law, class Holder>
BARRENO_FUNCTION decltype(auto) rock_of(const Law& law, const Holder& holder) {
  if constexpr (Law::scattered)
    return RockOf<R, Law>(law, holder.coherence);
  else
    return (law);
}

/// What a step keeps of points whose strength is their own.
template <class R, bool scattered>
struct WithCoherence {};
template <class R>
struct WithCoherence<R, true> {
  R coherence = R{} + 1.0;
};

}  // namespace barreno::arenisca
