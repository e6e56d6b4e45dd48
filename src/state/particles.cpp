// SPDX-License-Identifier: BSD-3-Clause
#include "state/particles.hpp"

#include "base/rows.hpp"
#include "scene/body_force.hpp"
#include "scene/heat.hpp"
#include "scene/porous.hpp"
#include "shape/shape_facts.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

int history_components(const AnyModel& model) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::history_count; }, model);
}

template <class View>
void grow(View& view, int capacity) {
  Kokkos::resize(view, static_cast<std::size_t>(capacity));
}

/// The pressure loads of a scene fit into the bits of one double: six faces each.
bool has_loads(const Scene& scene, int material, bool surfaces) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const PressureLoadSpec& load) {
    return scene.bodies[static_cast<std::size_t>(load.body)].material == material &&
           (!surfaces || is_on_surfaces(load));
  });
}

/// What the grid says to the particles, and what the transfer remembers of it.
void add_transfer_fields(const Scene& scene, Particles& p) {
  namespace dim = dimension;
  const int d = dimensions(scene.grid.mode);
  const bool xpic = scene.step.transfer == Transfer::xpic;
  const bool again = xpic || scene.step.order != Order::stress_last;
  const int gradient = d * d + (d == 2 ? 1 : 0);
  const bool affine = scene.step.transfer == Transfer::apic;
  p.affine = {"affine", {2, -1, 0, 0}, affine ? d * d : 0, {}};
  p.grid_motion = {"grid_motion", dim::velocity, 2 * d, {}};
  p.increment = {"increment", dim::none, gradient, {}};
  p.again_motion = {"again_motion", dim::velocity, again ? 2 * d : 0, {}};
  p.again_increment = {"again_increment", dim::none, xpic ? gradient : 0, {}};
  p.residual = {"residual", dim::velocity, xpic ? d : 0, {}};
  p.heat = {"heat", dim::none, takes_losses(scene, p.material) ? 1 : 0, {}};
}

}  // namespace

Particles make_particles(const Scene& scene, int material) {
  namespace dim = dimension;
  const int d = dimensions(scene.grid.mode);
  const bool axisymmetric = scene.grid.mode == Mode::axisymmetric;
  const Material& m = scene.materials[static_cast<std::size_t>(material)].material;
  Particles p;
  p.material = material;
  p.position = {"position", dim::length, d, {}};
  p.velocity = {"velocity", dim::velocity, d, {}};
  p.deformation_gradient = {"deformation_gradient", dim::none, d * d + (axisymmetric ? 1 : 0), {}};
  p.rotation = {"rotation", dim::none, d == 3 ? 4 : 0, {}};
  p.stress = {"stress", dim::stress, tensor_components(d), {}};
  p.mass = {"mass", dim::mass, 1, {}};
  p.volume = {"volume", {3, 0, 0, 0}, 1, {}};
  p.half_size = {"half_size", dim::length, d, {}};
  p.viscous_pressure = {"viscous_pressure", dim::stress, 1, {}};
  p.longitudinal_modulus = {"longitudinal_modulus", dim::stress, 1, {}};
  p.history = {"history", dim::none, history_components(m.model), {}};
  p.reference_position = {
      "reference_position",
      dim::length,
      is_manufactured(scene.body_force) ? dimensions(scene.grid.mode) : 0,
      {}};
  p.clipped = {"clipped", dim::none, follows_deformation(scene) ? 1 : 0, {}};
  p.loaded_faces = {"loaded_faces", dim::none, has_loads(scene, material, false) ? 1 : 0, {}};
  p.surface_share = {
      "surface_share", dim::none, has_loads(scene, material, true) ? 2 * (1 + d) : 0, {}};
  const bool drains = scene.pore_flow.on() && is_porous(m);
  p.darcy_velocity = {"darcy_velocity", dim::velocity, drains ? d : 0, {}};
  add_transfer_fields(scene, p);
  reserve(p, 1);
  return p;
}

void reserve(Particles& particles, int capacity) {
  if (capacity <= particles.capacity) return;
  particles.capacity = std::max(capacity, particles.capacity + particles.capacity / 2);
  const int n = particles.capacity;
  grow(particles.id, n);
  grow(particles.body, n);
  grow(particles.key, n);
  grow(particles.fault, n);
  grow(particles.spare, n);
  grow(particles.spare_id, n);
  grow(particles.order, n);
  grow(particles.run_part, n / rows_per_run + 1);
  grow(particles.left_out, n);
  const auto grow_field = [n](Field& field) {
    Kokkos::resize(
        field.values, static_cast<std::size_t>(n), static_cast<std::size_t>(field.components)
    );
  };
  particles.for_each_field(grow_field);
  particles.for_each_scratch_field(grow_field);
}

void keep_rows(Particles& particles, const std::vector<char>& keep) {
  int kept = 0;
  for (int p = 0; p < particles.count; ++p) {
    if (!keep[static_cast<std::size_t>(p)]) continue;
    if (kept != p) {
      particles.id(kept) = particles.id(p);
      particles.body(kept) = particles.body(p);
      particles.key(kept) = particles.key(p);
      particles.fault(kept) = particles.fault(p);
      particles.for_each_field([=](Field& field) {
        for (int c = 0; c < field.components; ++c) field(kept, c) = field(p, c);
      });
    }
    ++kept;
  }
  particles.count = kept;
  particles.sorted = false;
}

void permute_rows(Particles& particles) {
  const auto n = static_cast<std::size_t>(particles.count);
  const int* const order = particles.order.data();
  // One column of scratch serves every component in turn.
  double* const column = particles.grid_motion.values.data();
  particles.for_each_field([&](Field& field) {
    for (int c = 0; c < field.components; ++c) {
      double* const values = &field(0, c);
      for (std::size_t k = 0; k < n; ++k) column[k] = values[order[k]];
      std::copy(column, column + n, values);
    }
  });
  const auto permute = [&](auto& values, auto& spare) {
    for (std::size_t k = 0; k < n; ++k)
      spare(k) =
          static_cast<std::decay_t<decltype(spare(k))>>(values(static_cast<std::size_t>(order[k])));
    for (std::size_t k = 0; k < n; ++k)
      values(k) = static_cast<std::decay_t<decltype(values(k))>>(spare(k));
  };
  permute(particles.id, particles.spare_id);
  permute(particles.body, particles.spare);
  permute(particles.key, particles.spare);
  permute(particles.fault, particles.spare);
  for (std::size_t k = 0; k < n; ++k) particles.order(k) = static_cast<int>(k);
}

std::size_t bytes_per_particle(const Particles& particles) {
  std::size_t doubles = 0;
  const auto add = [&](const Field& field) {
    doubles += static_cast<std::size_t>(field.components);
  };
  particles.for_each_field(add);
  particles.for_each_scratch_field(add);
  // id; body, key and order; left_out and fault; the scratch of the sort
  return doubles * sizeof(double) + 2 * sizeof(ParticleId) + 2 * sizeof(unsigned char) +
         4 * sizeof(int);
}

}  // namespace barreno
