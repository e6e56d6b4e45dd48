// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_stress.hpp"

#include "base/points.hpp"
#include "base/region.hpp"
#include "state/step_rule.hpp"

#include <limits>
#include <string>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

/// A model's history of one or several points, and the R that it is updated with: Lanes where the
/// model has update_points().
template <class Model, class R>
struct HistoryFor {
  using type = typename Model::template HistoryOf<R>;
};
template <class Model>
struct HistoryFor<Model, double> {
  using type = typename Model::History;
};
template <class Model, class = void>
struct RealFor {
  using type = double;
};
#if BARRENO_HAS_LANES
template <class Model>
struct RealFor<Model, std::void_t<typename Model::template HistoryOf<Lanes>>> {
  using type = Lanes;
};
#endif

/// Points that go through the update together.
template <class Model, class R>
struct Points {
  using History = typename HistoryFor<Model, R>::type;
  static_assert(
      Model::history_count == 0 || sizeof(History) == sizeof(R) * Model::history_count,
      "a History holds reals only"
  );
  int first, count;

  KOKKOS_INLINE_FUNCTION R get(const Field& field, int c = 0) const {
    return load<R>(field.values, c, first, count);
  }
  KOKKOS_INLINE_FUNCTION void put(const R& value, const Field& field, int c = 0) const {
    store(value, field.values, c, first, count);
  }
  KOKKOS_INLINE_FUNCTION Sym3Of<R> get_plane(const Field& field) const {
    return {get(field, 0), get(field, 1), get(field, 2), get(field, 3), R{}, R{}};
  }
  KOKKOS_INLINE_FUNCTION void put_plane(const Sym3Of<R>& t, const Field& field) const {
    put(t.xx, field, 0);
    put(t.yy, field, 1);
    put(t.zz, field, 2);
    put(t.xy, field, 3);
  }
  KOKKOS_INLINE_FUNCTION History get_history(const Field& field) const {
    History history{};
    for (int c = 0; c < Model::history_count; ++c)
      reinterpret_cast<R*>(&history)[c] = get(field, c);
    return history;
  }
  /// Only where `good`.
  KOKKOS_INLINE_FUNCTION void put_history(
      const MaskOf<R>& good, const History& history, const Field& field
  ) const {
    for (int c = 0; c < Model::history_count; ++c)
      put(real::select(good, reinterpret_cast<const R*>(&history)[c], get(field, c)), field, c);
  }
};

#if BARRENO_HAS_LANES
template <class Model>
PointsOutcome<Lanes> update_points(
    const Model& model,
    const IncrementOf<Sym3Of<Lanes>>& increment,
    Sym3Of<Lanes>& stress,
    typename Model::template HistoryOf<Lanes>& history
) {
  return model.update_points(increment, stress, history);
}
#endif
template <class Model>
KOKKOS_INLINE_FUNCTION PointsOutcome<double> update_points(
    const Model& model, const Increment& increment, Sym3& stress, typename Model::History& history
) {
  const Outcome outcome = model.update(increment, stress, history);
  return {
      !outcome.failed(), outcome.elastic_work, outcome.plastic_work, outcome.longitudinal_modulus};
}

/// Sums of a launch; joins are never needed on one thread but other backends use them.
struct StressReducer {
  using reducer = StressReducer;
  using value_type = StressTally;
  using result_view_type = Kokkos::View<value_type, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  explicit StressReducer(value_type& value) : value_(&value) {}
  KOKKOS_INLINE_FUNCTION void join(value_type& to, const value_type& from) const { add(from, to); }
  KOKKOS_INLINE_FUNCTION void join(volatile value_type& to, const volatile value_type& from) const {
    join(const_cast<value_type&>(to), const_cast<const value_type&>(from));
  }
  KOKKOS_INLINE_FUNCTION void init(value_type& value) const { value = value_type{}; }
  KOKKOS_INLINE_FUNCTION value_type& reference() const { return *value_; }
  result_view_type view() const { return result_view_type(value_); }
  KOKKOS_INLINE_FUNCTION bool references_scalar() const { return true; }

private:
  value_type* value_;
};

template <class Model, class R>
struct UpdateStress {
  using Group = Points<Model, R>;
  using Mask = MaskOf<R>;

  Model model;
  Particles particles;
  StepRule rule;
  BadParticlePolicy policy;
  double reference_density;
  double largest_expansion;
  double dt;

  /// Sums over the lanes' own rows.
  struct Tally {
    R elastic{}, plastic{}, viscous{}, stress_work{};
    R stable_step = R{} + std::numeric_limits<double>::infinity();
  };

  KOKKOS_INLINE_FUNCTION void treat_failure(int p, int key, StressTally& sums) const {
    sums.failures += 1.0;
    const ParticleId id = particles.id(p);
    if (sums.first_failed < 0 || id < sums.first_failed) sums.first_failed = id;
    particles.viscous_pressure(p) = 0.0;
    if (policy == BadParticlePolicy::hold) {
      for (int c = 0; c < 4; ++c) particles.stress(p, c) = 0.0;
      particles.body(p) = static_cast<unsigned char>(particles.body(p) | held_bit);
    } else {
      particles.key(p) = key;
    }
  }
  KOKKOS_INLINE_FUNCTION void treat_failures(
      const Group& group, const Mask& failed, int key, StressTally& sums
  ) const {
    if (!real::any(failed)) return;
    for (int i = 0; i < group.count; ++i)
      if (entry(failed, i) != 0) treat_failure(group.first + i, key, sums);
  }

  /// Rows that are there and not held as debris.
  KOKKOS_INLINE_FUNCTION Mask alive(const Group& group) const {
    const bool may_hold = policy == BadParticlePolicy::hold;
    if (!may_hold && group.count == width<R>) return R{} <= 0.0;
    return mask_of<R>([&](int i) {
      return i < group.count && !(may_hold && (particles.body(group.first + i) & held_bit));
    });
  }

  KOKKOS_INLINE_FUNCTION void update(const Group& group, Tally& tally, StressTally& sums) const {
    const R mass = group.get(particles.mass);
    const R volume = group.get(particles.volume);
    const R old_volume = group.get(particles.increment, 4);
    const R old_q = group.get(particles.viscous_pressure);
    const R old_modulus = group.get(particles.longitudinal_modulus);
    const R density = mass / volume;
    const R reference_volume = mass * (1.0 / reference_density);
    const R per_reference = 1.0 / reference_volume;
    IncrementOf<Sym3Of<R>> increment;
    increment.strain = group.get_plane(particles.increment);
    increment.dt = dt;
    increment.volume_ratio_begin = old_volume * per_reference;
    increment.volume_ratio_end = volume * per_reference;
    const R rate = trace(increment.strain) * (1.0 / dt);
    const R q = rule.viscous_pressure(density, old_modulus, rate);
    increment.viscous_pressure = 0.5 * (old_q + q);

    const Mask here = alive(group);
    const Mask expanded = here & (increment.volume_ratio_end > largest_expansion);
    const Sym3Of<R> old_stress = group.get_plane(particles.stress);
    Sym3Of<R> stress = old_stress;
    auto history = group.get_history(particles.history);
    const PointsOutcome<R> outcome = update_points(model, increment, stress, history);
    const Mask good = here & (!expanded) & outcome.sound;

    group.put_plane(select_points(good, stress, old_stress), particles.stress);
    group.put_history(good, history, particles.history);
    group.put(real::select(good, q, old_q), particles.viscous_pressure);
    group.put(
        real::select(good, outcome.longitudinal_modulus, old_modulus),
        particles.longitudinal_modulus
    );
    treat_failures(group, expanded, expanded_key, sums);
    treat_failures(group, here & (!expanded) & (!outcome.sound), failed_key, sums);

    const R mean_volume = 0.5 * (old_volume + volume);
    const R viscous = increment.viscous_pressure * (old_volume - volume);
    const R stress_work = mean_volume * (0.5 * contract(old_stress + stress, increment.strain) -
                                         increment.viscous_pressure * trace(increment.strain));
    tally.elastic += real::select(good, reference_volume * outcome.elastic_work, 0.0);
    tally.plastic += real::select(good, reference_volume * outcome.plastic_work, 0.0);
    tally.viscous += real::select(good, viscous, 0.0);
    tally.stress_work += real::select(good, stress_work, 0.0);
    const R vx = group.get(particles.velocity, 0);
    const R vy = group.get(particles.velocity, 1);
    const R step = rule.stable_step(
        density, outcome.longitudinal_modulus, rate, real::sqrt(R(vx * vx + vy * vy))
    );
    tally.stable_step = real::select(good & (step < tally.stable_step), step, tally.stable_step);
  }

  /// A run of rows, so that the lanes' sums meet rarely.
  KOKKOS_INLINE_FUNCTION void operator()(Rows rows, StressTally& sums) const {
    Tally tally;
    for (int p = rows.begin; p < rows.end; p += width<R>)
      update({p, rows.end - p < width<R> ? rows.end - p : width<R>}, tally, sums);
    for (int i = 0; i < width<R>; ++i) {
      sums.elastic += entry(tally.elastic, i);
      sums.plastic += entry(tally.plastic, i);
      sums.viscous += entry(tally.viscous, i);
      sums.stress_work += entry(tally.stress_work, i);
      const double step = entry(tally.stable_step, i);
      if (step < sums.stable_step) sums.stable_step = step;
    }
  }
};

/// Timer label of a model's update.
const char* stress_label(const AnyModel& any) {
  return std::visit(
      [](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        static const std::string label = std::string("update_stress ") + Model::name;
        return label.c_str();
      },
      any
  );
}

}  // namespace

StressTally update_stress(const Scene& scene, double dt, Rows rows, Particles& particles) {
  const MaterialSpec& spec = scene.materials[static_cast<std::size_t>(particles.material)];
  const Region region(stress_label(spec.material.model));
  StressTally sums;
  std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        const UpdateStress<Model, typename RealFor<Model>::type> kernel{
            model,
            particles,
            StepRule(scene, particles.critical_courant),
            spec.bad_particles,
            spec.material.density,
            scene.step.largest_expansion,
            dt};
        constexpr int run = 64;
        Kokkos::parallel_reduce(
            "update_stress",
            range((rows.end - rows.begin + run - 1) / run),
            KOKKOS_LAMBDA(const int r, StressTally& part) {
              const int begin = rows.begin + r * run;
              kernel(Rows{begin, rows.end - begin < run ? rows.end : begin + run}, part);
            },
            StressReducer(sums)
        );
      },
      spec.material.model
  );
  return sums;
}

}  // namespace barreno
