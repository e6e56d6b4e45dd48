// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/project_loads.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "state/material_point.hpp"
#include "state/shape_fields.hpp"
#include "step/loads/face_force.hpp"
#include "step/loads/loaded_sets.hpp"

#include <barreno/models.hpp>
#include <barreno/tangent.hpp>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

template <class Model>
struct FindShearModuli {
  Model model;
  LoadTable loads;
  Particles particles;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (loads.loaded_tiles(tile) == 0) return;
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      bool absorbs = false;
      loads.for_each_face(particles, p, [&](int, int load) {
        absorbs = absorbs || loads.loads(load).non_reflecting;
      });
      if (absorbs) particles.shear_modulus(p) = shear_modulus_of(p);
    }
  }

  KOKKOS_INLINE_FUNCTION double shear_modulus_of(int p) const {
    const auto point = MaterialPoint<Model>::read(particles, p);
    return shear_modulus(model, point.stress, point.history);
  }
};

/// G of the particles with non-reflecting faces, in their present state.
void find_shear_moduli(
    const Grid& grid,
    const LoadTable& loads,
    const MaterialSpec& material,
    const Particles& particles
) {
  if (particles.shear_modulus.components == 0) return;
  std::visit(
      [&](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        launch(
            "find_shear_moduli", range(grid.active), FindShearModuli<Model>{model, loads, particles}
        );
      },
      material.material().model
  );
}

/// The loaded faces of one set of particles.
template <class M, class S>
struct FaceLoads : LoadedSet<M, S> {
  using Set = LoadedSet<M, S>;
  using Set::frame;
  using Set::loads;
  using Set::nodes;
  using Set::particles;

  /// visit(row, face, load) for those in a tile.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_face(int tile, Visitor&& visit) const {
    if (loads.loaded_tiles(tile) == 0) return;
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      loads.for_each_face(particles, p, [&](int face, int l) {
        const AppliedLoad& load = loads.loads(l);
        if (!load.on_surfaces) visit(p, face, load);
      });
    }
  }
  KOKKOS_INLINE_FUNCTION auto face_support(int tile, int p, int face) const {
    return S::template face_support<M>(
        frame.template geometry<S>(frame.first(tile), shape_fields(particles), p), face
    );
  }
};

template <class M, class S>
struct ProjectLoads {
  FaceLoads<M, S> faces;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Nodes& nodes = faces.nodes;
    if (nodes.keeps_sums(tile)) return;
    const Patch& sizes = faces.frame.patch;
    const Particles& particles = faces.particles;
    double* const patch = &nodes.sums(first_sum(sizes, tile));
    faces.for_each_face(tile, [&](int p, int face, const AppliedLoad& load) {
      const Vector force = face_force<M>(load, particles, p, face);
      const double impedance = load.non_reflecting
                                   ? face_impedance(particles, p, face_area<M>(particles, p, face))
                                   : 0.0;
      faces.face_support(tile, p, face)
          .for_each_node(sizes, [&](int slot, double s, const double*, double) {
            double* const sums = patch + slot * sum_components;
            double* const node = sums + first_force(M::dimensions);
            for (std::size_t d = 0; d < M::dimensions; ++d) node[d] += s * force[d];
            sums[impedance_component] += s * impedance;
          });
    });
  }
};

template <class M, class S>
struct TallyLoads {
  FaceLoads<M, S> faces;
  Dormancy dormancy;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, LoadTally& tally) const {
    if (!faces.ends_step(tile)) return;
    const Patch& sizes = faces.frame.patch;
    const Particles& particles = faces.particles;
    const double dt = faces.frame.tile_frame(tile).dt;
    const double* const patch = faces.motion_of(tile);
    faces.for_each_face(tile, [&](int p, int face, const AppliedLoad& load) {
      const Vector force = face_force<M>(load, particles, p, face);
      tally.impulse += force[1] * dt;
      if (dormancy.is_dormant(tile)) return;  // of no motion no work is taken
      double of_face = 0.0;
      faces.face_support(tile, p, face)
          .for_each_node(sizes, [&](int slot, double s, const double*, double) {
            // Mean velocity of the step: v after it less half of its increment.
            constexpr std::size_t dimensions = M::dimensions;
            const double* const node = patch + slot * motion_components(M::dimensions);
            double power = 0.0;
            for (std::size_t d = 0; d < dimensions; ++d)
              power += force[d] * (node[d] - 0.5 * node[dimensions + d]);
            of_face += dt * s * power;
          });
      tally.work += of_face;
    });
    tally.work.carry();
    tally.impulse.carry();
  }
};

template <class M, class S>
void launch_projection(int tiles, const LoadedSet<M, S>& set) {
  launch("project_loads", range(tiles), ProjectLoads<M, S>{{set}});
}
template <class M, class S>
LoadTally launch_tally(int tiles, const LoadedSet<M, S>& set, const Dormancy& dormancy) {
  LoadTally tally;
  launch_reduction(
      "tally_loads", range(tiles), TallyLoads<M, S>{{set}, dormancy}, TallyReducer<LoadTally>(tally)
  );
  return tally;
}

}  // namespace

void project_loads(const Tractions& tractions, const std::vector<MaterialSpec>& materials) {
  if (!tractions.loads.any) return;
  const Region region("project_loads");
  for (const Particles& particles : tractions.sets)
    find_shear_moduli(
        tractions.grid,
        tractions.loads,
        materials[static_cast<std::size_t>(particles.material)],
        particles
    );
  for_each_loaded_set(tractions, &Particles::loaded_faces, [&](const auto& set) {
    launch_projection(tractions.grid.active, set);
  });
}

ReproducibleSum tally_loads(
    const Tractions& tractions, const Dormancy& dormancy, OwnLedger& ledger
) {
  if (!tractions.loads.any) return {};
  const Region region("tally_loads");
  LoadTally sum;
  for_each_loaded_set(tractions, &Particles::loaded_faces, [&](const auto& set) {
    add(launch_tally(tractions.grid.active, set, dormancy), sum);
  });
  ledger.load_impulse += sum.impulse;
  ledger.boundary_work += sum.work;
  return sum.work;
}

}  // namespace barreno
