// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_deformation.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"

namespace barreno {
namespace {

/// New F, volume and unrotated strain of one row; `Exponential` is the short or the general one.
template <class M, bool Short>
struct UpdateDeformation {
  FieldView increment, deformation, volume;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    const PlaneTensor dt_l{
        increment(p, 0),
        increment(p, 1),
        increment(p, 2),
        increment(p, 3),
        M::hoop ? increment(p, 4) : 0.0};
    const PlaneTensor f_n = load_plane_tensor<M>(deformation, p);
    const PlaneTensor f = Short ? short_exponential(dt_l) : exponential(dt_l);
    const PlaneTensor f_n1 = multiply(f, f_n);
    const PlaneRotation r_m = mean_polar_rotation(f_n, f_n1);
    const Sym3 strain =
        unrotate(r_m, {dt_l.xx, dt_l.yy, dt_l.zz, 0.5 * (dt_l.xy + dt_l.yx), 0.0, 0.0});
    deformation(p, 0) = f_n1.xx;
    deformation(p, 1) = f_n1.xy;
    deformation(p, 2) = f_n1.yx;
    deformation(p, 3) = f_n1.yy;
    if constexpr (M::hoop) deformation(p, 4) = f_n1.zz;
    const double old_volume = volume(p, 0);
    volume(p, 0) = old_volume * determinant(f);
    increment(p, 0) = strain.xx;
    increment(p, 1) = strain.yy;
    increment(p, 2) = strain.zz;
    increment(p, 3) = strain.xy;
    increment(p, 4) = old_volume;
  }
};

}  // namespace

void update_deformation(const Scene& scene, Rows rows, Particles& particles) {
  const Region region("update_deformation");
  const FieldView& increment = particles.increment.values;
  const FieldView& deformation = particles.deformation_gradient.values;
  const FieldView& volume = particles.volume.values;
  visit_mode(scene.grid.mode, [&](auto mode) {
    using M = decltype(mode);
    // The general form takes the short one where that holds, row by row: the answer does not depend
    // on which rows share a block.
    if (all_short(increment, rows, 0, M::hoop ? 5 : 4))
      for_each_row(
          "update_deformation", rows, UpdateDeformation<M, true>{increment, deformation, volume}
      );
    else
      for_each_row(
          "update_deformation", rows, UpdateDeformation<M, false>{increment, deformation, volume}
      );
  });
}

}  // namespace barreno
