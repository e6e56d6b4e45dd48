// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_loads.hpp"

#include "base/numbers.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "shape/place.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "state/surface_share.hpp"

#include <barreno/tangent.hpp>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

/// The deformed face as a vector outwards: J F^-T N A, N and A of the undeformed particle (Nanson).
///
/// In axisymmetry the radius at the start follows from the initial volume, which is that of the
/// full ring.
template <class M>
Vector face_area(const Particles& particles, int p, int face) {
  const int axis = face / 2;
  const double side = face % 2 == 0 ? -1.0 : 1.0;
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  double area = particles.volume(p) / determinant(f) / (2.0 * particles.half_size(p, axis));
  if (M::hoop && axis == 0)
    area += side * two_pi * particles.half_size(p, 0) * 2.0 * particles.half_size(p, 1);
  const double scale = area * side;
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

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// G of a particle's material in its present state.
double shear_modulus_of(const Scene& scene, const Particles& particles, int p) {
  const auto& material = scene.materials[static_cast<std::size_t>(particles.material)].material;
  return std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        Sym3 stress;
        for (int c = 0; c < particles.stress.components; ++c)
          (&stress.xx)[c] = particles.stress(p, c);
        typename Model::History history{};
        if constexpr (Model::history_count > 0) {
          auto* const h = reinterpret_cast<double*>(&history);
          for (int c = 0; c < Model::history_count; ++c) h[c] = particles.history(p, c);
        }
        return shear_modulus(model, stress, history);
      },
      material.model
  );
}

/// rho c_p |A| of a face of a particle: its impedance against plane waves that come straight.
double impedance(const Particles& particles, int p, const Vector& area) {
  const double density = particles.mass(p) / particles.volume(p);
  return std::sqrt(density * particles.longitudinal_modulus(p) * dot(area, area));
}

/// -(rho c_p v_n n + rho c_s v_t) |A|: what a plane wave that goes on would do to the face. Source:
/// J. Lysmer, R. Kuhlemeyer, J. Eng. Mech. Div. ASCE 95 (1969).
Vector dashpot(const Scene& scene, const Particles& particles, int p, const Vector& area) {
  const double along = impedance(particles, p, area);
  const double slower =
      std::sqrt(shear_modulus_of(scene, particles, p) / particles.longitudinal_modulus(p));
  const Vector v = vector_of(particles.velocity, p);
  const double normal = (1.0 - slower) * dot(v, area) / dot(area, area);
  Vector force{};
  for (std::size_t d = 0; d < 3; ++d) force[d] = -along * (slower * v[d] + normal * area[d]);
  return force;
}

template <class M>
Vector face_force(
    const Scene& scene,
    const PressureLoadSpec& load,
    double time,
    const Particles& particles,
    int p,
    int face
) {
  const Vector area = face_area<M>(particles, p, face);
  const bool absorbs = load.kind == LoadKind::non_reflecting;
  Vector force = absorbs ? dashpot(scene, particles, p, area) : Vector{};
  const double pressure = load.pressure(time);
  for (std::size_t d = 0; d < 3; ++d) force[d] -= pressure * area[d];
  return force;
}

/// visit(particles, tile, row, face, load) for the loaded faces of a row.
template <class Visitor>
void visit_loaded_faces(
    const Scene& scene, const Particles& particles, int tile, int p, Visitor& visit
) {
  auto bits = static_cast<std::uint64_t>(particles.loaded_faces(p));
  for (int i = 0; bits != 0; ++i, bits >>= 1) {
    if (!(bits & 1U)) continue;
    const PressureLoadSpec& load = scene.loads[static_cast<std::size_t>(i / 6)];
    if (!is_on_surfaces(load)) visit(particles, tile, p, i % 6, load);
  }
}

/// The same for every loaded face of this rank.
template <class Visitor>
void for_each_loaded_face(const Scene& scene, const State& state, Visitor&& visit) {
  for (const Particles& particles : state.particles) {
    if (particles.rigid || particles.loaded_faces.components == 0) continue;
    for (int tile = 0; tile < state.grid.active; ++tile) {
      if (state.loaded_tiles[static_cast<std::size_t>(tile)] == 0) continue;
      for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k)
        visit_loaded_faces(scene, particles, tile, particles.order(k), visit);
    }
  }
}

template <class M, class S>
auto face_support(
    const PatchFrame<M::dimensions>& frame, const Particles& particles, int tile, int p, int face
) {
  return S::template face_support<M>(
      frame.template place<S>(frame.first(tile), shape_fields(particles), p), face
  );
}

}  // namespace

void project_loads(const Scene& scene, State& state) {
  if (scene.loads.empty()) return;
  const Region region("project_loads");
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(scene, state.grid);
    const auto add =
        [&](const Particles& particles, int tile, int p, int face, const PressureLoadSpec& load) {
          const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
          if (nodes.keeps(tile)) return;
          const Vector force = face_force<M>(scene, load, state.clock.time, particles, p, face);
          const bool absorbs = load.kind == LoadKind::non_reflecting;
          const double resistance =
              absorbs ? impedance(particles, p, face_area<M>(particles, p, face)) : 0.0;
          double* const patch = &nodes.sums(first_sum(frame.patch, tile));
          face_support<M, S>(frame, particles, tile, p, face)
              .for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
                double* const sums = patch + slot * sum_components;
                double* const node = sums + first_force(M::dimensions);
                for (std::size_t d = 0; d < M::dimensions; ++d) node[d] += s * force[d];
                sums[impedance_component] += s * resistance;
              });
        };
    for_each_loaded_face(scene, state, add);
  });
}

WholeSum tally_loads(const Scene& scene, double dt, State& state) {
  if (scene.loads.empty()) return {};
  const Region region("tally_loads");
  WholeSum work;
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(scene, state.grid);
    const auto add =
        [&](const Particles& particles, int tile, int p, int face, const PressureLoadSpec& load) {
          const Vector force = face_force<M>(scene, load, state.clock.time, particles, p, face);
          state.ledger.load_impulse += force[1] * dt;
          if (state.dormancy.leaves(tile)) return;  // of no motion no work is taken
          const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
          const double* const patch = &nodes.motion(first_motion(frame.patch, tile));
          double of_face = 0.0;
          face_support<M, S>(frame, particles, tile, p, face)
              .for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
                // Mean velocity of the step: v after it less half of its increment.
                constexpr std::size_t dimensions = M::dimensions;
                const double* const node = patch + slot * motion_components(M::dimensions);
                double power = 0.0;
                for (std::size_t d = 0; d < dimensions; ++d)
                  power += force[d] * (node[d] - 0.5 * node[dimensions + d]);
                of_face += dt * s * power;
              });
          work += of_face;
        };
    for_each_loaded_face(scene, state, add);
  });
  state.ledger.boundary_work += work;
  return work;
}

}  // namespace barreno
