// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/elasticity.hpp"
#include "barreno/models/arenisca_parameters.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace barreno {

/// Rules across Arenisca's parameters, each a sentence that names the parameter, or empty.
namespace arenisca {

/// "PEAKI1 = 2.1e+07": a parameter and its value, as messages name it.
inline std::string named(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s = %.6g", name, value);
  return text;
}

inline std::string check_surface(const AreniscaParameters& p) {
  const std::string FSLOPE = named("FSLOPE", p.FSLOPE), STREN = named("STREN", p.STREN);
  const std::string PEAKI1 = named("PEAKI1", p.PEAKI1), YSLOPE = named("YSLOPE", p.YSLOPE);
  if (p.FSLOPE == 0.0 && p.STREN == 0.0) {
    return FSLOPE + " and " + STREN +
           " leave the rock without any shear strength (the yield surface is "
           "empty); set FSLOPE, STREN or both.";
  }
  if (p.FSLOPE == 0.0 && p.PEAKI1 != 0.0) {
    return PEAKI1 +
           " needs a slope, but FSLOPE = 0 (STREN alone is the von Mises surface, which has no "
           "vertex); set FSLOPE, or PEAKI1 = 0.";
  }
  if (p.FSLOPE == 0.0 && p.YSLOPE != 0.0) {
    return YSLOPE +
           " exceeds FSLOPE = 0 (the limit surface would open backwards); set FSLOPE, or YSLOPE = "
           "0 "
           "for von Mises.";
  }
  if (p.STREN == 0.0 && p.YSLOPE != 0.0) {
    return YSLOPE +
           " is the slope at high pressure of the nonlinear surface, which needs STREN (now 0); "
           "set "
           "STREN, or YSLOPE = 0 for linear Drucker-Prager.";
  }
  if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.FSLOPE > p.YSLOPE)) {
    return YSLOPE + " is not below " + FSLOPE +
           " (the limit surface would open backwards); swap them?";
  }
  if (p.FSLOPE != 0.0 && p.STREN != 0.0 && !(p.STREN > p.YSLOPE * p.PEAKI1)) {
    return STREN + " must exceed YSLOPE*PEAKI1 = " + named("", p.YSLOPE * p.PEAKI1).substr(3) +
           " (the limit surface would open backwards); raise STREN or lower YSLOPE.";
  }
  return {};
}

inline std::string check_crush_curve(const AreniscaParameters& p) {
  if (p.p3_crush_curve == 0.0) return {};  // nonporous: no cap, p0 and p1 are not read
  if (!(p.p0_crush_curve < 0.0)) {
    return named("p0_crush_curve", p.p0_crush_curve) +
           " must be negative (it is the I1 at which crushing begins, tension positive); change "
           "its sign, or "
           "set p3_crush_curve = 0 for nonporous rock.";
  }
  if (!(p.p1_crush_curve > 0.0)) {
    return named("p1_crush_curve", p.p1_crush_curve) +
           " must be positive (else crushing softens the rock); change its sign, or set "
           "p3_crush_curve = 0 for "
           "nonporous rock.";
  }
  return {};
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
    return grains + " is below B0 + B1 = " + named("", p.B0 + p.B1).substr(3) +
           " (the rock would be stiffer than its grains); raise it.";
  }
  if (p.B0 > (1.0 - porosity) * matrix) {
    return named("B0", p.B0) + " exceeds (1 - porosity) times " + grains + " = " +
           named("", (1.0 - porosity) * matrix).substr(3) +
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

inline std::string check_angle(const AreniscaParameters& p) {
  constexpr double widest = 9.0 / 7.0;
  const bool narrow = p.J3_type == 1;
  if (narrow && !(p.J3_psi >= 1.0 / widest && p.J3_psi <= widest)) {
    return named("J3_psi", p.J3_psi) +
           " makes the Gudehus surface concave (it is convex from 7/9 to 9/7); change it, or use "
           "Willam-Warnke, which is convex from 1/2 to 2.";
  }
  if (p.J3_type == 0 && p.J3_psi != 1.0) {
    return named("J3_psi", p.J3_psi) +
           " has no effect without a J3_type (the shape of the section between J3_psi and 1); set "
           "J3_type, or set J3_psi to 1.";
  }
  return {};
}

inline std::string check_variability(const AreniscaParameters& p) {
  constexpr double max_seeds = 9007199254740992.0;  // 2^53: whole numbers that a double holds
  if (!(p.weibull_seed < max_seeds && p.weibull_seed == std::floor(p.weibull_seed))) {
    return named("Weibull seed", p.weibull_seed) +
           " is not a whole number below 2^53 (it numbers specimens); take 0, 1, 2 and so on.";
  }
  if (p.weibull_modulus == 0.0) {
    if (p.weibull_reference_volume == 0.0) return {};
    return named("Weibull reference volume", p.weibull_reference_volume) +
           " has no effect without a Weibull modulus (0: no scatter); set the modulus, or the "
           "volume to "
           "0.";
  }
  if (p.weibull_reference_volume == 0.0) {
    return named("Weibull modulus", p.weibull_modulus) +
           " needs a Weibull reference volume (strength depends on size); set that of the "
           "specimens that PEAKI1 was measured on.";
  }
  if (p.PEAKI1 == 0.0) {
    return named("Weibull modulus", p.weibull_modulus) +
           " has no effect with PEAKI1 = 0 (it is PEAKI1 that varies); set PEAKI1, or the modulus "
           "to 0.";
  }
  return {};
}

inline std::string check_bulk_modulus(const AreniscaParameters& p) {
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
  const double fall = p.p3_crush_curve > 0.0 ? p.B3 * std::exp(-p.B4 / p.p3_crush_curve) : 0.0;
  if (!(p.B0 - fall > 0.0)) {
    return named("B3", p.B3) + " makes the bulk modulus B0 - B3 exp(-B4/p3_crush_curve) = " +
           named("", p.B0 - fall).substr(3) +
           " negative when the pores are crushed; lower B3 or raise B0 or B4.";
  }
  return {};
}

inline std::string check_shear_modulus(const AreniscaParameters& p) {
  if (p.G3 != 0.0 || p.G4 != 0.0) {
    const bool third = p.G3 != 0.0;
    return named(third ? "G3" : "G4", third ? p.G3 : p.G4) +
           " has no effect in the published model and would be ignored; set it to 0.";
  }
  if ((p.G1 != 0.0) != (p.G2 != 0.0)) {
    return named("G1", p.G1) + " and " + named("G2", p.G2) +
           " have no effect unless both are set (else the shear modulus is G0); set both, or both "
           "to 0.";
  }
  if (p.G1 == 0.0) return {};
  for (const double nu : {p.G1, p.G1 + p.G2}) {
    if (nu > -1.0 && nu < 0.5) continue;
    return named("G1", p.G1) + " and " + named("G2", p.G2) + " give a Poisson's ratio of " +
           named("", nu).substr(3) +
           ", outside -1 to 0.5 (negative shear modulus); change G1 or G2.";
  }
  // Cards carry few digits; a jump of 1e-3 in G at I1 = 0 is below what calibrations resolve.
  constexpr double digits = 1e-3;
  const double continuous = Elasticity::shear_from_ratio(p.B0, p.G1);
  if (!(std::fabs(p.G0 - continuous) <= digits * continuous)) {
    return named("G0", p.G0) +
           " must equal 1.5 B0 (1 - 2 G1)/(1 + G1) = " + named("", continuous).substr(3) +
           " (the shear modulus would jump at zero pressure); set G0 to that.";
  }
  return {};
}

}  // namespace arenisca

inline std::string check_arenisca(const AreniscaParameters& p) {
  for (const auto& entry : arenisca_parameter_table().numbers) {
    if (entry.bounds.contain(p.*entry.member)) continue;
    return arenisca::named(entry.name, p.*entry.member) + " is out of range (" + entry.meaning +
           "); see the range in the manual.";
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
