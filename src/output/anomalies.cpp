// SPDX-License-Identifier: BSD-3-Clause
#include "output/anomalies.hpp"

#include "base/gather.hpp"
#include "base/launch.hpp"
#include "base/row_sum.hpp"
#include "scene/input_speeds.hpp"
#include "shape/kinematics.hpp"

#include <cmath>
#include <limits>

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

}  // namespace barreno
