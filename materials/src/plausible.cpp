// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/plausible.hpp"

#include "barreno/registry.hpp"

#include <cmath>
#include <map>

namespace barreno {
namespace {

using Ranges = std::vector<PlausibleRange>;

/// From foams to osmium (22.6 g/cm3) [kg/m3].
constexpr PlausibleRange density = {"Density", 10.0, 25e3};

/// Moduli from gels (some 100 Pa in shear) to diamond (442 GPa in bulk, 535 GPa in
/// shear): Ashby, Materials Selection in Mechanical Design, material property charts [Pa].
constexpr double softest = 1e2, stiffest = 1e12;

/// From loose sand to dense quartz and carbonate rock: Mavko, Mukerji and Dvorkin, The Rock Physics
/// Handbook, appendix A [Pa].
constexpr double softest_ground = 1e5;

/// Fluids in pores: gas at one atmosphere (K = pressure, 0.1 MPa) to mercury (25 GPa); water has
/// 2.2 GPa, oil 1 to 2 GPa (Batzle and Wang 1992, Geophysics 57:1396) [Pa].
constexpr double softest_fluid = 5e4, stiffest_fluid = 3e10;

/// Strengths, from loose ground to the strength of intact minerals at high pressure [Pa].
constexpr double weakest = 1e3, strongest = 1e11;

/// Pressures of pore fluids, from a centimetre of water to 2 GPa [Pa].
constexpr double least_pressure = 1e2, most_pressure = 2e9;

const Ranges arenisca_ranges = {
    density,
    {"PEAKI1", weakest, strongest},
    {"STREN", weakest, strongest},
    {"B0", softest_ground, stiffest},
    {"B1", softest_ground, stiffest},
    {"B2", weakest, strongest},
    {"B3", weakest, stiffest},
    {"G0", softest_ground, stiffest},
    {"p0_crush_curve", weakest, strongest, true},
    // Its inverse is the pressure over which pores crush.
    {"p1_crush_curve", 1.0 / strongest, 1.0 / weakest, true},
    {"fluid_B0", softest_fluid, stiffest_fluid},
    {"fluid_pressure_initial", least_pressure, most_pressure},
    {"Fluid Density", 0.1, 15e3},  // gas to mercury
    {"Matrix bulk modulus", 1e8, stiffest},
    {"Weibull reference volume", 1e-12, 1e3}};

/// Dobratz and Crawford 1985, LLNL Explosives Handbook, UCRL-52997: detonation from 1.5 to 10 km/s,
/// A from 40 to 2000 GPa, E0 from 1 to 13 GPa; with a margin for diluted and emulsion explosives.
const Ranges explosive = {
    density,
    {"Detonation Speed", 500.0, 2e4},
    {"A", 1e8, 1e14},
    {"B", 1e6, 1e13, true},
    {"Energy", 1e7, 1e11},
    {"Unreacted Bulk Modulus", 1e7, 1e12}};

const Ranges elastic = {
    density, {"Bulk Modulus", softest, stiffest}, {"Shear Modulus", softest, stiffest}};

const Ranges poroelastic = {
    density,
    {"Bulk Modulus", softest, stiffest},
    {"Shear Modulus", softest, stiffest},
    {"Fluid Bulk Modulus", softest_fluid, stiffest_fluid},
    {"Grain Bulk Modulus", 1e8, stiffest},
    {"Initial Pore Pressure", least_pressure, most_pressure, true}};

/// Ranges by the name of a model: those above, and those that a model says itself.
std::map<std::string, Ranges> all_ranges() {
  std::map<std::string, Ranges> ranges = {
      {"Arenisca", arenisca_ranges},
      {"JWL Explosive", explosive},
      {"Linear Elastic", elastic},
      {"Neo-Hookean", elastic},
      {"Poroelastic", poroelastic}};
  for (const ModelDescription& model : describe_models()) {
    if (model.plausible.empty()) continue;
    Ranges& of_model = ranges[model.name] = {density};
    of_model.insert(of_model.end(), model.plausible.begin(), model.plausible.end());
  }
  return ranges;
}

}  // namespace

bool PlausibleRange::holds(double value) const {
  const double size = of_magnitude ? std::fabs(value) : value;
  return value == 0.0 || (size >= lower && size <= upper);
}

const std::vector<PlausibleRange>& plausible_ranges(const std::string& model) {
  static const std::map<std::string, Ranges> ranges = all_ranges();
  static const Ranges unknown;
  const auto found = ranges.find(model);
  return found == ranges.end() ? unknown : found->second;
}

const PlausibleRange* find_plausible_range(const std::string& model, const std::string& parameter) {
  for (const PlausibleRange& range : plausible_ranges(model))
    if (parameter == range.parameter) return &range;
  return nullptr;
}

}  // namespace barreno
