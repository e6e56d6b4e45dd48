// SPDX-License-Identifier: BSD-3-Clause
#include "output/anomalies.hpp"

#include "base/gather.hpp"
#include "base/launch.hpp"
#include "base/row_sum.hpp"
#include "scene/input_speeds.hpp"
#include "shape/kinematics.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace barreno {
namespace {

template <class M>
struct CountAnomalies {
  Particles particles;
  double speed_bound;

  KOKKOS_INLINE_FUNCTION void operator()(int p, Anomalies& sum) const {
    if ((particles.body(p) & debris_bit) != 0) return;
    const FieldView& f = particles.deformation_gradient.values;
    Anomalies one;
    one.largest_stretch = largest_stretch(load_tensor<M>(f, p));
    double square = 0.0;
    for (int d = 0; d < particles.velocity.components; ++d)
      square += particles.velocity(p, d) * particles.velocity(p, d);
    one.largest_speed = std::sqrt(square);
    one.stretched = one.largest_stretch > anomalous_stretch ? 1.0 : 0.0;
    one.ejected = one.largest_speed > speed_bound ? 1.0 : 0.0;
    one.clipped = particles.clipped.components > 0 ? particles.clipped(p) : 0.0;
    add(one, sum);
  }
};

Anomalies count(const Particles& particles, Mode mode, double speed_bound) {
  Anomalies sum;
  if (particles.rigid) return sum;
  visit_mode(mode, [&](auto kinematics) {
    using M = decltype(kinematics);
    launch_reduction(
        "count_anomalies",
        range(particles.count),
        CountAnomalies<M>{particles, speed_bound},
        TallyReducer<Anomalies>(sum)
    );
  });
  return sum;
}

}  // namespace

std::vector<Anomalies> count_anomalies(const Scene& scene, const State& state) {
  const double input = largest_input_speed(scene);
  const double bound =
      input > 0.0 ? anomalous_speed * input : std::numeric_limits<double>::infinity();
  std::vector<Anomalies> counts;
  std::vector<double> sums, largest;
  for (const Particles& particles : state.particles) {
    const Anomalies one = count(particles, scene.grid.mode, bound);
    counts.push_back(one);
    sums.insert(sums.end(), {one.stretched, one.ejected, one.clipped});
    largest.insert(largest.end(), {one.largest_stretch, one.largest_speed});
  }
  sum_over_ranks(*state.grid.comm, sums);
  max_over_ranks(*state.grid.comm, largest);
  for (std::size_t m = 0; m < counts.size(); ++m)
    counts[m] = {sums[3 * m], sums[3 * m + 1], sums[3 * m + 2], largest[2 * m], largest[2 * m + 1]};
  return counts;
}

namespace {

/// Agrees on the extreme particle of all ranks.
ExtremeParticle agree(const Comm& comm, ExtremeParticle mine) {
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 1> top{mine.id < 0 ? -none : mine.value};
  max_over_ranks(comm, top);
  if (top[0] == -none) return {};
  const bool may = mine.id >= 0 && mine.value == top[0];
  std::array<double, 1> first{may ? static_cast<double>(mine.id) : none};
  min_over_ranks(comm, first);
  const bool here = may && static_cast<double>(mine.id) == first[0];
  std::array<double, 4> rest{-none, -none, -none, -none};
  if (here)
    rest = {
        static_cast<double>(mine.material), mine.position[0], mine.position[1], mine.position[2]};
  max_over_ranks(comm, rest);
  return {
      static_cast<ParticleId>(first[0]),
      static_cast<int>(rest[0]),
      top[0],
      {rest[1], rest[2], rest[3]}};
}

/// Takes a particle whose value is larger, or as large and its number lower.
void take(const Particles& particles, int p, double value, ExtremeParticle& most) {
  if (!std::isfinite(value)) return;
  const ParticleId id = particles.id(p);
  if (most.id >= 0 && (value < most.value || (value == most.value && id > most.id))) return;
  most = {id, particles.material, value, vector_of(particles.position, p)};
}

/// Column of a material's history with its temperature; -1: it has none.
int temperature_column(const MaterialSpec& material) {
  const std::vector<HistoryField> fields = material.history_table();
  for (std::size_t c = 0; c < fields.size(); ++c)
    if (std::string(fields[c].name) == "temperature") return static_cast<int>(c);
  return -1;
}

}  // namespace

Extremes find_extremes(const Scene& scene, const State& state) {
  Extremes found;
  visit_mode(scene.grid.mode, [&](auto kinematics) {
    using M = decltype(kinematics);
    for (const Particles& particles : state.particles) {
      if (particles.rigid) continue;
      const int column =
          temperature_column(scene.materials[static_cast<std::size_t>(particles.material)]);
      const FieldView& f = particles.deformation_gradient.values;
      for (int p = 0; p < particles.count; ++p) {
        if ((particles.body(p) & debris_bit) != 0) continue;
        take(particles, p, largest_stretch(load_tensor<M>(f, p)), found.most_stretched);
        if (column >= 0) take(particles, p, particles.history(p, column), found.hottest);
      }
    }
  });
  const Comm& comm = *state.grid.comm;
  return {agree(comm, found.hottest), agree(comm, found.most_stretched)};
}

}  // namespace barreno
