// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/list.hpp"

#include <type_traits>

namespace barreno {
/// What a card says about Arenisca; published names. Each part of the law has its own.
struct AreniscaParameters : ParametersOf<arenisca::AllParts> {};

inline ParameterTable<AreniscaParameters> arenisca_parameter_table() {
  ParameterTable<AreniscaParameters> table;
  for_each_part(arenisca::AllParts{}, [&](const auto* part) {
    add_table(std::decay_t<decltype(*part)>::parameter_table(), table);
  });
  return table;
}

namespace arenisca {

/// How many parts a card asks for in place of published ones.
inline int count_of_others(const AreniscaParameters& p) {
  int count = 0;
  for_each_part(OtherParts{}, [&](const auto* part) {
    count += std::decay_t<decltype(*part)>::asked(p) ? 1 : 0;
  });
  return count;
}

/// Fluid in the pores, in the poroplastic form.
inline bool is_poroplastic(const AreniscaParameters& p) {
  return p.fluid_B0 > 0.0 && p.p3_crush_curve > 0.0 &&
         p.backstress_strain == AreniscaParameters::poroplastic;
}
/// With damage, or with grains that break: both are histories of the damaged forms.
inline bool has_damage(const AreniscaParameters& p) {
  return p.fracture_strain > 0.0 || p.breakage_energy > 0.0;
}
/// Neither third invariant nor rate dependence nor variability nor damage nor heat, with the fast
/// return.
inline bool is_plain(const AreniscaParameters& p) {
  return p.T1_rate_dependence == 0.0 && p.J3_type == 0 && p.weibull_modulus == 0.0 &&
         !has_damage(p) && p.specific_heat == 0.0 && p.return_solver == 0;
}

/// Dry rock of which nothing but the strength varies, with the fast return.
inline bool is_scattered(const AreniscaParameters& p) {
  return p.weibull_modulus > 0.0 && p.fluid_B0 == 0.0 && p.T1_rate_dependence == 0.0 &&
         p.J3_type == 0 && !has_damage(p) && p.specific_heat == 0.0 && p.return_solver == 0;
}

/// Dry rock, or wet rock in the poroplastic form; with the fast return: not a form for comparison.
inline bool is_plain_law(const AreniscaParameters& p, bool wet) {
  return p.return_solver == 0 && (wet ? is_poroplastic(p) : p.fluid_B0 == 0.0);
}
/// With damage, which excludes the third invariant (arenisca_rules.hpp).
inline bool is_damaged(const AreniscaParameters& p, bool wet) {
  return is_plain_law(p, wet) && p.T1_rate_dependence == 0.0 && has_damage(p) &&
         p.specific_heat == 0.0;
}
/// With heat, and with damage or without; it excludes the same.
inline bool is_heated(const AreniscaParameters& p, bool wet) {
  return is_plain_law(p, wet) && p.T1_rate_dependence == 0.0 && p.specific_heat > 0.0;
}
/// With rate dependence, and with damage, heat or both.
inline bool is_rated_heated(const AreniscaParameters& p, bool wet) {
  return is_plain_law(p, wet) && p.T1_rate_dependence > 0.0 &&
         (has_damage(p) || p.specific_heat > 0.0);
}
/// With third invariant.
inline bool is_angled(const AreniscaParameters& p, bool wet) {
  return is_plain_law(p, wet) && p.J3_type != 0;
}
/// With rate dependence, or wet and of scattering strength.
inline bool is_rated(const AreniscaParameters& p, bool wet) {
  return is_plain_law(p, wet) && p.J3_type == 0 && !has_damage(p) && p.specific_heat == 0.0 &&
         (p.T1_rate_dependence > 0.0 || (wet && p.weibull_modulus > 0.0));
}

}  // namespace arenisca
}  // namespace barreno
