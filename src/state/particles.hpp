// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/field.hpp"
#include "grid/patch.hpp"
#include "scene/scene.hpp"
#include "state/tally_sizes.hpp"

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
inline constexpr int held_bit = 1 << 30;

/// Particles::key of a row whose cell is not known: of newcomers, until place_particles.
inline constexpr int unplaced_key = -1;

/// What a step has found wrong with a particle that its material then removes; locate_particles of
/// the next step takes it out. It stands beside the key, which is that of the particle's cell until
/// then: what is left of the step has the particle in its tile.
enum class Fault : unsigned char { none, failed, expanded, inverted };

/// All particles of one material: structure of arrays, `count` rows used of `capacity`.
/// Storage order has no meaning; `order` lists the rows by (tile, cell, id), so that every sum over
/// particles has one order, whatever their history or rank count.
struct Particles {
  int material = 0;    ///< index into Scene::materials
  int field = 0;       ///< velocity field
  bool rigid = false;  ///< one body with prescribed motion
  int count = 0;
  int capacity = 0;
  double critical_courant = 1.0;  ///< of the smallest particle that the scene gives this set
  double lone_courant = 1.0;      ///< of lone_courant()
  TallySizes tally_sizes;         ///< of tally_sizes()
  bool sorted = false;            ///< order and tile_begin belong to the present rows and tiles

  ArrayView<ParticleId> id;  ///< unique over the run; files sort by it
  ArrayView<int> body;  ///< index into Scene::bodies, or its size for the jet; held_bit: debris

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
  Field clipped;       ///< 1 if the domain is cut at Largest Domain, of shapes that deform [-]
  Field loaded_faces;  ///< bits of pressure loads on own faces; no components if there are none
  /// SurfaceShare of the inner, then the outer surface of a loaded ball; no components without one.
  Field surface_share;
  Field darcy_velocity;  ///< of the fluid, where it drains [length/time]
  /// Of APIC: B_p, first moments of the grid's velocity [length^2/time]; before the first step the
  /// gradient of the initial velocity [1/time].
  Field affine;

  /// Scratch of the step, not state: what the grid says to the particle.
  Field grid_motion;  ///< interpolated velocity, then velocity increment [length/time]
  Field increment;    ///< dt L, then the unrotated strain increment, then the old volume
  /// What the grid says a second time: XPIC, modified stress last and stress first only.
  Field again_motion;
  Field again_increment;  ///< XPIC only
  Field heat;  ///< energy that the step must leave in the particle, where its losses are returned
               ///< [energy]
  Field residual;  ///< of XPIC: what of v_p the grid does not hold [length/time]

  ArrayView<int> key;  ///< tile * cells per tile + cell in tile, of the last sort
  ArrayView<Fault> fault;
  ArrayView<int> spare;  ///< scratch of the sort
  ArrayView<ParticleId> spare_id;
  ArrayView<int> order;                 ///< rows sorted by (key, id)
  ArrayView<int> cell_begin, cell_end;  ///< scratch of the sort
  ArrayView<unsigned char> run_part;    ///< RunPart of each run of rows
  ArrayView<unsigned char> left_out;    ///< 1 for rows of a run in part that stay as they are
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
    f(particles.again_motion);
    f(particles.again_increment);
    f(particles.heat);
    f(particles.residual);
  }
};

/// A row that has come: its cell is looked for by place_particles.
inline void put_unplaced(const Particles& particles, int p) {
  particles.key(p) = unplaced_key;
  particles.fault(p) = Fault::none;
}

/// Tile of a row on this rank, to index with.
/// @pre  place_particles has placed it
KOKKOS_INLINE_FUNCTION int tile_of(const Patch& patch, const Particles& particles, int p) {
  assert(particles.key(p) >= 0);
  return particles.key(p) >> (patch.tile_bits * patch.dimensions);
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

/// An empty set for one material with the fields that the scene needs.
Particles make_particles(const Scene& scene, int material);

/// Room for at least `capacity` rows; grows by half when it must grow, keeps what is there.
void reserve(Particles& particles, int capacity);

/// Put the rows into the order of the last sort, for the sake of the cache.
void permute_rows(Particles& particles);

/// Rows [0, count) of the listed rows only, in their present order; `keep[p]` says which.
void keep_rows(Particles& particles, const std::vector<char>& keep);

/// Bytes of state and scratch arrays that one particle of this set occupies.
std::size_t bytes_per_particle(const Particles& particles);

}  // namespace barreno
