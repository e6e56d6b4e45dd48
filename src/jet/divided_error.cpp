// SPDX-License-Identifier: BSD-3-Clause
#include "jet/divided_error.hpp"

#include "base/format.hpp"
#include "jet/failure.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"

#include <barreno/models.hpp>
#include <cmath>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

/// The jet of perforation.xml (verification/results/depth_shots.json).
constexpr int measured_splits = 4, measured_particles_per_cell = 2;
constexpr double measured_end = 400e-6;   ///< with the measured radius and tip velocity [time]
constexpr double measured_length = 0.55;  ///< of the tip's slug, in radii
constexpr double slowest_slug = 400.0;    ///< [velocity]
constexpr double least_filled = 0.051;
constexpr double least_confinement = 34e6;  ///< of a hole whose volume rests [stress]
constexpr double measured_dilatancy = 1.0, measured_damage_pressure = 1e9;  ///< [-], [stress]
/// How far another jet may be from it: no other was run.
constexpr double farthest_jet = 1.1;
constexpr double rested = 0.9;  ///< of measured_end: a run at rest may end earlier
constexpr double round_off = 1e-6;

template <class Parameters, class = void>
constexpr bool grains_can_break = false;
template <class Parameters>
constexpr bool grains_can_break<
    Parameters,
    std::void_t<
        decltype(Parameters::breakage_energy),
        decltype(Parameters::broken_dilatancy),
        decltype(Parameters::damage_pressure)>> = true;

/// Broken rock that nothing holds flies apart, and its hole goes on growing.
bool is_bare(const Scene& scene) {
  const BodySpec* rock = longest_solid(scene);
  return rock != nullptr && rock->initial_pressure < least_confinement;
}

bool is_like(double ratio) {
  return is_within(ratio, farthest_jet);
}

std::string why_jet_unknown(const Scene& scene, const JetEstimate& estimate) {
  if (scene.jet.particles_per_cell != measured_particles_per_cell)
    return format(
        "of divided particles it was measured with %d per cell only", measured_particles_per_cell
    );
  if (!is_like(scene.jet.slugs.front().velocity / measured_velocity))
    return format("it was measured with a tip of %g m/s only", measured_velocity);
  if (!is_like(estimate.thinnest / measured_radius))
    return format("it was measured with a radius of %g mm only", 1e3 * measured_radius);
  if (!is_like(estimate.length / estimate.thinnest / measured_length))
    return format("it was measured with slugs %g times as long as their radius", measured_length);
  if (estimate.slowest * farthest_jet < slowest_slug)
    return format("it was measured with slugs faster than %g m/s only", slowest_slug);
  if (estimate.least_filled * farthest_jet < least_filled)
    return format(
        "it was measured with slugs that fill at least %g of their flight only", least_filled
    );
  return {};
}

std::string why_cells_unknown(const DepthTables& tables, double cells) {
  const double fewest = tables.divided.front().cells_per_radius;
  const double most = tables.divided.back().cells_per_radius;
  if (cells >= fewest * (1.0 - round_off) && cells <= most * (1.0 + round_off)) return {};
  return format(
      "of divided particles it was measured with %g to %g cells per radius only", fewest, most
  );
}

/// Between the cells that were measured, over their logarithm.
DepthError error_with(const DepthTables& tables, double cells, DepthError DividedError::*whose) {
  std::size_t upper = 1;
  while (upper + 1 < tables.divided.size() && cells > tables.divided[upper].cells_per_radius)
    ++upper;
  const DividedError &coarse = tables.divided[upper - 1], &fine = tables.divided[upper];
  return error_between(
      cells, coarse.cells_per_radius, coarse.*whose, fine.cells_per_radius, fine.*whose
  );
}

DepthDoubt doubt_of(
    const Scene& scene, double time, const DepthTables& tables, DepthError DividedError::*whose
) {
  const JetEstimate estimate = estimate_jet(scene, time);
  const double cell = cell_size_of_path(scene);
  DepthDoubt doubt;
  doubt.cells_per_radius = estimate.thinnest / cell;
  doubt.cells_per_length = estimate.length / cell;
  doubt.unknown = estimate.thinnest == 0.0 ? "the jet does not reach a target by then"
                                           : why_scene_unmeasured(tables, scene);
  if (doubt.unknown.empty()) doubt.unknown = why_jet_unknown(scene, estimate);
  if (doubt.unknown.empty()) doubt.unknown = why_cells_unknown(tables, doubt.cells_per_radius);
  if (doubt.unknown.empty()) doubt.error = error_with(tables, doubt.cells_per_radius, whose);
  return doubt;
}

/// The end of what was measured, for this jet.
double end_of(const Scene& scene) {
  return measured_end * measured_velocity / scene.jet.slugs.front().velocity;
}

}  // namespace

bool is_divided(const Scene& scene) {
  return scene.jet.present && scene.jet.splits >= measured_splits &&
         breaks(scene.materials[static_cast<std::size_t>(scene.jet.material)]);
}

DepthDoubt divided_depth_doubt(const Scene& scene, double time, const DepthTables& tables) {
  const double end = end_of(scene);
  const bool later = time > end * (1.0 + round_off);
  // A run to rest that ends at its longest time is not at rest.
  const bool rests = later && scene.at_rest && time < scene.end_time;
  DepthDoubt doubt =
      doubt_of(scene, time, tables, rests ? &DividedError::resting : &DividedError::depth);
  if (doubt.unknown.empty() && later && !rests)
    doubt.unknown = format(
        "it was measured until %.3g us and at rest only; what a hole narrower than the jet grows "
        "later follows the cells",
        1e6 * end
    );
  return doubt;
}

namespace {

/// Of a hole whose jet is divided and has not left the target.
DepthDoubt hole_doubt(
    const Scene& scene,
    double time,
    const Penetration& found,
    const DepthTables& tables,
    DepthError DividedError::*whose
) {
  DepthDoubt doubt;
  if (!is_divided(scene))
    doubt.unknown =
        format("it was measured with particles that are divided %d times only", measured_splits);
  else if (found.through)
    doubt.unknown = "the jet has come out of the rear of the target";
  else
    doubt = doubt_of(scene, time, tables, whose);
  return doubt;
}

}  // namespace

DepthDoubt probed_depth_doubt(
    const Scene& scene, double time, const Penetration& found, const DepthTables& tables
) {
  return hole_doubt(scene, time, found, tables, &DividedError::probed);
}

namespace {

/// A doubt about what rests only where something holds the rock.
DepthDoubt where_held(const Scene& scene, DepthDoubt doubt) {
  if (doubt.unknown.empty() && is_bare(scene))
    doubt.unknown = format(
        "it was measured under a confinement of %g MPa and more only; broken rock that nothing "
        "holds flies apart",
        1e-6 * least_confinement
    );
  return doubt;
}

/// What decides the pores and the grains of the crushed zone; 0 in other materials.
struct BreakingRock {
  double breakage_energy = 0.0, broken_dilatancy = 0.0, damage_pressure = 0.0;
};
BreakingRock breaking_rock(const MaterialSpec& material) {
  return std::visit(
      [](const auto& model) -> BreakingRock {
        using Parameters = typename std::decay_t<decltype(model)>::Parameters;
        if constexpr (grains_can_break<Parameters>) {
          const Parameters& p = model.parameters();
          return {p.breakage_energy, p.broken_dilatancy, p.damage_pressure};
        } else {
          return {};
        }
      },
      material.material().model
  );
}

std::string why_rock_unknown(const Scene& scene) {
  const BodySpec& body = *longest_solid(scene);  // the scene is as measured, with one
  const BreakingRock rock = breaking_rock(scene.materials[static_cast<std::size_t>(body.material)]);
  if (!(rock.breakage_energy > 0.0))
    return "it was measured in rock whose grains break only (Breakage energy)";
  if (rock.broken_dilatancy != measured_dilatancy ||
      !is_like(rock.damage_pressure / measured_damage_pressure))
    return format(
        "it was measured with a Broken dilatancy of %g and a Damage pressure of %g GPa only",
        measured_dilatancy,
        1e-9 * measured_damage_pressure
    );
  return {};
}

}  // namespace

DepthDoubt volume_doubt(
    const Scene& scene, double time, const Penetration& found, const DepthTables& tables
) {
  return where_held(scene, hole_doubt(scene, time, found, tables, &DividedError::volume));
}

DepthDoubt efficiency_doubt(
    const Scene& scene, double time, const Penetration& found, const DepthTables& tables
) {
  DepthDoubt doubt =
      where_held(scene, hole_doubt(scene, time, found, tables, &DividedError::efficiency));
  if (doubt.unknown.empty()) doubt.unknown = why_rock_unknown(scene);
  const double end = end_of(scene);
  if (doubt.unknown.empty() && time < rested * end)
    doubt.unknown = format("it was measured at %.3g us only, when the hole is at rest", 1e6 * end);
  return doubt;
}

}  // namespace barreno
