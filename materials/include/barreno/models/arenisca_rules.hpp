// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/constituents.hpp"
#include "barreno/models/arenisca_parameters.hpp"

#include <cmath>
#include <string>

namespace barreno {

// Rules between the parts of Arenisca, each a sentence that names the parameter, or empty; those
// within a part are its own.
namespace arenisca {

/// Grains and fluid whose moduli change with the pressure.
inline std::string check_stiffening(const AreniscaParameters& p) {
  const std::string stiffening = named("Fluid stiffening", p.fluid_stiffening);
  if (p.fluid_B0 == 0.0) {
    if (p.fluid_stiffening == 0.0) return {};
    return stiffening +
           " needs a fluid, but fluid_B0 = 0 (dry rock); set fluid_B0, or leave it out.";
  }
  const bool grains = p.grain_stiffening > 0.0, turns = p.transition_strain > 0.0;
  if (!grains && !turns && p.fluid_stiffening == 0.0) return {};
  if (!is_poroplastic(p)) {
    const std::string first = grains  ? named("Grain stiffening", p.grain_stiffening)
                              : turns ? named("Transition strain", p.transition_strain)
                                      : stiffening;
    return first +
           " goes with fluid_B0 only in the form Backstress strain = poroplastic of rock with "
           "pores "
           "(the published forms have constant moduli of grains and fluid); set that form and "
           "p3_crush_curve, or leave it out.";
  }
  constexpr double jet = 40e9;  // Pa: what a fast jet brings to bear
  // Grains that turn into a denser phase may well give way more than the fluid.
  Constituents c = Constituents::make(p);
  c.transition_strain = 0.0;
  if (p.fluid_stiffening == 0.0 || c.fluid_strain(jet) > c.grain_strain(jet)) return {};
  return stiffening + " makes the fluid less compressible than the grains on the way to 40 GPa " +
         "(volumes fall to " + shown(std::exp(-c.fluid_strain(jet))) + " and " +
         shown(std::exp(-c.grain_strain(jet))) +
         "); lower it (water: about 8), or raise Grain stiffening (quartz: 5).";
}

inline std::string check_fluid(const AreniscaParameters& p) {
  if (p.fluid_B0 == 0.0) {
    if (p.fluid_pressure_initial == 0.0) return {};
    return named("fluid_pressure_initial", p.fluid_pressure_initial) +
           " needs a fluid, but fluid_B0 = 0 (dry rock); set fluid_B0, or the pressure to 0.";
  }
  if (is_poroplastic(p) && p.return_solver != 0) {
    return "Return solver = bisection does not go with Backstress strain = poroplastic (it is the "
           "published return, for dry rock and the published forms of the pore fluid); leave "
           "Return solver out, or set Backstress strain to one of the others.";
  }
  const double matrix = p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;
  const double porosity = -std::expm1(-p.p3_crush_curve);
  const std::string grains = named("Matrix bulk modulus", matrix);
  if (p.fluid_B0 > matrix) {
    return named("fluid_B0", p.fluid_B0) + " exceeds " + grains +
           " (the fluid would be stiffer than the grains); lower fluid_B0 or raise the other.";
  }
  if (p.B0 + p.B1 > matrix) {
    return grains + " is below B0 + B1 = " + shown(p.B0 + p.B1) +
           " (the rock would be stiffer than its grains); raise it.";
  }
  if (p.B0 > (1.0 - porosity) * matrix) {
    return named("B0", p.B0) + " exceeds (1 - porosity) times " + grains + " = " +
           shown((1.0 - porosity) * matrix) +
           " (pores would not soften the rock); lower B0 or p3_crush_curve, or raise the matrix "
           "bulk modulus.";
  }
  if (p.undrained_moduli == AreniscaParameters::arenisca3_moduli &&
      p.backstress_strain != AreniscaParameters::plastic_backstress) {
    return "Undrained moduli = arenisca3 belongs to the published backstress (the two were "
           "calibrated together); set Backstress strain to plastic.";
  }
  return {};
}

inline std::string check_scattered_vertex(const AreniscaParameters& p) {
  if (p.weibull_modulus > 0.0 && p.PEAKI1 == 0.0) {
    return named("Weibull modulus", p.weibull_modulus) +
           " has no effect with PEAKI1 = 0 (it is PEAKI1 that varies); set PEAKI1, or the modulus "
           "to 0.";
  }
  return {};
}

inline std::string check_crushed_bulk_modulus(const AreniscaParameters& p) {
  const double fall = p.p3_crush_curve > 0.0 ? p.B3 * std::exp(-p.B4 / p.p3_crush_curve) : 0.0;
  if (!(p.B0 - fall > 0.0)) {
    return named("B3", p.B3) +
           " makes the bulk modulus B0 - B3 exp(-B4/p3_crush_curve) = " + shown(p.B0 - fall) +
           " negative when the pores are crushed; lower B3 or raise B0 or B4.";
  }
  return {};
}

/// What damage takes and leaves must be there.
inline std::string check_damage(const AreniscaParameters& p) {
  if (p.fracture_strain == 0.0) return {};
  constexpr double steepest =
      0.57735026918962576;  // 1/sqrt(3): sqrt(J2) over -I1 without confinement
  const std::string strain = named("Fracture strain", p.fracture_strain);
  if (p.PEAKI1 == 0.0) {
    return strain +
           " has no effect with PEAKI1 = 0 (rock without tensile strength has no cohesion to "
           "lose); "
           "set PEAKI1, or leave the damage out.";
  }
  const bool other = count_of_others(p) > 0;
  if (p.J3_type != 0 || other || !is_plain_law(p, p.fluid_B0 > 0.0)) {
    return strain +
           " (damage) goes with neither J3_type, the bisection, a published pore fluid nor parts "
           "from outside; leave those or the damage out.";
  }
  const bool own = p.residual_slope > 0.0;
  const std::string slope = own ? named("Residual slope", p.residual_slope)
                                : named("FSLOPE", p.FSLOPE) + " without a Residual slope";
  if (own && p.residual_slope > p.FSLOPE) {
    return slope + " exceeds " + named("FSLOPE", p.FSLOPE) +
           " (rock would gain strength when it breaks); lower it.";
  }
  if (!((own ? p.residual_slope : p.FSLOPE) < steepest)) {
    return slope + " leaves broken rock a strength without confinement (its slope is not below " +
           "1/sqrt(3) = 0.577); set Residual slope, about 0.4 for a friction angle of 50 degrees.";
  }
  if (own && !(p.residual_slope > p.YSLOPE)) {
    return slope + " is not above " + named("YSLOPE", p.YSLOPE) +
           " (the limit surface of broken rock would open backwards); raise it.";
  }
  return {};
}

/// The bound on tension falls with damage.
inline std::string check_tension(const AreniscaParameters& p) {
  if (p.tension_cutoff == 0.0 || p.fracture_strain > 0.0) return {};
  return named("Tension cutoff", p.tension_cutoff) +
         " needs a Fracture strain, but that is 0 (rock without damage, whose cracks would keep "
         "their strength); set the plastic strain at which rock under tension is broken, 0.01 for "
         "example, or leave Tension cutoff out.";
}

/// Heat goes with what damage goes with.
inline std::string check_heat(const AreniscaParameters& p) {
  if (p.specific_heat == 0.0) return {};
  const bool other = count_of_others(p) > 0;
  if (p.J3_type == 0 && !other && is_plain_law(p, p.fluid_B0 > 0.0)) return {};
  return named("Specific heat", p.specific_heat) +
         " (heat) goes with neither J3_type, the bisection, a published pore fluid nor parts from "
         "outside; leave those or the heat out.";
}

/// So do grains that break.
inline std::string check_breakage(const AreniscaParameters& p) {
  if (p.breakage_energy == 0.0) return {};
  const bool other = count_of_others(p) > 0;
  if (p.J3_type == 0 && !other && is_plain_law(p, p.fluid_B0 > 0.0)) return {};
  return named("Breakage energy", p.breakage_energy) +
         " (grains that break) goes with neither J3_type, the bisection, a published pore fluid "
         "nor parts from outside; leave those or the breakage out.";
}

/// One part in place of a published one, in rock without the features that have forms of their own.
inline std::string check_other_parts(const AreniscaParameters& p) {
  std::string words;
  for_each_part(OtherParts{}, [&](const auto* part) {
    using Part = std::decay_t<decltype(*part)>;
    if (Part::asked(p)) words += (words.empty() ? "" : " and ") + std::string(Part::word);
  });
  if (count_of_others(p) > 1) return words + " exclude each other; keep one of them.";
  if (words.empty() || (is_plain(p) && is_plain_law(p, p.fluid_B0 > 0.0))) return {};
  return words +
         " goes with neither rate dependence, J3_type, a Weibull modulus, the bisection nor a "
         "published pore fluid; leave those out.";
}

template <class... Parts>
std::string check_parts(const AreniscaParameters& p, PartList<Parts...> /*list*/) {
  std::string problem;
  (void)((problem = Parts::check(p), !problem.empty()) || ...);
  return problem;
}

}  // namespace arenisca

inline std::string check_arenisca(const AreniscaParameters& p) {
  for (const auto& entry : arenisca_parameter_table().numbers) {
    if (entry.bounds.contain(p.*entry.member)) continue;
    return arenisca::named(entry.name, p.*entry.member) + " is out of range (" + entry.meaning +
           "); see the range in the manual.";
  }
  std::string problem = arenisca::check_parts(p, arenisca::AllParts{});
  for (const auto rule :
       {arenisca::check_fluid,
        arenisca::check_stiffening,
        arenisca::check_scattered_vertex,
        arenisca::check_crushed_bulk_modulus,
        arenisca::check_damage,
        arenisca::check_tension,
        arenisca::check_heat,
        arenisca::check_breakage,
        arenisca::check_other_parts})
    if (problem.empty()) problem = rule(p);
  return problem;
}

}  // namespace barreno
