// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_step.hpp"

#include <cstddef>
#include <cstring>

namespace barreno::arenisca {

/// Bounds the cost of any input; 100 % strain needs some hundred.
constexpr int max_attempts_together = 2000;

/// Points that need more attempts than their group, packed into lanes so that few lanes are idle.
/// Which lanes they share changes nothing for a point.
template <class Law, std::size_t max_groups>
struct LaneQueue {
  using Step = StepOf<Lanes, Law>;
  struct Place {
    int group, lane;
  };
  Step packed[max_groups];                ///< lane groups
  Place places[max_groups * lane_count];  ///< where each came from
  int count = 0;

  static void copy_lane(const Step& from, int lane_from, Step& to, int lane_to) {
    static_assert(sizeof(Step) % sizeof(Lanes) == 0, "lanes only");
    constexpr std::size_t words = sizeof(Step) / sizeof(Lanes);
    const char* source = reinterpret_cast<const char*>(&from) + lane_from * 8;
    char* target = reinterpret_cast<char*>(&to) + lane_to * 8;
    for (std::size_t w = 0; w < words; ++w)
      std::memcpy(target + w * sizeof(Lanes), source + w * sizeof(Lanes), 8);
  }
  void put(const Step& from, int lane, Place place) {
    copy_lane(from, lane, packed[count / lane_count], count % lane_count);
    places[count++] = place;
  }
  int group_count() const { return (count + lane_count - 1) / lane_count; }

  /// One attempt of each; those that are done are copied back to the groups that they came from.
  void advance(const Law& rock, Step* home) {
    const int groups_now = group_count(), count_now = count;
    for (int i = count; i < groups_now * lane_count; ++i) {
      // Idle lanes repeat a point that is there, so that they meet nothing unusual.
      copy_lane(packed[0], 0, packed[i / lane_count], i % lane_count);
      packed[i / lane_count].active[i % lane_count] = 0;
    }
    for (int g = 0; g < groups_now; ++g) advance_step(rock, packed[g]);
    count = 0;
    for (int i = 0; i < count_now; ++i) {
      const Step& group = packed[i / lane_count];
      const Place place = places[i];
      if (group.active[i % lane_count] != 0)
        put(group, i % lane_count, place);
      else
        copy_lane(group, i % lane_count, home[place.group], place.lane);
    }
  }
};

/// Carries the steps of groups to their end: the first attempt of a group that is mostly active
/// in place, the rest packed.
template <class Law, std::size_t max_groups>
inline void finish_steps(const Law& rock, StepOf<Lanes, Law> (&steps)[max_groups], int count) {
  LaneQueue<Law, max_groups> queue;
  for (int g = 0; g < count; ++g) {
    int active = 0;
    for (int i = 0; i < lane_count; ++i) active += steps[g].active[i] != 0 ? 1 : 0;
    constexpr int mostly = 3 * lane_count / 4;
    if (active >= mostly) advance_step(rock, steps[g]);
    for (int i = 0; i < lane_count; ++i)
      if (steps[g].active[i] != 0) queue.put(steps[g], i, {g, i});
  }
  for (int i = 1; i < max_attempts_together && queue.count > 0; ++i) queue.advance(rock, steps);
  for (int i = 0; i < queue.count; ++i)
    steps[queue.places[i].group].refused[queue.places[i].lane] = -1;
}

}  // namespace barreno::arenisca
