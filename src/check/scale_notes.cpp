// SPDX-License-Identifier: BSD-3-Clause
#include "check/scale_notes.hpp"

#include "base/format.hpp"
#include "check/predict_cost.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "jet/path.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace barreno {
namespace {

using Notes = std::vector<std::string>;

/// What is usual for shaped charges, from hand-held ones to those against concrete, with a wide
/// margin.
constexpr double slowest_jet = 500.0, fastest_jet = 20e3;       // m/s
constexpr double thinnest_jet = 10e-6, widest_jet = 50e-3;      // m
constexpr double shortest_target = 1e-3, longest_target = 5.0;  // m
constexpr double most_steps = 1e7;

std::string jet_rows(const JetSpec& jet) {
  return jet.table_file.empty() ? path_of(&JetSpec::slugs) : path_of(&JetSpec::table_file);
}

std::string unit_of_rows(const JetSpec& jet) {
  return jet.table_file.empty()
             ? "if a unit was forgotten, mind that the numbers of Slugs are in the deck's Units"
             : "if a unit was forgotten, name the system of the numbers in the table's file, "
               "\"# units: mm-us-g\"";
}

void add_jet_notes(const JetSpec& jet, Notes& notes) {
  double fastest = 0.0, widest = 0.0, thinnest = std::numeric_limits<double>::infinity();
  for (const JetSlug& slug : jet.slugs) {
    fastest = std::max(fastest, slug.velocity);
    widest = std::max(widest, slug.radius);
    thinnest = std::min(thinnest, slug.radius);
  }
  if (fastest < slowest_jet || fastest > fastest_jet)
    notes.push_back(
        jet_rows(jet) +
        format(
            " gives the fastest slug %.4g m/s, which is unusual for a jet (%g to %g m/s); ",
            fastest,
            slowest_jet,
            fastest_jet
        ) +
        unit_of_rows(jet)
    );
  if (thinnest < thinnest_jet || widest > widest_jet)
    notes.push_back(
        jet_rows(jet) +
        format(
            " gives a slug a radius of %.4g m, which is unusual for a jet (%g to %g m); ",
            widest > widest_jet ? widest : thinnest,
            thinnest_jet,
            widest_jet
        ) +
        unit_of_rows(jet)
    );
}

void add_target_note(const Scene& scene, Notes& notes) {
  const JetPath path = jet_path(scene);
  if (!path.has_target) return;
  const double length = std::abs(path.end - path.face);
  if (length >= shortest_target && length <= longest_target) return;
  notes.push_back(format(
      "the target is %.4g m thick along the jet, which is unusual (%g to %g m); if a unit was "
      "forgotten in Bodies, write it behind the number, \"12.7 mm\"",
      length,
      shortest_target,
      longest_target
  ));
}

/// Where a body is thinnest, as its box or as its wall [length].
double thickness_of(const BodySpec& body, const GridSpec& grid) {
  if (const auto* ball = std::get_if<Ball>(&body.shape);
      ball != nullptr && ball->inner_radius > 0.0)
    return ball->radius - ball->inner_radius;
  const Box box = box_around(body.shape, grid);
  double thickness = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    thickness = std::min(thickness, box.upper[d] - box.lower[d]);
  return thickness;
}

void add_thin_body_note(const Scene& scene, Notes& notes) {
  for (const BodySpec& body : scene.bodies) {
    const double thickness = thickness_of(body, scene.grid);
    if (thickness >= scene.grid.cell_size - length_tolerance(scene.grid)) continue;
    notes.push_back(
        list_of<BodySpec>(body.name) +
        format(
            " is %.4g m thick, less than a cell (%s = %g m), so nothing inside it is resolved; ",
            thickness,
            path_of(&GridSpec::cell_size).c_str(),
            scene.grid.cell_size
        ) +
        "look for a wrong unit, or make cells smaller"
    );
    return;  // the first says enough
  }
}

void add_end_note(const Scene& scene, Notes& notes) {
  double step = stable_step_of_scene(scene, false);
  if (scene.step.largest_step > 0.0) step = std::min(step, scene.step.largest_step);
  const double steps = scene.end_time / step;
  if (!(steps > most_steps)) return;
  notes.push_back(
      (scene.at_rest ? path_of(&TimeSpec::longest_time) : path_of(&TimeSpec::end_time)) +
      format(
          " = %g s takes %.2g steps of %.2g s; look for a wrong unit of that time, or of a length, "
          "velocity, stiffness or density",
          scene.end_time,
          steps,
          step
      )
  );
}

}  // namespace

std::vector<std::string> scale_notes(const Scene& scene) {
  Notes notes;
  if (scene.jet.present) {
    add_jet_notes(scene.jet, notes);
    add_target_note(scene, notes);
  }
  add_thin_body_note(scene, notes);
  add_end_note(scene, notes);
  return notes;
}

}  // namespace barreno
