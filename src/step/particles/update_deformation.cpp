// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/update_deformation.hpp"

#include "base/region.hpp"
#include "shape/generator.hpp"

namespace barreno {
namespace {

/// How much dt L may be: anything, or within short_series or shorter_series.
enum class Size { any, small, tiny };

template <class M, Size S>
KOKKOS_INLINE_FUNCTION typename M::Tensor generator_of(
    const typename M::Tensor& dt_l, double sign
) {
  if constexpr (S != Size::any) return short_generator(dt_l, sign);
  return generator(dt_l, sign);
}
template <class M, Size S>
KOKKOS_INLINE_FUNCTION typename M::Tensor exponential_of(const typename M::Tensor& a) {
  if constexpr (S == Size::tiny && M::dimensions == 3) return short_exponential<7>(a);
  if constexpr (S != Size::any) return short_exponential(a);
  return exponential(a);
}

/// New F, volume and unrotated strain of one row in two dimensions.
template <class M, Size S>
struct DeformInPlane {
  FieldView increment, deformation, volume;
  double sign;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    const PlaneTensor a = generator_of<M, S>(load_tensor<M>(increment, p, 0.0), sign);
    const PlaneTensor f_n = load_tensor<M>(deformation, p);
    const PlaneTensor f = exponential_of<M, S>(a);
    const PlaneTensor f_n1 = multiply(f, f_n);
    const PlaneRotation r_m = mean_polar_rotation(f_n, f_n1);
    const Sym3 strain = unrotate(r_m, {a.xx, a.yy, a.zz, 0.5 * (a.xy + a.yx), 0.0, 0.0});
    store_tensor<M>(f_n1, deformation, p);
    const double old_volume = volume(p, 0);
    volume(p, 0) = old_volume * determinant(f);
    increment(p, 0) = strain.xx;
    increment(p, 1) = strain.yy;
    increment(p, 2) = strain.zz;
    increment(p, 3) = strain.xy;
    increment(p, 4) = old_volume;
  }
};

/// Where a row's new rotation waits in the scratch until it is known to be exact, and what was left
/// of it.
enum { new_rotation = 0, rotation_left = 4 };

KOKKOS_INLINE_FUNCTION void store_rotation(
    const SpaceRotation& r, const FieldView& scratch, int p
) {
  scratch(p, new_rotation) = r.w;
  scratch(p, new_rotation + 1) = r.x;
  scratch(p, new_rotation + 2) = r.y;
  scratch(p, new_rotation + 3) = r.z;
}
KOKKOS_INLINE_FUNCTION SpaceRotation waiting_rotation(const FieldView& scratch, int p) {
  return {
      scratch(p, new_rotation),
      scratch(p, new_rotation + 1),
      scratch(p, new_rotation + 2),
      scratch(p, new_rotation + 3)};
}

/// In three dimensions first the generator, in the place of dt L: loops are small enough to be
/// vectorised.
template <Size S>
struct FindGenerator {
  using M = ThreeDimensional;
  FieldView increment;
  double sign;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    store_tensor<M>(generator_of<M, S>(load_tensor<M>(increment, p, 0.0), sign), increment, p);
  }
};

/// Then F, volume and rotation; the strain waits in the space frame.
template <Size S>
struct DeformInSpace {
  using M = ThreeDimensional;
  FieldView increment, deformation, rotation, volume, scratch;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    const SpaceTensor a = load_tensor<M>(increment, p, 0.0);
    const SpaceTensor f = exponential_of<M, S>(a);
    const SpaceTensor f_n1 = multiply(f, load_tensor<M>(deformation, p));
    const SpaceRotation r_n = load_rotation<M>(deformation, rotation, p);
    double left = 0.0;
    const SpaceRotation r = nearer_polar_rotation(f_n1, rotated_by_spin(r_n, a), left);
    store_tensor<M>(f_n1, deformation, p);
    store_rotation(r, scratch, p);
    scratch(p, rotation_left) = left;
    const double old_volume = volume(p, 0);
    volume(p, 0) = old_volume * determinant(f);
    increment(p, 0) = a.xx;
    increment(p, 1) = a.yy;
    increment(p, 2) = a.zz;
    increment(p, 3) = 0.5 * (a.xy + a.yx);
    increment(p, 4) = 0.5 * (a.yz + a.zy);
    increment(p, 5) = 0.5 * (a.zx + a.xz);
    increment(p, 6) = old_volume;
  }
};

bool all_found(const FieldView& scratch, Rows rows) {
  int left = 0;
  launch_reduction(
      "all_found",
      range((rows.end - rows.begin + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, int& some) {
        const int begin = rows.begin + chunk * rows_per_chunk;
        const int end = begin + rows_per_chunk < rows.end ? begin + rows_per_chunk : rows.end;
        if (rows.skips(begin)) return;
        int here = 0;
        for (int p = begin; p < end; ++p)
          here |= static_cast<int>(!(scratch(p, rotation_left) <= rotation_tolerance));
        some += here;
      },
      left
  );
  return left == 0;
}

/// Another Newton step for the rows that need it, computed for all and without branches.
struct TurnOnce {
  FieldView deformation, scratch;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    const double before = scratch(p, rotation_left);
    const SpaceRotation first = waiting_rotation(scratch, p);
    double left = 0.0;
    const SpaceRotation next =
        nearer_polar_rotation(load_tensor<ThreeDimensional>(deformation, p), first, left);
    const bool found = before <= rotation_tolerance;
    scratch(p, new_rotation) = found ? first.w : next.w;
    scratch(p, new_rotation + 1) = found ? first.x : next.x;
    scratch(p, new_rotation + 2) = found ? first.y : next.y;
    scratch(p, new_rotation + 3) = found ? first.z : next.z;
    scratch(p, rotation_left) = found ? before : left;
  }
};

/// Rows whose rotation two Newton steps did not find: drawn out far, or turned far in one step. An
/// F that is inside out has none and keeps the one before: held debris must stay finite.
struct FindRotation {
  FieldView deformation, rotation, scratch;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    if (scratch(p, rotation_left) <= rotation_tolerance) return;
    using M = ThreeDimensional;
    const SpaceTensor f = load_tensor<M>(deformation, p);
    const SpaceRotation before = load_rotation<M>(deformation, rotation, p);
    const SpaceRotation r = determinant(f) > 0.0 ? polar_rotation(f, before) : before;
    store_rotation(r, scratch, p);
  }
};

/// Then the strain, in the frame half-way between the old and the new rotation.
struct UnrotateStrain {
  FieldView increment, rotation, scratch;
  ArrayView<unsigned char> stays;  ///< 1: left as it is by a step that its chunk takes part in

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    const SpaceRotation r_n{rotation(p, 0), rotation(p, 1), rotation(p, 2), rotation(p, 3)};
    const SpaceRotation r = waiting_rotation(scratch, p);
    const Sym3 strain = unrotate_between(
        r_n,
        r,
        {increment(p, 0),
         increment(p, 1),
         increment(p, 2),
         increment(p, 3),
         increment(p, 4),
         increment(p, 5)}
    );
    increment(p, 0) = strain.xx;
    increment(p, 1) = strain.yy;
    increment(p, 2) = strain.zz;
    increment(p, 3) = strain.xy;
    increment(p, 4) = strain.yz;
    increment(p, 5) = strain.zx;
    // Another Newton step would change it by round-off, with the rows that share its chunk.
    const bool moves = stays(p) == 0;
    rotation(p, 0) = moves ? r.w : r_n.w;
    rotation(p, 1) = moves ? r.x : r_n.x;
    rotation(p, 2) = moves ? r.y : r_n.y;
    rotation(p, 3) = moves ? r.z : r_n.z;
  }
};

template <class M, Size S>
void deform(Rows rows, double sign, const Particles& particles) {
  const FieldView& increment = particles.increment.values;
  const FieldView& deformation = particles.deformation_gradient.values;
  const FieldView& volume = particles.volume.values;
  const char* const label = "update_deformation";
  if constexpr (M::dimensions == 3) {
    const FieldView& rotation = particles.rotation.values;
    const FieldView& scratch = particles.grid_motion.values;  // what it held has been used
    for_each_row(label, rows, FindGenerator<S>{increment, sign});
    for_each_row(label, rows, DeformInSpace<S>{increment, deformation, rotation, volume, scratch});
    if (!all_found(scratch, rows)) {
      for_each_row(label, rows, TurnOnce{deformation, scratch});
      for_each_row(label, rows, FindRotation{deformation, rotation, scratch});
    }
    for_each_row(label, rows, UnrotateStrain{increment, rotation, scratch, particles.dormant});
  } else {
    for_each_row(label, rows, DeformInPlane<M, S>{increment, deformation, volume, sign});
  }
}

}  // namespace

void update_deformation(Mode mode, Rows rows, Gradient gradient, Particles& particles) {
  const Region region("update_deformation");
  visit_mode(mode, [&](auto kinematics) {
    using M = decltype(kinematics);
    const auto within = [&](double limit) {
      return all_short(particles.increment.values, rows, 0, M::deformation_components, limit);
    };
    const double sign = sign_of(gradient);
    // All forms give a row the same bits: its answer does not depend on which rows share a block.
    if (M::dimensions == 3 && within(shorter_series))
      deform<M, Size::tiny>(rows, sign, particles);
    else if (within(short_series))
      deform<M, Size::small>(rows, sign, particles);
    else
      deform<M, Size::any>(rows, sign, particles);
  });
}

}  // namespace barreno
