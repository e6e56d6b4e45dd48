// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// The constants of rock_permeability(). `barreno describe --report-tables` gives them to the
/// report and to `barreno flow` (src/python/barreno/report/porosity.py).
struct PermeabilityLaw {
  /// The least that enters a skin: of rock whose pores are closed.
  static constexpr double least = 1e-4;
  /// The most that pores alone give: rock that opens breaks in cracks, not in wider pores. Assumed.
  static constexpr double most = 3.0;
  /// Of rock whose grains are fully broken, with the porosity of virgin rock. Fitted.
  static constexpr double of_broken = 0.3;
  /// Rock below it counts as impaired: the upper bound that is published for the zone.
  static constexpr double impaired = 0.7;
};

/// Permeability over that of virgin rock,
///
///   k/k_0 = min((phi/phi_0)^3 ((1 - phi_0)/(1 - phi))^2, 3) / (1 + s B)^2
///
/// after Kozeny and Carman, whose k ~ phi^3/(S (1 - phi))^2 falls with the surface S of the grains
/// per volume of theirs. Broken grains have more of it: S/S_0 = 1 + s B in a mixture of whole
/// grains and of fully broken ones (a part B, the breakage), with s from
/// PermeabilityLaw::of_broken.
///
/// @param porosity  that plastic flow has left
/// @param virgin    phi_0
/// @param breakage  B, 0 in rock without such a history
double rock_permeability(double porosity, double virgin, double breakage);

}  // namespace barreno
