// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic_run.hpp"

#include "base/gather.hpp"

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace barreno::synthetic {
namespace {

constexpr int slug_particles = 8;  // a slug is a 2 x 4 patch of particles
constexpr double slug_spacing = 1e-6;

Material linear_material(const char* name, double density) {
  return {name, density, LinearElastic({160e9, 80e9}, density)};
}

Material rock_material() {
  Arenisca::Parameters p{};
  p.PEAKI1 = 1e6;
  p.FSLOPE = 0.4;
  p.STREN = 300e6;
  p.YSLOPE = 0.2;
  p.B0 = 10e9;
  p.G0 = 8e9;
  p.p0_crush_curve = -100e6;
  p.p1_crush_curve = 1e-9;
  p.p3_crush_curve = 0.2;
  p.CR = 0.5;
  p.tolerance = 1e-6;
  return {"sandstone", 2300.0, Arenisca(p, 2300.0)};
}

struct Lattice {
  int columns, rows;
  double spacing;
  long long count() const { return static_cast<long long>(columns) * rows; }
};
Lattice lattice(const Scene& scene, const BodySpec& body) {
  const auto& box = std::get<Box>(body.shape);
  const double spacing = scene.grid.cell_size / body.particles_per_cell;
  return {
      static_cast<int>(std::lround((box.upper[0] - box.lower[0]) / spacing)),
      static_cast<int>(std::lround((box.upper[1] - box.lower[1]) / spacing)),
      spacing};
}

/// Whether this rank holds the particle: the decomposition of a run is arbitrary for the files.
bool mine(const State& state, ParticleId id) {
  return id / 5 % state.grid.comm->getSize() == state.grid.comm->getRank();
}

void add_particle(
    State& state, int set, ParticleId id, std::size_t body, double x, double y, double half
) {
  if (!mine(state, id)) return;
  Particles& p = state.particles[static_cast<std::size_t>(set)];
  reserve(p, p.count + 1);
  const int row = p.count++;
  p.for_each_field([row](Field& field) {
    for (int c = 0; c < field.components; ++c) field(row, c) = 0.0;
  });
  p.id(row) = id;
  p.body(row) = static_cast<int>(body);
  p.position(row, 0) = x;
  p.position(row, 1) = y;
  for (const int c : {0, 3}) p.deformation_gradient(row, c) = 1.0;
  if (p.deformation_gradient.components > 4) p.deformation_gradient(row, 4) = 1.0;
  p.half_size(row, 0) = p.half_size(row, 1) = half;
  p.volume(row) = 4.0 * half * half * 2.0 * std::acos(-1.0) * x;
  p.mass(row) = p.volume(row) * 1000.0 * (set + 1);
  state.ledger.mass += p.mass(row);
}

void launch_slug(const Scene& scene, State& state, std::size_t slug) {
  const double spacing = scene.grid.cell_size / scene.jet.particles_per_cell;
  const long long first = make_slots(scene).back().first;
  for (int i = 0; i < slug_particles; ++i) {
    const auto number = static_cast<long long>(slug) * slug_particles + i;
    const int row = i / 2;
    const double x = (i % 2 + 0.5) * spacing, y = launch_plane - (row + 0.5) * spacing;
    add_particle(
        state, scene.jet.material, first + number, scene.bodies.size(), x, y, 0.5 * spacing
    );
  }
}

/// Radial motion that opens a channel down to `depth`, in step with the jet.
void open_channel(const Scene& scene, Particles& p, int row, double x, double y, double depth) {
  const double radius = y < depth ? 0.004 * std::exp(-20.0 * std::max(0.0, y)) : 0.0;
  const double moved = std::sqrt(x * x + radius * radius);
  p.position(row, 0) = moved;
  const double stretch = x / moved;  // dr/dR; the hoop stretch is the inverse: no volume change
  p.deformation_gradient(row, 0) = stretch;
  p.deformation_gradient(row, 1) = 0.1 * (moved - x) / scene.grid.cell_size;
  if (p.deformation_gradient.components > 4) p.deformation_gradient(row, 4) = moved / x;
  for (int c = 0; c < 3; ++c) p.stress(row, c) = -1e8 * (moved - x) / scene.grid.cell_size;
  p.stress(row, 3) = 2e7;
  if (p.history.components > 1) p.history(row, 1) = (moved - x) / scene.grid.cell_size;
}

}  // namespace

Scene make_scene(Mode mode) {
  Scene scene;
  scene.title = "synthetic penetration";
  scene.grid = {mode, {0.0, -0.012, 0.0}, {0.02, 0.04, 0.0}, 0.002};
  scene.materials = {
      {linear_material("steel", 7800.0)},
      {rock_material()},
      {linear_material("tungsten", 17600.0)}};
  // add_particle gives set m this density.
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    scene.materials[m].scale_density(
        1000.0 * static_cast<double>(m + 1) / scene.materials[m].density()
    );
  BodySpec casing, rock;
  casing.name = "casing";
  casing.material = 0;
  casing.shape = Box{{0.0, 0.0, 0.0}, {0.02, 0.004, 0.0}};
  rock.name = "rock";
  rock.material = 1;
  rock.shape = Box{{0.0, 0.004, 0.0}, {0.02, 0.04, 0.0}};
  scene.bodies = {rock, casing};  // the first body met is not the first one listed
  scene.jet.present = true;
  scene.jet.material = 2;
  scene.jet.table_file = "jet.csv";
  scene.jet.launch_position = launch_plane;
  for (int s = 0; s < 6; ++s)
    scene.jet.slugs.push_back({s * slug_spacing, tip_speed - 200.0 * s, 0.001, 0.002, 17600.0});
  scene.end_time = 1e-5;
  scene.output.field_interval = 2.5e-6;
  return scene;
}

std::vector<IdRange> make_slots(const Scene& scene) {
  std::vector<IdRange> slots;
  ParticleId next = 1;
  for (const BodySpec& body : scene.bodies) {
    slots.push_back({body.material, next, lattice(scene, body).count()});
    next += slots.back().count;
  }
  const auto launched = static_cast<long long>(scene.jet.slugs.size()) * slug_particles;
  slots.push_back({scene.jet.material, next, launched});
  return slots;
}

State make_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  State state;
  state.grid.mode = scene.grid.mode;
  state.grid.cell_size = scene.grid.cell_size;
  state.grid.comm = comm;
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    state.particles.push_back(make_particles(scene, static_cast<int>(m)));
  const std::vector<IdRange> slots = make_slots(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Lattice l = lattice(scene, scene.bodies[b]);
    const Vector& corner = std::get<Box>(scene.bodies[b].shape).lower;
    for (long long i = l.count() - 1; i >= 0; --i) {  // ids fall in storage: the files sort
      const double x = corner[0] + (static_cast<double>(i % l.columns) + 0.5) * l.spacing;
      const auto row = i / l.columns;
      const double y = corner[1] + (static_cast<double>(row) + 0.5) * l.spacing;
      add_particle(state, scene.bodies[b].material, slots[b].first + i, b, x, y, 0.5 * l.spacing);
    }
  }
  state.ledger.initial_mass = state.ledger.mass;
  return state;
}

void move_to(const Scene& scene, State& state, double time) {
  while (state.jet.next_slug < scene.jet.slugs.size() &&
         scene.jet.slugs[state.jet.next_slug].time <= time) {
    const double before = state.ledger.mass;
    launch_slug(scene, state, state.jet.next_slug++);
    state.ledger.launched_mass += state.ledger.mass - before;
  }
  const double depth = launch_plane + tip_speed * time;
  const std::vector<IdRange> slots = make_slots(scene);
  for (Particles& p : state.particles) {
    for (int row = 0; row < p.count; ++row) {
      const auto body = static_cast<std::size_t>(p.body(row));
      const long long i = p.id(row) - slots[body].first;
      if (body == scene.bodies.size()) {
        const JetSlug& slug = scene.jet.slugs[static_cast<std::size_t>(i / slug_particles)];
        const double spacing = scene.grid.cell_size / scene.jet.particles_per_cell;
        const auto pair = i % slug_particles / 2;
        const double start = launch_plane - (static_cast<double>(pair) + 0.5) * spacing;
        p.position(row, 1) = start + slug.velocity * (time - slug.time);
        p.velocity(row, 1) = slug.velocity;
        continue;
      }
      const Lattice l = lattice(scene, scene.bodies[body]);
      const Vector& corner = std::get<Box>(scene.bodies[body].shape).lower;
      const double x = corner[0] + (static_cast<double>(i % l.columns) + 0.5) * l.spacing;
      const auto line = i / l.columns;
      const double y = corner[1] + (static_cast<double>(line) + 0.5) * l.spacing;
      open_channel(scene, p, row, x, y, depth);
    }
    state.particle_steps += p.count;
  }
  state.clock.dt = time - state.clock.time;
  state.clock.time = time;
  ++state.clock.step;
}

void remove_particle(State& state, ParticleId id) {
  for (Particles& p : state.particles) {
    int marked = 0;
    for (int row = 0; row < p.count; ++row) {
      p.spare(row) = p.id(row) == id ? 1 : 0;
      if (p.id(row) != id) continue;
      ++marked;
      auto& tally = state.ledger.removed[static_cast<std::size_t>(RemovalCause::not_finite)];
      tally.count += 1.0;
      tally.mass += p.mass(row);
      state.ledger.mass -= p.mass(row);
    }
    remove_marked_rows(p, marked);
  }
}

TemporaryFolder::TemporaryFolder(const Teuchos::Comm<int>& comm) : comm_(comm) {
  std::string name;
  if (is_root(comm)) {
    name = (std::filesystem::temp_directory_path() / "barreno_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) name.clear();
  }
  path_ = broadcast_from_root(comm, name);
}

TemporaryFolder::~TemporaryFolder() {
  comm_.barrier();  // the other ranks may still look at the files
  std::error_code ignored;
  if (is_root(comm_)) std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace barreno::synthetic
