// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/arenisca/selection.hpp"
#include "barreno/real.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Tangent bulk and shear modulus at a state [stress].
template <class R>
struct ModuliOf {
  R bulk{}, shear{};
};
using Moduli = ModuliOf<double>;

/// exp(B2/I1) and its two derivatives by I1: all pressure dependence enters through this one
/// number, so a second-order step needs one exponential only.
template <class R>
struct PressureTermOf {
  R value{}, slope{}, curvature{};
};

/// An elastic state, and what moduli further on are found from.
template <class R>
struct ElasticStateOf {
  R x{}, evp{};
  PressureTermOf<R> term{};
  R coupling{};
  ModuliOf<R> moduli{};
};

/// Nonlinear isotropic elasticity of the drained rock, I1 = tr(sigma), tension positive; of one
/// point or several (real.hpp).
///
///   I1 >= 0 or evp > 0:    K = B0, G = G0   (evp > 0: with `Dilated moduli` = constant)
///   else:                  K = B0 + B1 exp(B2/I1) - B3 exp(B4/evp)   (last term for evp < 0)
///                          nu = G1 + G2 exp(B2/I1), G = 1.5 K (1 - 2 nu)/(1 + nu)   if G1 and G2
///                          are both set
///
/// Grains that stiffen under pressure, and turn into a denser phase, add to that (p = -I1/3):
///
///   K = K_g/(1 + c K_g),   K_g = B0 + (B1 + B' p) exp(B2/I1) - B3 exp(B4/evp)
///   c = 6 D w (1 - w)/(p_e - p_s),   w = (p - p_s)/(p_e - p_s) within 0 to 1
///
/// B' is dK/dp at high pressure, after F. D. Murnaghan (Proc. Natl. Acad. Sci. 30 (1944) 244), D
/// the logarithmic volume strain of the transition, which a return of the pressure undoes. G is
/// that of K without either: grains yield before it matters.
///
/// As published, dilated rock (evp > 0) keeps the low-pressure moduli until it is compacted again.
/// Benchmark 08 depends on it (I1 = -1481 with it, -1527 without, at the seventh way point). Rock
/// that begins to dilate under pressure then gives back work that it never took up; with
/// `Dilated moduli` = pressure it keeps the moduli of its pressure, and nothing jumps.
struct Elasticity {
  struct Parameters {
    double B0, B1, B2, B3, B4;
    double G0, G1, G2, G3, G4;
    double grain_stiffening, transition_strain, transition_start, transition_end;
    int dilated_moduli;
  };
  static auto numbers_of_grains() {
    using P = Parameters;
    namespace d = dimension;
    using Numbers = decltype(ParameterTable<Parameters>::numbers);
    return Numbers{
        optional(
            &P::grain_stiffening,
            "Grain stiffening",
            d::none,
            at_least(0.0),
            0.0,
            "B': dK/dp of rock whose grains bear the pressure. 0: K tends to B0 + B1, as "
            "published"
        ),
        optional(
            &P::transition_strain,
            "Transition strain",
            d::none,
            at_least(0.0),
            0.0,
            "D: logarithmic volume strain by which grains turn into a denser phase. 0: none"
        ),
        optional(
            &P::transition_start,
            "Transition start",
            d::stress,
            at_least(0.0),
            0.0,
            "p_s: mean pressure at which the transition begins"
        ),
        optional(
            &P::transition_end,
            "Transition end",
            d::stress,
            at_least(0.0),
            0.0,
            "p_e: mean pressure at which it is complete"
        )};
  }
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    ParameterTable<Parameters> table = {
        {required(
             &P::B0, "B0", d::stress, above(0.0), "bulk modulus at zero pressure and in tension"
         ),
         optional(
             &P::B1, "B1", d::stress, at_least(0.0), 0.0, "rise of the bulk modulus under pressure"
         ),
         optional(&P::B2, "B2", d::stress, at_least(0.0), 0.0, "I1 scale of that rise"),
         optional(
             &P::B3, "B3", d::stress, at_least(0.0), 0.0, "elastic-plastic coupling: fall of K"
         ),
         optional(
             &P::B4, "B4", d::none, at_least(0.0), 0.0, "plastic volume strain scale of that fall"
         ),
         required(&P::G0, "G0", d::stress, above(0.0), "shear modulus"),
         optional(
             &P::G1, "G1", d::none, any(), 0.0, "Poisson's ratio at zero pressure; 0 = constant G"
         ),
         optional(&P::G2, "G2", d::none, any(), 0.0, "rise of Poisson's ratio under pressure"),
         optional(&P::G3, "G3", d::none, any(), 0.0, "published name without effect: must be 0"),
         optional(&P::G4, "G4", d::none, any(), 0.0, "published name without effect: must be 0")},
        {{&P::dilated_moduli,
          "Dilated moduli",
          {"constant", "pressure"},
          0,
          "moduli of dilated rock: B0 and G0, as published, or those of its pressure, so that the "
          "onset of dilation creates no work"}}};
    for (const auto& entry : numbers_of_grains()) table.numbers.push_back(entry);
    return table;
  }
  static std::string check(const Parameters& p) {
    std::string problem;
    for (const auto rule : {check_bulk_modulus, check_shear_modulus, check_transition})
      if (problem.empty()) problem = rule(p);
    return problem;
  }
  static Elasticity make(const Parameters& p) {
    Elasticity e{p.B0, p.B1, p.B2, p.B3, p.B4, p.G0, p.G1, p.G2};
    e.stiffening = p.grain_stiffening;
    if (p.dilated_moduli == of_pressure) e.jump = HUGE_VAL;
    if (p.transition_strain == 0.0) return e;
    e.per_transition = 1.0 / (p.transition_end - p.transition_start);
    e.transition_start = p.transition_start;
    e.transition_compliance = 6.0 * p.transition_strain * e.per_transition;
    return e;
  }

  double B0, B1, B2, B3, B4, G0, G1, G2;
  double stiffening = 0.0;             ///< B'
  double transition_compliance = 0.0;  ///< 6 D/(p_e - p_s) [1/stress]; 0: no transition
  double transition_start = 0.0, per_transition = 0.0;

  enum DilatedModuli { constant = 0, of_pressure = 1 };
  /// The moduli jump where rock becomes dilated; |evp| below this counts as at the jump (round-off
  /// of an isochoric flow is not dilation).
  static constexpr double at_jump = 1e-12;
  double jump = at_jump;  ///< plastic volume strain above which pressure changes no moduli
  /// Whether the moduli are those without pressure.
  template <class R>
  BARRENO_FUNCTION MaskOf<R> dilated(const R& evp) const {
    return evp > jump;
  }
  /// Plastic strain at which to take the moduli when the way to `evp_end` began at `evp_begin`: at
  /// the jump itself those of the side it came from.
  template <class R>
  BARRENO_FUNCTION R seen_from(const R& evp_begin, const R& evp_end) const {
    const MaskOf<R> from_dilated = dilated(evp_begin) & (real::abs(evp_end) <= at_jump);
    return real::select(from_dilated, 2.0 * at_jump, evp_end);
  }
  /// Whether the jump lies between two plastic volume strains.
  template <class R>
  BARRENO_FUNCTION MaskOf<R> crosses_jump(const R& begin, const R& end) const {
    const bool changes = B1 != 0.0 || B3 != 0.0 || variable_ratio() || grains_change();
    if (!changes || jump != at_jump) return none_of<R>();
    return ((begin < -at_jump) & (end > at_jump)) | ((begin > at_jump) & (end < -at_jump));
  }
  BARRENO_FUNCTION bool variable_ratio() const { return G1 != 0.0 && G2 != 0.0; }
  BARRENO_FUNCTION bool grains_change() const {
    return stiffening != 0.0 || transition_compliance != 0.0;
  }

  template <class R>
  BARRENO_FUNCTION PressureTermOf<R> pressure_term(const R& I1, const R& evp) const {
    const MaskOf<R> pressed = (I1 < 0.0) & (evp <= jump);
    const bool same = B1 == 0.0 && !variable_ratio() && !grains_change();
    if (same || !real::any(pressed)) return {};
    const R inverse = 1.0 / real::select(pressed, I1, -1.0);
    const R ratio = B2 * inverse;
    const R value = real::select(pressed, real::exp(ratio), 0.0);
    const R slope = -ratio * inverse * value;
    return {value, slope, -slope * inverse * (ratio + 2.0)};
  }

  /// Elastic-plastic coupling B3 exp(B4/evp): crushed rock is softer than its pressure says
  /// [stress].
  template <class R>
  BARRENO_FUNCTION R coupling(const R& I1, const R& evp) const {
    if (B3 == 0.0) return R{};
    const MaskOf<R> coupled = (I1 < 0.0) & (evp < 0.0);
    if (!real::any(coupled)) return R{};
    return real::select(coupled, B3 * real::exp(R(B4 / real::select(coupled, evp, -1.0))), 0.0);
  }

  template <class R>
  BARRENO_FUNCTION ModuliOf<R> moduli(const R& I1, const R& pressure_value, const R& coupling_value)
      const {
    const R bulk = B0 + B1 * pressure_value - coupling_value;
    if (!variable_ratio()) return {of_grains(I1, pressure_value, bulk), R{} + G0};
    const R nu = G1 + G2 * pressure_value;
    const R shear = shear_from_ratio(bulk, nu);
    return {of_grains(I1, pressure_value, bulk), shear};
  }
  /// Bulk modulus with what the grains do under pressure [stress].
  /// @param bulk  without
  template <class R>
  BARRENO_FUNCTION R of_grains(const R& I1, const R& pressure_value, const R& bulk) const {
    if (!grains_change()) return bulk;
    const R pressure = (-1.0 / 3.0) * real::smaller(I1, 0.0);
    const R grains = bulk + stiffening * pressure * pressure_value;
    if (transition_compliance == 0.0) return grains;
    const R way = (pressure - transition_start) * per_transition;
    const MaskOf<R> within = (way > 0.0) & (way < 1.0) & (pressure_value > 0.0);
    if (!real::any(within)) return grains;
    const R compliance = real::select(within, transition_compliance * way * (1.0 - way), 0.0);
    return grains / (1.0 + compliance * grains);
  }
  template <class R>
  BARRENO_FUNCTION ModuliOf<R> moduli_at(const R& I1, const R& evp) const {
    return moduli(I1, pressure_term(I1, evp).value, coupling(I1, evp));
  }
  template <class R>
  BARRENO_FUNCTION ElasticStateOf<R> state_at(const R& I1, const R& evp) const {
    ElasticStateOf<R> n{I1, evp, pressure_term(I1, evp), coupling(I1, evp)};
    n.moduli = moduli(n.x, n.term.value, n.coupling);
    return n;
  }
  /// Moduli half way to a change of I1, to second order.
  template <class R>
  BARRENO_FUNCTION ModuliOf<R> moduli_midway(const ElasticStateOf<R>& n, const R& change) const {
    const R middle = n.term.value + 0.5 * n.term.slope * change;
    const R value = real::smaller(real::larger(middle, 0.0), 1.0);
    return moduli(R(n.x + 0.5 * change), value, n.coupling);
  }
  /// Moduli at the end of an elastic change of I1: a parabola in I1 for short ones in compression
  /// (its relative error in exp(B2/I1) is below (B2/I1 dI1/I1)^3, here 1e-6), else the exponential.
  /// @param asked where they are asked for
  template <class R>
  BARRENO_FUNCTION ModuliOf<R> moduli_after(
      const MaskOf<R>& asked, const ElasticStateOf<R>& n, const R& x_end
  ) const {
    constexpr double short_step = 0.01;
    const R change = x_end - n.x;
    const MaskOf<R> is_short =
        (n.x < 0.0) & (n.evp <= jump) &
        (real::abs(change) * (real::abs(n.x) + B2) <= short_step * n.x * n.x);
    R value = n.term.value + change * (n.term.slope + 0.5 * change * n.term.curvature);
    R coupled = n.coupling;
    if (real::any(asked & !is_short)) {
      value = real::select(is_short, value, pressure_term(x_end, n.evp).value);
      coupled = real::select(is_short, coupled, coupling(x_end, n.evp));
    }
    return moduli(x_end, value, coupled);
  }

  template <class R>
  BARRENO_FUNCTION static R shear_from_ratio(const R& bulk, const R& nu) {
    return 1.5 * bulk * (1.0 - 2.0 * nu) / (1.0 + nu);
  }

  static std::string check_bulk_modulus(const Parameters& p) {
    if (p.B1 > 0.0 && p.B2 == 0.0) {
      return named("B1", p.B1) +
             " with B2 = 0 makes the bulk modulus jump at zero pressure; set B2, the I1 over "
             "which it rises, or B1 = 0.";
    }
    if (p.B3 > 0.0 && p.B4 == 0.0) {
      return named("B3", p.B3) +
             " with B4 = 0 makes the bulk modulus jump at the first crushing; set B4, the "
             "plastic strain over which it falls, or B3 = 0.";
    }
    return {};
  }
  static std::string check_transition(const Parameters& p) {
    const std::string strain = named("Transition strain", p.transition_strain);
    const std::string start = named("Transition start", p.transition_start);
    const std::string end = named("Transition end", p.transition_end);
    if (p.transition_strain == 0.0) {
      const bool starts = p.transition_start > 0.0;
      if (!starts && p.transition_end == 0.0) return {};
      return (starts ? start : end) +
             " needs a Transition strain, by which the grains become denser; set it, or leave the "
             "transition out.";
    }
    if (!(p.transition_start > 0.0)) {
      return strain + " needs the pressure at which the transition begins; set Transition start.";
    }
    if (!(p.transition_end > p.transition_start)) {
      return end + " does not exceed " + start + " (grains turn into the denser phase between " +
             "them); raise the end.";
    }
    return {};
  }
  static std::string check_shear_modulus(const Parameters& p) {
    if (p.G3 != 0.0 || p.G4 != 0.0) {
      const bool third = p.G3 != 0.0;
      return named(third ? "G3" : "G4", third ? p.G3 : p.G4) +
             " has no effect in the published model and would be ignored; set it to 0.";
    }
    if ((p.G1 != 0.0) != (p.G2 != 0.0)) {
      return named("G1", p.G1) + " and " + named("G2", p.G2) +
             " have no effect unless both are set (else the shear modulus is G0); set both, or "
             "both "
             "to 0.";
    }
    if (p.G1 == 0.0) return {};
    for (const double nu : {p.G1, p.G1 + p.G2}) {
      if (nu > -1.0 && nu < 0.5) continue;
      return named("G1", p.G1) + " and " + named("G2", p.G2) + " give a Poisson's ratio of " +
             shown(nu) + ", outside -1 to 0.5 (negative shear modulus); change G1 or G2.";
    }
    // Cards carry few digits; a jump of 1e-3 in G at I1 = 0 is below what calibrations resolve.
    constexpr double digits = 1e-3;
    const double continuous = shear_from_ratio(p.B0, p.G1);
    if (!(std::fabs(p.G0 - continuous) <= digits * continuous)) {
      return named("G0", p.G0) + " must equal 1.5 B0 (1 - 2 G1)/(1 + G1) = " + shown(continuous) +
             " (the shear modulus would jump at zero pressure); set G0 to that.";
    }
    return {};
  }

  /// Upper bounds over all reachable states of rock whose grains do not change; without bound else.
  BARRENO_FUNCTION Moduli upper_bound() const {
    const Moduli published = published_bound();
    return {grains_change() ? HUGE_VAL : published.bulk, published.shear};
  }
  /// Bounds on the published part of the moduli.
  BARRENO_FUNCTION Moduli published_bound() const {
    const double bulk = B0 + B1;
    if (!variable_ratio()) return {bulk, G0};
    const double smallest_ratio = G2 < 0.0 ? G1 + G2 : G1;
    return {bulk, std::fmax(G0, shear_from_ratio(bulk, smallest_ratio))};
  }
};

}  // namespace barreno::arenisca
