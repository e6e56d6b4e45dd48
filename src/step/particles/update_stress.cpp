// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/update_stress.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "scene/explosive_traits.hpp"
#include "scene/heat.hpp"
#include "scene/voids.hpp"
#include "state/bad_particle.hpp"
#include "state/dormancy.hpp"
#include "state/row_frames.hpp"
#include "step/particles/burn_explosive.hpp"
#include "step/particles/point_group.hpp"
#include "step/stable_step_rule.hpp"

#include <barreno/models.hpp>
#include <limits>
#include <string>
#include <variant>

namespace barreno {
namespace {

template <class Model, class R>
struct UpdateStress {
  using Group = PointGroup<Model, R>;
  using Mask = MaskOf<R>;

  Model model;
  Particles particles;
  int components;  ///< of stress and strain
  StableStepRule rule;
  BadParticlePolicy policy;
  double reference_density;
  double largest_expansion;
  double end_time;  ///< of the step
  RowFrames frames;

  /// Sums over the lanes' own rows.
  struct Tally {
    RowSum<R> elastic, plastic, viscous, stress_work;
    R stable_step = R{} + std::numeric_limits<double>::infinity();
  };

  KOKKOS_INLINE_FUNCTION void treat_failure(int p, Fault fault, StressTally& sums) const {
    sums.failures += 1.0;
    const ParticleId id = particles.id(p);
    if (sums.first_failed < 0 || id < sums.first_failed) sums.first_failed = id;
    treat_bad_particle(particles, p, policy, fault);
  }
  KOKKOS_INLINE_FUNCTION void treat_failures(
      const Group& group, const Mask& failed, Fault fault, StressTally& sums
  ) const {
    if (!real::any(failed)) return;
    for (int i = 0; i < group.count; ++i)
      if (entry(failed, i) != 0) treat_failure(group.first + i, fault, sums);
  }

  /// Rows that are there and not debris.
  KOKKOS_INLINE_FUNCTION Mask alive(const Group& group) const {
    const bool may_hold = policy == BadParticlePolicy::hold;
    if (!may_hold && group.count == width<R>) return R{} <= 0.0;
    return mask_of<R>([&](int i) {
      return i < group.count && !(may_hold && (particles.body(group.first + i) & debris_bit));
    });
  }

  /// Rows of dormant tiles in a chunk that is updated: their motion is nothing, and they must not
  /// change by the round-off that a model makes of nothing.
  KOKKOS_INLINE_FUNCTION Mask dormant(const Group& group) const {
    if (particles.chunk_part(group.first / rows_per_chunk) == whole_chunk) return R{} > 0.0;
    return mask_of<R>([&](int i) {
      return i < group.count && particles.dormant(group.first + i) != 0;
    });
  }

  /// Whether all rows are in tiles whose own steps go on, in a chunk that others share: nothing is
  /// asked of them before those end.
  KOKKOS_INLINE_FUNCTION bool is_in_its_step_whole(const Group& group) const {
    if (particles.chunk_part(group.first / rows_per_chunk) != part_of_chunk) return false;
    bool all = true;
    for (int i = 0; i < group.count; ++i)
      all = all && particles.dormant(group.first + i) == is_in_its_step;
    return all;
  }

  using Update = PointsOf<Sym3Of<R>, typename Group::History>;

  /// What end() needs of begin() beside the update itself.
  struct Begun {
    R mass, volume, old_volume, density, rate;  ///< rate: tr D
    R old_modulus, old_q, q;                    ///< q: artificial viscosity at the end of the step
    R cell_size;
    Sym3Of<R> old_stress;
  };

  /// State and increment of a group.
  KOKKOS_INLINE_FUNCTION Update begin(const Group& group, Begun& begun) const {
    for (const Field* field :
         {&particles.stress,
          &particles.history,
          &particles.viscous_pressure,
          &particles.longitudinal_modulus})
      group.prefetch(*field);
    const GroupFrame<R> frame(frames, group.first, group.count);
    begun.cell_size = frame.cell_size;
    begun.mass = group.get(particles.mass);
    begun.volume = group.get(particles.volume);
    begun.old_volume = group.get(particles.increment, components);
    const R per_reference = 1.0 / (begun.mass * (1.0 / reference_density));
    Update update;
    auto& increment = update.increment;
    increment.strain = group.get_tensor(particles.increment, components);
    increment.dt = frame.dt;
    increment.volume_ratio_begin = begun.old_volume * per_reference;
    increment.volume_ratio_end = begun.volume * per_reference;
    begun.old_q = group.get(particles.viscous_pressure);
    begun.old_modulus = group.get(particles.longitudinal_modulus);
    begun.density = begun.mass / begun.volume;
    begun.rate = trace(increment.strain) * (1.0 / frame.dt);
    begun.q = rule.viscous_pressure(begun.cell_size, begun.density, begun.old_modulus, begun.rate);
    update.history = group.get_history(particles.history);
    begun.q = burn_explosive(model, end_time, begun.cell_size, begun.q, update.history);
    increment.viscous_pressure = 0.5 * (begun.old_q + begun.q);
    begun.old_stress = group.get_tensor(particles.stress, components);
    update.stress = begun.old_stress;
    return update;
  }

  /// Of a group over its step [energy].
  struct Works {
    R elastic, plastic, viscous, stress;
  };
  /// Particles get what the grid took from them: what their update did not know of becomes heat.
  KOKKOS_INLINE_FUNCTION void take_losses(
      const Group& group,
      const Begun& begun,
      const Sym3Of<R>& stress,
      Works& works,
      typename Group::History& history
  ) const {
    works.stress = group.get(particles.heat);
    const R elastic = works.stress - works.plastic - works.viscous;
    if constexpr (is_heated_rock<Model>)
      model.add_heat(R((elastic - works.elastic) / begun.mass), stress, history);
    else
      model.correct_energy(
          group.get_history(particles.history), R(works.stress / begun.mass), history
      );
    works.elastic = elastic;
  }

  /// What becomes of a group whose update is done.
  KOKKOS_INLINE_FUNCTION void end(
      const Group& group, const Update& update, const Begun& begun, Tally& tally, StressTally& sums
  ) const {
    const auto& increment = update.increment;
    const PointsOutcome<R>& outcome = update.outcome;
    const Mask living = alive(group);
    const Mask here = living & (!dormant(group));
    R ratio = increment.volume_ratio_end;
    if constexpr (opens_voids<Model>) ratio = Model::expanded_ratio(ratio, update.history);
    const Mask expanded = here & (ratio > largest_expansion);
    // Not every model checks its input: motion that is not finite fails here.
    const Mask sound = outcome.sound & (increment.volume_ratio_end > 0.0);
    const Mask good = here & (!expanded) & sound;

    group.put_tensor(
        select_points(good, update.stress, begun.old_stress), particles.stress, components
    );
    group.put(real::select(good, begun.q, begun.old_q), particles.viscous_pressure);
    const R modulus = real::select(good, outcome.longitudinal_modulus, begun.old_modulus);
    group.put(modulus, particles.longitudinal_modulus);
    treat_failures(group, expanded, Fault::expanded, sums);
    treat_failures(group, here & (!expanded) & (!sound), Fault::failed, sums);

    const R reference_volume = begun.mass * (1.0 / reference_density);
    const R mean_volume = 0.5 * (begun.old_volume + begun.volume);
    const R viscous = increment.viscous_pressure * (begun.old_volume - begun.volume);
    R stress_work =
        mean_volume * (0.5 * contract(begun.old_stress + update.stress, increment.strain) -
                       increment.viscous_pressure * trace(increment.strain));
    R elastic_work = reference_volume * outcome.elastic_work;
    // Voids close and open without work, in a part of the step that the model alone knows.
    if constexpr (opens_voids<Model>)
      stress_work = elastic_work + reference_volume * outcome.plastic_work + viscous;
    auto history = update.history;
    Works works{elastic_work, reference_volume * outcome.plastic_work, viscous, stress_work};
    if constexpr (keeps_heat<Model> || is_heated_rock<Model>)
      if (particles.heat.components > 0) take_losses(group, begun, update.stress, works, history);
    group.put_history(good, history, particles.history);
    tally_works(good, works, tally, sums);
    R speed_squared{};
    for (int d = 0; d < particles.velocity.components; ++d) {
      const R v = group.get(particles.velocity, d);
      speed_squared += v * v;
    }
    const R step = rule.stable_step(
        begun.cell_size, begun.density, modulus, begun.rate, real::sqrt(speed_squared)
    );
    limit_step(good | (living & (!here)), step, tally);
  }

  KOKKOS_INLINE_FUNCTION void tally_works(
      const Mask& good, const Works& works, Tally& tally, StressTally& sums
  ) const {
    const SplitScales& scales = particles.tally_scales.energy;
    const auto enter = [&](const R& energy, RowSum<R>& sum, ReproducibleSum& beyond) {
      sum.add(real::select(good, energy, 0.0), scales, beyond);
    };
    if constexpr (burns_by_program<Model>) {
      enter(-works.elastic - works.viscous, tally.elastic, sums.explosive);
    } else {
      enter(works.elastic, tally.elastic, sums.elastic);
      enter(works.plastic, tally.plastic, sums.plastic);
      enter(works.viscous, tally.viscous, sums.viscous);
    }
    enter(works.stress, tally.stress_work, sums.stress_work);
  }

  KOKKOS_INLINE_FUNCTION static void limit_step(const Mask& good, const R& step, Tally& tally) {
    tally.stable_step = real::select(good & (step < tally.stable_step), step, tally.stable_step);
  }

  KOKKOS_INLINE_FUNCTION static Group group_at(int row, Rows rows) {
    return {row, rows.end - row < width<R> ? rows.end - row : width<R>};
  }
  /// Rows by groups, each through all of the update.
  KOKKOS_INLINE_FUNCTION void update_groups(Rows rows, Tally& tally, StressTally& sums) const {
    for (int row = rows.begin; row < rows.end; row += width<R>) {
      const Group group = group_at(row, rows);
      // find_dormant_tiles knows the step that they allow.
      if (rows.skips(row) || is_in_its_step_whole(group)) continue;
      Begun begun;
      Update update = begin(group, begun);
      update.outcome = update_points(model, update.increment, update.stress, update.history);
      end(group, update, begun, tally, sums);
    }
  }
  /// The same with a model whose update has two parts: what the first leaves waits for other groups
  /// to share the lanes with.
  KOKKOS_INLINE_FUNCTION void update_in_parts(Rows rows, Tally& tally, StressTally& sums) const {
    constexpr int most = Model::groups_together;
    constexpr std::size_t room = most;
    Group groups[room];
    Update waiting[room];
    Mask rest[room];
    Begun begun[room];
    int count = 0;
    const auto finish = [&] {
      if (count == 0) return;
      model.finish_points(waiting, rest, count);
      for (int g = 0; g < count; ++g) end(groups[g], waiting[g], begun[g], tally, sums);
      count = 0;
    };
    for (int row = rows.begin; row < rows.end; row += width<R>) {
      const Group group = group_at(row, rows);
      // find_dormant_tiles knows the step that they allow.
      if (rows.skips(row) || is_in_its_step_whole(group)) continue;
      Update update = begin(group, begun[count]);
      // Debris and points that have expanded too far skip the second part of the update.
      const Mask left = model.start_points(update) & alive(group) & (!dormant(group)) &
                        (update.increment.volume_ratio_end <= largest_expansion);
      if (real::any(left)) {
        groups[count] = group;
        rest[count] = left;
        waiting[count++] = update;
      } else {
        end(group, update, begun[count], tally, sums);
      }
      if (count == most) finish();
    }
    finish();
  }

  /// All rows of a launch index, so that the sums of the lanes are added up rarely.
  KOKKOS_INLINE_FUNCTION void operator()(Rows rows, StressTally& sums) const {
    Tally tally;
    if constexpr (updates_in_parts<Model, R>)
      update_in_parts(rows, tally, sums);
    else
      update_groups(rows, tally, sums);
    tally.elastic.add_to(burns_by_program<Model> ? sums.explosive : sums.elastic);
    tally.plastic.add_to(sums.plastic);
    tally.viscous.add_to(sums.viscous);
    tally.stress_work.add_to(sums.stress_work);
    for (int i = 0; i < width<R>; ++i) {
      const double step = entry(tally.stable_step, i);
      if (step < sums.stable_step) sums.stable_step = step;
    }
  }
};

}  // namespace

const char* stress_label(const Material& material) {
  return std::visit(
      [](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        static const std::string label = "update_stress " + FullName<Model>::of();
        return label.c_str();
      },
      material.model
  );
}

StressTally update_stress(
    const MaterialSpec& spec,
    const StepSpec& step,
    const Grid& grid,
    double end,
    Rows rows,
    Particles& particles
) {
  const Region region(stress_label(spec.material()));
  StressTally sums;
  std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        const UpdateStress<Model, typename RealFor<Model>::type> kernel{
            model,
            particles,
            particles.stress.components,
            StableStepRule(step, grid.mode, particles.critical_courant, particles.isolated_courant),
            spec.bad_particles,
            spec.density(),
            spec.largest_expansion.value_or(step.largest_expansion),
            end,
            RowFrames(grid, particles)};
        // A model that packs its yielding points needs many of them at once.
        constexpr int together = updates_in_parts<Model, typename RealFor<Model>::type>
                                     ? max_summed_rows
                                     : rows_per_chunk;
        launch_reduction(
            "update_stress",
            range((rows.end - rows.begin + together - 1) / together),
            KOKKOS_LAMBDA(const int i, StressTally& part) {
              const int first = rows.begin + i * together;
              const int past = rows.end - first < together ? rows.end : first + together;
              kernel(Rows{first, past, rows.chunks}, part);
            },
            TallyReducer<StressTally>(sums)
        );
      },
      spec.material().model
  );
  return sums;
}

}  // namespace barreno
