// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/run_numbers.hpp"
#include "jet/depth.hpp"
#include "scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace barreno {

/// The hole of a jet is at rest if its depth and its volume have grown by no more than this share
/// in a window of time, or by less than the cells can tell, and if no more than the same share of
/// the jet's mass is on its way (docs/jets.md): each part of the mass makes about the same part of
/// the depth.
inline constexpr double rest_share = 1e-3;
/// Part of a cell by which the wall of the hole may seem to have moved: debris and loose rock on
/// it, moving to and fro, shift it by up to 0.09 of a cell (docs/jets.md, At rest).
inline constexpr double wall_share = 0.1;
/// The window, of the time since the jet met its target. It grows with the hole, which grows ever
/// more slowly, and in bursts: it must be longer than most pauses between them, in which necks are
/// closed or no slug arrives.
inline constexpr double rest_window = 0.2;
/// The hole that is as wide as the jet (Penetration::probed_depth) counts where it is at least this
/// share of the depth; the thread of spent metal behind it does not count then. Where less of the
/// hole is so wide, the depth alone decides.
inline constexpr double wide_share = 0.5;
/// Slugs lose velocity on their way through the hole: they count as on their way until they would
/// have reached the bottom at this part of their launch velocity (docs/trade.md, what late slugs
/// lose on their way).
inline constexpr double slowed = 0.8;

/// A slug that digs when it arrives: it is not slower than cut_off_velocity().
struct ComingSlug {
  double time = 0.0;      ///< of its launch [time]
  double velocity = 0.0;  ///< [length/time]
  double mass = 0.0;
};

/// What the rule takes from a scene with a launched jet.
struct RestRule {
  double jet_mass = 0.0;      ///< of the whole table [mass]
  double least_window = 0.0;  ///< in which the tip flies twenty radii of the widest slug [time]
  double stand_off = 0.0;     ///< of the launch plane from the outer face of the target [length]
  std::vector<ComingSlug> slugs{};
  double row = 0.0;    ///< of the hole, whose depth is a number of them: one cell [length]
  bool plane = false;  ///< plane strain: volumes are areas
};
RestRule rest_rule(const Scene& scene);

/// Share of the jet's mass that still digs and is on its way to a bottom at this depth at a time.
double share_on_its_way(const RestRule& rule, double time, double depth);

/// What was found when the hole was last looked at.
struct Rest {
  bool met = false;               ///< the jet has met its target
  bool through = false;           ///< and has come out of the rear
  bool at_rest = false;           ///< as above
  double time = 0.0;              ///< of the look [time]
  double window = 0.0;            ///< over which growth is known [time]
  double growth = 0.0;            ///< of the depth in this window [length]
  double share_on_its_way = 0.0;  ///< of the jet's mass
  double depth = 0.0;             ///< largest so far [length]
  bool probed = false;            ///< the hole that is as wide as the jet counts
  double probed_depth = 0.0;      ///< largest so far [length]
  double probed_growth = 0.0;     ///< in the window [length]
  double probed_volume = 0.0;     ///< largest so far [length^3]
  double volume_growth = 0.0;     ///< of probed_volume in the window [length^3]
  double rate() const { return window > 0.0 ? growth / window : 0.0; }  ///< [length/time]
};

/// Looks at a hole that grows, at the times of depth.csv. Depths and volume are the largest so far:
/// metal that is thrown back, or removed, does not fill the hole, and necks come and go.
class RestWatch {
public:
  explicit RestWatch(RestRule rule) : rule_(std::move(rule)) {}
  /// @param position  numbers() of a run that is resumed
  RestWatch(RestRule rule, const RunNumbers& position);

  void look(double time, const Penetration& found);
  const Rest& last() const { return last_; }
  /// What a checkpoint must hold.
  RunNumbers numbers() const;

private:
  /// The largest depths and volume so far, and when they were first seen.
  struct Sample {
    double time, depth, probed_depth, probed_volume;
  };
  void keep(double time, const Penetration& found);
  void judge();
  RestRule rule_;
  double first_contact_ = 0.0;
  std::vector<Sample> samples_;  ///< of a growing hole, from the beginning of the window on
  Rest last_;
};

/// What is wrong with a checkpoint's numbers() at a time, for a sentence; empty: nothing, or they
/// are not there.
std::string fault_of_rest(const RunNumbers& position, double time);

/// Whether a checkpoint's numbers() are of a hole at rest.
bool is_at_rest(const RunNumbers& position);

/// Whether the tip has gone on where the hole as wide as the jet counts: as a rule in a thread.
bool has_growing_thread(const Rest& rest);

/// Whether a hole is at rest, and why or why not.
std::string rest_sentence(const Rest& rest);

}  // namespace barreno
