// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/heat.hpp"
#include "barreno/arenisca/points_damage.hpp"
#include "barreno/outcome.hpp"

namespace barreno::arenisca {

// Rock that heats (parts/heat.hpp), of one or several points.

/// Dry or wet rock with heat, and with damage where a card asks for it.
template <class Whole>
struct HeatedRock : DamagedRock<Whole> {
  static constexpr bool heated = true;

  Heat heat;
};

/// Its pieces: those with damage, at the temperature where the step begins.
template <class R, class Whole>
struct HeatedPiecesOf : DamagedPiecesOf<R, Whole> {
  BARRENO_FUNCTION HeatedPiecesOf(
      const HeatedRock<Whole>& rock, const R& coherence, const R& damage, const R& softened
  )
      : DamagedPiecesOf<R, Whole>(rock, coherence, damage) {
    if (real::any(softened != 1.0)) this->surface.scale(softened);
  }
};
template <class R, class Whole>
struct RockFor<R, HeatedRock<Whole>> {
  using type = HeatedPiecesOf<R, Whole>;
};

/// Dry or wet rock with overstress and damage, heat or both: all but the third invariant.
template <class Whole>
struct RatedHeatedRock : HeatedRock<Whole> {
  static constexpr bool rated = true;

  double T1 = 0.0, T2 = 0.0;  ///< see RatedRock
};
template <class R, class Whole>
struct RockFor<R, RatedHeatedRock<Whole>> {
  using type = HeatedPiecesOf<R, Whole>;
};

/// What a step keeps of points that are hot.
template <class R, bool heated>
struct HeatOfStep {};
template <class R>
struct HeatOfStep<R, true> {
  R temperature{};  ///< at its begin
};

/// Ends the step of points with its heat: their temperature, and by how much their grains expand in
/// the next step. That lag makes the expansion explicit: it depends on nothing that it changes.
/// @param before  mean stress before the step [stress]; `p` has that after it, and its works
template <class R, class Law, class Points>
BARRENO_ALIKE void heat_points(const Law& law, const MaskOf<R>& ended, const R& before, Points& p) {
  const auto& i = p.increment;
  auto& h = p.history;
  PointsOutcome<R>& out = p.outcome;
  const R after = trace(p.stress) * (1.0 / 3.0);
  const R mean_ratio = 0.5 * (i.volume_ratio_begin + i.volume_ratio_end);
  // The stress works on the expanding grains too, and what they do comes from the heat.
  const R expanding = mean_ratio * (0.5 * (before + after) * h.thermal_expansion);
  const R viscous = i.viscous_pressure * (i.volume_ratio_begin - i.volume_ratio_end);
  const R warming = (out.plastic_work + viscous + expanding) * law.heat.per_heat_capacity;
  out.elastic_work = real::select(ended, out.elastic_work + expanding, out.elastic_work);
  const R pressure = R{} - after;
  h.temperature = real::select(ended, h.temperature + warming, h.temperature);
  h.thermal_expansion =
      real::select(ended, law.heat.expansion(warming, pressure), h.thermal_expansion);
}

}  // namespace barreno::arenisca
