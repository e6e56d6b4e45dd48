// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// Wet rock around the dry law, with the pressure as an unknown of its own.
namespace barreno::test {

/// Volume that grains and fluid take less the volume there is, over the volume at the start.
struct Balance {
  const WetArenisca& model;
  const Sym3 strain;
  const Sym3 begin;  ///< effective stress
  const WetArenisca::History h;
  Sym3 end{};
  Arenisca::History dry{};

  /// With this rise of the pressure; leaves stress and history of the dry rock behind.
  double excess(const Arenisca& skeleton, double rise) {
    const arenisca::Constituents& c = model.rock().constituents;
    Increment increment;
    increment.strain = strain + isotropic(rise / (3.0 * c.matrix));
    end = begin;
    dry = {h.plastic_volume_strain, h.equivalent_plastic_strain};
    EXPECT_FALSE(skeleton.update(increment, end, dry).failed());
    const double solid = 1.0 - h.porosity, fluid = h.porosity - h.gas;
    const double load = -trace(end - begin) / 3.0;
    return solid * std::exp(-(load / solid + rise) / c.matrix) + fluid * std::exp(-rise / c.fluid) -
           std::exp(trace(strain));
  }
};

/// A step of wet rock by halving the rise of the pressure around the dry law: its own solution of
/// the same equations, without their derivatives.
inline void step_by_halving(
    const WetArenisca& model,
    const Arenisca& skeleton,
    const Sym3& strain,
    Sym3& stress,
    WetArenisca::History& h
) {
  constexpr int halvings = 80;
  const double p = h.pore_pressure;
  Balance balance{model, strain, stress + isotropic(p), h};
  double low = -p, high = 20e9;
  if (balance.excess(skeleton, low) <= 0.0) high = low;  // gas
  for (int i = 0; i < halvings && high > low; ++i) {
    const double rise = 0.5 * (low + high);
    (balance.excess(skeleton, rise) > 0.0 ? low : high) = rise;
  }
  balance.excess(skeleton, high);
  const arenisca::Constituents& c = model.rock().constituents;
  const double solid = 1.0 - h.porosity, fluid = h.porosity - h.gas;
  const double load = -trace(balance.end - balance.begin) / 3.0, volume = std::exp(trace(strain));
  h.porosity = 1.0 - solid * std::exp(-(load / solid + high) / c.matrix) / volume;
  h.gas = std::fmax(0.0, h.porosity - fluid * std::exp(-high / c.fluid) / volume);
  h.pore_pressure = p + high;
  if (h.pore_pressure > 0.0) h.gas = 0.0;
  h.plastic_volume_strain = balance.dry.plastic_volume_strain;
  h.equivalent_plastic_strain = balance.dry.equivalent_plastic_strain;
  stress = balance.end - isotropic(h.pore_pressure);
}

}  // namespace barreno::test
