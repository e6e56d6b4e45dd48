// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "files/text_file.hpp"
#include "state/state.hpp"

#include <memory>
#include <vector>

namespace barreno {

/// Bodies of a scene that are hollow balls, in their order.
std::vector<int> hollow_balls(const Scene& scene);

/// Mass average of r^n of a body's particles, r the distance from the centre of its ball, and their
/// volume; n = 3 in axisymmetry, 2 in plane strain.
struct RadialMoment {
  double mass = 0.0, mean_power = 0.0, volume = 0.0;
};

/// Collective; one for each body asked for.
std::vector<RadialMoment> radial_moments(
    const Scene& scene, const State& state, const std::vector<int>& bodies
);

/// Of each hollow ball at t = 0 its mean power and its volume. Collective.
std::vector<double> start_of_radii(const Scene& scene, const State& state);

/// radii.csv: inner and outer radius of every hollow ball as it moves; a row per call.
///
/// Every point of a sphere that keeps its volume has r^3 = R^3 - c, so the mean of r^3 moves as
/// a^3 and b^3 do: no surface has to be found, and what particles are displaced at random averages
/// out. With the mean change of volume, which a uniform density would share with the matrix
/// V = b^3 - a^3,
///
///   a^3 = a0^3 + (<r^3> - <R^3>) - (V - V0) / 2,   b^3 = b0^3 + (<r^3> - <R^3>) + (V - V0) / 2
///
/// (squares in plane strain).
class RadiiWriter {
public:
  /// @param start  start_of_radii
  /// Collective. @throws FileError on every rank
  RadiiWriter(
      const Scene& scene,
      const Comm& comm,
      const std::vector<double>& start,
      const std::filesystem::path& path,
      std::uintmax_t kept = 0
  );
  /// Collective. @throws FileError on every rank
  void write(const Scene& scene, const State& state);

  std::uintmax_t bytes() const { return file_ ? file_->bytes() : 0; }

private:
  std::vector<int> bodies_;
  std::vector<double> start_;
  std::unique_ptr<LineFile> file_;  ///< root only
};

}  // namespace barreno
