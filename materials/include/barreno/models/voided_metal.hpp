// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/metal.hpp"

#include <cmath>
#include <vector>

namespace barreno {

/// A metal with voids (Expansion strain): the metal's own law between voids that bear nothing.
///
/// The expansion strain e_v = ln(alpha) >= 0 is that of the voids, alpha = solid over mean density:
///   V / V_ref = alpha V_metal / V_ref.
/// A step of volume strain d = ln(V_n+1 / V_n) is taken in this order:
///   1. e_v > 0, d < 0: the voids close by c = min(e_v, -d), e_v -= c, at stress 0 and without
///      plastic work. e_v > 0, d >= 0: e_v += d, and nothing else happens.
///   2. The share 1 - c/(-d) of the strain, volume and deviator, and of the time goes to the metal;
///      at a share of 0 the stress stays 0, and broken metal keeps its state but for the heat of 4.
///   3. Where the metal breaks in tension, or is broken and opens, its pressure is 0 and what it
///      has grown beyond its volume at no pressure goes to e_v.
///   4. The artificial viscosity q, found with the mean density, acts in the voids too; all of its
///      work, -q dV, heats the metal. Closing loses the kinetic energy of a porous shock: this is
///      where it goes.
/// Without voids the update is the metal's.
///
/// The longitudinal modulus is the metal's over alpha, so that with the mean density the sound
/// speed is the metal's, never 0: voids may close within a step. Broken metal whose voids are too
/// large for that, e_v > 0.5, bears nothing and has next to none, 1 % of it.
///
/// @par Source  front, pressure and heat of a porous slug on a rigid wall, which follow from the
///              jump conditions with the heat U^2/2: Zel'dovich & Raizer, Physics of Shock Waves,
///              1967, ch. XI (porous Hugoniot); verification/cases/porous_slug.py.
template <class Strength, class EquationOfState, class Failure>
struct Metal<Strength, EquationOfState, Voids<Failure>>
    : Metal<Strength, EquationOfState, Failure> {
  using Solid = Metal<Strength, EquationOfState, Failure>;
  using SpecialForm = Solid;
  using Parameters = typename Solid::Parameters;
  using Solid::Solid;
  static constexpr const char* form = "expanded";  ///< tells it from others of that name

  template <class R>
  struct HistoryOf : Solid::template HistoryOf<R> {
    R expansion_strain{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = Solid::history_count + 1;

  static bool needed(const Parameters& p) { return p.expansion_strain != 0; }
  static std::vector<HistoryField> history_table() {
    std::vector<HistoryField> table = Solid::history_table();
    table.push_back(
        {"expansion_strain", dimension::none, "ln of solid over mean density: strain of the voids"}
    );
    return table;
  }

  History initial_history() const { return {Solid::initial_history(), 0.0}; }
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    const auto s = Solid::initial_state(pressure);
    return {s.stress, {s.history, 0.0}, s.volume_ratio, s.stored_energy, s.possible};
  }
  /// A point at rest whose mean density is that of the metal over `expansion` (alpha >= 1).
  InitialStateOf<Sym3, History> expanded_state(double expansion) const {
    auto state = initial_state(0.0);
    state.volume_ratio *= expansion;
    state.history.expansion_strain = std::log(expansion);
    state.possible = state.possible && expansion >= 1.0;
    return state;
  }

  /// @param[in]     increment strain, dt, volume ratios and viscous pressure of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]
  /// @param[in,out] history   as in history_table(); with the stress left as it was if the outcome
  ///                          failed
  /// @return bad_input where the metal's update says so, or for e_v < 0
  BARRENO_FUNCTION Outcome
  update(const Increment& increment, Sym3& stress, History& history) const {
    const Sym3 stress_before = stress;
    const History before = history;
    const PointsOutcome<double> points = update_points(increment, stress, history);
    Outcome outcome;
    outcome.elastic_work = points.elastic_work;
    outcome.plastic_work = points.plastic_work;
    outcome.longitudinal_modulus = points.longitudinal_modulus;
    if (points.sound) return outcome;
    // Why: as the metal says of its own share.
    Sym3 s = stress_before;
    auto of_solid = before;
    outcome = Solid::update(share_of(increment, before.expansion_strain).increment, s, of_solid);
    if (!outcome.failed()) {
      outcome = Outcome{};
      outcome.status = Status::bad_input;
    }
    return outcome;
  }

  /// update() of one point or of several at once (real.hpp).
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
  ) const {
    if (real::all(history.expansion_strain == 0.0)) return update_solid(increment, stress, history);
    const Share<R> share = share_of(increment, history.expansion_strain);
    const R whole = increment.volume_ratio_begin - increment.volume_ratio_end;
    const R of_metal = share.increment.volume_ratio_begin - share.increment.volume_ratio_end;
    HistoryOf<R> end = history;
    // Nothing is added where the metal takes the whole step: then both changes are the same.
    const R heat = increment.viscous_pressure * (whole - of_metal);
    this->correct_energy(history, R(heat * this->inverse_density()), end);
    // Broken metal whose voids stay open: most of the debris that lies in a hole.
    const MaskOf<R> idle = (!share.closed) & Failure::template broken<R>(history);
    PointsOutcome<R> outcome = this->leave_open(share.increment, stress, history);
    Sym3Of<R> s{};
    R opened{};
    if (!real::all(idle)) {
      HistoryOf<R> moved = end;
      s = stress;
      outcome = select_points(idle, outcome, Solid::update_points(share.increment, s, moved));
      s = select_points(share.closed, s, Sym3Of<R>{});
      opened = real::select(
          share.closed, this->opening(share.increment.volume_ratio_end, s, moved), 0.0
      );
      put_where<R>(!idle, moved, end);
    }
    end.expansion_strain = share.void_strain + opened;
    outcome.sound = outcome.sound & (history.expansion_strain >= 0.0) &
                    real::is_finite(end.expansion_strain) & (increment.dt >= 0.0);
    outcome.elastic_work = real::select(share.closed, outcome.elastic_work, 0.0);
    outcome.plastic_work = real::select(share.closed, outcome.plastic_work, 0.0);
    outcome.longitudinal_modulus = outcome.longitudinal_modulus * stiff_share<R>(end);
    stress = select_points(outcome.sound, s, stress);
    put_where<R>(outcome.sound, end, history);
    return outcome;
  }

  /// Bound on the metal's K + 4G/3 over alpha of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& history, double volume_ratio
  ) const {
    const double metal_share = std::exp(-history.expansion_strain);
    return stiff_share<double>(history) *
           Solid::longitudinal_modulus(stress, history, volume_ratio * metal_share);
  }

  /// V / V_ref of what has expanded: the solid's, since voids may have any size.
  template <class R>
  BARRENO_FUNCTION static R expanded_ratio(const R& volume_ratio, const HistoryOf<R>& history) {
    return volume_ratio * real::exp(R(-history.expansion_strain));
  }

private:
  template <class R>
  BARRENO_FUNCTION static void put_where(
      const MaskOf<R>& choice, const HistoryOf<R>& from, HistoryOf<R>& to
  ) {
    for (int i = 0; i < history_count; ++i)
      reals_of<R>(to)[i] = real::select(choice, reals_of<R>(from)[i], reals_of<R>(to)[i]);
  }
  /// update_points() where no point has voids: the metal's, and what opens.
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_solid(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
  ) const {
    PointsOutcome<R> outcome = Solid::update_points(increment, stress, history);
    const R opened = this->opening(increment.volume_ratio_end, stress, history);
    history.expansion_strain = real::select(outcome.sound, opened, 0.0);
    if (real::any(opened > 0.0)) outcome.longitudinal_modulus *= stiff_share<R>(history);
    return outcome;
  }
  template <class R>
  BARRENO_FUNCTION static MaskOf<R> broken_apart(const HistoryOf<R>& history) {
    return Failure::template broken<R>(history) & (history.expansion_strain > 0.0);
  }
  /// Of the metal's modulus, that a point with these voids has.
  template <class R>
  BARRENO_FUNCTION static R stiff_share(const HistoryOf<R>& history) {
    constexpr double closes_in_a_step = 0.5;  // Step/Largest Strain is less where metal breaks
    constexpr double next_to_none = 0.01;
    const R share = real::exp(R(-history.expansion_strain));
    const MaskOf<R> soft = broken_apart<R>(history) & (history.expansion_strain > closes_in_a_step);
    return real::select(soft, next_to_none * share, share);
  }
  /// What a step leaves to the metal.
  template <class R>
  struct Share {
    MaskOf<R> closed;  ///< the metal takes a part of the step
    R void_strain;     ///< e_v at the end as far as the voids decide it
    IncrementOf<Sym3Of<R>> increment;
  };
  template <class R>
  BARRENO_FUNCTION static Share<R> share_of(
      const IncrementOf<Sym3Of<R>>& increment, const R& void_strain
  ) {
    const MaskOf<R> open = void_strain > 0.0;
    if (!real::any(open)) return {!open, R{}, increment};
    const R begin = increment.volume_ratio_begin, end = increment.volume_ratio_end;
    const MaskOf<R> usable = open & (begin > 0.0) & (end > 0.0);
    const R growth = real::log(R(real::select(usable, end / begin, 1.0)));
    const R closes = real::select(growth < 0.0, -growth, 0.0);
    const R part = real::select(closes < void_strain, closes, void_strain);
    const MaskOf<R> through = open & (closes > void_strain);
    const R share = real::select(
        through, 1.0 - part / real::select(through, closes, 1.0), real::select(open, 0.0, 1.0)
    );
    const R left = real::select(
        open, real::select(growth < 0.0, void_strain - part, void_strain + growth), 0.0
    );
    const MaskOf<R> closed = (!open) | through;
    Share<R> result{closed, left, increment};
    result.increment.strain = share * increment.strain;
    result.increment.dt = share * increment.dt;
    result.increment.volume_ratio_begin =
        real::select(open, begin * real::exp(R(-void_strain)), begin);
    // Voids that stay open keep the metal's volume to the last bit.
    result.increment.volume_ratio_end =
        real::select(result.closed, end, result.increment.volume_ratio_begin);
    return result;
  }
};

}  // namespace barreno
