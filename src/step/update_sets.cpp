// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_sets.hpp"

#include "base/gather.hpp"
#include "step/move_particles.hpp"
#include "step/move_rigid.hpp"
#include "step/tally_domains.hpp"
#include "step/update_deformation.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace barreno {
namespace {

/// update(rows, particles) of set s, timed for the balance of the ranks.
template <class Update>
void for_each_set_block(State& state, std::size_t s, const Update& update) {
  Particles& particles = state.particles[s];
  std::size_t block = 0;
  const auto update_block = [&](Rows rows) {
    const Stopwatch watch;
    update(rows, particles);
    state.effort.add(s, block++, watch.seconds());
  };
  for_each_block(
      particles.count, update_block, state.dormancy.on ? particles.run_part.data() : nullptr
  );
}
template <class Update>
void for_each_block_of_sets(State& state, const Update& update) {
  for (std::size_t s = 0; s < state.particles.size(); ++s)
    if (!state.particles[s].rigid) for_each_set_block(state, s, update);
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

/// What the set's particle policy says to its failures.
void apply_policy(
    const Scene& scene,
    const Particles& particles,
    const StressTally& set,
    State& state,
    StepResult& result
) {
  const BadParticlePolicy policy =
      scene.materials[static_cast<std::size_t>(particles.material)].bad_particles;
  if (policy == BadParticlePolicy::hold) state.ledger.held += set.failures;
  const bool stops = policy == BadParticlePolicy::stop;
  if (set.failures > 0.0 && stops && (result.failed < 0 || set.first_failed < result.failed))
    result = {true, set.first_failed, particles.material, result.interrupt, {}};
}

/// F and sigma of all sets, after first(rows, particles) of each block.
template <class First>
void strain_after(
    const Scene& scene,
    double dt,
    State& state,
    StepTally& tally,
    StepResult& result,
    Gradient gradient,
    const First& first
) {
  double clipped = 0.0;
  for (std::size_t s = 0; s < state.particles.size(); ++s) {
    if (state.particles[s].rigid) continue;
    StressTally set;
    for_each_set_block(state, s, [&](Rows rows, Particles& particles) {
      first(rows, particles);
      update_deformation(scene, rows, gradient, particles);
      add(update_stress(scene, dt, rows, particles), set);
    });
    add(tally_domains(scene, state.grid, state.particles[s]), set, clipped);
    apply_policy(scene, state.particles[s], set, state, result);
    add(set, tally.stress);
  }
  state.ledger.clipped = {};
  state.ledger.clipped += clipped;
}

}  // namespace

void update_sets(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
) {
  const auto first = [&](Rows rows, Particles& particles) {
    add(accelerate_particles(scene, dt, rows, particles), tally.moved);
    move_particles(scene, dt, rows, particles);
  };
  strain_after(scene, dt, state, tally, result, Gradient::at_start, first);
}

void accelerate_sets(const Scene& scene, double dt, State& state, StepTally& tally) {
  for_each_block_of_sets(state, [&](Rows rows, Particles& particles) {
    add(accelerate_particles(scene, dt, rows, particles), tally.moved);
  });
}

void move_and_strain_sets(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
) {
  const auto first = [&](Rows rows, Particles& particles) {
    move_particles(scene, dt, rows, particles);
  };
  strain_after(scene, dt, state, tally, result, Gradient::at_start, first);
}

void strain_sets(
    const Scene& scene, double dt, State& state, StepTally& tally, StepResult& result
) {
  strain_after(scene, dt, state, tally, result, Gradient::at_end, [](Rows, Particles&) {});
}

void accelerate_and_move_sets(const Scene& scene, double dt, State& state, StepTally& tally) {
  for_each_block_of_sets(state, [&](Rows rows, Particles& particles) {
    add(accelerate_particles(scene, dt, rows, particles), tally.moved);
    move_particles(scene, dt, rows, particles);
  });
}

void move_rigid_sets(const Scene& scene, double dt, State& state, StepTally& tally) {
  for (Particles& particles : state.particles) {
    if (!particles.rigid) continue;
    StressTally set;
    set.stable_step = move_rigid(scene, state.clock, dt, particles);
    add(set, tally.stress);
  }
}

void agree_on_failure(const Scene& scene, const State& state, StepResult& result) {
  const bool may_stop =
      std::any_of(scene.materials.begin(), scene.materials.end(), [](const MaterialSpec& m) {
        return m.bad_particles == BadParticlePolicy::stop;
      });
  if (!may_stop) return;
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 1> first{result.failed < 0 ? none : static_cast<double>(result.failed)};
  min_over_ranks(*state.grid.comm, first);
  if (first[0] == none) return;
  std::array<double, 1> material{
      static_cast<double>(result.failed) == first[0] ? result.material : -1.0};
  max_over_ranks(*state.grid.comm, material);
  result = {
      true, static_cast<ParticleId>(first[0]), static_cast<int>(material[0]), result.interrupt, {}};
}

}  // namespace barreno
