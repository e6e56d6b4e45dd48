// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/take_over.hpp"

#include "base/region.hpp"
#include "base/split_scales.hpp"
#include "grid/tiles.hpp"
#include "state/balance.hpp"
#include "state/build_state.hpp"
#include "step/order/remove_lost.hpp"
#include "step/ranks/migrate_particles.hpp"

#include <algorithm>
#include <barreno/history_values.hpp>
#include <barreno/input/scan_xml.hpp>
#include <barreno/models.hpp>
#include <limits>
#include <unordered_map>
#include <utility>
#include <variant>

namespace barreno {
namespace {

constexpr double no_particle = std::numeric_limits<double>::max();

/// Fields that start anew: what belongs to loads, and what APIC remembers of the grid.
bool starts_anew(const std::string& field) {
  return field == "loaded_faces" || field == "surface_share" || field == "affine";
}

/// Fields of a set and those that fill them; a null pointer: zero.
using FieldPairs = std::vector<std::pair<const Field*, const Field*>>;
FieldPairs pairs_of(const Particles& from, const Particles& to) {
  FieldPairs pairs;
  to.for_each_field([&](const Field& field) {
    const Field* source = nullptr;
    if (!starts_anew(field.name))
      from.for_each_field([&](const Field& other) {
        if (std::string(other.name) == field.name && other.components == field.components)
          source = &other;
      });
    pairs.emplace_back(&field, source);
  });
  return pairs;
}

/// The particle's modulus by the material of the deck.
double modulus_of(const MaterialSpec& material, const Particles& particles, int p) {
  const double ratio = particles.volume(p) * material.density() / particles.mass(p);
  return std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        auto history = model.initial_history();
        double* const values = history_values<Model>(history);
        for (int c = 0; c < Model::history_count; ++c) values[c] = particles.history(p, c);
        Sym3 stress{};
        double* const components = reals_of<double>(stress);
        for (int c = 0; c < particles.stress.components; ++c)
          components[c] = particles.stress(p, c);
        return model.longitudinal_modulus(stress, history, ratio);
      },
      material.material().model
  );
}

/// Moves rows from the sets of a run into those of a scene, on this rank.
class RowMover {
public:
  RowMover(
      const Scene& run, const Succession& succession, const Scene& scene, double time, State& state
  )
      : run_(run),
        succession_(succession),
        scene_(scene),
        time_(time),
        state_(state),
        taken_(2 * (run.bodies.size() + 1)),
        left_(taken_.size()) {}

  void move(const Grid& from_grid, const Particles& from) {
    const RemovalRule rule(from_grid, from);
    pairs_.clear();
    for (const Particles& to : state_.particles) pairs_.push_back(pairs_of(from, to));
    for (int p = 0; p < from.count; ++p) {
      if (p % max_summed_rows == 0) carry_sums();
      const auto b = static_cast<std::size_t>(from.body(p) & ~debris_bit);
      const int body = succession_.body_of[b];
      const int cause = rule.cause_of(p);
      const bool sound = cause < 0 || cause == static_cast<int>(RemovalCause::left_grid);
      const bool taken = body >= 0 && sound && state_.grid.holds(vector_of(from.position, p));
      std::vector<ReproducibleSum>& sums = taken ? taken_ : left_;
      sums[2 * b] += 1.0;
      sums[2 * b + 1] += from.mass(p) / run_.quasi_static.inertia_factor;
      if (taken) add_row(from, p, body);
    }
    carry_sums();
  }
  /// Particles and mass by body of the run, of this rank.
  std::vector<ReproducibleSum> taken() const { return taken_; }
  std::vector<ReproducibleSum> left() const { return left_; }

private:
  void carry_sums() {
    for (std::vector<ReproducibleSum>* sums : {&taken_, &left_})
      for (ReproducibleSum& sum : *sums) sum.carry();
  }
  void add_row(const Particles& from, int p, int body) {
    const auto b = static_cast<std::size_t>(body);
    const auto m = static_cast<std::size_t>(scene_.bodies[b].material);
    Particles& to = state_.particles[m];
    const int q = to.count;
    reserve(to, q + 1);
    ++to.count;
    mark_unplaced(to, q);
    to.id(q) = from.id(p);
    to.body(q) = body | (from.body(p) & debris_bit);
    for (const auto& [field, source] : pairs_[m])
      for (int c = 0; c < field->components; ++c)
        (*field)(q, c) = source != nullptr ? (*source)(p, c) : 0.0;
    settle_row(from, scene_.materials[m], b, q, to);
  }
  /// What does not stay as it is.
  void settle_row(
      const Particles& from, const MaterialSpec& material, std::size_t body, int q, Particles& to
  ) {
    const auto old = static_cast<std::size_t>(from.material);
    to.mass(q) *= material.density() / run_.materials[old].density();
    if (to.burn_columns.burns()) to.history(q, to.burn_columns.lighting) -= time_;
    if (succession_.at_rest) {
      for (int d = 0; d < to.velocity.components; ++d) to.velocity(q, d) = 0.0;
      to.viscous_pressure(q) = 0.0;
    }
    const bool debris = (to.body(q) & debris_bit) != 0;
    if (!succession_.same_material[body] && !debris)
      to.longitudinal_modulus(q) = modulus_of(material, to, q);
  }

  const Scene& run_;
  const Succession& succession_;
  const Scene& scene_;
  double time_;  ///< of the run
  State& state_;
  std::vector<FieldPairs> pairs_;              ///< of the set that is moved, by set of the state
  std::vector<ReproducibleSum> taken_, left_;  ///< by body of the run, its jet last: count, mass
};

/// Particles by parcel on all ranks. Collective.
std::vector<ParcelCost> count_by_parcel(const State& state) {
  const Grid& grid = state.grid;
  std::vector<double> counts(grid.owner.size(), 0.0);
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      const int tile = cell_of(grid, vector_of(particles.position, p)).box_tile;
      counts[static_cast<std::size_t>(grid.parcels.holding(tile))] += 1.0;
    }
  sum_over_ranks(*grid.comm, counts);  // whole numbers: in any order the same
  std::vector<ParcelCost> costs(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) costs[i].particles = counts[i];
  return costs;
}

/// Smallest half size by material, on all ranks. Collective.
std::vector<double> smallest_half_sizes(const State& state) {
  std::vector<double> least;
  for (const Particles& particles : state.particles) {
    double& mine = least.emplace_back(no_particle);
    for (int p = 0; p < particles.count; ++p)
      for (int d = 0; d < particles.half_size.components; ++d)
        mine = std::min(mine, particles.half_size(p, d));
  }
  min_over_ranks(*state.grid.comm, least);
  std::replace(least.begin(), least.end(), no_particle, 0.0);
  return least;
}

/// The ledger starts with what the particles have; their elastic energy is that of the run's
/// ledger, which no particle keeps.
void start_ledger(double elastic, State& state) {
  OwnLedger& ledger = state.ledger;
  for (const Particles& particles : state.particles) {
    if (particles.rigid) continue;
    for (int p = 0; p < particles.count; ++p) {
      const double m = particles.mass(p);
      const Vector v = vector_of(particles.velocity, p);
      ledger.initial_mass += m;
      ledger.initial_momentum += m * v[1];
      ledger.initial_kinetic += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      if (p % max_summed_rows == 0) carry(ledger);
    }
  }
  carry(ledger);
  if (is_root(*state.grid.comm)) ledger.prestress += elastic;
  ledger.mass = ledger.initial_mass;
  ledger.momentum = ledger.initial_momentum;
  ledger.kinetic = ledger.initial_kinetic;
  ledger.elastic = ledger.prestress;
}

std::vector<ContinuedBody> bodies_of(
    const Scene& run,
    const Succession& succession,
    const std::vector<ReproducibleSum>& taken,
    const std::vector<ReproducibleSum>& left
) {
  std::vector<ContinuedBody> bodies;
  for (std::size_t b = 0; b < succession.body_of.size(); ++b) {
    const bool jet = b == run.bodies.size();
    if (jet && !run.jet.present) continue;
    bodies.push_back(
        {jet ? "Jet" : input::on_one_line(run.bodies[b].name),
         succession.body_of[b] >= 0,
         {taken[2 * b], taken[2 * b + 1]},
         {left[2 * b], left[2 * b + 1]}}
    );
  }
  return bodies;
}

/// Ids of the bodies that the deck has, in the order of the run.
std::vector<IdRange> taken_ids(
    const Succession& succession, const Scene& scene, const std::vector<IdRange>& ids
) {
  std::vector<IdRange> taken;
  for (std::size_t b = 0; b < ids.size(); ++b) {
    const int body = succession.body_of[b];
    if (body < 0) continue;
    const int material = scene.bodies[static_cast<std::size_t>(body)].material;
    taken.push_back({material, ids[b].first, ids[b].count});
  }
  return taken;
}

}  // namespace

Continued take_over(
    const Scene& run,
    State& ended,
    const std::vector<IdRange>& ids,
    const Succession& succession,
    const Scene& scene,
    State& state
) {
  const Region region("take_over");
  const Comm& comm = *state.grid.comm;
  const double elastic = sum_over_ranks(comm, ended.ledger).elastic;
  RowMover mover(run, succession, scene, ended.clock.time, state);
  for (const Particles& particles : ended.particles) mover.move(ended.grid, particles);
  ended.particles.clear();
  share_parcels(count_by_parcel(state), state.grid);
  migrate_particles(state.grid, state.particles);
  start_ledger(elastic, state);
  std::vector<ReproducibleSum> taken = mover.taken(), left = mover.left();
  sum_over_ranks(comm, taken);
  sum_over_ranks(comm, left);
  Continued continued;
  continued.time = ended.clock.time;
  continued.bodies = bodies_of(run, succession, taken, left);
  continued.ids = taken_ids(succession, scene, ids);
  continued.half_sizes = smallest_half_sizes(state);
  bound_steps(scene, continued, state);
  return continued;
}

namespace {

/// Rows of this rank by the id with which their body was made: parts of a divided particle have the
/// ids behind it.
std::unordered_map<ParticleId, std::vector<int>> rows_by_made_id(
    const Particles& particles, int body, ParticleId first, ParticleId ids_each
) {
  std::unordered_map<ParticleId, std::vector<int>> rows;
  for (int p = 0; p < particles.count; ++p) {
    if ((particles.body(p) & ~debris_bit) != body) continue;
    rows[(particles.id(p) - first) / ids_each].push_back(p);
  }
  return rows;
}

}  // namespace

void put_loads_on_taken(const Origin& origin, const Scene& scene, State& state) {
  const Scene& from = origin.scene;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Particles& particles = state.particles[static_cast<std::size_t>(scene.bodies[b].material)];
    if (particles.loaded_faces.components == 0) continue;
    const auto made = std::find_if(from.bodies.begin(), from.bodies.end(), [&](const auto& body) {
      return body.name == scene.bodies[b].name;
    });
    const auto o = static_cast<std::size_t>(made - from.bodies.begin());
    const auto rows = rows_by_made_id(
        particles, static_cast<int>(b), origin.census.first[o], ids_of_particle(from, *made)
    );
    const auto put = [&](const NewParticle& particle) {
      const auto found = rows.find(particle.id);
      if (found == rows.end()) return;
      for (const int p : found->second)
        put_load_shares(scene, static_cast<int>(b), particle, p, particles);
    };
    for_each_body_particle(from.grid, *made, 0, put, box_cuts(from));
  }
}

}  // namespace barreno
