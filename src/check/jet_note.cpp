// SPDX-License-Identifier: BSD-3-Clause
#include "check/jet_note.hpp"

#include "base/format.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "jet/estimate.hpp"
#include "jet/failure.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"
#include "state/bodies/box_divisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

/// The entry of the deck that ends a run in any case.
std::string end_path(const Scene& scene) {
  return scene.at_rest ? path_of(&TimeSpec::longest_time) : path_of(&TimeSpec::end_time);
}
std::string end_words(const Scene& scene) {
  return end_path(scene) + format(" = %g s", scene.end_time);
}

/// Nothing but the rim of the widest slugs meets a body.
bool only_grazes(const Scene& scene) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const JetSlug& slug : scene.jet.slugs) thinnest = std::min(thinnest, slug.radius);
  return path_layers(scene, thinnest).empty();
}

/// Slugs that arrive when the hole is hardly wider than they are, and still dig [m/s].
constexpr double slowest_that_digs = 1000.0, fastest_late = 2500.0;
/// Of a disc, which it needs to flow aside: measured in docs/verification/late_train.md.
constexpr long long fewest_layers = 3;
/// Which do as well, measured there.
constexpr int enough_splits = 4;

/// Length at the metal's own density of the shortest late slug that is shorter than its radius; 0
/// if there is none.
double thinnest_late_disc(const Scene& scene, const MaterialSpec& metal) {
  double thinnest = 0.0;
  for (const JetSlug& slug : scene.jet.slugs) {
    const double length = slug.length * slug.density / metal.density();
    if (slug.velocity > slowest_that_digs && slug.velocity < fastest_late && length < slug.radius &&
        (thinnest == 0.0 || length < thinnest))
      thinnest = length;
  }
  return thinnest;
}

}  // namespace

std::string jet_note(const Scene& scene) {
  if (!scene.jet.present) return {};
  const JetPath path = jet_path(scene);
  const char* const along = path.direction > 0.0 ? "+y" : "-y";
  if (!path.has_target && !path_layers(scene, widest_radius(scene)).empty())
    return "the jet meets liquids alone, so no depth will be computed (a depth is one in solids); "
           "if it should, place a solid body behind them";
  if (!path.has_target)
    return format(
               "the jet hits no body (none lies in its path along %s from y = %g m), so no depth "
               "will be computed; ",
               along,
               scene.jet.launch_position
           ) +
           "if it should, reverse Jet/Direction, or move Jet/Launch Position or a body";
  const double arrival = first_arrival(scene, path);
  if (arrival >= scene.end_time)
    return format("the jet reaches the target at %g s, not before ", arrival) + end_words(scene) +
           ", so no depth will be computed; choose a later " +
           (scene.at_rest ? "one" : "End Time") + " if it should";
  if (!only_grazes(scene)) return {};
  return format(
      "the thinnest slugs of the jet hit no body along %s from y = %g m (only wider ones meet one, "
      "with their rims); if they should, move a body onto the jet's axis, x = 0",
      along,
      scene.jet.launch_position
  );
}

std::string through_note(const Scene& scene) {
  if (!scene.jet.present || !estimate_jet(scene, scene.end_time).passed) return {};
  return "the jet comes out of the rear of the target before " + end_path(scene) +
         ", according to a hydrodynamic estimate, so there will be no depth; for one, make the "
         "last body longer";
}

namespace {

/// A run to rest that its longest time cuts off.
std::string early_cut_note(const Scene& scene) {
  const double rest = predicted_rest(scene);
  if (rest <= scene.end_time) return {};
  return end_words(scene) +
         format(" ends the run before its hole is at rest, which is predicted at %.2g s; ", rest) +
         "choose a later one, or leave it out";
}

}  // namespace

std::string early_end_note(const Scene& scene) {
  if (!scene.jet.present) return {};
  if (scene.at_rest) return early_cut_note(scene);
  constexpr double small_share = 0.05;
  const JetEstimate estimate = estimate_jet(scene, scene.end_time);
  if (estimate.thinnest == 0.0 || estimate.passed || estimate.mass_left < small_share) return {};
  const JetEstimate whole = estimate_jet(scene, std::numeric_limits<double>::infinity());
  return format(
             "Time/End Time = %g s ends the run before the jet stops (%.0f %% of its mass and "
             "%.0f %% of its energy are left by then, according to a hydrodynamic estimate), ",
             scene.end_time,
             100.0 * estimate.mass_left,
             100.0 * estimate.energy_left
         ) +
         format(
             "so the depth will not be the final one; for that, choose an End Time of about %.2g "
             "s%s",
             whole.time,
             whole.passed ? ", when the jet comes out of the back of the target" : ""
         );
}

std::string thin_slugs_note(const Scene& scene) {
  const JetSpec& jet = scene.jet;
  const bool round = scene.grid.mode != Mode::plane_strain;  // as it was measured
  if (!jet.present || jet.kind != JetKind::discrete || !round || jet.splits >= enough_splits)
    return {};
  const MaterialSpec& metal = scene.materials[static_cast<std::size_t>(jet.material)];
  const double thinnest = thinnest_late_disc(scene, metal);
  if (thinnest == 0.0 || !breaks(metal)) return {};
  const double cell = grid_of_jet(scene.grid, jet).cell_size;
  const long long layers = divide(0.0, thinnest, cell / jet.particles_per_cell, cell).count;
  if (layers >= fewest_layers) return {};
  return format(
             "late slugs of the jet, %.3g m long, are too thin for their particles (layers: %lld "
             "of "
             "at least %lld): they pile up at the bottom, and the depth at rest comes out too "
             "small "
             "(docs/trade.md, Depth at rest); ",
             thinnest,
             layers,
             fewest_layers
         ) +
         format("choose %s = %d", path_of(&JetSpec::splits).c_str(), enough_splits);
}

}  // namespace barreno
