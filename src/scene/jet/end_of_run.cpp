// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "scene/jet.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// When the last slug that still digs would reach the end of the grid in free flight [time].
double last_arrival(const Scene& scene) {
  const GridSpec& grid = scene.grid;
  const JetSpec& jet = scene.jet;
  const double far = jet.direction > 0.0 ? grid.upper[1] : grid.lower[1];
  const double way = std::abs(far - jet.launch_position);
  const double cut_off = cut_off_velocity(scene);
  double last = 0.0;
  for (const JetSlug& slug : jet.slugs)
    if (slug.velocity >= cut_off) last = std::max(last, slug.time + way / slug.velocity);
  return last;
}

void add_cut_off(const Deck& deck, const TimeSpec& time, Scene& scene) {
  scene.cut_off_velocity = time.cut_off_velocity;
  if (!time.cut_off_velocity) return;
  const std::string path = path_of(&TimeSpec::cut_off_velocity);
  if (!scene.jet.present)
    deck.refuse_value(path, "has no meaning without a Jet (nothing digs); remove it");
  const double fastest = fastest_velocity(scene.jet);
  if (*time.cut_off_velocity < fastest) return;
  deck.refuse_value(
      path,
      "is not below the velocity of the fastest slug, " + text_of("%.6g", fastest) +
          " m/s (nothing of the jet would dig); choose the velocity below which it does not"
  );
}

}  // namespace

void add_end(const Deck& deck, Scene& scene) {
  const auto time = read_section<TimeSpec>(deck);
  if (!time.at_rest && time.longest_time)
    deck.refuse_value(
        path_of(&TimeSpec::longest_time),
        "has no meaning beside a time in " + path_of(&TimeSpec::end_time) +
            " (it bounds a run that ends at rest); remove it, or write " +
            path_of(&TimeSpec::end_time) + " = " + at_rest_word
    );
  add_cut_off(deck, time, scene);
  scene.end_time = time.end_time;
  scene.at_rest = time.at_rest;
  if (!time.at_rest) return;
  if (!scene.jet.present)
    deck.refuse_value(
        path_of(&TimeSpec::end_time),
        "needs a Jet (the run ends when the hole of the jet no longer grows); give a time, or add "
        "a Jet"
    );
  constexpr double margin =
      1.5;  // for slugs that are slowed down on their way, and for a look back
  scene.end_time = time.longest_time.value_or(margin * last_arrival(scene));
}

}  // namespace barreno
