// SPDX-License-Identifier: BSD-3-Clause
#include "output/depth.hpp"

#include "base/numbers.hpp"
#include "base/region.hpp"
#include "output/jet/channel.hpp"
#include "scene/geometry.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace barreno {
namespace {

/// Extent of a body on the axis; empty (lower > upper) if it does not reach it.
struct Extent {
  double lower = infinity, upper = -infinity;
};
/// Where a shape begins and ends in the column around the axis: halving, because what a slice from
/// one of its ends on holds only grows.
Extent in_column(const Shape& shape, Box column, double radius, int dimension) {
  for (const std::size_t across : {0U, 2U}) {
    column.lower[across] = std::max(column.lower[across], -radius);
    column.upper[across] = std::min(column.upper[across], radius);
    if (across < static_cast<std::size_t>(dimension) &&
        column.upper[across] <= column.lower[across])
      return {};
  }
  const auto holds_some = [&](double from, double to) {
    Box slice = column;
    slice.lower[1] = from;
    slice.upper[1] = to;
    return piece_of(shape, slice, dimension).measure > 0.0;
  };
  const double from = column.lower[1], to = column.upper[1];
  if (!holds_some(from, to)) return {};
  Extent extent{from, to};
  double end = to, begin = from;
  for (int halving = 0; halving < 40; ++halving) {
    const double lower = 0.5 * (extent.lower + end), upper = 0.5 * (begin + extent.upper);
    (holds_some(from, lower) ? end : extent.lower) = lower;
    (holds_some(upper, to) ? begin : extent.upper) = upper;
  }
  return extent;
}

Extent on_axis(const Shape& shape, const GridSpec& grid, double radius) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    const auto reaches = [&](std::size_t across) {
      return box->lower[across] < radius && box->upper[across] > -radius;
    };
    const bool meets = reaches(0) && (dimensions(grid.mode) == 2 || reaches(2));
    return meets ? Extent{box->lower[1], box->upper[1]} : Extent{};
  }
  if (const auto* ball = std::get_if<Ball>(&shape)) {
    if (std::hypot(ball->centre[0], ball->centre[2]) - ball->radius >= radius) return {};
    return {ball->centre[1] - ball->radius, ball->centre[1] + ball->radius};
  }
  return in_column(shape, box_around(shape, grid), radius, dimensions(grid.mode));
}

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

/// The channel is measured with the smallest cells of the grid, so that larger ones elsewhere do
/// not change its measure.
double finest_cell(const GridSpec& grid) {
  unsigned char level = 0;
  for (const unsigned char one : grid.level_of_tile) level = std::max(level, one);
  return grid.cell_size / (1 << level);
}

/// Bodies that a jet meets, the nearest first.
std::vector<PathLayer> layers_ahead(const Scene& scene, const JetOrigin& origin) {
  const double start = origin.direction * origin.plane + length_tolerance(scene.grid);
  const bool forward = origin.direction > 0.0;
  std::vector<PathLayer> layers;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (is_jet_body(origin, static_cast<int>(b))) continue;
    const Extent extent = on_axis(scene.bodies[b].shape, scene.grid, origin.radius);
    const double near = forward ? extent.lower : -extent.upper;
    const double far = forward ? extent.upper : -extent.lower;
    if (!(far > near) || far <= start) continue;  // off the axis or behind the jet
    layers.push_back({b, near, far});
  }
  std::stable_sort(layers.begin(), layers.end(), [](const PathLayer& a, const PathLayer& b) {
    return a.near < b.near;
  });
  return layers;
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

bool is_jet_body(const JetOrigin& origin, int body) {
  return std::find(origin.bodies.begin(), origin.bodies.end(), body) != origin.bodies.end();
}

double widest_radius(const Scene& scene) {
  double radius = 0.0;
  for (const JetSlug& slug : scene.jet.slugs) radius = std::max(radius, slug.radius);
  return radius;
}

double depth_in(const PathLayer& layer, const JetPath& path, double depth) {
  return std::clamp(depth - (layer.near - path.direction * path.face), 0.0, layer.far - layer.near);
}

std::vector<PathLayer> path_layers(const Scene& scene, double radius) {
  JetOrigin origin = launched_jet(scene);
  origin.radius = radius;
  return layers_ahead(scene, origin);
}

JetOrigin launched_jet(const Scene& scene) {
  JetOrigin origin;
  origin.bodies = {static_cast<int>(scene.bodies.size())};
  origin.plane = scene.jet.launch_position;
  origin.direction = scene.jet.direction;
  origin.radius = widest_radius(scene);
  origin.mass = jet_table_totals(scene, scene.jet.slugs.size()).mass;
  return origin;
}

JetOrigin formed_jet(const Scene& scene, const JetMonitorSpec& monitor) {
  JetOrigin origin;
  origin.bodies = monitor.bodies;
  origin.plane = monitor.position;
  origin.direction = monitor.direction;
  origin.formed = true;
  // How wide it will be is not known: what lies on the axis.
  origin.radius = scene.grid.cell_size;
  const double ring = scene.grid.mode == Mode::axisymmetric ? two_pi * scene.grid.upper[0] : 1.0;
  for (const int body : monitor.bodies)
    origin.mass += ring * monitor.density *
                   max_measure(scene.bodies[static_cast<std::size_t>(body)].shape, scene.grid);
  return origin;
}

JetPath jet_path(const Scene& scene) {
  return jet_path(scene, launched_jet(scene));
}

std::optional<JetPath> recorded_path(const Scene& scene, const JetMonitorSpec& monitor) {
  if (scene.jet.present) return jet_path(scene);
  if (!monitor.present()) return {};
  JetPath path = jet_path(scene, formed_jet(scene, monitor));
  if (!path.has_target) return {};
  return path;
}

JetPath jet_path(const Scene& scene, const JetOrigin& origin) {
  JetPath path;
  path.origin = origin;
  path.direction = origin.direction;
  path.bin = finest_cell(scene.grid);
  const double launch = path.direction * origin.plane;
  double face = infinity, end = -infinity;
  for (const PathLayer& layer : layers_ahead(scene, origin)) {
    face = std::min(face, layer.near);
    end = std::max(end, layer.far);
  }
  path.has_target = end >= face;
  if (!path.has_target) face = end = launch;
  path.face = path.direction * face;
  path.end = path.direction * end;
  constexpr double round_off = 1e-9;
  path.bins = static_cast<int>(std::ceil((end - face) / path.bin - round_off));
  return path;
}

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
        "# SI units: time s; depth, channel_depth, channel_radius_mid m; jet_mass_inside kg (plane "
        "strain: "
        "kg per m); tip_velocity m/s; through 1 once the jet has come out of the rear of the target"
    );
    file_->append(
        path_.has_target ? "# depths from the outer face at y = " + to_text(path_.face) +
                               " along the jet's direction, 0 until the jet has met the target"
                         : std::string("# no depth: the jet meets no target")
    );
    file_->append("time,depth,channel_depth,channel_radius_mid,jet_mass_inside,tip_velocity,through"
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

void DepthWriter::write(const Scene& scene, const State& state) {
  const Region region("write_depth");
  measure(scene, state);
  RootWork work(*state.grid.comm);
  work.run([&] {
    file_->append(csv_line(
        {state.clock.time,
         last_.depth,
         last_.channel_depth,
         last_.channel_radius_mid,
         last_.jet_mass_inside,
         last_.tip_velocity,
         last_.through ? 1.0 : 0.0}
    ));
  });
  work.agree();
}

}  // namespace barreno
