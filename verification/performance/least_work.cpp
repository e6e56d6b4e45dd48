// SPDX-License-Identifier: BSD-3-Clause
#include "least_work.hpp"

#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"

#include <algorithm>
#include <chrono>

namespace barreno {
namespace {

constexpr double double_size = 8.0;

template <class M, class S>
double mean_nodes(const State& state) {
  const Particles& particles = state.particles.front();
  const PatchFrame<M::dimensions> frame(state.grid);
  double sum = 0.0;
  for (int tile = 0; tile < state.grid.active; ++tile) {
    const auto first = frame.first(tile);
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k)
      S::template support<M>(
          frame.template geometry<S>(first, shape_fields(particles), particles.order(k))
      )
          .for_each_node(frame.patch, [&](int, double s, const double*, double) {
            sum += s > 0.0 ? 1.0 : 0.0;
          });
  }
  return sum / particles.count;
}

/// Numbers of the state that a step reads to give to the grid, reads to take from it, and changes.
double state_numbers(const Particles& p) {
  const int moving = p.position.components + p.velocity.components +
                     p.deformation_gradient.components + p.rotation.components +
                     p.stress.components + p.volume.components + p.viscous_pressure.components;
  const int constant = p.mass.components + p.half_size.components;
  const int material = p.history.components + p.longitudinal_modulus.components;
  const int to_grid = moving + constant;
  const int from_grid = moving + constant + p.history.components;
  return to_grid + from_grid + moving + material;
}

}  // namespace

double LeastWork::seconds(double bytes_per_second, double operations_per_second) const {
  return std::max(bytes / bytes_per_second, operations / operations_per_second);
}

LeastWork least_work(const Scene& scene, const State& state) {
  const int d = dimensions(scene.grid.mode);
  const int hoop = scene.grid.mode == Mode::axisymmetric ? 1 : 0;
  LeastWork work;
  work.nodes = visit_kernels(state.grid, [&](auto mode, auto shape) {
    return mean_nodes<decltype(mode), decltype(shape)>(state);
  });
  const int given = 1 + d + d * d + hoop;
  const int taken = 2 * d + d * d + hoop;
  work.operations = 2.0 * work.nodes * (given + taken);
  double in_cell = 1.0;
  for (int axis = 0; axis < d; ++axis) in_cell *= scene.bodies.front().particles_per_cell;
  const int node = 2 * (1 + 2 * d) + 2 * (2 * d);
  work.bytes = double_size * (state_numbers(state.particles.front()) + node / in_cell);
  return work;
}

double measure_arithmetic() {
  constexpr int lanes = 64;  // enough independent chains to hide a multiply-add's latency
  constexpr long rounds = 4000000;
  double best = 0.0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    double value[lanes];
    for (int i = 0; i < lanes; ++i) value[i] = 1e-3 * (i + repeat);
    const auto start = std::chrono::steady_clock::now();
    for (long round = 0; round < rounds; ++round)
      for (double& v : value) v = v * 0.999999 + 1e-6;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    double sum = 0.0;
    for (const double v : value) sum += v;
    if (sum > 0.0)
      best = std::max(best, 2.0 * lanes * static_cast<double>(rounds) / seconds.count());
  }
  return best;
}

}  // namespace barreno
