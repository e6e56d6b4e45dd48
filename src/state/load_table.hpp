// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "state/particles.hpp"

#include <cstdint>

namespace barreno {

/// A load as kernels read it.
struct AppliedLoad {
  double pressure = 0.0;        ///< at the start of the step [stress]
  bool non_reflecting = false;  ///< its faces absorb waves
  bool on_surfaces = false;     ///< of a ball: it acts inside all of its particles
};

/// A face of a body's box, or a surface of its ball, that a load presses.
struct LoadedFace {
  int load = 0;  ///< index into Scene::loads
  int face = 0;  ///< Face or BallSurface
};

/// The loads of a scene as kernels read them. Bit i of a particle's `loaded_faces` stands for the
/// i-th face of its body: a scene may have any number of loads.
struct LoadTable {
  ArrayView<AppliedLoad> loads;           ///< in the order of Scene::loads
  ArrayView<LoadedFace> faces;            ///< body after body, in the order of the loads
  ArrayView<int> first;                   ///< face of every body, of the jet (none), and the end
  ArrayView<unsigned char> loaded_tiles;  ///< by own tile: 1 where a particle has a loaded face
  bool any = false, any_on_surfaces = false;

  /// visit(face, index of its load) for the loaded faces of a particle.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_face(const Particles& particles, int p, Visitor&& visit)
      const {
    auto bits = static_cast<std::uint64_t>(particles.loaded_faces(p));
    if (bits == 0) return;
    const int body = particles.body(p) & ~debris_bit;
    for (int i = first(body); bits != 0 && i < first(body + 1); ++i, bits >>= 1)
      if ((bits & 1U) != 0) visit(faces(i).face, faces(i).load);
  }
};

/// The table of a scene, without pressures (set_load_pressures) and tiles (release_torn_faces).
/// @throws std::logic_error if a body has more loaded faces than a double has bits
LoadTable make_load_table(const Scene& scene);

/// Bits of the loaded faces of a particle.
/// @param sides  of the body that it is a part of, bits by Face
double loaded_face_bits(const Scene& scene, int body, unsigned sides);

/// Loaded faces of the body that has most of them.
int max_loaded_faces(const Scene& scene);

}  // namespace barreno
