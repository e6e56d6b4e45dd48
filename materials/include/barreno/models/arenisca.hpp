// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/rock.hpp"
#include "barreno/describe.hpp"
#include "barreno/models/arenisca_parameters.hpp"
#include "barreno/models/arenisca_rules.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

using Increment = IncrementOf<Sym3>;

/// Arenisca, drained: nonlinear Drucker-Prager with a cap that follows the crush curve, nonlinear
/// elasticity with elastic-plastic coupling, nonassociated flow, error-controlled substeps.
///
/// Source: Homel, Guilkey, Brannon, "Continuum effective-stress approach for high-rate plastic
/// deformation of fluid-saturated geomaterials with application to shaped-charge jet penetration",
/// Acta Mech. 227 (2016). Parameter names are the published ones. Read next:
/// arenisca/points_step.hpp.
/// @param Parts  which parts it is made of (arenisca/parts/list.hpp)
template <class Parts>
struct AreniscaOf {
  static constexpr const char* name = "Arenisca";
  static constexpr const char* summary =
      "Porous rock: nonlinear Drucker-Prager with crush-curve cap, nonlinear elasticity, pore "
      "fluid.";

  using Parameters = AreniscaParameters;
  using Law = arenisca::DryRock<Parts>;
  static constexpr int plastic_backstress = Parameters::plastic_backstress;
  static constexpr int arenisca3_moduli = Parameters::arenisca3_moduli;
  static constexpr int ring_volume = Parameters::ring_volume, scale_only = Parameters::scale_only;
  /// The cap's place X is a function of plastic_volume_strain and not stored.
  template <class R>
  struct HistoryOf {
    R plastic_volume_strain{}, equivalent_plastic_strain{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 2;

  static ParameterTable<Parameters> parameter_table() { return arenisca_parameter_table(); }
  static std::vector<HistoryField> history_table() {
    return {
        {"plastic_volume_strain",
         dimension::none,
         "volumetric plastic strain, negative in compaction"},
        {"equivalent_plastic_strain",
         dimension::none,
         "accumulated sqrt(2/3 de_p : de_p) of the plastic deviator"}};
  }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& p, double /*density*/) { return check_arenisca(p); }

  AreniscaOf(const Parameters& p, double /*density*/) : p_(p), rock_(make_rock(p)) {}

  History initial_history() const { return {}; }

  /// Rate-form law: the reference volume is that of the confined rock.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    const bool capped = rock_.crush.has_cap(0.0);
    const bool possible = pressure >= 0.0 && (!capped || -3.0 * pressure > p_.p0_crush_curve);
    return {isotropic(-pressure), History{}, 1.0, stored_energy(pressure), possible};
  }

  /// Advances a point by a strain increment.
  /// @param[in]     increment strain and volume ratios of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]; as it was when the outcome has
  /// failed
  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const;

  /// update() of points in lanes, in two parts (outcome.hpp, arenisca_update.hpp), to the same
  /// bits.
  template <class R>
  using Points = PointsOf<Sym3Of<R>, HistoryOf<R>>;
  static constexpr int groups_together = 32;
  template <class R>
  BARRENO_FUNCTION MaskOf<R> start_points(Points<R>& p) const;
  template <class R>
  BARRENO_FUNCTION void finish_points(Points<R>* groups, const MaskOf<R>* flows, int count) const;

  /// Bound on K + 4G/3 over all reachable states [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    return plane_wave_modulus(rock_.elasticity.upper_bound());
  }
  /// K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double
  longitudinal_modulus(const Sym3& stress, const History& h, double /*volume_ratio*/) const {
    return plane_wave_modulus(drained_moduli(stress, h));
  }
  /// Tangent moduli of a point in this state.
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    return rock_.elasticity.moduli_at(trace(stress), h.plastic_volume_strain);
  }
  const Parameters& parameters() const { return p_; }
  const Law& rock() const { return rock_; }

private:
  static Law make_rock(const Parameters& p);

  BARRENO_FUNCTION static double plane_wave_modulus(const arenisca::Moduli& m) {
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  /// Elastic energy under hydrostatic pressure: integral of p dp / K(p), Simpson's rule.
  double stored_energy(double pressure) const {
    constexpr int intervals = 1000;
    const double step = pressure / intervals;
    double sum = 0.0;
    for (int i = 0; i <= intervals; ++i) {
      const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      const double p = i * step;
      sum += weight * p / rock_.elasticity.moduli_at(-3.0 * p, 0.0).bulk;
    }
    return sum * step / 3.0;
  }

  Parameters p_;
  Law rock_;
};

/// Of the published parts.
using Arenisca = AreniscaOf<arenisca::PublishedParts>;

template <class Parts>
typename AreniscaOf<Parts>::Law AreniscaOf<Parts>::make_rock(const Parameters& p) {
  using Limit = typename Parts::ShearLimit;
  Law rock;
  rock.elasticity = arenisca::Elasticity::make(p);
  rock.surface = arenisca::make_surface<Limit>(p, Limit::peak(p), p.CR);
  rock.crush = typename Parts::CrushCurve(p);
  rock.first_cap = rock.cap_at(0.0);
  rock.flow = Parts::FlowRule::make(p);
  rock.tolerance = p.tolerance;
  // An elastic strain of 1e-4 or the shear strength at zero pressure: errors below tolerance times
  // this do not matter however small the stress is.
  constexpr double small_strain = 1e-4;
  rock.stress_floor = std::fmax(small_strain * p.B0, rock.surface.limit(0.0));
  rock.bisection = p.return_solver == 1;
  constexpr double negligible = 0.01;
  const double smallest_error = rock.tolerance * rock.stress_floor;
  rock.jump_width = std::fmax(
      arenisca::Elasticity::at_jump,
      negligible * smallest_error / (3.0 * rock.elasticity.published_bound().bulk)
  );
  return rock;
}

}  // namespace barreno

#include "barreno/models/arenisca_update.hpp"
