// SPDX-License-Identifier: BSD-3-Clause
#include "check/plan.hpp"

#include "base/error.hpp"
#include "base/format.hpp"
#include "check/awake_parts.hpp"
#include "check/choices.hpp"
#include "check/feature_table.hpp"
#include "check/jet_lines.hpp"
#include "check/predict_cost.hpp"
#include "check/update_row.hpp"
#include "deck/fidelity.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "geometry/piece.hpp"
#include "jet/estimate.hpp"
#include "output/file_shares.hpp"
#include "output/progress.hpp"
#include "scene/build_scene.hpp"
#include "scene/tile_levels.hpp"
#include "shape/shape_facts.hpp"
#include "state/bodies/body_particles.hpp"
#include "state/particles.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace barreno {
namespace {

std::string box_text(const GridSpec& grid) {
  std::string text;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    text += format(d == 0 ? "%g" : " x %g", grid.upper[d] - grid.lower[d]);
  return text;
}

std::string cells_text(const GridSpec& grid) {
  std::string text = format("%g m", grid.cell_size);
  if (finest_level(grid) > 0) text += format(", refined to %g m", smallest_cell(grid));
  return text;
}

std::string material_lines(const Scene& scene) {
  std::string text;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const MaterialSpec& material = scene.materials[m];
    const std::size_t bytes = bytes_per_particle(make_particles(scene, static_cast<int>(m)));
    text += format(
        "  %-22s %s, %.6g kg/m3, %zu bytes per particle\n",
        material.name().c_str(),
        material.model_name().c_str(),
        material.density(),
        bytes
    );
  }
  return text;
}

/// Volumes as filled: how far they are known follows from the shape.
std::string body_lines(const Scene& scene) {
  std::string text;
  const bool plane = scene.grid.mode == Mode::plane_strain;
  for (const BodySpec& body : scene.bodies) {
    double volume = 0.0;
    long long count = 0;
    for_each_body_particle(
        scene.grid,
        body,
        1,
        [&](const NewParticle& particle) {
          volume += particle.volume;
          ++count;
        },
        box_cuts(scene)
    );
    text += format(
        "  %-22s %.6g m3%s (%s), %lld particles\n",
        body.name.c_str(),
        volume,
        plane ? " per m" : "",
        has_exact_pieces(body.shape) ? "exact" : "estimated",
        count
    );
  }
  return text;
}

/// Which materials set the step; empty with particles of one only.
std::string step_line(const Scene& scene) {
  const std::vector<double> steps = stable_steps_of_materials(scene, true);
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < steps.size(); ++m)
    if (std::isfinite(steps[m])) order.push_back(m);
  if (order.size() < 2) return {};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return steps[a] < steps[b];
  });
  std::string text = format(
      "Step      set by %s in cells of %g m",
      scene.materials[order.front()].name().c_str(),
      smallest_cell(scene.grid)
  );
  for (std::size_t i = 1; i < order.size(); ++i)
    text += format(
        "%s%s%s %.2g",
        i == 1 ? "; " : ", ",
        scene.materials[order[i]].name().c_str(),
        i == 1 ? " could take" : "",
        steps[order[i]] / steps[order.front()]
    );
  return text + " times that\n";
}

/// Shares of a sum, the last first, by the words for their places; empty where there is only one.
template <class WordsOf>
std::string share_words(const double* counts, int size, const WordsOf& words_of) {
  const double all = std::accumulate(counts, counts + size, 0.0);
  std::string text;
  for (int i = size - 1; i >= 0; --i)
    if (counts[i] > 0.0 && counts[i] < all)
      text += format("%s%.0f %% ", text.empty() ? "" : ", ", 100.0 * counts[i] / all) + words_of(i);
  return text;
}

/// Particle-steps of bodies by the size of their cells and by the length of their steps.
std::string share_line(const Scene& scene, const StepShares& shares) {
  const std::string cells = share_words(shares.of_level, max_level + 1, [&](int level) {
    return format("in cells of %g m", uniform_grid(scene.grid, level).cell_size);
  });
  const std::string lengths = share_words(shares.of_length, step_lengths, [](int length) {
    return format("of %d part%s", 1 << length, length == 0 ? "" : "s");
  });
  if (cells.empty() && lengths.empty()) return {};
  return "Shares    particle-steps of the bodies: " + cells +
         (cells.empty() || lengths.empty() ? "" : "; ") + lengths + "\n";
}

/// Whether a material's update was measured in short runs alone, and costs more in long ones.
bool is_least_cost(const Scene& scene) {
  return std::any_of(
      scene.materials.begin(),
      scene.materials.end(),
      [](const MaterialSpec& material) {
        const auto cost = update_cost(material.material());
        return cost && cost->is_early;
      }
  );
}

std::string cost_line(const Scene& scene, const Prediction& cost, int ranks) {
  if (!cost.unknown.empty()) return "Cost      unknown (" + cost.unknown + ")\n";
  return format(
      "Cost      %s %s of computing on %d rank%s, %.0f ns per particle-step on one core%s\n",
      is_least_cost(scene) ? "at least" : "about",
      cost_text(cost.seconds).c_str(),
      ranks,
      ranks == 1 ? "" : "s",
      cost.nanoseconds,
      // Only where a jet wakes tiles is it known which are dormant.
      dormancy_choice(scene).on && !foresees_dormancy(scene) ? ", less while tiles are dormant" : ""
  );
}

/// Which files the particles will be written to.
std::string files_line(const Scene& scene, const std::vector<long long>& counts, int ranks) {
  const long long places = first_ids(scene, counts).back() - 1;
  const int files = count_files(scene.output.files, places, ranks);
  if (files == 1) return "Files     particles.e, one for all ranks\n";
  const FileShares shares{files, {}};
  const std::filesystem::path name = "particles.e";
  const bool by_number = scene.output.files == ParticleFiles::by_number;
  return format(
      "Files     %s to %s, one per rank%s; barreno join makes one of them\n",
      name_in_set(name, shares, 0).c_str(),
      name_in_set(name, shares, files - 1).c_str(),
      by_number ? format(" above %lld particles", most_in_one_file).c_str() : ""
  );
}

}  // namespace

void refuse_short_domains(const Deck& deck, const Scene& scene) {
  const double corner = largest_corner(scene);
  // A deck is not refused for the round-off of its numbers.
  if (!follows_deformation(scene) || scene.step.largest_domain >= corner * (1.0 - 1e-9)) return;
  deck.refuse_value(
      path_of(&StepSpec::largest_domain),
      format(
          "is shorter than undeformed particles (their corners are %.3g cells from the centre); "
          "choose at least that, or more particles per cell",
          corner
      )
  );
}

void refuse_unreachable_end(const Deck& deck, const Scene& scene) {
  const double step = stable_step_of_scene(scene, true);
  const double steps = scene.end_time / step;
  constexpr double most = 0x1p53;  // from here on a step no longer changes the time
  if (steps < most) return;
  const bool longest = deck.has(path_of(&TimeSpec::longest_time));
  deck.refuse_value(
      longest ? path_of(&TimeSpec::longest_time) : path_of(&TimeSpec::end_time),
      format(
          "cannot be reached with steps of %g s (the stable step at the speeds and wave speeds of "
          "this scene); look for a wrong unit of a time, velocity, stiffness or density",
          step
      )
  );
}

void refuse_rest_without_target(const Deck& deck, const Scene& scene) {
  if (!scene.at_rest || jet_path(scene).has_target) return;
  deck.refuse_value(
      path_of(&TimeSpec::end_time),
      "needs a hole that the jet digs, and the jet meets no body on its way; give a time, or turn "
      "the jet to its target"
  );
}

/// The error of the depth that the cells of a scene let expect; empty without a jet.
std::string depth_error(const Scene& scene) {
  if (!scene.jet.present) return {};
  const DepthDoubt doubt = depth_doubt(scene, expected_end(scene));
  if (!doubt.unknown.empty()) return ", depth unknown (" + doubt.unknown + ")";
  return ", depth " + depth_error_text(doubt.error);
}

namespace {

std::string cost_of_choice(const Prediction& cost) {
  if (!cost.unknown.empty()) return "cost unknown (" + cost.unknown + ")";
  return format("%s, %.3g particle-steps", cost_text(cost.seconds).c_str(), cost.particle_steps);
}

/// Time, and how many steps it takes if that is known.
std::string time_line(const Scene& scene, const Prediction& cost) {
  const std::string end = scene.at_rest ? format(
                                              "to rest, predicted at %.3g s, and to %.3g s at most",
                                              expected_end(scene),
                                              scene.end_time
                                          )
                                        : format("to %g s", scene.end_time);
  const std::string begin =
      "Time      " + end + format(", first steps of %.3g s: ", cost.first_step);
  if (!(cost.steps > 0.0)) return begin + "number of steps unknown\n";
  const int most = scene.step.subcycles;
  return begin + format(
                     "about %.*g steps%s, %.3g particle-steps\n",
                     cost.steps < 1e9 ? 10 : 3,
                     cost.steps < 1e9 ? std::round(cost.steps) : cost.steps,
                     most > 1 ? format(" of %d parts", most).c_str() : "",
                     cost.particle_steps
                 );
}

/// What a fidelity costs and promises, or why the deck cannot have it: it may make too many cells
/// of a deck that is valid as it stands.
std::string fidelity_row(
    const std::function<Scene(const std::string&)>& scene_with, const std::string& name, int ranks
) {
  try {
    const Scene scene = scene_with(name);
    const Prediction cost = predict_cost(scene, probe_cost(scene), particle_counts(scene), ranks);
    return cost_of_choice(cost) + "; errors: " + fidelity_errors(name) + depth_error(scene);
  } catch (const DeckError& error) {
    return std::string("not with this deck: ") + error.what();
  }
}

}  // namespace

std::string fidelity_lines(const std::function<Scene(const std::string&)>& scene_with, int ranks) {
  std::string text =
      "Fidelity  (--fidelity NAME chooses what the deck leaves open. Errors measured in "
      "docs/trade.md: pressures of a shock, smooth strains of 0.3; depth: expected from the size "
      "of the cells)\n";
  for (const std::string& name : fidelity_words())
    text += format("  %-22s ", name.c_str()) + fidelity_row(scene_with, name, ranks) + "\n";
  return text;
}

namespace {

double sum_of(const std::vector<long long>& counts) {
  double sum = 0.0;
  for (const long long count : counts) sum += static_cast<double>(count);
  return sum;
}

}  // namespace

std::string plan_text(
    const Scene& scene,
    const Probe& probe,
    int ranks,
    const std::vector<std::string>& notes,
    const JetMonitorSpec& monitor
) {
  const std::vector<long long> counts = particle_counts(scene);  // with the whole jet
  const double particles = sum_of(counts);
  const Prediction cost = predict_cost(scene, probe, counts, ranks);
  std::string text = scene.title.empty()
                         ? std::string("The deck is valid.\n")
                         : input::on_one_line(scene.title) + "\nThe deck is valid.\n";
  text += format(
      "Grid      %s, %s m, cells of %s\n",
      word_of(scene.grid.mode).c_str(),
      box_text(scene.grid).c_str(),
      cells_text(scene.grid).c_str()
  );
  text += format(
      "Particles %.0f, including the whole jet; about %.0f MB of memory\n",
      particles,
      cost.bytes * 1e-6
  );
  text += time_line(scene, cost);
  text += cost_line(scene, cost, ranks) + files_line(scene, counts, ranks) + step_line(scene) +
          share_line(scene, cost.shares) + jet_lines(scene, monitor);
  if (!scene.bodies.empty()) text += "Bodies\n" + body_lines(scene);
  text += "Materials\n" + material_lines(scene) + feature_table(scene, probe);
  for (const std::string& note : notes) text += "Note: " + note + "\n";
  return text;
}

}  // namespace barreno
