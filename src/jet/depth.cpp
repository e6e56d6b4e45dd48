// SPDX-License-Identifier: BSD-3-Clause
#include "jet/depth.hpp"

#include "base/numbers.hpp"
#include "base/region.hpp"
#include "jet/channel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace barreno {
namespace {

/// The jet's mass in units of a fixed quantum: whole numbers add up the same in every order.
class MassCounter {
public:
  explicit MassCounter(double most) : quantum_(std::ldexp(most > 0.0 ? most : 1.0, -52)) {}
  long long count(double mass) const { return std::llround(mass / quantum_); }
  double mass(long long count) const { return static_cast<double>(count) * quantum_; }

private:
  double quantum_;
};

/// The jet particle that reaches deepest on this rank, and the mass inside.
struct JetReach {
  double depth = -infinity;
  ParticleId id = std::numeric_limits<ParticleId>::max();
  double velocity = 0.0;
  long long mass = 0;
};

void follow_jet_particle(
    const HostParticles& particles,
    int p,
    const JetPath& path,
    const MassCounter& masses,
    JetReach& deepest
) {
  // The undeformed box, which is what the shape function sees: the corner of a particle that was
  // drawn out into a needle says nothing about where the jet is.
  const double depth = path.depth(particles.position(p, 1)) + particles.half_size(p, 1);
  const ParticleId id = particles.id(p);
  if (depth > deepest.depth || (depth == deepest.depth && id < deepest.id)) {
    deepest.depth = depth;
    deepest.id = id;
    deepest.velocity = path.direction * particles.velocity(p, 1);
  }
  if (path.has_target && path.depth(particles.position(p, 1)) > 0.0)
    deepest.mass += masses.count(particles.mass(p, 0));
}

/// What has been torn from a jet is none.
bool is_jet(const HostParticles& particles, int p, const JetOrigin& origin) {
  return is_jet_body(origin, particles.body(p)) &&
         (!origin.formed || origin.direction * (particles.position(p, 1) - origin.plane) > 0.0);
}

/// Depth and velocity of the deepest particle of all ranks, on the root.
void combine_reach(
    const Comm& comm, const JetPath& path, const JetReach& mine, Penetration& result
) {
  const std::vector<double> values =
      gather_to_root(comm, std::vector<double>{mine.depth, mine.velocity});
  const std::vector<long long> ids = gather_to_root(comm, std::vector<long long>{mine.id});
  double depth = -infinity;
  long long id = std::numeric_limits<long long>::max();
  for (std::size_t r = 0; r < ids.size(); ++r) {
    if (values[2 * r] < depth || (values[2 * r] == depth && ids[r] > id)) continue;
    depth = values[2 * r];
    id = ids[r];
    result.tip_velocity = values[2 * r + 1];
  }
  result.met = path.has_target && depth > 0.0;
  if (!result.met) return;
  const double length = path.direction * (path.end - path.face);
  result.through = depth > length;
  result.depth = std::min(depth, length);
}

}  // namespace

Penetration measure_penetration(const Scene& scene, const State& state, const JetPath& path) {
  const MassCounter masses(path.origin.mass);
  JetReach deepest;
  const std::vector<HostParticles> sets(state.particles.begin(), state.particles.end());
  for (const HostParticles& particles : sets)
    for (int p = 0; p < particles.count; ++p)
      if (is_jet(particles, p, path.origin))
        follow_jet_particle(particles, p, path, masses, deepest);
  const Comm& comm = *state.grid.comm;
  std::vector<long long> mass{deepest.mass};
  sum_over_ranks(comm, mass);

  Penetration result;
  combine_reach(comm, path, deepest, result);
  result.jet_mass_inside = masses.mass(mass[0]);
  result.walls = wall_radii(sets, scene, path, comm);
  measure_channel(result.walls, path, result);
  result.probed_volume = probed_volume(scene.grid, path, result);
  return result;
}

DepthWriter::DepthWriter(
    JetPath path,
    const Comm& comm,
    const std::filesystem::path& file,
    std::uintmax_t kept,
    double through_since
)
    : path_(std::move(path)), through_since_(through_since) {
  RootWork work(comm);
  work.run([&] {
    file_ = std::make_unique<LineFile>(file, kept);
    if (kept > 0) return;  // it has its header
    file_->append(
        "# SI units: time s; depth, channel_depth, probed_depth, channel_radius_mid m; "
        "probed_volume m3 (plane strain: m2); jet_mass_inside "
        "kg (plane strain: kg per m); tip_velocity m/s; through 1 once the jet has come out of the "
        "rear of the target"
    );
    file_->append(
        path_.has_target ? "# depths from the outer face at y = " + to_text(path_.face) +
                               " along the jet's direction, 0 until the jet has met the target"
                         : std::string("# no depth: the jet meets no target")
    );
    if (path_.has_target && path_.liquid > 0.0)
      file_->append(
          "# liquids do not count: the face is that of a solid, and a hole full of liquid is open"
      );
    file_->append(
        "time,depth,channel_depth,probed_depth,probed_volume,channel_radius_mid,jet_mass_inside,"
        "tip_velocity,through"
    );
  });
  work.agree();
}

void DepthWriter::measure(const Scene& scene, const State& state) {
  last_ = measure_penetration(scene, state, path_);
  if (last_.through && !(through_since_ > 0.0)) through_since_ = state.clock.time;
  if (!(through_since_ > 0.0)) return;
  // What has left the grid or was consumed since does not close the target again.
  last_.met = last_.through = true;
  last_.through_since = through_since_;
  last_.depth = path_.direction * (path_.end - path_.face);
}

std::vector<RockZones> DepthWriter::zones(const Scene& scene, const State& state) const {
  return measure_zones(scene, state, path_, last_);
}

void DepthWriter::write(const Scene& scene, const State& state) {
  const Region region("write_depth");
  measure(scene, state);
  RootWork work(*state.grid.comm);
  work.run([&] {
    file_->append(csv_line(
        {state.clock.time,
         last_.depth,
         last_.channel_depth,
         last_.probed_depth,
         last_.probed_volume,
         last_.channel_radius_mid,
         last_.jet_mass_inside,
         last_.tip_velocity,
         last_.through ? 1.0 : 0.0}
    ));
  });
  work.agree();
}

}  // namespace barreno
