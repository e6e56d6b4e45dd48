// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <vector>

namespace barreno {

/// What a card says about Arenisca; published names. Meanings: arenisca_parameter_table().
struct AreniscaParameters {
  double PEAKI1, FSLOPE, STREN, YSLOPE, BETA_nonassociativity;
  double B0, B1, B2, B3, B4;
  double G0, G1, G2, G3, G4;
  double p0_crush_curve, p1_crush_curve, p3_crush_curve, CR;
  double tolerance;
  double fluid_B0, fluid_pressure_initial, matrix_bulk_modulus;
  double T1_rate_dependence, T2_rate_dependence;
  double J3_psi;
  double weibull_modulus, weibull_reference_volume, weibull_seed;
  int return_solver, backstress_strain, undrained_moduli, J3_type, weibull_volume, weibull_scatter;

  /// Indices of words.
  static constexpr int elastic_centre = 0, plastic_backstress = 1, poroplastic = 2;
  static constexpr int arenisca3_moduli = 1;
  static constexpr int ring_volume = 1, scale_only = 1;
};

namespace arenisca {

/// Fluid in the pores, in the poroplastic form.
inline bool is_poroplastic(const AreniscaParameters& p) {
  return p.fluid_B0 > 0.0 && p.p3_crush_curve > 0.0 &&
         p.backstress_strain == AreniscaParameters::poroplastic;
}
/// Neither third invariant nor rate dependence nor variability, with the fast return.
inline bool is_plain(const AreniscaParameters& p) {
  return p.T1_rate_dependence == 0.0 && p.J3_type == 0 && p.weibull_modulus == 0.0 &&
         p.return_solver == 0;
}

/// Dry rock of which nothing but the strength varies, with the fast return.
inline bool is_scattered(const AreniscaParameters& p) {
  return p.weibull_modulus > 0.0 && p.fluid_B0 == 0.0 && p.T1_rate_dependence == 0.0 &&
         p.J3_type == 0 && p.return_solver == 0;
}

/// Dry rock, or wet rock in the poroplastic form; with the fast return.
inline bool goes_in_lanes(const AreniscaParameters& p, bool wet) {
  return p.return_solver == 0 && (wet ? is_poroplastic(p) : p.fluid_B0 == 0.0);
}
/// With third invariant.
inline bool is_angled(const AreniscaParameters& p, bool wet) {
  return goes_in_lanes(p, wet) && p.J3_type != 0;
}
/// With rate dependence, or wet and of scattering strength.
inline bool is_rated(const AreniscaParameters& p, bool wet) {
  return goes_in_lanes(p, wet) && p.J3_type == 0 &&
         (p.T1_rate_dependence > 0.0 || (wet && p.weibull_modulus > 0.0));
}

using Entries = std::vector<ParameterEntry<AreniscaParameters>>;

inline Entries strength_entries() {
  using P = AreniscaParameters;
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
  using P = AreniscaParameters;
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
  using P = AreniscaParameters;
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
  using P = AreniscaParameters;
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
          "initial pressure of the fluid"
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
  using P = AreniscaParameters;
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
  using P = AreniscaParameters;
  namespace d = dimension;
  return {
      optional(
          &P::weibull_modulus,
          "Weibull modulus",
          d::none,
          at_least(0.0),
          0.0,
          "m: PEAKI1 varies from particle to particle, less with larger m; 0: no variation"
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
          "whole number; each gives another specimen of the same rock"
      )};
}

}  // namespace arenisca

inline ParameterTable<AreniscaParameters> arenisca_parameter_table() {
  ParameterTable<AreniscaParameters> table;
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
      {&AreniscaParameters::return_solver,
       "Return solver",
       {"fast", "bisection"},
       0,
       "fast: one superlinear scalar solve; bisection: the published nested method, the oracle "
       "(not "
       "with poroplastic fluid)"},
      {&AreniscaParameters::backstress_strain,
       "Backstress strain",
       {"elastic centre", "plastic", "poroplastic"},
       AreniscaParameters::poroplastic,
       "effect of the fluid on the rock; poroplastic: strength, flow and crush curve are those of "
       "dry rock under the effective stress, stress plus pore pressure. The others are for "
       "comparison and ten times as expensive: plastic: the published form, for its calibrations; "
       "elastic centre: the same about the strain of zero effective stress"},
      {&AreniscaParameters::undrained_moduli,
       "Undrained moduli",
       {"biot", "arenisca3"},
       0,
       "of the plastic form; arenisca3: those of the published code (2 to 5 % too stiff, no B1), "
       "for its "
       "calibrations"},
      {&AreniscaParameters::J3_type,
       "J3_type",
       {"none", "Gudehus", "Willam-Warnke", "Mohr-Coulomb"},
       0,
       "dependence of the strength on the Lode angle"},
      {&AreniscaParameters::weibull_volume,
       "Weibull volume",
       {"cube", "ring"},
       0,
       "volume of a particle for the scale effect: the cube over its face in the plane, the same "
       "at "
       "any distance from the axis; ring: its own (full circle, or per unit thickness)"},
      {&AreniscaParameters::weibull_scatter,
       "Weibull scatter",
       {"random", "scale only"},
       0,
       "scale only: every particle has the mean of its size"}};
  return table;
}

}  // namespace barreno
