// SPDX-License-Identifier: BSD-3-Clause
#include "step/surface_pressures.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace barreno {
namespace {

bool has_surface_loads(const Scene& scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), is_on_surfaces);
}

const Ball& ball_of(const Scene& scene, const PressureLoadSpec& load) {
  return std::get<Ball>(scene.bodies[static_cast<std::size_t>(load.body)].shape);
}

/// A pressure inside a particle and its gradient there now.
struct Inside {
  double value = 0.0, gradient[3] = {};
};

/// p e and p F^-T grad e of the loads on a particle; `pressure` by load.
template <class M>
Inside pressure_inside(
    const Scene& scene, const Particles& particles, int p, const ByLoad& pressure
) {
  constexpr unsigned parts = 1 + M::dimensions;
  double sum[parts] = {};
  auto bits = static_cast<std::uint64_t>(particles.loaded_faces(p));
  for (std::size_t i = 0; bits != 0; ++i, bits >>= 1) {
    if ((bits & 1U) == 0 || !is_on_surfaces(scene.loads[i / 6])) continue;
    const auto first = static_cast<int>(i % 6 * parts);
    for (unsigned c = 0; c < parts; ++c)
      sum[c] += pressure[i / 6] * particles.surface_share(p, first + static_cast<int>(c));
  }
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  const auto c = cofactors(f);
  const double scale = 1.0 / determinant(f);
  Inside inside{sum[0], {}};
  if constexpr (M::dimensions == 3) {
    inside.gradient[0] = scale * (c.xx * sum[1] + c.xy * sum[2] + c.xz * sum[3]);
    inside.gradient[1] = scale * (c.yx * sum[1] + c.yy * sum[2] + c.yz * sum[3]);
    inside.gradient[2] = scale * (c.zx * sum[1] + c.zy * sum[2] + c.zz * sum[3]);
  } else {
    inside.gradient[0] = scale * (c.xx * sum[1] + c.xy * sum[2]);
    inside.gradient[1] = scale * (c.yx * sum[1] + c.yy * sum[2]);
  }
  return inside;
}

/// visit(particles, tile, row, its support) for every particle of this rank that has a load.
template <class M, class S, class Visitor>
void for_each_loaded_row(
    const PatchFrame<M::dimensions>& frame, const State& state, Visitor&& visit
) {
  SupportBatch<typename S::template Support<M>> supports;
  for (const Particles& particles : state.particles) {
    if (particles.rigid || particles.surface_share.components == 0) continue;
    for (int tile = 0; tile < state.grid.active; ++tile) {
      const int end = particles.tile_begin(tile + 1);
      for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
        const BatchRows rows(particles.order, k, end);
        find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
        for (int i = 0; i < rows.count; ++i)
          if (particles.loaded_faces(rows.row[i]) != 0.0)
            visit(particles, tile, rows.row[i], supports.get(i));
      }
    }
  }
}

/// Force of a pressure inside a particle on a node: V (value grad S + gradient S), turned round.
template <class M>
void node_force(
    const Inside& inside,
    double volume,
    double s,
    const double* slope,
    double hoop,
    double (&force)[M::dimensions]
) {
  for (int d = 0; d < M::dimensions; ++d)
    force[d] = -volume * (inside.value * slope[d] + inside.gradient[d] * s);
  if constexpr (M::hoop) force[0] -= volume * inside.value * hoop;
}

/// Power of a pressure inside a particle on its nodes, with a part of the step's increment taken
/// from the velocity after it: a half for the mean velocity.
template <class M, class Support>
double power_of(
    const Inside& inside,
    double volume,
    const Support& support,
    const Patch& sizes,
    const double* motion,
    double part
) {
  double power = 0.0;
  support.for_each_node(sizes, [&](int slot, double s, const double* slope, double hoop) {
    double force[M::dimensions];
    node_force<M>(inside, volume, s, slope, hoop, force);
    const double* const node = motion + slot * motion_components(M::dimensions);
    for (int d = 0; d < M::dimensions; ++d)
      power += force[d] * (node[d] - part * node[M::dimensions + d]);
  });
  return power;
}

/// Volumes of the cavities that hold a fluid at the start, by load; 0: none.
ByLoad first_volumes(const Scene& scene) {
  ByLoad volumes{};
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    if (scene.loads[l].kind == LoadKind::pore_fluid)
      volumes[l] = cavity_volume(ball_of(scene, scene.loads[l]), scene.grid);
  return volumes;
}

/// Growth of cavities over their volumes at the start, by load; the same on any ranks.
using Growth = std::array<WholeSum, most_loads>;

/// New volumes of the cavities from the growth that this rank found.
void grow_cavities(const ByLoad& start, Growth& growth, State& state) {
  sum_over_ranks(*state.grid.comm, growth);
  for (std::size_t l = 0; l < start.size(); ++l)
    if (start[l] > 0.0) state.cavities[l] += start[l] * growth[l].value();
}

[[noreturn]] void refuse_closed(const std::string& name) {
  std::ostringstream text;
  text << "The cavity of Loads/" << name
       << " has closed: its fluid has no volume left. Raise Bulk Modulus or load the body less.";
  throw NumericalError(text.str());
}

}  // namespace

ByLoad load_pressures(const Scene& scene, const State& state) {
  ByLoad pressures{};
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const PressureLoadSpec& load = scene.loads[l];
    double pressure = load.pressure(state.clock.time);
    if (load.kind == LoadKind::pore_fluid) {
      const double ratio = state.cavities[l] / cavity_volume(ball_of(scene, load), scene.grid);
      if (!(ratio > 0.0)) refuse_closed(load.name);
      pressure -= load.bulk_modulus * std::log(ratio);
    }
    pressures[l] = pressure;
  }
  return pressures;
}

void project_surface_pressures(const Scene& scene, State& state) {
  if (!has_surface_loads(scene)) return;
  const Region region("project_surface_pressures");
  const ByLoad pressures = load_pressures(scene, state);
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(scene, state.grid);
    for_each_loaded_row<M, S>(
        frame,
        state,
        [&](const Particles& particles, int tile, int p, const auto& support) {
          const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
          if (nodes.keeps(tile)) return;
          const Inside inside = pressure_inside<M>(scene, particles, p, pressures);
          const double volume = particles.volume(p);
          double* const patch = &nodes.sums(first_sum(frame.patch, tile));
          support.for_each_node(
              frame.patch,
              [&](int slot, double s, const double* slope, double hoop) {
                double force[M::dimensions];
                node_force<M>(inside, volume, s, slope, hoop, force);
                double* const node = patch + slot * sum_components + first_force(M::dimensions);
                for (int d = 0; d < M::dimensions; ++d) node[d] += force[d];
              }
          );
        }
    );
  });
}

WholeSum tally_surface_pressures(const Scene& scene, double dt, State& state) {
  if (!has_surface_loads(scene)) return {};
  const Region region("tally_surface_pressures");
  const ByLoad pressures = load_pressures(scene, state);
  const std::size_t loads = scene.loads.size();
  const ByLoad start = first_volumes(scene);
  Growth growth{};
  WholeSum work;
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(scene, state.grid);
    for_each_loaded_row<M, S>(
        frame,
        state,
        [&](const Particles& particles, int tile, int p, const auto& support) {
          const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
          const double* const motion = &nodes.motion(first_motion(frame.patch, tile));
          const double volume = particles.volume(p);
          const auto work_under = [&](const Inside& inside, double part) {
            return dt * power_of<M>(inside, volume, support, frame.patch, motion, part);
          };
          const Inside inside = pressure_inside<M>(scene, particles, p, pressures);
          work += work_under(inside, 0.5);
          // The weights add up to 1 and their slopes to 0.
          state.ledger.load_impulse -= dt * volume * inside.gradient[1];
          for (std::size_t l = 0; l < loads; ++l) {
            if (!(start[l] > 0.0)) continue;
            ByLoad unit{};
            unit[l] = 1.0;
            const double grown = work_under(pressure_inside<M>(scene, particles, p, unit), 0.0);
            growth[l] += grown / start[l];
            growth[l].carry();  // there may be any number of particles
          }
        }
    );
  });
  state.ledger.boundary_work += work;
  const bool fluids = std::any_of(start.begin(), start.end(), [](double v) { return v > 0.0; });
  if (fluids) grow_cavities(start, growth, state);
  return work;
}

double stable_step_with_fluids(const Scene& scene, const State& state, double dt) {
  double step = dt;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const PressureLoadSpec& load = scene.loads[l];
    if (load.kind != LoadKind::pore_fluid) continue;
    const Ball& ball = ball_of(scene, load);
    const int material = scene.bodies[static_cast<std::size_t>(load.body)].material;
    const double density = scene.materials[static_cast<std::size_t>(material)].material.density;
    const double powers =
        scene.grid.mode == Mode::plane_strain ? 2.0 : 3.0;  // of the radius in the volume
    const double ratio = state.cavities[l] / cavity_volume(ball, scene.grid);
    const double radius = ball.inner_radius * std::pow(std::max(ratio, 0.0), 1.0 / powers);
    const double square =
        8.0 * powers * load.bulk_modulus / (density * radius * scene.grid.cell_size);
    step = std::min(step, dt / std::sqrt(1.0 + 0.25 * square * dt * dt));
  }
  return step;
}

}  // namespace barreno
