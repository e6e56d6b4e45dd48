// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/scatter.hpp"
#include "barreno/models/arenisca.hpp"
#include "barreno/models/arenisca_update.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

namespace arenisca {

inline Weibull make_weibull(const AreniscaParameters& p) {
  Weibull w;
  w.modulus = p.weibull_modulus;
  w.reference_volume = p.weibull_reference_volume;
  w.seed = static_cast<std::uint64_t>(p.weibull_seed);
  w.ring = p.weibull_volume == AreniscaParameters::ring_volume;
  w.scale_only = p.weibull_scatter == AreniscaParameters::scale_only;
  w.bound = ShearLimit::largest_factor(p);
  return w;
}

/// What a cap depends on.
template <class Crush, class Surface>
struct CrushedSurface {
  const Crush& crush;
  Surface surface;
};
/// What the surface of a piece is made of.
template <class Whole>
void set_strength(const AreniscaParameters& p, ScatteredRock<Whole>& rock) {
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

}  // namespace arenisca

/// Dry Arenisca whose strength at the vertex scatters from piece to piece
/// (arenisca/parts/scatter.hpp): the dry law with PEAKI1 times the coherence of each point
/// (arenisca/points_pieces.hpp).
struct ScatteredArenisca {
  using SpecialForm = Arenisca;
  using Parameters = Arenisca::Parameters;
  using Law = arenisca::ScatteredRock<arenisca::Rock>;
  static constexpr const char* name = "Arenisca";
  static constexpr const char* form = "scattered";  ///< tells it from others of that name
  static constexpr const char* summary = Arenisca::summary;

  template <class R>
  struct HistoryOf {
    R plastic_volume_strain{}, equivalent_plastic_strain{};
    R coherence = R{} + 1.0;
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 3;

  static bool needed(const Parameters& p) { return arenisca::is_scattered(p); }
  static ParameterTable<Parameters> parameter_table() { return arenisca_parameter_table(); }
  static std::vector<HistoryField> history_table() {
    std::vector<HistoryField> table = Arenisca::history_table();
    table.push_back({"coherence", dimension::none, "strength at the vertex over the card's PEAKI1"}
    );
    return table;
  }
  static std::string check(const Parameters& p, double density) {
    return Arenisca::check(p, density);
  }

  ScatteredArenisca(const Parameters& p, double density)
      : mean_(p, density), rock_(make_rock(mean_)), weibull_(arenisca::make_weibull(p)) {}

  /// Gives a piece of rock the strength of its own; a host that makes pieces calls this once, one
  /// that does not has the mean everywhere.
  void vary(History& h, const Specimen& piece) const { h.coherence = weibull_.factor(piece); }
  const arenisca::Weibull& weibull() const { return weibull_; }

  History initial_history() const { return {}; }
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    const auto s = mean_.initial_state(pressure);
    return {s.stress, History{}, s.volume_ratio, s.stored_energy, s.possible};
  }

  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    return arenisca::update_point(*this, rock_, increment, stress, h);
  }
  template <class R>
  using Points = PointsOf<Sym3Of<R>, HistoryOf<R>>;
  static constexpr int groups_together = 32;
  template <class R>
  BARRENO_FUNCTION MaskOf<R> start_points(Points<R>& p) const {
    const HistoryOf<R>& h = p.history;
    const MaskOf<R> sound = arenisca::sound_points(
                                p.increment,
                                p.stress,
                                R(h.plastic_volume_strain + h.coherence),
                                h.equivalent_plastic_strain
                            ) &
                            (h.coherence >= 0.0);
    return arenisca::start_rock<R>(rock_, sound, p);
  }
  template <class R>
  BARRENO_FUNCTION void finish_points(Points<R>* groups, const MaskOf<R>* flows, int count) const {
    arenisca::StepOf<R, Law> steps[groups_together];
    arenisca::finish_rock(rock_, steps, groups, flows, count);
  }

  /// Bound on K + 4G/3 over all reachable states [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const { return mean_.longitudinal_modulus(); }
  /// K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& h, double volume_ratio
  ) const {
    return mean_.longitudinal_modulus(stress, mean(h), volume_ratio);
  }
  /// Tangent moduli of a point in this state.
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    return mean_.drained_moduli(stress, mean(h));
  }
  const Parameters& parameters() const { return mean_.parameters(); }
  const Law& rock() const { return rock_; }

private:
  static Law make_rock(const Arenisca& mean) {
    const Parameters& p = mean.parameters();
    Law rock;
    static_cast<arenisca::Rock&>(rock) = mean.rock();
    arenisca::set_strength(p, rock);
    return rock;
  }

  BARRENO_FUNCTION static Arenisca::History mean(const History& h) {
    return {h.plastic_volume_strain, h.equivalent_plastic_strain};
  }

  Arenisca mean_;
  Law rock_;
  arenisca::Weibull weibull_;
};

}  // namespace barreno
