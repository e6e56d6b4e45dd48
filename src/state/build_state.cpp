// SPDX-License-Identifier: BSD-3-Clause
#include "state/build_state.hpp"

#include "base/error.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/work_counts.hpp"
#include "grid/partition.hpp"
#include "grid/tiles.hpp"
#include "scene/body_force.hpp"
#include "scene/dormant.hpp"
#include "scene/lighting.hpp"
#include "scene/porous.hpp"
#include "scene/voids.hpp"
#include "shape/visit_kernels.hpp"
#include "state/bodies/box_in_parcels.hpp"
#include "state/bodies/lattice_shares.hpp"
#include "state/isolated_courant.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <barreno/history_values.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <type_traits>
#include <utility>
#include <variant>

namespace barreno {
namespace {

/// True for a model whose strength scatters.
template <class Model, class = void>
struct VariesByPiece : std::false_type {};
template <class Model>
struct VariesByPiece<Model, std::void_t<decltype(&Model::vary)>> : std::true_type {};

/// Shares of a particle in the pressures on the surfaces of its ball.
void put_shares(
    const Scene& scene, const BodySpec& body, const Vector& x, int p, Particles& particles
) {
  const auto* ball = std::get_if<Ball>(&body.shape);
  if (particles.surface_share.components == 0 || ball == nullptr) return;
  const int count = dimensions(scene.grid.mode);
  int c = 0;
  for (const BallSurface surface : {BallSurface::inner, BallSurface::outer}) {
    const SurfaceShare share = surface_share(*ball, surface, x, count);
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

/// What the rows from `first` on bring into the balances.
void enter(const Particles& particles, int first, double stored_energy, OwnLedger& ledger) {
  OwnMaterialEnergies& own = ledger.materials[static_cast<std::size_t>(particles.material)];
  for (int p = first; p < particles.count; ++p) {
    const double m = particles.mass(p);
    const Vector v = vector_of(particles.velocity, p);
    ledger.initial_mass += m;
    ledger.initial_momentum += m * v[1];
    ledger.initial_kinetic += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    ledger.prestress += m * stored_energy;
    own.prestress += m * stored_energy;
    if (p % max_summed_rows == 0) carry(ledger);
  }
}

/// Elastic energy of the initial equilibrium per mass.
/// @throws DeckError if the material cannot hold the pressure
double initial_energy(const Scene& scene, const BodySpec& body) {
  const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material();
  return std::visit(
      [&](const auto& model) {
        const auto start = initial_state_of(model, body);
        if (start.possible) return start.stored_energy / material.density;
        std::ostringstream text;
        text << "Bodies/" << body.name << " starts under " << body.initial_pressure
             << " Pa, which its material '" << material.name
             << "' cannot hold elastically. Lower the confinement or take a stronger material.";
        throw DeckError(text.str());
      },
      material.model
  );
}

/// Without skipping, dormant tiles only matter where their nodes may move a little.
Dormancy make_dormancy(const Scene& scene) {
  Dormancy dormancy;
  dormancy.motion = rest_motion(scene);
  dormancy.skip = scene.step.skip_dormant;
  const bool used = dormancy.skip || dormancy.motion > 0.0 || scene.step.subcycles > 1;
  dormancy.on = why_all_awake(scene).empty() && used;
  return dormancy;
}

}  // namespace

namespace {

template <class Model, class Start>
StartPoint start_point_of(const Model& /*model*/, const Start& start) {
  const double* const h = history_values<Model>(start.history);
  return {start.stress, {h, h + Model::history_count}, start.volume_ratio};
}

}  // namespace

void put_load_shares(
    const Scene& scene, int body, const NewParticle& made, int p, Particles& particles
) {
  if (particles.loaded_faces.components > 0)
    particles.loaded_faces(p) = loaded_face_bits(scene, body, made.loaded_sides);
  put_shares(scene, scene.bodies[static_cast<std::size_t>(body)], made.x, p, particles);
}

StartPoint start_point(const MaterialSpec& material, const BodySpec* body) {
  StartPoint start = std::visit(
      [&](const auto& model) {
        return start_point_of(
            model, body ? initial_state_of(model, *body) : model.initial_state(0.0)
        );
      },
      material.material().model
  );
  if (body) start.per_cell = body->particles_per_cell;
  return start;
}

StartPoint expanded_start_point(const MaterialSpec& material, double expansion) {
  return std::visit(
      [&](const auto& model) {
        if constexpr (holds_voids<std::decay_t<decltype(model)>>)
          return start_point_of(model, model.expanded_state(expansion));
        else
          return start_point_of(model, model.initial_state(0.0));
      },
      material.material().model
  );
}

namespace {

/// Writes the rows of new particles that start alike, from `first_row` on.
template <class Model>
struct WriteNewParticles {
  Model model;
  double density;  ///< at reference [mass/length^3]
  double volume_ratio;
  Sym3 stress;
  double start_history[Model::history_count + 1] = {};
  double per_cell;  ///< particles along a cell
  int body, first_row;
  ArrayView<NewParticle> made;
  Particles particles;

  KOKKOS_INLINE_FUNCTION void write_motion(const NewParticle& from, int p) const {
    particles.id(p) = from.id;
    particles.body(p) = body;
    mark_unplaced(particles, p);
    const int d = particles.position.components;
    for (int i = 0; i < d; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      particles.position(p, i) = from.x[axis];
      particles.velocity(p, i) = from.velocity[axis];
      particles.half_size(p, i) = from.half[axis];
      particles.deformation_gradient(p, i * (d + 1)) = 1.0;
    }
    if (particles.deformation_gradient.components == 5) particles.deformation_gradient(p, 4) = 1.0;
    if (particles.rotation.components > 0) particles.rotation(p, 0) = 1.0;
    for (int c = 0; c < particles.reference_position.components; ++c)
      particles.reference_position(p, c) = from.x[static_cast<std::size_t>(c)];
  }
  /// Area in its plane, in three dimensions that of a cube of its volume, which is what the scatter
  /// of strength asks for.
  KOKKOS_INLINE_FUNCTION double section(const NewParticle& from) const {
    if (particles.position.components == 3) return std::pow(from.volume, 2.0 / 3.0);
    return 2.0 * from.half[0] * (2.0 * from.half[1]);
  }
  /// A call of its own: in the loop over rows compilers round the parts that do not change with the
  /// row by themselves.
  [[gnu::noinline]] KOKKOS_FUNCTION double modulus(const typename Model::History& history) const {
    return model.longitudinal_modulus(stress, history, volume_ratio);
  }
  KOKKOS_INLINE_FUNCTION void operator()(int k) const {
    const NewParticle& from = made(k);
    const int p = first_row + k;
    write_motion(from, p);
    auto history = model.initial_history();
    double* const h = history_values<Model>(history);
    for (int c = 0; c < Model::history_count; ++c) h[c] = start_history[c];
    if constexpr (VariesByPiece<Model>::value)
      model.vary(
          history, {static_cast<std::uint64_t>(from.id), from.volume, section(from), per_cell}
      );
    const double* const s = reals_of<double>(stress);
    for (int c = 0; c < 3; ++c) particles.stress(p, c) = s[c];
    for (int c = 0; c < Model::history_count; ++c) particles.history(p, c) = h[c];
    particles.volume(p) = from.volume;
    particles.mass(p) = density / volume_ratio * from.volume;
    particles.longitudinal_modulus(p) = modulus(history);
  }
};

/// Room for so many rows more, all fields 0.
int add_empty_rows(int count, Particles& particles) {
  const int first_row = particles.count;
  reserve(particles, first_row + count);
  particles.count += count;
  particles.sorted = false;
  const std::pair<int, int> rows(first_row, particles.count);
  particles.for_each_field([&](const Field& field) {
    Kokkos::deep_copy(Kokkos::subview(field.values, rows, Kokkos::ALL), 0.0);
  });
  return first_row;
}

}  // namespace

int add_particles(
    const MaterialSpec& material,
    const std::vector<NewParticle>& made,
    int body,
    const StartPoint& start,
    Particles& particles
) {
  const int count = static_cast<int>(made.size());
  const int first_row = add_empty_rows(count, particles);
  const Kokkos::View<const NewParticle*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> from(
      made.data(), made.size()
  );
  ArrayView<NewParticle> rows("new_particles", made.size());
  Kokkos::deep_copy(rows, from);
  std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        WriteNewParticles<Model> write{
            model,
            material.material().density,
            start.volume_ratio,
            start.stress,
            {},
            static_cast<double>(start.per_cell),
            body,
            first_row,
            rows,
            particles};
        std::copy(start.history.begin(), start.history.end(), write.start_history);
        launch("add_particles", range(count), write);
      },
      material.material().model
  );
  return first_row;
}

namespace {

/// An empty set of particles for each material, with the velocity fields that they move in.
void add_sets(const Scene& scene, State& state) {
  state.fields = velocity_fields(scene);
  state.nodes.resize(static_cast<std::size_t>(state.fields.count));
  state.step_limits = make_step_limits(scene);
  state.ledger.materials.resize(scene.materials.size());
  state.agreed.reserve(scene.materials.size() + 8);
  for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m) {
    Particles particles = make_particles(scene, m);
    particles.courant_table =
        visit_shape(scene.step.shape, [](auto shape) { return decltype(shape)::courant_table; });
    particles.critical_courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, m));
    });
    particles.isolated_courant = isolated_courant(scene, m);
    particles.tally_scales = tally_scales(scene, m);
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

/// Particles that are added at once: enough for a kernel, few beside those of a run.
constexpr std::size_t particles_at_once = 4096;

/// When the detonation comes to a particle of an explosive body. @return whether it does
bool put_lighting_time(const Scene& scene, int p, Particles& particles) {
  if (!particles.burn_columns.burns()) return true;
  const double time =
      lighting_time(scene.detonation, scene.grid.mode, vector_of(particles.position, p));
  particles.history(p, particles.burn_columns.lighting) = time;
  return std::isfinite(time);
}

/// What the scene lays on the particles of a body, row by row of what was made.
/// @return whether all of them are lit in time
bool put_loads(
    const Scene& scene,
    std::size_t b,
    const std::vector<NewParticle>& made,
    int first_row,
    Particles& particles
) {
  bool lit = true;
  for (std::size_t k = 0; k < made.size(); ++k) {
    const int p = first_row + static_cast<int>(k);
    put_load_shares(scene, static_cast<int>(b), made[k], p, particles);
    lit = put_lighting_time(scene, p, particles) && lit;
    put_velocity_gradient(scene, scene.bodies[b], made[k], p, particles);
  }
  return lit;
}

/// Bodies that are being filled with the particles of this rank's tiles.
class BodyFiller {
public:
  BodyFiller(const Scene& scene, const BodyCensus& census, State& state)
      : scene_(scene),
        census_(census),
        state_(state),
        made_(scene.bodies.size()),
        unlit_(scene.bodies.size(), 0) {}

  /// @param particle  its id counts from 0 over the body
  void take(std::size_t b, NewParticle particle) {
    const BodySpec& body = scene_.bodies[b];
    particle.velocity = start_velocity(scene_, body, particle.x);
    particle.id = census_.first[b] + particle.id * ids_of_particle(scene_, body);
    made_[b].push_back(particle);
    if (made_[b].size() == particles_at_once) add(b);
  }
  /// What was taken for a body becomes rows of its set.
  void add(std::size_t b) {
    if (made_[b].empty()) return;
    const BodySpec& body = scene_.bodies[b];
    const MaterialSpec& material = scene_.materials[static_cast<std::size_t>(body.material)];
    Particles& particles = state_.particles[static_cast<std::size_t>(body.material)];
    const StartPoint start = start_point(material, &body);
    const int row = add_particles(material, made_[b], static_cast<int>(b), start, particles);
    if (!put_loads(scene_, b, made_[b], row, particles)) unlit_[b] = 1;
    if (!particles.rigid) enter(particles, row, initial_energy(scene_, body), state_.ledger);
    work_counts().particles_made += static_cast<long long>(made_[b].size());
    made_[b].clear();
  }
  /// Collective. @throws DeckError  on every rank, where the detonation never comes to one
  void refuse_unlit() {
    max_over_ranks(*state_.grid.comm, unlit_);
    const auto first = std::find(unlit_.begin(), unlit_.end(), 1);
    if (first == unlit_.end()) return;
    throw DeckError(
        "Bodies/" + scene_.bodies[static_cast<std::size_t>(first - unlit_.begin())].name +
        " has a part thinner than a cell that the detonation does not reach around obstacles. Make "
        "cells smaller, or write Detonation/Lighting = straight."
    );
  }

private:
  const Scene& scene_;
  const BodyCensus& census_;
  State& state_;
  std::vector<std::vector<NewParticle>> made_;  ///< by body
  std::vector<long long> unlit_;                ///< by body: 1 if a particle is never lit
};

/// The particles of all bodies that are in this rank's tiles. Collective.
/// @throws NumericalError  on every rank
void fill_bodies(const Scene& scene, const BodyCensus& census, State& state) {
  for (const BodySpec& body : scene.bodies) initial_energy(scene, body);  // throws
  BodyFiller filler(scene, census, state);
  const auto take = [&](std::size_t b, const NewParticle& particle) { filler.take(b, particle); };
  LatticeShares shares(state.grid, take);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    if (std::holds_alternative<Box>(body.shape))
      for_each_own_box_particle(scene, body, state.grid, [&](const NewParticle& particle) {
        filler.take(b, particle);
      });
    else
      shares.make(scene.grid, body, b, census.before[b]);
    filler.add(b);
  }
  shares.finish();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) filler.add(b);
  filler.refuse_unlit();
}

}  // namespace

State build_empty_state(
    const Scene& scene, const BodyCensus& census, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
) {
  State state;
  const int reach =
      visit_shape(scene.step.shape, [&](auto shape) { return decltype(shape)::reach(scene); });
  state.grid = make_grid(scene, reach, comm);
  add_sets(scene, state);
  state.reactions = reactions_of(scene, state.fields);
  state.pore_flow.on = scene.pore_flow.on();
  state.dormancy = make_dormancy(scene);
  state.subcycling.most = state.dormancy.on ? scene.step.subcycles : 1;
  state.loads = make_load_table(scene);
  state.conditions = make_node_conditions(scene.conditions, state.grid);
  state.rigid_motions = make_rigid_motions(scene.bodies, state.fields);
  state.cavities = make_cavities(scene);
  const auto slugs = census.first.begin() + static_cast<std::ptrdiff_t>(scene.bodies.size());
  state.jet.body = static_cast<int>(scene.bodies.size());
  state.jet.slug_ids.assign(slugs, census.first.end());
  return state;
}

State build_state(
    const Scene& scene, const BodyCensus& census, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
) {
  const Region region("build_state");
  State state = build_empty_state(scene, census, comm);
  share_parcels(census.parcels, state.grid);
  fill_bodies(scene, census, state);
  OwnLedger& ledger = state.ledger;
  ledger.mass = ledger.initial_mass;
  ledger.momentum = ledger.initial_momentum;
  ledger.kinetic = ledger.initial_kinetic;
  ledger.elastic = ledger.prestress;
  for (OwnMaterialEnergies& own : ledger.materials) own.elastic = own.prestress;
  return state;
}

State build_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  return build_state(scene, take_census(scene, comm), comm);
}

}  // namespace barreno
