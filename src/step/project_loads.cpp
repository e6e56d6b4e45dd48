// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_loads.hpp"

#include "base/numbers.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/place.hpp"
#include "shape/visit_kernels.hpp"

#include <cstdint>

namespace barreno {
namespace {

/// Pressure on the deformed face: -p J F^-T N A, N and A of the undeformed particle (Nanson).
///
/// In axisymmetry the radius at the start follows from the initial volume, which is that of the
/// full ring.
template <class M>
Vector face_force(const Particles& particles, int p, int face, double pressure) {
  const int axis = face / 2;
  const double side = face % 2 == 0 ? -1.0 : 1.0;
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  double area = particles.volume(p) / determinant(f) / (2.0 * particles.half_size(p, axis));
  if (M::hoop && axis == 0)
    area += side * two_pi * particles.half_size(p, 0) * 2.0 * particles.half_size(p, 1);
  const double scale = -pressure * area * side;
  const auto c = cofactors(f);
  if constexpr (M::dimensions == 3) {
    if (axis == 0) return {scale * c.xx, scale * c.yx, scale * c.zx};
    if (axis == 1) return {scale * c.xy, scale * c.yy, scale * c.zy};
    return {scale * c.xz, scale * c.yz, scale * c.zz};
  } else {
    if (axis == 0) return {scale * c.xx, scale * c.yx};
    return {scale * c.xy, scale * c.yy};
  }
}

/// visit(tile, row, face, pressure) for every loaded face of this rank.
template <class Visitor>
void for_each_loaded_face(const Scene& scene, double time, const State& state, Visitor&& visit) {
  for (const Particles& particles : state.particles) {
    if (particles.loaded_faces.components == 0) continue;
    for (int tile = 0; tile < state.grid.active; ++tile)
      for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
        const int p = particles.order(k);
        auto bits = static_cast<std::uint64_t>(particles.loaded_faces(p));
        for (int i = 0; bits != 0; ++i, bits >>= 1)
          if (bits & 1U)
            visit(
                particles,
                tile,
                p,
                i % 6,
                scene.loads[static_cast<std::size_t>(i / 6)].pressure(time)
            );
      }
  }
}

template <class M, class S>
auto face_support(
    const PatchFrame<M::dimensions>& frame, const Particles& particles, int tile, int p, int face
) {
  return S::template face_support<M>(
      frame.place(frame.first(tile), particles.position.values, particles.half_size.values, p), face
  );
}

}  // namespace

void project_loads(const Scene& scene, State& state) {
  if (scene.loads.empty()) return;
  const Region region("project_loads");
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(state.grid);
    const auto add = [&](const Particles& particles, int tile, int p, int face, double pressure) {
      const Vector force = face_force<M>(particles, p, face, pressure);
      const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
      double* const patch = &nodes.sums(first_sum(frame.patch, tile));
      face_support<M, S>(frame, particles, tile, p, face)
          .for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
            double* const node = patch + slot * sum_components + first_force(M::dimensions);
            for (std::size_t d = 0; d < M::dimensions; ++d) node[d] += s * force[d];
          });
    };
    for_each_loaded_face(scene, state.clock.time, state, add);
  });
}

double tally_loads(const Scene& scene, double dt, State& state) {
  if (scene.loads.empty()) return 0.0;
  const Region region("tally_loads");
  double work = 0.0;
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(state.grid);
    const auto add = [&](const Particles& particles, int tile, int p, int face, double pressure) {
      const Vector force = face_force<M>(particles, p, face, pressure);
      const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
      const double* const patch = &nodes.motion(first_motion(frame.patch, tile));
      face_support<M, S>(frame, particles, tile, p, face)
          .for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
            // Mean velocity of the step: v after it less half of its increment.
            constexpr std::size_t dimensions = M::dimensions;
            const double* const node = patch + slot * motion_components(M::dimensions);
            double power = 0.0;
            for (std::size_t d = 0; d < dimensions; ++d)
              power += force[d] * (node[d] - 0.5 * node[dimensions + d]);
            work += dt * s * power;
          });
      state.ledger.load_impulse += force[1] * dt;
    };
    for_each_loaded_face(scene, state.clock.time, state, add);
  });
  state.ledger.boundary_work += work;
  return work;
}

}  // namespace barreno
