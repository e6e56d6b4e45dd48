// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_sets.hpp"

#include "base/gather.hpp"
#include "step/boundary/move_rigid_particles.hpp"
#include "step/cell_step.hpp"
#include "step/particles/move_particles.hpp"
#include "step/particles/tally_domains.hpp"
#include "step/particles/update_deformation.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace barreno {
namespace {

/// change(rows, particles) of set s, timed for the balance of the ranks.
template <class Change>
void for_each_set_block(const SetUpdate& update, std::size_t s, const Change& change) {
  Particles& particles = update.sets[s];
  std::size_t block = 0;
  const auto change_block = [&](Rows rows) {
    const Stopwatch watch;
    change(rows, particles);
    update.effort.add(s, block++, watch.seconds());
  };
  for_each_block(
      particles.count, change_block, update.dormancy.on ? particles.chunk_part.data() : nullptr
  );
}
template <class Change>
void for_each_block_of_sets(const SetUpdate& update, const Change& change) {
  for (std::size_t s = 0; s < update.sets.size(); ++s)
    if (!update.sets[s].rigid) for_each_set_block(update, s, change);
}

/// Particles with an inverted domain have failed like those that their material gave up.
void add(const DomainTally& domains, StressTally& set, double& clipped) {
  clipped += domains.clipped;
  StressTally failed;
  failed.failures = domains.inverted;
  failed.first_failed = domains.first_bad;
  add(failed, set);
  set.stable_step = std::min(set.stable_step, domains.stable_step);
}

/// Applies the set's particle policy to its failures.
void apply_policy(
    BadParticlePolicy policy,
    int material,
    const StressTally& set,
    OwnLedger& ledger,
    StepResult& result
) {
  if (policy == BadParticlePolicy::hold) ledger.held += set.failures;
  const bool stops = policy == BadParticlePolicy::stop;
  if (set.failures > 0.0 && stops && (result.failed < 0 || set.first_failed < result.failed))
    result = {true, set.first_failed, material, result.interrupt, {}};
}

/// What the update of a set was worth to its material; tally_step carries the sums.
void enter(const StressTally& set, OwnMaterialEnergies& material) {
  material.elastic += set.elastic;
  material.plastic += set.plastic;
  material.viscous += set.viscous;
  material.explosive += set.explosive;
}

/// F and sigma of all sets, after first(rows, particles) of each block.
template <class First>
void strain_after(
    const SetUpdate& update,
    Gradient gradient,
    const First& first,
    StepTally& tally,
    StepResult& result
) {
  const auto& [materials, step, grid, dormancy, sets, ledger, effort, end, own_fields] = update;
  double clipped = 0.0;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (sets[s].rigid) continue;
    const MaterialSpec& material = materials[static_cast<std::size_t>(sets[s].material)];
    StressTally set;
    for_each_set_block(update, s, [&](Rows rows, Particles& particles) {
      first(rows, particles);
      update_deformation(update.grid.mode, rows, gradient, particles);
      add(update_stress(material, update.step, update.grid, update.end, rows, particles), set);
    });
    add(tally_domains(step, material.bad_particles, own_fields, grid, sets[s]), set, clipped);
    // Found from all of a cell, at the end of the step.
    if (decides_by_cells(sets[s])) set.stable_step = std::numeric_limits<double>::infinity();
    sets[s].stable_step = set.stable_step;
    apply_policy(material.bad_particles, sets[s].material, set, ledger, result);
    enter(set, ledger.materials[static_cast<std::size_t>(sets[s].material)]);
    add(set, tally.stress);
  }
  ledger.clipped = {};
  ledger.clipped += clipped;
}

}  // namespace

SetUpdate set_update(
    const std::vector<MaterialSpec>& materials, const StepSpec& step, double end, State& state
) {
  return {
      materials,
      step,
      state.grid,
      state.dormancy,
      state.particles,
      state.ledger,
      state.effort,
      end,
      state.fields.count > 1};
}

void update_sets(const SetUpdate& update, StepTally& tally, StepResult& result) {
  const auto first = [&](Rows rows, Particles& particles) {
    add(accelerate_particles(update.step, update.grid, rows, particles), tally.moved);
    move_particles(update.grid, rows, particles);
  };
  strain_after(update, Gradient::at_start, first, tally, result);
}

void accelerate_sets(const SetUpdate& update, StepTally& tally) {
  for_each_block_of_sets(update, [&](Rows rows, Particles& particles) {
    add(accelerate_particles(update.step, update.grid, rows, particles), tally.moved);
  });
}

void move_and_strain_sets(const SetUpdate& update, StepTally& tally, StepResult& result) {
  const auto first = [&](Rows rows, Particles& particles) {
    move_particles(update.grid, rows, particles);
  };
  strain_after(update, Gradient::at_start, first, tally, result);
}

void strain_sets(const SetUpdate& update, StepTally& tally, StepResult& result) {
  strain_after(
      update, Gradient::at_end, [](Rows, Particles&) {}, tally, result
  );
}

void accelerate_and_move_sets(const SetUpdate& update, StepTally& tally) {
  for_each_block_of_sets(update, [&](Rows rows, Particles& particles) {
    add(accelerate_particles(update.step, update.grid, rows, particles), tally.moved);
    move_particles(update.grid, rows, particles);
  });
}

void move_rigid_sets(
    const RigidMotions& motions,
    double time,
    const Grid& grid,
    std::vector<Particles>& sets,
    StepTally& tally
) {
  for (Particles& particles : sets) {
    if (!particles.rigid) continue;
    StressTally set;
    set.stable_step = move_rigid_particles(motions, time, grid, particles);
    particles.stable_step = set.stable_step;
    add(set, tally.stress);
  }
}

void agree_on_failure(
    const std::vector<MaterialSpec>& materials, const Teuchos::Comm<int>& comm, StepResult& result
) {
  const bool may_stop = std::any_of(materials.begin(), materials.end(), [](const MaterialSpec& m) {
    return m.bad_particles == BadParticlePolicy::stop;
  });
  if (!may_stop) return;
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 1> first{result.failed < 0 ? none : static_cast<double>(result.failed)};
  min_over_ranks(comm, first);
  if (first[0] == none) return;
  std::array<double, 1> material{
      static_cast<double>(result.failed) == first[0] ? result.material : -1.0};
  max_over_ranks(comm, material);
  result = {
      true, static_cast<ParticleId>(first[0]), static_cast<int>(material[0]), result.interrupt, {}};
}

}  // namespace barreno
