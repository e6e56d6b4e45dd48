// SPDX-License-Identifier: BSD-3-Clause
#include "output/result_numbers.hpp"

#include "files/text_file.hpp"
#include "jet/channel.hpp"
#include "jet/divided_error.hpp"
#include "jet/estimate.hpp"
#include "jet/range_effects.hpp"
#include "output/progress.hpp"
#include "output/share_numbers.hpp"
#include "state/balance.hpp"

#include <cmath>

namespace barreno {
namespace {

/// Where the particle-steps went, and which were spared.
void add_work_lines(const Scene& scene, const RunTotals& totals, std::vector<std::string>& lines) {
  if (totals.skipped_steps > 0.0)
    lines.push_back(number_line(
        "%.0f %% of all particle-steps were skipped, in dormant tiles",
        100.0 * totals.skipped_steps / (totals.skipped_steps + totals.particle_steps)
    ));
  const auto cells = shares_by_cell_size(scene.grid.cell_size, totals.step_shares);
  if (!cells.empty()) lines.push_back("particle-steps by cell size: " + share_text(cells));
  const auto lengths = shares_by_step_length(totals.step_shares);
  if (!lengths.empty()) lines.push_back("particle-steps by length of step: " + share_text(lengths));
  const auto limits = shares_of_limits(scene, totals.step_limits);
  if (!limits.empty()) lines.push_back("length of the steps set by: " + share_text(limits));
}

/// Depth from the outer face, and in the last body that the jet has reached.
std::string depth_words(const Scene& scene, const Penetration& p) {
  std::string text = p.through
                         ? number_line("depth: through the target of %.2f mm", 1e3 * p.depth) +
                               number_line(" since %.4g us", 1e6 * p.through_since)
                         : number_line("depth %.2f mm", 1e3 * p.depth);
  if (scene.jet.present && !p.through) {
    const JetPath path = jet_path(scene);
    const std::vector<PathLayer> layers = solid_layers(path_layers(scene, widest_radius(scene)));
    for (auto layer = layers.rbegin(); layer != layers.rend() && layers.size() > 1; ++layer) {
      const double depth = depth_in(*layer, path, p.depth);
      if (depth == 0.0) continue;
      text += number_line(" (%.2f mm in ", 1e3 * depth) + scene.bodies[layer->body].name + ")";
      break;
    }
  }
  text += number_line(", open channel %.2f mm", 1e3 * p.channel_depth);
  const double widest = widest_radius(scene);
  if (is_divided(scene))  // whose depth may be that of a thread
    text += number_line(", as wide as the jet (%.2f mm)", 2e3 * widest) +
            number_line(" to %.2f mm", 1e3 * p.probed_depth);
  return text;
}

/// Size of the open channel; nothing where it is closed.
std::string hole_words(const Scene& scene, const Penetration& p) {
  const JetPath path = jet_path(scene);
  const double volume = channel_volume(scene.grid, path, p);
  if (!(volume > 0.0)) return {};
  const bool of_depth = scene.grid.mode == Mode::plane_strain;
  std::string text =
      number_line(of_depth ? "hole: %.3g cm2" : "hole: %.3g cm3", (of_depth ? 1e4 : 1e6) * volume);
  const char* word = ", entrance of ";
  for (const PathLayer& layer : solid_layers(path_layers(scene, widest_radius(scene)))) {
    const double entrance = entrance_diameter(layer, path, p);
    if (!(entrance > 0.0)) continue;
    text += word + number_line("%.2f mm in ", 1e3 * entrance) + scene.bodies[layer.body].name;
    word = " and ";
  }
  return text + number_line(", %.2f mm wide half-way down", 2e3 * p.channel_radius_mid);
}

/// What has become of the rock around it.
std::string zones_words(const Scene& scene, const RockZones& zones) {
  std::string text =
      scene.bodies[zones.body].name + number_line(" at %.1f mm: ", 1e3 * zones.depth);
  text += zones.crushed_to > zones.crushed_from
              ? number_line("crushed from %.2f ", 1e3 * zones.crushed_from) +
                    number_line("to %.2f mm from the axis", 1e3 * zones.crushed_to)
              : std::string("not crushed");
  if (zones.dilated_to > zones.wall)
    text += number_line(", dilated to %.2f mm", 1e3 * zones.dilated_to);
  if (zones.impaired_to > zones.wall)
    text += number_line(", impaired to %.2f mm", 1e3 * zones.impaired_to);
  if (std::isfinite(zones.skin)) {
    text += number_line("; skin %.2g by its porosity", zones.skin);
    if (zones.greatest_breakage > 0.0) text += " and its broken grains";
  }
  return text;
}

/// How deep, what hole, what of the rock, whether at rest, and how sure.
void add_hole_lines(
    const Scene& scene,
    double time,
    const Penetration& penetration,
    const RunSummary& summary,
    std::vector<std::string>& lines
) {
  if (scene.jet.present || penetration.met)
    lines.push_back(
        penetration.met ? depth_words(scene, penetration) : "no depth: the jet has hit no target"
    );
  if (penetration.met && scene.jet.present) {
    const std::string hole = hole_words(scene, penetration);
    if (!hole.empty()) lines.push_back(hole);
  }
  if (penetration.met && scene.jet.present && jet_path(scene).liquid > 0.0)
    lines.push_back(number_line(
        "%.4g mm of the jet's path are liquid, which counts as a gap: depth and hole are those in "
        "solids",
        1e3 * jet_path(scene).liquid
    ));
  for (const RockZones& zones : summary.zones) lines.push_back(zones_words(scene, zones));
  if (summary.rest && summary.rest->met) lines.push_back(rest_sentence(*summary.rest));
  if (penetration.met)
    lines.push_back(
        "error of the depth from the size of the cells: " +
        depth_doubt_text(depth_doubt(scene, time, penetration))
    );
  if (penetration.met && is_divided(scene)) {
    lines.push_back(
        "error of the depth of the hole that is as wide as the jet: " +
        depth_doubt_text(probed_depth_doubt(scene, time, penetration))
    );
    lines.push_back(
        "error of the volume of the hole: " +
        depth_doubt_text(volume_doubt(scene, time, penetration))
    );
  }
  if (!penetration.met) return;
  const std::string least = least_certain_sentence(least_certain(scene));
  if (!least.empty()) lines.push_back(least);
}

}  // namespace

std::vector<std::string> result_numbers(
    const Scene& scene,
    const RunTotals& totals,
    const Penetration& penetration,
    const RunSummary& summary,
    const Prediction& prediction
) {
  std::vector<std::string> lines;
  add_hole_lines(scene, totals.time, penetration, summary, lines);
  const Ledger& ledger = totals.ledger;
  const NumericalEnergy energy = numerical_energy(ledger);
  lines.push_back(number_line(
      "energy that the method itself has added (+) or lost (-): %+.2g %% of the energy put in "
      "(stress integration %+.2g %%, transfer between particles and grid %+.2g %%)",
      100.0 * energy.sum(),
      100.0 * energy.stress_integration,
      100.0 * energy.transfer
  ));
  lines.push_back(number_line(
      "what the balances then leave over: energy %+.2e, mass %+.1e, axial momentum %+.1e",
      energy_balance(ledger).error(),
      mass_balance(ledger).error(),
      momentum_balance(ledger).error()
  ));
  lines.push_back(
      counted(total_removed(ledger).count, "particles removed") +
      number_line(", %.0f held", ledger.held)
  );
  lines.push_back(
      "took " + duration_text(summary.wall_seconds) +
      number_line(
          ", %.0f ns per particle-step, at most %.0f MB",
          totals.particle_steps > 0.0 ? 1e9 * summary.wall_seconds / totals.particle_steps : 0.0,
          1e-6 * summary.peak_resident_bytes
      )
  );
  if (!prediction.unknown.empty())
    lines.push_back("predicted: unknown (" + prediction.unknown + ")");
  if (prediction.seconds > 0.0)
    lines.push_back(
        "predicted: " + cost_text(prediction.seconds) +
        number_line(
            ", %.0f ns per particle-step, %.3g particle-steps (actual %.3g)",
            prediction.nanoseconds,
            prediction.particle_steps,
            totals.particle_steps
        )
    );
  add_work_lines(scene, totals, lines);
  return lines;
}

}  // namespace barreno
