// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_stress.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "state/step_rule.hpp"

#include <string>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

template <class Model>
KOKKOS_INLINE_FUNCTION typename Model::History load_history(const FieldView& values, int p) {
  typename Model::History history{};
  if constexpr (Model::history_count > 0) {
    static_assert(
        sizeof(history) == sizeof(double) * Model::history_count, "a History holds doubles only"
    );
    auto* const h = reinterpret_cast<double*>(&history);
    for (int c = 0; c < Model::history_count; ++c) h[c] = values(p, c);
  }
  return history;
}

template <class Model>
KOKKOS_INLINE_FUNCTION void store_history(
    const typename Model::History& history, const FieldView& values, int p
) {
  if constexpr (Model::history_count > 0) {
    const auto* const h = reinterpret_cast<const double*>(&history);
    for (int c = 0; c < Model::history_count; ++c) values(p, c) = h[c];
  }
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

template <class M, class Model>
struct UpdateStress {
  Model model;
  Particles particles;
  StepRule rule;
  BadParticlePolicy policy;
  double reference_density;
  double largest_expansion;
  double dt;

  /// Volume ratios, strain and viscosity of the step at one particle.
  KOKKOS_INLINE_FUNCTION Increment
  increment(int p, double volume, double reference_volume, double q) const {
    const double old_volume = particles.increment(p, 4);
    Increment out;
    out.strain = {
        particles.increment(p, 0),
        particles.increment(p, 1),
        particles.increment(p, 2),
        particles.increment(p, 3),
        0.0,
        0.0};
    out.dt = dt;
    out.volume_ratio_begin = old_volume / reference_volume;
    out.volume_ratio_end = volume / reference_volume;
    out.viscous_pressure = 0.5 * (particles.viscous_pressure(p) + q);
    return out;
  }

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

  KOKKOS_INLINE_FUNCTION void operator()(int p, StressTally& sums) const {
    if (particles.body(p) & held_bit) return;
    const double mass = particles.mass(p);
    const double reference_volume = mass / reference_density;
    const double volume = particles.volume(p);
    const double density = mass / volume;
    const double rate =
        (particles.increment(p, 0) + particles.increment(p, 1) + particles.increment(p, 2)) / dt;
    const double q = rule.viscous_pressure(density, particles.longitudinal_modulus(p), rate);
    const Increment inc = increment(p, volume, reference_volume, q);
    if (inc.volume_ratio_end > largest_expansion) return treat_failure(p, expanded_key, sums);

    Sym3 stress{
        particles.stress(p, 0),
        particles.stress(p, 1),
        particles.stress(p, 2),
        particles.stress(p, 3),
        0.0,
        0.0};
    const Sym3 old_stress = stress;
    auto history = load_history<Model>(particles.history.values, p);
    const Outcome outcome = model.update(inc, stress, history);
    if (outcome.failed()) return treat_failure(p, failed_key, sums);

    store_history<Model>(history, particles.history.values, p);
    particles.stress(p, 0) = stress.xx;
    particles.stress(p, 1) = stress.yy;
    particles.stress(p, 2) = stress.zz;
    particles.stress(p, 3) = stress.xy;
    particles.viscous_pressure(p) = q;
    particles.longitudinal_modulus(p) = outcome.longitudinal_modulus;

    const double mean_volume =
        0.5 * (inc.volume_ratio_begin + inc.volume_ratio_end) * reference_volume;
    const double viscous =
        inc.viscous_pressure * (inc.volume_ratio_begin - inc.volume_ratio_end) * reference_volume;
    sums.elastic += reference_volume * outcome.elastic_work;
    sums.plastic += reference_volume * outcome.plastic_work;
    sums.viscous += viscous;
    sums.stress_work += mean_volume * 0.5 * contract(old_stress + stress, inc.strain) -
                        mean_volume * inc.viscous_pressure * trace(inc.strain);
    const double vx = particles.velocity(p, 0);
    const double vy = particles.velocity(p, 1);
    const double step =
        rule.stable_step(density, outcome.longitudinal_modulus, rate, std::sqrt(vx * vx + vy * vy));
    sums.stable_step = std::fmin(sums.stable_step, step);
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
  visit_mode(scene.grid.mode, [&](auto mode) {
    std::visit(
        [&](const auto& model) {
          using Kernel = UpdateStress<decltype(mode), std::decay_t<decltype(model)>>;
          Kokkos::parallel_reduce(
              "update_stress",
              range(rows),
              Kernel{
                  model,
                  particles,
                  StepRule(scene, particles.critical_courant),
                  spec.bad_particles,
                  spec.material.density,
                  scene.step.largest_expansion,
                  dt},
              StressReducer(sums)
          );
        },
        spec.material.model
    );
  });
  return sums;
}

}  // namespace barreno
