// SPDX-License-Identifier: BSD-3-Clause
#include "output/depth.hpp"

#include "base/region.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Extent of a body on the axis; empty (lower > upper) if it does not reach it.
struct Extent {
  double lower = infinity, upper = -infinity;
};
Extent on_axis(const Shape& shape, double radius) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    const bool meets = box->lower[0] < radius && box->upper[0] > -radius;
    return meets ? Extent{box->lower[1], box->upper[1]} : Extent{};
  }
  const auto& ball = std::get<Ball>(shape);
  if (std::abs(ball.centre[0]) - ball.radius >= radius) return {};
  return {ball.centre[1] - ball.radius, ball.centre[1] + ball.radius};
}

/// The jet's mass in units of a fixed quantum: whole numbers add up the same in every order.
class MassCounter {
public:
  explicit MassCounter(const Scene& scene) {
    const double total = jet_table_totals(scene, scene.jet.slugs.size()).mass;
    quantum_ = std::ldexp(total > 0.0 ? total : 1.0, -52);
  }
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
  const Corners corners = particles.corners(p);
  double depth = -infinity;
  for (std::size_t a = 0; a < 4; ++a) depth = std::max(depth, path.depth(corners[2 * a + 1]));
  const ParticleId id = particles.id(p);
  if (depth > deepest.depth || (depth == deepest.depth && id < deepest.id)) {
    deepest.depth = depth;
    deepest.id = id;
    deepest.velocity = path.direction * particles.velocity(p, 1);
  }
  if (path.depth(particles.position(p, 1)) > 0.0)
    deepest.mass += masses.count(particles.mass(p, 0));
}

/// Bins that an interval of depths touches; none if first > last.
struct Bins {
  int first = 0, last = -1;
};
Bins bins_between(const JetPath& path, double shallow, double deep) {
  if (!(deep > 0.0) || !(shallow < path.bins * path.bin)) return {};  // not finite: none
  const double last_bin = path.bins - 1.0;
  return {
      static_cast<int>(std::clamp(std::floor(shallow / path.bin), 0.0, last_bin)),
      static_cast<int>(std::clamp(std::floor(deep / path.bin), 0.0, last_bin))};
}

/// The centre lies in the domain: a first bound that spares most particles the exact look.
void bound_channel(
    const HostParticles& particles, int p, const JetPath& path, std::vector<double>& nearest
) {
  const double depth = path.depth(particles.position(p, 1));
  const Bins bins = bins_between(path, depth, depth);
  if (bins.first > bins.last) return;
  double& bin = nearest[static_cast<std::size_t>(bins.first)];
  bin = std::min(bin, std::abs(particles.position(p, 0)));
}

void narrow_channel(
    const HostParticles& particles, int p, const JetPath& path, std::vector<double>& nearest
) {
  const auto& F = particles.deformation_gradient;
  const double h_x = particles.half_size(p, 0), h_y = particles.half_size(p, 1);
  const double reach_x = std::abs(F(p, 0)) * h_x + std::abs(F(p, 1)) * h_y;
  const double reach_y = std::abs(F(p, 2)) * h_x + std::abs(F(p, 3)) * h_y;
  const double depth = path.depth(particles.position(p, 1));
  const Bins bins = bins_between(path, depth - reach_y, depth + reach_y);
  const double inner = std::abs(particles.position(p, 0)) - reach_x;
  for (int b = bins.first; b <= bins.last; ++b) {
    double& bin = nearest[static_cast<std::size_t>(b)];
    if (!(inner < bin)) continue;
    const Corners corners = particles.corners(p);
    bin = std::min(bin, nearest_to_axis(corners, path, b * path.bin, (b + 1) * path.bin));
  }
}

/// Smallest distance of target domains to the axis in every bin, of this rank.
std::vector<double> nearest_in_bins(
    const std::vector<HostParticles>& sets, std::size_t jet, const JetPath& path
) {
  std::vector<double> nearest(static_cast<std::size_t>(path.bins), infinity);
  if (nearest.empty()) return nearest;
  for (auto* visit : {&bound_channel, &narrow_channel})
    for (const HostParticles& particles : sets)
      for (int p = 0; p < particles.count; ++p)
        if (particles.body(p) != jet) visit(particles, p, path, nearest);
  return nearest;
}

/// Depth and velocity of the deepest particle of all ranks, on the root.
void combine_reach(const Comm& comm, const JetReach& mine, Penetration& result) {
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
  result.depth = std::max(0.0, depth);
}

}  // namespace

JetPath jet_path(const Scene& scene) {
  JetPath path;
  path.direction = scene.jet.direction;
  path.bin = scene.grid.cell_size;
  double radius = 0.0;
  for (const JetSlug& slug : scene.jet.slugs) radius = std::max(radius, slug.radius);
  const double launch = path.direction * scene.jet.launch_position;
  double face = infinity, end = -infinity;
  for (const BodySpec& body : scene.bodies) {
    const Extent extent = on_axis(body.shape, radius);
    const bool forward = path.direction > 0.0;
    const double near = forward ? extent.lower : -extent.upper;
    const double far = forward ? extent.upper : -extent.lower;
    if (!(far > near) || far <= launch) continue;  // off the axis or behind the jet
    face = std::min(face, near);
    end = std::max(end, far);
  }
  if (end < face) face = end = launch;
  path.face = path.direction * face;
  path.end = path.direction * end;
  constexpr double round_off = 1e-9;
  path.bins = static_cast<int>(std::ceil((end - face) / path.bin - round_off));
  return path;
}

double nearest_to_axis(const Corners& corners, const JetPath& path, double above, double below) {
  // Domains that only touch a bin, up to round-off, are not in it.
  const double margin = 1e-9 * path.bin;
  const double upper = above + margin, lower = below - margin;
  double nearest = infinity;
  bool left = false, right = false;
  for (std::size_t a = 0; a < 4; ++a) {
    const std::size_t b = (a + 1) % 4;
    const double d_a = path.depth(corners[2 * a + 1]), d_b = path.depth(corners[2 * b + 1]);
    if (std::max(d_a, d_b) < upper || std::min(d_a, d_b) > lower) continue;
    for (const double bound : {upper, lower}) {
      // Where the edge enters and leaves the strip; an edge along the strip keeps its own ends.
      const double depth = std::clamp(bound, std::min(d_a, d_b), std::max(d_a, d_b));
      const bool level = d_a == d_b;
      const double weight = level ? (bound == upper ? 0.0 : 1.0) : (depth - d_a) / (d_b - d_a);
      const double x = corners[2 * a] + weight * (corners[2 * b] - corners[2 * a]);
      (x < 0.0 ? left : right) = true;
      nearest = std::min(nearest, std::abs(x));
    }
  }
  return left && right ? 0.0 : nearest;
}

void measure_channel(
    const std::vector<double>& nearest, const JetPath& path, double grid_width, Penetration& result
) {
  const auto closed = std::find_if(nearest.begin(), nearest.end(), [&](double distance) {
    return distance < 0.5 * path.bin;
  });
  const auto open = static_cast<std::size_t>(closed - nearest.begin());
  result.channel_depth =
      std::min(static_cast<double>(open) * path.bin, path.direction * (path.end - path.face));
  result.channel_radius_mid = open == 0 ? 0.0 : std::min(nearest[open / 2], grid_width);
}

Penetration measure_penetration(const Scene& scene, const State& state, const JetPath& path) {
  const MassCounter masses(scene);
  const std::size_t jet = scene.bodies.size();
  JetReach deepest;
  const std::vector<HostParticles> sets(state.particles.begin(), state.particles.end());
  for (const HostParticles& particles : sets)
    for (int p = 0; p < particles.count; ++p)
      if (particles.body(p) == jet) follow_jet_particle(particles, p, path, masses, deepest);
  std::vector<double> nearest = nearest_in_bins(sets, jet, path);
  const Comm& comm = *state.grid.comm;
  min_over_ranks(comm, nearest);
  std::vector<long long> mass{deepest.mass};
  sum_over_ranks(comm, mass);

  Penetration result;
  combine_reach(comm, deepest, result);
  result.jet_mass_inside = masses.mass(mass[0]);
  const double width = std::max(std::abs(scene.grid.lower[0]), std::abs(scene.grid.upper[0]));
  measure_channel(nearest, path, width, result);
  return result;
}

DepthWriter::DepthWriter(const Scene& scene, const Comm& comm, const std::filesystem::path& path)
    : path_(jet_path(scene)) {
  RootWork work(comm);
  work.run([&] {
    file_ = std::make_unique<LineFile>(path);
    file_->append(
        "# SI units: time s; depth, channel_depth, channel_radius_mid m; jet_mass_inside kg (plane "
        "strain: "
        "kg per m); tip_velocity m/s"
    );
    file_->append(
        "# depths from the outer face at y = " + to_text(path_.face) + " along the jet's direction"
    );
    file_->append("time,depth,channel_depth,channel_radius_mid,jet_mass_inside,tip_velocity");
  });
  work.agree();
}

void DepthWriter::write(const Scene& scene, const State& state) {
  const Region region("write_depth");
  last_ = measure_penetration(scene, state, path_);
  RootWork work(*state.grid.comm);
  work.run([&] {
    file_->append(csv_line(
        {state.clock.time,
         last_.depth,
         last_.channel_depth,
         last_.channel_radius_mid,
         last_.jet_mass_inside,
         last_.tip_velocity}
    ));
  });
  work.agree();
}

}  // namespace barreno
