// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/field.hpp"
#include "grid/patch.hpp"
#include "scene/scene.hpp"
#include "shape/courant_table.hpp"
#include "state/tally_scales.hpp"

#include <cassert>
#include <vector>

namespace barreno {

/// Components; two-dimensional modes store hoop or out-of-plane parts only where they move.
///
///                                  two dimensions              three
///   position, velocity, half_size  x y                         x y z
///   deformation_gradient           xx xy yx yy and, in         xx xy xz yx yy yz zx zy zz
///                                  axisymmetry, zz
///   stress                         xx yy zz xy                 xx yy zz xy yz zx
///   rotation                       none: follows from F        quaternion w x y z
///
/// Stress is unrotated: the space tensor is R stress R^T with F = R U.

/// Set in Particles::body of a particle that its policy holds as stress-free debris. A deck has
/// fewer bodies (its size is bounded).
inline constexpr int debris_bit = 1 << 30;

/// The cell of a row among those of this rank's tiles, tile * cells per tile + cell in tile; or
/// `unplaced`, of newcomers until place_particles. A type of its own, so that it cannot be an index
/// without a check that it may be one (index_of).
enum class CellKey : int { unplaced = -1 };
KOKKOS_INLINE_FUNCTION constexpr bool is_placed(CellKey key) {
  return key != CellKey::unplaced;
}
/// @pre  place_particles has placed its row
KOKKOS_INLINE_FUNCTION int index_of(CellKey key) {
  assert(is_placed(key));
  return static_cast<int>(key);
}

/// What a step has found wrong with a particle that its material then removes; locate_particles of
/// the next step takes it out. It stands beside the key, which is that of the particle's cell until
/// then: what is left of the step has the particle in its tile.
enum class Fault : unsigned char { none, failed, expanded, inverted };

/// Columns of an explosive's history that hold lighting time and burnt fraction; -1 of others.
struct BurnColumns {
  int lighting = -1, burn = -1;
  KOKKOS_INLINE_FUNCTION bool burns() const { return lighting >= 0; }
};

/// How particles of a set are divided (split_particles).
struct SplitRule {
  int most = 0;        ///< how often each may be; 0: never
  double width = 1.0;  ///< from which on [cells]
  int column = -1;     ///< of the count in an explosive's history; -1: Particles::splits has it
  bool halves = true;  ///< half_size, else that stays what the weights see of the particle
  int body = -1;       ///< whose particles are; -1: all of the set
};

/// Metal whose voids are too large for a step to close bears nothing: its strain may be larger than
/// that of others. docs/method.md 4
struct VoidRule {
  int column = -1;     ///< of the voids' strain in its history; -1: it has none
  double open = 0.0;   ///< strain of the voids from which on it bears nothing over a step [-]
  double share = 1.0;  ///< of its strain, that counts towards Largest Strain
};

/// All particles of one material: structure of arrays, `count` rows used of `capacity`.
/// Storage order has no meaning; `order` lists the rows by (tile, cell, id), so that every sum over
/// particles has one order, whatever their history or rank count.
struct Particles {
  int material = 0;    ///< index into Scene::materials
  int field = 0;       ///< velocity field
  bool rigid = false;  ///< one body with prescribed motion
  int count = 0;
  int capacity = 0;
  CourantTable courant_table{};   ///< of the shape function
  double critical_courant = 1.0;  ///< of the smallest particle that the scene gives this set
  double isolated_courant = 1.0;  ///< of isolated_courant()
  double stable_step = std::numeric_limits<double>::infinity();  ///< of its rows here [time]
  TallyScales tally_scales;                                      ///< of tally_scales()
  BurnColumns burn_columns;
  VoidRule void_rule;
  SplitRule split_rule;
  bool sorted = false;  ///< order and tile_begin belong to the present rows and tiles

  ArrayView<ParticleId> id;  ///< unique over the run; files sort by it
  ArrayView<int> body;  ///< index into Scene::bodies, or its size for the jet; debris_bit: debris

  Field position;              ///< x_p [length]
  Field velocity;              ///< v_p [length/time]
  Field deformation_gradient;  ///< F_p, identity at the start (prestressed states included) [-]
  Field rotation;              ///< R_p of F = R U, where the mode keeps it [-]
  Field stress;                ///< unrotated Cauchy stress [stress]
  Field mass;                  ///< m_p [mass]
  Field volume;  ///< V_p; kept beside F, whose determinant cancels when it is drawn out [length^3]
  Field half_size;             ///< half edge lengths of the undeformed particle [length]
  Field viscous_pressure;      ///< q_p, artificial viscosity, positive in compression [stress]
  Field longitudinal_modulus;  ///< K + 4G/3 of the last update [stress]
  Field history;  ///< the model's internal variables, in the order of its history_table()
  Field reference_position;  ///< X_p, only where a manufactured body force asks for it [length]
  /// How often the particle of a jet was divided along each axis of the undeformed one [-].
  Field splits;
  Field clipped;  ///< 1 if the domain is cut at Largest Domain, of shapes that deform [-]
  Field
      loaded_faces;  ///< bits of own faces with loads (LoadTable); no components if there are none
  /// SurfaceShare of the inner, then the outer surface of a loaded ball; no components without one.
  Field surface_share;
  Field darcy_velocity;  ///< of the fluid, where it drains [length/time]
  /// Of APIC: B_p, first moments of the grid's velocity [length^2/time]; before the first step the
  /// gradient of the initial velocity [1/time].
  Field affine;

  /// Scratch of the step, not state: what particles receive from the grid.
  Field grid_motion;  ///< interpolated velocity, then velocity increment [length/time]
  Field increment;    ///< dt L, then the unrotated strain increment, then the old volume
  /// What they receive in a second pass: XPIC, modified stress last and stress first only.
  Field second_pass_motion;
  Field second_pass_increment;  ///< XPIC only
  Field heat;  ///< energy that the step must leave in the particle, where its losses are returned
               ///< [energy]
  Field shear_modulus;  ///< of particles with non-reflecting faces, where there are such [stress]
  Field residual;       ///< of XPIC: part of v_p that the grid cannot represent [length/time]

  ArrayView<CellKey> key;  ///< of the last sort
  ArrayView<Fault> fault;
  ArrayView<int> spare;  ///< scratch
  ArrayView<ParticleId> spare_id;
  ArrayView<int> order;                 ///< rows sorted by (key, id)
  ArrayView<int> cell_begin, cell_end;  ///< scratch of the sort
  ArrayView<unsigned char> chunk_part;  ///< ChunkPart of each chunk of rows
  /// So many chunks from the first on still have the rows, and these the keys, that `chunk_part`
  /// was found for: those of which the step left all rows as they were need not be looked for
  /// again.
  int settled_chunks = 0;
  ArrayView<unsigned char> dormant;  ///< Stay of the row's tile; 0: it moves
  ArrayView<int> tile_begin;  ///< order[tile_begin[t] .. tile_begin[t+1]) are the rows in tile t

  /// Every field that is state: migration, restart, output and the finiteness audit walk this one
  /// list.
  template <class F>
  void for_each_field(F&& f) {
    list_fields(*this, f);
  }
  template <class F>
  void for_each_field(F&& f) const {
    list_fields(*this, f);
  }
  template <class F>
  void for_each_scratch_field(F&& f) {
    list_scratch_fields(*this, f);
  }
  template <class F>
  void for_each_scratch_field(F&& f) const {
    list_scratch_fields(*this, f);
  }

private:
  /// Of particles that may be changed, and of others.
  template <class Any, class F>
  static void list_fields(Any& particles, F& f) {
    f(particles.position);
    f(particles.velocity);
    f(particles.deformation_gradient);
    f(particles.rotation);
    f(particles.stress);
    f(particles.mass);
    f(particles.volume);
    f(particles.half_size);
    f(particles.viscous_pressure);
    f(particles.longitudinal_modulus);
    f(particles.history);
    f(particles.reference_position);
    f(particles.splits);
    f(particles.clipped);
    f(particles.loaded_faces);
    f(particles.surface_share);
    f(particles.affine);
    f(particles.darcy_velocity);
  }
  template <class Any, class F>
  static void list_scratch_fields(Any& particles, F& f) {
    f(particles.grid_motion);
    f(particles.increment);
    f(particles.second_pass_motion);
    f(particles.second_pass_increment);
    f(particles.heat);
    f(particles.shear_modulus);
    f(particles.residual);
  }
};

/// A row that has come: its cell is looked for by place_particles.
inline void mark_unplaced(const Particles& particles, int p) {
  particles.key(p) = CellKey::unplaced;
  particles.fault(p) = Fault::none;
}

/// Tile of a row on this rank, to index with.
/// @pre  place_particles has placed it
KOKKOS_INLINE_FUNCTION int tile_of(const Patch& patch, const Particles& particles, int p) {
  return index_of(particles.key(p)) >> (patch.tile_bits * patch.dimensions);
}

/// Components of a symmetric tensor in a mode; the old volume follows them in `increment`.
inline int tensor_components(int dimensions) {
  return dimensions == 3 ? 6 : 4;
}

/// A row of a vector field; 0 along z in two-dimensional modes.
inline Vector vector_of(const Field& field, int p) {
  Vector v{};
  for (int d = 0; d < field.components; ++d) v[static_cast<std::size_t>(d)] = field(p, d);
  return v;
}

/// Whether it keeps first moments of the grid's velocity (APIC).
inline bool has_affine_velocity(const Particles& particles) {
  return particles.affine.components > 0 && !particles.rigid;
}

/// An empty set for one material with the fields that the scene needs.
Particles make_particles(const Scene& scene, int material);

/// Room for at least `capacity` rows; grows by half when it must grow, keeps what is there.
void reserve(Particles& particles, int capacity);

/// Put the rows into the order of the last sort, for the sake of the cache.
void permute_rows(Particles& particles);

/// Remove the `marked` rows that `spare` marks with 1: the last ones of those that stay take
/// their places, so that no more is moved than has gone. Storage order has no meaning.
void remove_marked_rows(Particles& particles, int marked);

/// Bytes of state and scratch arrays that one particle of this set occupies.
std::size_t bytes_per_particle(const Particles& particles);

}  // namespace barreno
