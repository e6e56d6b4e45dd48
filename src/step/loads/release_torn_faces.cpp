// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/release_torn_faces.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/view_of.hpp"
#include "shape/kinematics.hpp"

namespace barreno {
namespace {

/// A face of a particle that is stretched to more than this belongs to no surface any more.
constexpr double torn_stretch = 2.0;

/// Ends the loads of what is torn. What has not changed is not: tiles that keep their sums.
template <class M>
struct ReleaseTornFaces {
  LoadTable loads;
  Particles particles;
  Nodes nodes;

  /// A pressure on a surface of a ball acts inside its particles, however they are stretched.
  KOKKOS_INLINE_FUNCTION bool is_on_surfaces(int p) const {
    bool found = false;
    loads.for_each_face(particles, p, [&](int, int load) {
      found = found || loads.loads(load).on_surfaces;
    });
    return found;
  }
  KOKKOS_INLINE_FUNCTION bool is_torn(int p) const {
    if ((particles.body(p) & debris_bit) != 0) return true;
    if (is_on_surfaces(p)) return false;
    return largest_stretch(load_tensor<M>(particles.deformation_gradient.values, p)) > torn_stretch;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& released) const {
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      if (particles.loaded_faces(p) == 0.0) continue;
      if (!nodes.keeps_sums(tile) && is_torn(p)) {
        particles.loaded_faces(p) = 0.0;
        released += 1.0;
      } else {
        loads.loaded_tiles(tile) = 1;
      }
    }
  }
};

void clear_loaded_tiles(int tiles, const ArrayView<unsigned char>& loaded_tiles) {
  launch(
      "clear_loaded_tiles", range(tiles), KOKKOS_LAMBDA(const int tile) { loaded_tiles(tile) = 0; }
  );
}

}  // namespace

double release_torn_faces(
    const Grid& grid,
    const std::vector<Nodes>& nodes,
    const std::vector<Particles>& sets,
    LoadTable& loads
) {
  if (!loads.any) return 0.0;
  const Region region("release_torn_faces");
  make_room("loaded_tiles", static_cast<std::size_t>(grid.active), loads.loaded_tiles);
  clear_loaded_tiles(grid.active, loads.loaded_tiles);
  double released = 0.0;
  visit_mode(grid.mode, [&](auto mode) {
    using M = decltype(mode);
    for (const Particles& particles : sets) {
      if (particles.loaded_faces.components == 0) continue;
      double of_set = 0.0;
      launch_reduction(
          "release_torn_faces",
          range(grid.active),
          ReleaseTornFaces<M>{loads, particles, nodes[static_cast<std::size_t>(particles.field)]},
          of_set
      );
      released += of_set;
    }
  });
  return released;
}

}  // namespace barreno
