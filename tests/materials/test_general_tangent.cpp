// SPDX-License-Identifier: BSD-3-Clause
/// The tangent of the general form against differences of plain steps, over the whole yield
/// surface.

#include "general_card.hpp"
#include "tangent_differences.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <string>
#include <variant>

namespace barreno::test {
namespace {

constexpr double time_step = 1e-6;

Sym3 quasi_static(const Sym3& stress, const GeneralArenisca::History& h) {
  return stress - Sym3{
                      h.overstress_xx,
                      h.overstress_yy,
                      h.overstress_zz,
                      h.overstress_xy,
                      h.overstress_yz,
                      h.overstress_zx};
}

/// Where on the yield surface a step has ended that began at a volumetric strain of the centre.
std::string region_of(
    const GeneralArenisca& model, const Point<GeneralArenisca>& p, double e_begin
) {
  const double e = p.history.plastic_volume_strain;
  if (e_begin * e < 0.0) return through_jump;
  if (p.last.plastic_work == 0.0) return "elastic";
  const arenisca::PointRock point(model.rock(), p.history.coherence, p.history.fluid_mass_ratio);
  const Sym3 stress = quasi_static(p.stress, p.history);
  const double q = std::sqrt(second_invariant(deviator(stress)));
  return region(trace(stress) - point.zeta(e), q, point.surface.vertex, point.cap_at(e));
}

void walk(const std::string& more, int paths) {
  const std::string tolerance = R"(
  <Parameter name="Tolerance" type="double" value="1e-3"/>)";
  const Material material = read_card(berea_card_with(more + tolerance, "general_tangent"));
  const auto& model = std::get<GeneralArenisca>(material.model);
  const auto region = [&](const auto& point, double e_begin) {
    return region_of(model, point, e_begin);
  };
  demand_tangents(compare_tangents(model, model, time_step, paths, region));
}

TEST(GeneralTangent, WetRockOverTheWholeYieldSurface) {
  walk(water_in_quartz + about_the_elastic_centre, 288);
}

TEST(GeneralTangent, AllThatTheGeneralFormKnows) {
  walk(everything_general + about_the_elastic_centre, 144);
}

}  // namespace
}  // namespace barreno::test
