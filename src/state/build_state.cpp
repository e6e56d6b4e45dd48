// SPDX-License-Identifier: BSD-3-Clause
#include "state/build_state.hpp"

#include "base/error.hpp"
#include "base/region.hpp"
#include "grid/partition.hpp"
#include "grid/tiles.hpp"
#include "scene/body_force.hpp"
#include "scene/dormant.hpp"
#include "scene/porous.hpp"
#include "shape/visit_kernels.hpp"
#include "state/lone_courant.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

/// True for a model whose strength scatters.
template <class Model, class = void>
struct VariesByPiece : std::false_type {};
template <class Model>
struct VariesByPiece<Model, std::void_t<decltype(&Model::vary)>> : std::true_type {};

/// Bits of the pressure loads on a particle's own faces: load * 6 + face.
double loaded_faces(const Scene& scene, int body, unsigned sides) {
  double bits = 0.0;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    if (scene.loads[l].body != body) continue;
    const PressureLoadSpec& load = scene.loads[l];
    for (unsigned face = 0; face < 6; ++face)
      if (load.faces[face] && (sides >> face & 1U))
        bits += std::ldexp(1.0, static_cast<int>(6 * l + face));
    for (unsigned surface = 0; surface < 2; ++surface)  // of the ball: every particle has a share
      if (load.surfaces[surface]) bits += std::ldexp(1.0, static_cast<int>(6 * l + surface));
  }
  return bits;
}

/// Shares of a particle in the pressures on the surfaces of its ball.
void put_shares(const Scene& scene, const BodySpec& body, int p, Particles& particles) {
  const auto* ball = std::get_if<Ball>(&body.shape);
  if (particles.surface_share.components == 0 || ball == nullptr) return;
  const int count = dimensions(scene.grid.mode);
  int c = 0;
  for (const BallSurface surface : {BallSurface::inner, BallSurface::outer}) {
    const SurfaceShare share =
        surface_share(*ball, surface, vector_of(particles.position, p), count);
    particles.surface_share(p, c++) = share.value;
    for (int d = 0; d < count; ++d)
      particles.surface_share(p, c++) = share.gradient[static_cast<std::size_t>(d)];
  }
}

/// v (a / r)^2 outwards, v (a / r) in plane strain: div v = 0.
void add_radial_velocity(Mode mode, const BodySpec& body, const Vector& x, Vector& velocity) {
  const Ball& ball = std::get<Ball>(body.shape);
  Vector from_centre{};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(mode)); ++d)
    from_centre[d] = x[d] - ball.centre[d];
  const double r = std::hypot(from_centre[0], from_centre[1], from_centre[2]);
  const double ratio = ball.inner_radius / r;
  const double speed = body.radial_velocity * (mode == Mode::plane_strain ? ratio : ratio * ratio);
  for (std::size_t d = 0; d < 3; ++d) velocity[d] += speed * from_centre[d] / r;
}

/// Middle of a body's undeformed shape.
Vector middle_of(const Shape& shape) {
  if (const auto* ball = std::get_if<Ball>(&shape)) return ball->centre;
  const auto& box = std::get<Box>(shape);
  return {0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1]), 0.0};
}

Vector velocity_at(Mode mode, const BodySpec& body, const Vector& x) {
  const Vector& k = body.velocity_wave_number;
  const bool wave = k[0] != 0.0 || k[1] != 0.0 || k[2] != 0.0;
  const double shape = wave ? std::sin(k[0] * x[0] + k[1] * x[1] + k[2] * x[2]) : 1.0;
  Vector velocity{};
  for (std::size_t d = 0; d < velocity.size(); ++d) velocity[d] = body.velocity[d] * shape;
  if (body.spin != 0.0) {
    const Vector middle = middle_of(body.shape);
    velocity[0] -= body.spin * (x[1] - middle[1]);
    velocity[1] += body.spin * (x[0] - middle[0]);
  }
  if (body.radial_velocity != 0.0) add_radial_velocity(mode, body, x, velocity);
  return velocity;
}

/// Initial velocity of a body at x, that of a manufactured motion included.
Vector start_velocity(const Scene& scene, const BodySpec& body, const Vector& x) {
  Vector velocity = velocity_at(scene.grid.mode, body, x);
  const Vector prescribed = prescribed_start_velocity(scene.body_force, x);
  for (std::size_t d = 0; d < velocity.size(); ++d) velocity[d] += prescribed[d];
  return velocity;
}

/// Gradient of that at a particle, which APIC asks for (start_affine): by differences over a
/// hundredth of it, exact for linear velocities.
void put_velocity_gradient(
    const Scene& scene, const BodySpec& body, const NewParticle& made, int p, Particles& particles
) {
  const auto dimension = static_cast<std::size_t>(particles.position.components);
  if (particles.affine.components == 0) return;
  for (std::size_t d = 0; d < dimension; ++d) {
    const double reach = 0.01 * made.half[d];
    Vector from = made.x, to = made.x;
    from[d] -= reach;
    to[d] += reach;
    const Vector before = start_velocity(scene, body, from);
    const Vector after = start_velocity(scene, body, to);
    for (std::size_t i = 0; i < dimension; ++i)
      particles.affine(p, static_cast<int>(dimension * i + d)) =
          0.5 * (after[i] - before[i]) / reach;
  }
}

/// Particles per tile of the box, found by every rank for itself.
std::vector<TileCost> count_in_tiles(const Scene& scene, const Grid& grid) {
  std::vector<TileCost> counts(grid.owner.size());
  for (const BodySpec& body : scene.bodies)
    for_each_body_particle(scene.grid, body, 0, [&](const NewParticle& p) {
      counts[static_cast<std::size_t>(cell_of(grid, p.x).tile)].particles += 1.0;
    });
  return counts;
}

/// What the rows from `first` on bring into the balances.
void enter(const Particles& particles, int first, double stored_energy, OwnLedger& ledger) {
  for (int p = first; p < particles.count; ++p) {
    const double m = particles.mass(p);
    const Vector v = vector_of(particles.velocity, p);
    ledger.initial_mass += m;
    ledger.initial_momentum += m * v[1];
    ledger.initial_kinetic += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    ledger.prestress += m * stored_energy;
    if (p % most_summed_rows == 0) carry(ledger);
  }
}

/// Elastic energy of the initial equilibrium per mass.
/// @throws NumericalError if the material cannot hold the pressure
double initial_energy(const Scene& scene, const BodySpec& body) {
  const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material;
  return std::visit(
      [&](const auto& model) {
        const auto start = initial_state_of(model, body);
        if (start.possible) return start.stored_energy / material.density;
        std::ostringstream text;
        text << "Bodies/" << body.name << " starts under " << body.initial_pressure
             << " Pa, which its material '" << material.name
             << "' cannot hold elastically. Lower the confinement or take a stronger material.";
        throw NumericalError(text.str());
      },
      material.model
  );
}

/// Without skipping, tiles that rest only matter where their nodes may move a little.
Dormancy make_dormancy(const Scene& scene) {
  Dormancy dormancy;
  dormancy.motion = rest_motion(scene);
  dormancy.skips = scene.step.skip_dormant;
  dormancy.on = why_all_awake(scene).empty() && (dormancy.skips || dormancy.motion > 0.0);
  return dormancy;
}

}  // namespace

StartPoint start_point(const Scene& scene, int material, const BodySpec* body) {
  return std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        const auto start = body ? initial_state_of(model, *body) : model.initial_state(0.0);
        const auto* const h = reinterpret_cast<const double*>(&start.history);
        return StartPoint{start.stress, {h, h + Model::history_count}, start.volume_ratio};
      },
      scene.materials[static_cast<std::size_t>(material)].material.model
  );
}

int add_particle(
    const Scene& scene,
    Particles& particles,
    const NewParticle& made,
    int body,
    const StartPoint& start,
    const Vector& velocity
) {
  reserve(particles, particles.count + 1);
  const int p = particles.count++;
  particles.sorted = false;
  particles.id(p) = made.id;
  particles.body(p) = body;
  put_unplaced(particles, p);
  particles.for_each_field([p](Field& field) {
    for (int c = 0; c < field.components; ++c) field(p, c) = 0.0;
  });
  const int d = particles.position.components;
  double section = 1.0;  // of the undeformed particle in its plane
  for (int i = 0; i < d; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    particles.position(p, i) = made.x[axis];
    particles.velocity(p, i) = velocity[axis];
    particles.half_size(p, i) = made.half[axis];
    section *= 2.0 * made.half[axis];
  }
  // In three dimensions that of a cube of its volume, which is what the scatter of strength asks
  // for.
  if (d == 3) section = std::pow(made.volume, 2.0 / 3.0);
  particles.volume(p) = made.volume;
  for (int i = 0; i < d; ++i) particles.deformation_gradient(p, i * (d + 1)) = 1.0;
  if (scene.grid.mode == Mode::axisymmetric) particles.deformation_gradient(p, 4) = 1.0;
  if (particles.rotation.components > 0) particles.rotation(p, 0) = 1.0;
  for (int c = 0; c < particles.reference_position.components; ++c)
    particles.reference_position(p, c) = made.x[static_cast<std::size_t>(c)];
  if (particles.loaded_faces.components > 0)
    particles.loaded_faces(p) = loaded_faces(scene, body, made.loaded_sides);
  if (const auto b = static_cast<std::size_t>(body); b < scene.bodies.size())
    put_shares(scene, scene.bodies[b], p, particles);

  const Material& material = scene.materials[static_cast<std::size_t>(particles.material)].material;
  std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        auto history = model.initial_history();
        auto* const h = reinterpret_cast<double*>(&history);
        std::copy(start.history.begin(), start.history.end(), h);
        if constexpr (VariesByPiece<Model>::value)
          model.vary(history, {static_cast<std::uint64_t>(made.id), made.volume, section});
        for (int c = 0; c < 3; ++c) particles.stress(p, c) = (&start.stress.xx)[c];
        for (int c = 0; c < Model::history_count; ++c) particles.history(p, c) = h[c];
        particles.mass(p) = material.density / start.volume_ratio * made.volume;
        particles.longitudinal_modulus(p) =
            model.longitudinal_modulus(start.stress, history, start.volume_ratio);
      },
      material.model
  );
  return p;
}

namespace {

/// An empty set of particles for each material, with the velocity fields that they move in.
void add_sets(const Scene& scene, State& state) {
  state.fields = velocity_fields(scene);
  state.nodes.resize(static_cast<std::size_t>(state.fields.count));
  for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m) {
    Particles particles = make_particles(scene, m);
    particles.critical_courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, m));
    });
    particles.lone_courant = lone_courant(scene, m);
    particles.tally_sizes = tally_sizes(scene, m);
    particles.field = state.fields.of_material[static_cast<std::size_t>(m)];
    particles.rigid = state.fields.rigid_body[static_cast<std::size_t>(particles.field)] >= 0;
    state.particles.push_back(particles);
  }
}

std::vector<Reaction> reactions_of(const Scene& scene, const VelocityFields& fields) {
  std::vector<Reaction> reactions;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b)
    for (int f = 0; f < fields.count; ++f)
      if (fields.rigid_body[static_cast<std::size_t>(f)] == b) reactions.push_back({b, f, {}});
  return reactions;
}

/// The particles of a body that are in this rank's tiles.
void fill_body(const Scene& scene, std::size_t b, ParticleId first_id, State& state) {
  const BodySpec& body = scene.bodies[b];
  const double energy = initial_energy(scene, body);
  const StartPoint at_rest = start_point(scene, body.material, &body);
  Particles& particles = state.particles[static_cast<std::size_t>(body.material)];
  const int first_row = particles.count;
  for_each_body_particle(scene.grid, body, first_id, [&](const NewParticle& made) {
    if (owner_of(state.grid, made.x) != state.grid.comm->getRank()) return;
    const Vector velocity = start_velocity(scene, body, made.x);
    const int p = add_particle(scene, particles, made, static_cast<int>(b), at_rest, velocity);
    put_velocity_gradient(scene, body, made, p, particles);
  });
  if (!particles.rigid) enter(particles, first_row, energy, state.ledger);
}

std::vector<double> cavities_of(const Scene& scene) {
  std::vector<double> cavities;
  for (const PressureLoadSpec& load : scene.loads) {
    const bool fluid = load.kind == LoadKind::pore_fluid;
    const Shape& shape = scene.bodies[static_cast<std::size_t>(load.body)].shape;
    cavities.push_back(fluid ? cavity_volume(std::get<Ball>(shape), scene.grid) : 0.0);
  }
  return cavities;
}

}  // namespace

State build_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const Region region("build_state");
  State state;
  const int reach =
      visit_shape(scene.step.shape, [&](auto shape) { return decltype(shape)::reach(scene); });
  state.grid = make_grid(scene.grid, reach, comm);
  state.grid.owner =
      bisect_tiles(state.grid.tiles, count_in_tiles(scene, state.grid), comm->getSize());
  add_sets(scene, state);
  state.reactions = reactions_of(scene, state.fields);
  state.pore_flow.on = scene.pore_flow.on();
  state.dormancy = make_dormancy(scene);
  state.cavities = cavities_of(scene);
  const std::vector<ParticleId> first = first_ids(scene);
  const std::size_t bodies = scene.bodies.size();
  state.slug_ids.assign(first.begin() + static_cast<std::ptrdiff_t>(bodies), first.end());
  for (std::size_t b = 0; b < bodies; ++b) fill_body(scene, b, first[b], state);
  OwnLedger& ledger = state.ledger;
  ledger.mass = ledger.initial_mass;
  ledger.momentum = ledger.initial_momentum;
  ledger.kinetic = ledger.initial_kinetic;
  ledger.elastic = ledger.prestress;
  return state;
}

}  // namespace barreno
