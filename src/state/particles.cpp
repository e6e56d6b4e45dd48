// SPDX-License-Identifier: BSD-3-Clause
#include "state/particles.hpp"

#include "base/rows.hpp"
#include "scene/body_force.hpp"
#include "scene/explosive_traits.hpp"
#include "scene/heat.hpp"
#include "shape/shape_facts.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

int history_components(const AnyModel& model) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::history_count; }, model);
}

BurnColumns burn_columns_of(const AnyModel& any) {
  return std::visit(
      [](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        BurnColumns columns;
        if constexpr (burns_by_program<Model>)
          columns = {Model::lighting_column, Model::burn_column};
        return columns;
      },
      any
  );
}

template <class View>
void grow(View& view, int capacity) {
  Kokkos::resize(view, static_cast<std::size_t>(capacity));
}

/// Whether a load of the scene that `counts` acts on bodies of a material.
template <class Counts>
bool has_loads(const Scene& scene, int material, const Counts& counts) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const PressureLoadSpec& load) {
    return scene.bodies[static_cast<std::size_t>(load.body)].material == material && counts(load);
  });
}

/// What loads need of their particles.
void add_load_fields(const Scene& scene, int material, Particles& p) {
  namespace dim = dimension;
  const int d = dimensions(scene.grid.mode);
  const auto any = [](const PressureLoadSpec&) { return true; };
  const auto absorbs = [](const PressureLoadSpec& load) { return traits_of(load.kind).absorbs; };
  const bool on_surfaces = has_loads(scene, material, is_on_surfaces);
  p.loaded_faces = {"loaded_faces", dim::none, has_loads(scene, material, any) ? 1 : 0, {}};
  p.surface_share = {"surface_share", dim::none, on_surfaces ? 2 * (1 + d) : 0, {}};
  p.shear_modulus = {"shear_modulus", dim::stress, has_loads(scene, material, absorbs) ? 1 : 0, {}};
}

/// What particles receive from the grid, and what the transfer stores of it.
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
  p.second_pass_motion = {"second_pass_motion", dim::velocity, again ? 2 * d : 0, {}};
  p.second_pass_increment = {"second_pass_increment", dim::none, xpic ? gradient : 0, {}};
  p.residual = {"residual", dim::velocity, xpic ? d : 0, {}};
  p.heat = {"heat", dim::none, takes_losses(scene, p.material) ? 1 : 0, {}};
}

}  // namespace

/// Gas is divided where it is wider than a cell. A jet, of which a cell holds several particles, is
/// where it is wider than half of one. Weights that take the undeformed size keep it: a smaller one
/// would shorten the step of all (CourantTable), and what is divided is long, not small.
SplitRule split_rule(const Scene& scene, int material) {
  const MaterialSpec& spec = scene.materials[static_cast<std::size_t>(material)];
  if (spec.splits() > 0) return {spec.splits(), 1.0, spec.splits_column(), true, -1};
  if (!scene.jet.present || scene.jet.material != material) return {};
  const int jet = static_cast<int>(scene.bodies.size());
  return {scene.jet.splits, 0.5, -1, follows_deformation(scene), jet};
}

/// A strain of |D| dt = 1/2 turns no particle inside out, and its trace is sqrt(3)/2 at most: it
/// closes no larger voids.
VoidRule void_rule(const Scene& scene, int material) {
  constexpr double bearable = 0.5;
  const std::optional<int> column =
      scene.materials[static_cast<std::size_t>(material)].history_column("expansion_strain");
  if (!column) return {};
  return {*column, std::sqrt(3.0) * bearable, std::min(scene.step.largest_strain / bearable, 1.0)};
}

Particles make_particles(const Scene& scene, int material) {
  namespace dim = dimension;
  const int d = dimensions(scene.grid.mode);
  const bool axisymmetric = scene.grid.mode == Mode::axisymmetric;
  const Material& m = scene.materials[static_cast<std::size_t>(material)].material();
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
  p.burn_columns = burn_columns_of(m.model);
  p.void_rule = void_rule(scene, material);
  p.history = {"history", dim::none, history_components(m.model), {}};
  p.reference_position = {
      "reference_position",
      dim::length,
      is_manufactured(scene.body_force) ? dimensions(scene.grid.mode) : 0,
      {}};
  p.split_rule = split_rule(scene, material);
  p.splits = {"splits", dim::none, p.split_rule.most > 0 && p.split_rule.column < 0 ? d : 0, {}};
  p.clipped = {"clipped", dim::none, follows_deformation(scene) ? 1 : 0, {}};
  add_load_fields(scene, material, p);
  const bool drains =
      scene.pore_flow.on() && scene.materials[static_cast<std::size_t>(material)].is_porous();
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
  grow(particles.chunk_part, n / rows_per_chunk + 1);
  grow(particles.dormant, n);
  const auto grow_field = [n](Field& field) {
    Kokkos::resize(
        field.values, static_cast<std::size_t>(n), static_cast<std::size_t>(field.components)
    );
  };
  particles.for_each_field(grow_field);
  particles.for_each_scratch_field(grow_field);
}

namespace {

/// Lists in `order` the marked rows below `left` from the front, and what stays from `left` on from
/// the back. @return how many there are of either
int list_moves(const Particles& particles, int left) {
  const ArrayView<int> marked = particles.spare, order = particles.order;
  const int count = particles.count;
  int gaps = 0;
  launch_reduction(
      "count_gaps", range(left), KOKKOS_LAMBDA(const int p, int& sum) { sum += marked(p); }, gaps
  );
  launch_scan(
      "list_gaps",
      range(left),
      KOKKOS_LAMBDA(const int p, int& sum, const bool last) {
        if (last && marked(p) != 0) order(sum) = p;
        sum += marked(p);
      }
  );
  launch_scan(
      "list_last_rows",
      range({left, count}),
      KOKKOS_LAMBDA(const int p, int& sum, const bool last) {
        if (last && marked(p) == 0) order(count - 1 - sum) = p;
        sum += 1 - marked(p);
      }
  );
  return gaps;
}

}  // namespace

void remove_marked_rows(Particles& particles, int marked) {
  particles.settled_chunks = 0;
  if (marked == 0) return;
  const int count = particles.count;
  const ArrayView<int> order = particles.order;
  const int moves = list_moves(particles, count - marked);
  const auto move = [&](const char* label, const auto& values) {
    launch(
        label,
        range(moves),
        KOKKOS_LAMBDA(const int k) { values(order(k)) = values(order(count - 1 - k)); }
    );
  };
  move("move_ids", particles.id);
  move("move_bodies", particles.body);
  move("move_keys", particles.key);
  move("move_faults", particles.fault);
  particles.for_each_field([&](Field& field) {
    const FieldView values = field.values;
    const int components = field.components;
    launch(
        "move_fields",
        range(moves),
        KOKKOS_LAMBDA(const int k) {
          for (int c = 0; c < components; ++c)
            values(order(k), c) = values(order(count - 1 - k), c);
        }
    );
  });
  particles.count -= marked;
  particles.sorted = false;
}

void permute_rows(Particles& particles) {
  particles.settled_chunks = 0;
  const RowPolicy rows = range(particles.count);
  const ArrayView<int> order = particles.order;
  const auto permute = [&](const auto& values, const auto& spare) {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    using Spare = typename std::decay_t<decltype(spare)>::value_type;
    launch(
        "permute_rows",
        rows,
        KOKKOS_LAMBDA(const int k) { spare(k) = static_cast<Spare>(values(order(k))); }
    );
    launch(
        "permute_rows_back",
        rows,
        KOKKOS_LAMBDA(const int k) { values(k) = static_cast<Value>(spare(k)); }
    );
  };
  // One column of scratch serves every component in turn.
  const auto column = Kokkos::subview(particles.grid_motion.values, Kokkos::ALL, 0);
  particles.for_each_field([&](Field& field) {
    for (int c = 0; c < field.components; ++c)
      permute(Kokkos::subview(field.values, Kokkos::ALL, c), column);
  });
  permute(particles.id, particles.spare_id);
  permute(particles.body, particles.spare);
  permute(particles.key, particles.spare);
  permute(particles.fault, particles.spare);
  launch(
      "order_rows", rows, KOKKOS_LAMBDA(const int k) { order(k) = k; }
  );
}

std::size_t bytes_per_particle(const Particles& particles) {
  std::size_t doubles = 0;
  const auto add = [&](const Field& field) {
    doubles += static_cast<std::size_t>(field.components);
  };
  particles.for_each_field(add);
  particles.for_each_scratch_field(add);
  // id; body, key and order; dormant and fault; the scratch of the sort
  return doubles * sizeof(double) + 2 * sizeof(ParticleId) + 2 * sizeof(unsigned char) +
         4 * sizeof(int);
}

}  // namespace barreno
