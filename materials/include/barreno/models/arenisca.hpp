// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/substep.hpp"
#include "barreno/describe.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace barreno {

using Increment = IncrementOf<Sym3>;

namespace arenisca {

/// False for NaN, infinite or absurd input: a strain increment beyond exp(10) has no meaning.
BARRENO_FUNCTION bool sound_increment(const Increment& i, const Sym3& stress) {
  constexpr double largest_increment = 10.0;
  const double strain_squared = contract(i.strain, i.strain);
  return strain_squared <= largest_increment * largest_increment &&
         std::isfinite(contract(stress, stress)) &&
         std::isfinite(i.volume_ratio_begin + i.volume_ratio_end);
}

}  // namespace arenisca

/// Arenisca, drained: nonlinear Drucker-Prager with a cap that follows the crush curve, nonlinear
/// elasticity with elastic-plastic coupling, nonassociated flow, error-controlled substeps.
///
/// Source: Homel, Guilkey, Brannon, "Continuum effective-stress approach for high-rate plastic
/// deformation of fluid-saturated geomaterials with application to shaped-charge jet penetration",
/// Acta Mech. 227 (2016). Parameter names are the published ones. Read next: arenisca/substep.hpp.
struct Arenisca {
  static constexpr const char* name = "Arenisca";
  static constexpr const char* summary =
      "Porous rock: nonlinear Drucker-Prager with crush-curve cap, nonlinear elasticity, pore "
      "fluid.";

  struct Parameters {
    double PEAKI1, FSLOPE, STREN, YSLOPE, BETA_nonassociativity;
    double B0, B1, B2, B3, B4;
    double G0, G1, G2, G3, G4;
    double p0_crush_curve, p1_crush_curve, p3_crush_curve, CR;
    double tolerance;
    double fluid_B0, fluid_pressure_initial, matrix_bulk_modulus;
    double T1_rate_dependence, T2_rate_dependence;
    double J3_psi;
    double weibull_modulus, weibull_reference_volume, weibull_seed;
    int return_solver, backstress_strain, undrained_moduli, J3_type, weibull_volume,
        weibull_scatter;
  };
  /// Indices of words.
  static constexpr int plastic_backstress = 1, arenisca3_moduli = 1;
  static constexpr int ring_volume = 1, scale_only = 1;
  /// The cap's place X is a function of plastic_volume_strain and not stored.
  template <class R>
  struct HistoryOf {
    R plastic_volume_strain{}, equivalent_plastic_strain{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 2;

  static ParameterTable<Parameters> parameter_table();
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
  static std::string check(const Parameters& p, double density);

  Arenisca(const Parameters& p, double /*density*/) : p_(p), rock_(make_rock(p)) {}

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
  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    arenisca::NoCounter none;
    return update_counted(increment, stress, h, none);
  }

  /// update() that also counts yield-function evaluations.
  template <class Counter>
  BARRENO_FUNCTION Outcome
  update_counted(const Increment& increment, Sym3& stress, History& h, Counter& count) const {
    if (!arenisca::sound_increment(increment, stress) || !sound_history(h)) {
      Outcome refused;
      refused.status = Status::bad_input;
      refused.substeps = 0;
      return refused;
    }
    arenisca::PointState state{
        trace(stress), deviator(stress), h.plastic_volume_strain, h.equivalent_plastic_strain};
    Outcome outcome = arenisca::integrate(rock_, state, increment.strain, count);
    if (outcome.failed()) return failed(outcome.status, outcome.substeps);
    const Sym3 end = state.s + isotropic(state.x / 3.0);
    if (!is_finite(end)) return failed(Status::not_converged, outcome.substeps);
    stress = end;
    h = {state.evp, state.shear_strain};
    const double mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
    outcome.elastic_work *= mean_ratio;
    outcome.plastic_work *= mean_ratio;
    return outcome;
  }

  /// update() of points in lanes, in two parts (outcome.hpp, arenisca_update.hpp); agrees with it
  /// to 1e-9 of the larger of strength and trial stress.
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
    return plane_wave_modulus(rock_.elasticity.moduli_at(trace(stress), h.plastic_volume_strain));
  }
  const Parameters& parameters() const { return p_; }
  const arenisca::Rock& rock() const { return rock_; }

private:
  static arenisca::Rock make_rock(const Parameters& p);

  BARRENO_FUNCTION static double plane_wave_modulus(const arenisca::Moduli& m) {
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  BARRENO_FUNCTION static Outcome failed(Status status, int substeps) {
    Outcome outcome;
    outcome.status = status;
    outcome.substeps = substeps;
    return outcome;
  }
  BARRENO_FUNCTION static bool sound_history(const History& h) {
    return std::isfinite(h.plastic_volume_strain) && std::isfinite(h.equivalent_plastic_strain);
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
  arenisca::Rock rock_;
};

namespace arenisca {

using Entries = std::vector<ParameterEntry<Arenisca::Parameters>>;

inline Entries strength_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      required(&P::PEAKI1, "PEAKI1", d::stress, at_least(0.0), "I1 at the tensile vertex"),
      required(
          &P::FSLOPE, "FSLOPE", d::none, at_least(0.0), "slope of the limit surface at the vertex"
      ),
      optional(
          &P::STREN, "STREN", d::stress, at_least(0.0), 0.0, "shear strength at high pressure"
      ),
      optional(&P::YSLOPE, "YSLOPE", d::none, at_least(0.0), 0.0, "slope at high pressure"),
      optional(
          &P::BETA_nonassociativity,
          "BETA_nonassociativity",
          d::none,
          Bounds{0.0, 1.0, true, false},
          1.0,
          "beta: dilatancy slope / friction slope = beta^2; above 1 plastic work could be negative"
      )};
}

inline Entries elastic_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      required(&P::B0, "B0", d::stress, above(0.0), "bulk modulus at zero pressure and in tension"),
      optional(
          &P::B1, "B1", d::stress, at_least(0.0), 0.0, "rise of the bulk modulus under pressure"
      ),
      optional(&P::B2, "B2", d::stress, at_least(0.0), 0.0, "I1 scale of that rise"),
      optional(&P::B3, "B3", d::stress, at_least(0.0), 0.0, "elastic-plastic coupling: fall of K"),
      optional(
          &P::B4, "B4", d::none, at_least(0.0), 0.0, "plastic volume strain scale of that fall"
      ),
      required(&P::G0, "G0", d::stress, above(0.0), "shear modulus"),
      optional(
          &P::G1, "G1", d::none, any(), 0.0, "Poisson's ratio at zero pressure; 0 = constant G"
      ),
      optional(&P::G2, "G2", d::none, any(), 0.0, "rise of Poisson's ratio under pressure"),
      optional(&P::G3, "G3", d::none, any(), 0.0, "published name without effect: must be 0"),
      optional(&P::G4, "G4", d::none, any(), 0.0, "published name without effect: must be 0")};
}

inline Entries cap_and_solver_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      optional(
          &P::p0_crush_curve,
          "p0_crush_curve",
          d::stress,
          any(),
          0.0,
          "I1 at which crushing begins; needed unless p3_crush_curve = 0"
      ),
      optional(
          &P::p1_crush_curve,
          "p1_crush_curve",
          d::compliance,
          any(),
          0.0,
          "steepness of the crush curve; needed unless p3_crush_curve = 0"
      ),
      required(&P::p3_crush_curve, "p3_crush_curve", d::none, at_least(0.0), "-ln(1 - porosity)"),
      optional(&P::CR, "CR", d::none, Bounds{0.0, 1.0, false, true}, 0.5, "shape of the cap"),
      optional(
          &P::tolerance,
          "Tolerance",
          d::none,
          Bounds{0.0, 1.0, true, true},
          // Measured over random updates like those of a penetration: mean error 2e-4 for 1.5
          // substeps; ten times tighter costs twice as much for a third of the error.
          1e-2,
          "relative local error of a substep; results are of second order in the step down to "
          "errors of about a tenth of this, then of first order"
      )};
}

inline Entries fluid_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      optional(
          &P::fluid_B0,
          "fluid_B0",
          d::stress,
          at_least(0.0),
          0.0,
          "bulk modulus of the fluid; 0: dry"
      ),
      optional(
          &P::fluid_pressure_initial,
          "fluid_pressure_initial",
          d::stress,
          at_least(0.0),
          0.0,
          "pressure of the fluid at the start"
      ),
      optional(
          &P::matrix_bulk_modulus,
          "Matrix bulk modulus",
          d::stress,
          at_least(0.0),
          0.0,
          "bulk modulus of the grains; 0: B0 + B1"
      )};
}

inline Entries rate_and_angle_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      optional(
          &P::T1_rate_dependence,
          "T1_rate_dependence",
          d::none,
          at_least(0.0),
          0.0,
          "overstress relaxes in T1 |D|^-T2 (in seconds, D per second); 0: no rate dependence"
      ),
      optional(
          &P::T2_rate_dependence,
          "T2_rate_dependence",
          d::none,
          at_least(0.0),
          0.0,
          "exponent of the rate; 0: constant relaxation time T1"
      ),
      optional(
          &P::J3_psi,
          "J3_psi",
          d::none,
          Bounds{0.5, 2.0, false, false},
          1.0,
          "strength in triaxial extension over that in compression"
      )};
}

inline Entries variability_entries() {
  using P = Arenisca::Parameters;
  namespace d = dimension;
  return {
      optional(
          &P::weibull_modulus,
          "Weibull modulus",
          d::none,
          at_least(0.0),
          0.0,
          "m: PEAKI1 varies from particle to particle, the less the larger m; 0: it does not"
      ),
      optional(
          &P::weibull_reference_volume,
          "Weibull reference volume",
          d::volume,
          at_least(0.0),
          0.0,
          "volume of the specimens whose mean strength is PEAKI1; smaller particles are stronger"
      ),
      optional(
          &P::weibull_seed,
          "Weibull seed",
          d::none,
          at_least(0.0),
          0.0,
          "whole number; another one is another specimen of the same rock"
      )};
}

}  // namespace arenisca

inline ParameterTable<Arenisca::Parameters> Arenisca::parameter_table() {
  ParameterTable<Parameters> table;
  for (const auto& entries :
       {arenisca::strength_entries(),
        arenisca::elastic_entries(),
        arenisca::cap_and_solver_entries(),
        arenisca::fluid_entries(),
        arenisca::rate_and_angle_entries(),
        arenisca::variability_entries()}) {
    table.numbers.insert(table.numbers.end(), entries.begin(), entries.end());
  }
  table.choices = {
      {&Parameters::return_solver,
       "Return solver",
       {"fast", "bisection"},
       0,
       "fast: one superlinear scalar solve; bisection: the published nested method, the oracle"},
      {&Parameters::backstress_strain,
       "Backstress strain",
       {"elastic centre", "plastic"},
       0,
       "strain that the fluid's backstress follows; plastic: the published form, for its "
       "calibrations"},
      {&Parameters::undrained_moduli,
       "Undrained moduli",
       {"biot", "arenisca3"},
       0,
       "arenisca3: those of the published code (2 to 5 % stiff, no B1), for its calibrations"},
      {&Parameters::J3_type,
       "J3_type",
       {"none", "Gudehus", "Willam-Warnke", "Mohr-Coulomb"},
       0,
       "dependence of the strength on the Lode angle"},
      {&Parameters::weibull_volume,
       "Weibull volume",
       {"cube", "ring"},
       0,
       "volume of a particle for the scale effect: the cube over its face in the plane, the same "
       "at "
       "any distance from the axis; ring: its own (full circle, or per unit thickness)"},
      {&Parameters::weibull_scatter,
       "Weibull scatter",
       {"random", "scale only"},
       0,
       "scale only: every particle has the mean of its size"}};
  return table;
}

inline arenisca::Rock Arenisca::make_rock(const Parameters& p) {
  arenisca::Rock rock;
  rock.elasticity = {p.B0, p.B1, p.B2, p.B3, p.B4, p.G0, p.G1, p.G2};
  rock.surface = arenisca::make_yield_surface(p.PEAKI1, p.FSLOPE, p.STREN, p.YSLOPE, p.CR);
  rock.crush = {p.p0_crush_curve, p.p1_crush_curve, p.p3_crush_curve};
  rock.rates = arenisca::crush_rates(rock.crush);
  rock.first_cap = rock.cap_at(0.0);
  rock.beta = p.BETA_nonassociativity;
  rock.tolerance = p.tolerance;
  // An elastic strain of 1e-4 or the shear strength at zero pressure: errors below tolerance times
  // this do not matter however small the stress is.
  constexpr double small_strain = 1e-4;
  rock.stress_floor = std::fmax(small_strain * p.B0, rock.surface.limit(0.0));
  rock.bisection = p.return_solver == 1;
  return rock;
}

namespace arenisca {

/// "PEAKI1 = 2.1e+07": a parameter and its value, as messages name it.
inline std::string named(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s = %.6g", name, value);
  return text;
}

inline std::string check_surface(const Arenisca::Parameters& p) {
  const std::string FSLOPE = named("FSLOPE", p.FSLOPE), STREN = named("STREN", p.STREN);
  const std::string PEAKI1 = named("PEAKI1", p.PEAKI1), YSLOPE = named("YSLOPE", p.YSLOPE);
  if (p.FSLOPE == 0.0 && p.STREN == 0.0) {
    return FSLOPE + " and " + STREN +
           " leave the rock without any shear strength (the yield surface is "
           "empty). Set FSLOPE, STREN or both.";
  }
  if (p.FSLOPE == 0.0 && p.PEAKI1 != 0.0) {
    return PEAKI1 +
           " needs a slope, but FSLOPE = 0 (STREN alone is the von Mises surface, which has no "
           "vertex). Set FSLOPE, or PEAKI1 = 0.";
  }
  if (p.FSLOPE == 0.0 && p.YSLOPE != 0.0) {
    return YSLOPE +
           " exceeds FSLOPE = 0 (the limit surface would open backwards). Set FSLOPE, or YSLOPE = "
           "0 "
           "for von Mises.";
  }
  if (p.STREN == 0.0 && p.YSLOPE != 0.0) {
    return YSLOPE +
           " is the slope at high pressure of the nonlinear surface, which needs STREN (now 0). "
           "Set "
           "STREN, or YSLOPE = 0 for linear Drucker-Prager.";
  }
  if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.FSLOPE > p.YSLOPE)) {
    return YSLOPE + " is not below " + FSLOPE +
           " (the limit surface would open backwards). Swap them?";
  }
  if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.STREN > p.YSLOPE * p.PEAKI1)) {
    return STREN + " must exceed YSLOPE*PEAKI1 = " + named("", p.YSLOPE * p.PEAKI1).substr(3) +
           " (the limit surface would open backwards). Raise STREN or lower YSLOPE.";
  }
  return {};
}

inline std::string check_crush_curve(const Arenisca::Parameters& p) {
  if (p.p3_crush_curve == 0.0) return {};  // nonporous: no cap, p0 and p1 are not read
  if (!(p.p0_crush_curve < 0.0)) {
    return named("p0_crush_curve", p.p0_crush_curve) +
           " must be negative (it is the I1 at which crushing begins, tension positive). Change "
           "its sign, or "
           "set p3_crush_curve = 0 for nonporous rock.";
  }
  if (!(p.p1_crush_curve > 0.0)) {
    return named("p1_crush_curve", p.p1_crush_curve) +
           " must be positive (else crushing softens the rock). Change its sign, or set "
           "p3_crush_curve = 0 for "
           "nonporous rock.";
  }
  return {};
}

inline std::string check_fluid(const Arenisca::Parameters& p) {
  if (p.fluid_B0 == 0.0) {
    if (p.fluid_pressure_initial == 0.0) return {};
    return named("fluid_pressure_initial", p.fluid_pressure_initial) +
           " needs a fluid, but fluid_B0 = 0 (dry rock). Set fluid_B0, or the pressure to 0.";
  }
  const double matrix = p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;
  const double porosity = -std::expm1(-p.p3_crush_curve);
  const std::string grains = named("Matrix bulk modulus", matrix);
  if (p.fluid_B0 > matrix) {
    return named("fluid_B0", p.fluid_B0) + " exceeds " + grains +
           " (the fluid would be stiffer than the grains). Lower fluid_B0 or raise the other.";
  }
  if (p.B0 + p.B1 > matrix) {
    return grains + " is below B0 + B1 = " + named("", p.B0 + p.B1).substr(3) +
           " (the rock would be stiffer than its grains). Raise it.";
  }
  if (p.B0 > (1.0 - porosity) * matrix) {
    return named("B0", p.B0) + " exceeds (1 - porosity) times " + grains + " = " +
           named("", (1.0 - porosity) * matrix).substr(3) +
           " (pores would not soften the rock). Lower B0 or p3_crush_curve, or raise the matrix "
           "bulk modulus.";
  }
  if (p.undrained_moduli == Arenisca::arenisca3_moduli &&
      p.backstress_strain != Arenisca::plastic_backstress) {
    return "Undrained moduli = arenisca3 belongs to the published backstress (the two were "
           "calibrated together). Set Backstress strain to plastic.";
  }
  return {};
}

inline std::string check_angle(const Arenisca::Parameters& p) {
  constexpr double widest = 9.0 / 7.0;
  const bool narrow = p.J3_type == 1;
  if (narrow && !(p.J3_psi >= 1.0 / widest && p.J3_psi <= widest)) {
    return named("J3_psi", p.J3_psi) +
           " makes the Gudehus surface not convex (it is from 7/9 to 9/7). Change it, or take "
           "Willam-Warnke, which is convex from 1/2 to 2.";
  }
  if (p.J3_type == 0 && p.J3_psi != 1.0) {
    return named("J3_psi", p.J3_psi) +
           " has no effect without a J3_type (which says how the strength goes from 1 to it). Set "
           "J3_type, or J3_psi to 1.";
  }
  return {};
}

inline std::string check_variability(const Arenisca::Parameters& p) {
  constexpr double most_seeds = 9007199254740992.0;  // 2^53: whole numbers that a double holds
  if (!(p.weibull_seed < most_seeds && p.weibull_seed == std::floor(p.weibull_seed))) {
    return named("Weibull seed", p.weibull_seed) +
           " is not a whole number below 2^53 (it numbers specimens). Take 0, 1, 2 and so on.";
  }
  if (p.weibull_modulus == 0.0) {
    if (p.weibull_reference_volume == 0.0) return {};
    return named("Weibull reference volume", p.weibull_reference_volume) +
           " has no effect without a Weibull modulus (0: no scatter). Set the modulus, or the "
           "volume to "
           "0.";
  }
  if (p.weibull_reference_volume == 0.0) {
    return named("Weibull modulus", p.weibull_modulus) +
           " needs a Weibull reference volume (strength depends on size). Set that of the "
           "specimens that PEAKI1 was measured on.";
  }
  if (p.PEAKI1 == 0.0) {
    return named("Weibull modulus", p.weibull_modulus) +
           " has no effect with PEAKI1 = 0 (it is PEAKI1 that varies). Set PEAKI1, or the modulus "
           "to 0.";
  }
  return {};
}

inline std::string check_bulk_modulus(const Arenisca::Parameters& p) {
  if (p.B1 > 0.0 && p.B2 == 0.0) {
    return named("B1", p.B1) +
           " with B2 = 0 makes the bulk modulus jump at zero pressure. Set B2, the I1 over "
           "which it rises, or B1 = 0.";
  }
  if (p.B3 > 0.0 && p.B4 == 0.0) {
    return named("B3", p.B3) +
           " with B4 = 0 makes the bulk modulus jump at the first crushing. Set B4, the "
           "plastic strain over which it falls, or B3 = 0.";
  }
  const double fall = p.p3_crush_curve > 0.0 ? p.B3 * std::exp(-p.B4 / p.p3_crush_curve) : 0.0;
  if (!(p.B0 - fall > 0.0)) {
    return named("B3", p.B3) + " makes the bulk modulus B0 - B3 exp(-B4/p3_crush_curve) = " +
           named("", p.B0 - fall).substr(3) +
           " negative when the pores are crushed. Lower B3 or raise B0 or B4.";
  }
  return {};
}

inline std::string check_shear_modulus(const Arenisca::Parameters& p) {
  if (p.G3 != 0.0 || p.G4 != 0.0) {
    const bool third = p.G3 != 0.0;
    return named(third ? "G3" : "G4", third ? p.G3 : p.G4) +
           " has no effect in the published model and would be ignored. Set it to 0.";
  }
  if ((p.G1 != 0.0) != (p.G2 != 0.0)) {
    return named("G1", p.G1) + " and " + named("G2", p.G2) +
           " have no effect unless both are set (else the shear modulus is G0). Set both, or both "
           "to 0.";
  }
  if (p.G1 == 0.0) return {};
  for (const double nu : {p.G1, p.G1 + p.G2}) {
    if (nu > -1.0 && nu < 0.5) continue;
    return named("G1", p.G1) + " and " + named("G2", p.G2) + " give a Poisson's ratio of " +
           named("", nu).substr(3) +
           ", outside -1 to 0.5 (negative shear modulus). Change G1 or G2.";
  }
  // Cards carry few digits; a jump of 1e-3 in G at I1 = 0 is below what calibrations resolve.
  constexpr double digits = 1e-3;
  const double continuous = Elasticity::shear_from_ratio(p.B0, p.G1);
  if (!(std::fabs(p.G0 - continuous) <= digits * continuous)) {
    return named("G0", p.G0) +
           " must equal 1.5 B0 (1 - 2 G1)/(1 + G1) = " + named("", continuous).substr(3) +
           " (the shear modulus would jump at zero pressure). Set G0 to that.";
  }
  return {};
}

}  // namespace arenisca

inline std::string Arenisca::check(const Parameters& p, double /*density*/) {
  for (const auto& entry : parameter_table().numbers) {
    if (entry.bounds.contain(p.*entry.member)) continue;
    return arenisca::named(entry.name, p.*entry.member) + " is out of range (" + entry.meaning +
           "). See the range in the manual.";
  }
  for (const auto rule :
       {arenisca::check_surface,
        arenisca::check_fluid,
        arenisca::check_angle,
        arenisca::check_variability,
        arenisca::check_crush_curve,
        arenisca::check_bulk_modulus,
        arenisca::check_shear_modulus}) {
    std::string problem = rule(p);
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace barreno

#include "barreno/models/arenisca_update.hpp"
