// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <filesystem>
#include <string>

namespace barreno::synthetic {

/// A jet, a casing and a rock whose motion is written down instead of computed: slugs fly at
/// constant speed, and the target makes room for them. The files of such a run are known
/// beforehand.
Scene make_scene(Mode mode = Mode::axisymmetric);

/// Ids in the order casing, rock, jet, counted from 1.
std::vector<IdRange> make_slots(const Scene& scene);

/// The particles at t = 0, dealt out to the ranks by id in blocks of a few.
State make_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// Moves the particles to where they are at `time` and launches the slugs that are due.
void move_to(const Scene& scene, State& state, double time);

/// Takes a particle out, tallied as not finite, wherever it is.
void remove_particle(State& state, ParticleId id);

/// An empty folder that is removed with the object; the same on every rank, seen by all.
class TemporaryFolder {
public:
  explicit TemporaryFolder(const Teuchos::Comm<int>& comm);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  const Teuchos::Comm<int>& comm_;
  std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);

/// The first speed of the jet; its tip starts at the launch plane at t = 0.
inline constexpr double tip_speed = 4000.0;
inline constexpr double launch_plane = -0.006;

}  // namespace barreno::synthetic
