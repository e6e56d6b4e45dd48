// SPDX-License-Identifier: BSD-3-Clause
#include "step/update_deformation.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"

namespace barreno {

void update_deformation(const Scene& scene, Particles& particles) {
  const Region region("update_deformation");
  const Particles p_ = particles;
  visit_mode(scene.grid.mode, [&](auto mode) {
    using M = decltype(mode);
    Kokkos::parallel_for(
        "update_deformation",
        range(particles.count),
        KOKKOS_LAMBDA(const int p) {
          const FieldView& inc = p_.increment.values;
          const FieldView& deformation = p_.deformation_gradient.values;
          const PlaneTensor dt_l{
              inc(p, 0), inc(p, 1), inc(p, 2), inc(p, 3), M::hoop ? inc(p, 4) : 0.0};
          const PlaneTensor f_n = load_plane_tensor<M>(deformation, p);
          const PlaneTensor f_n1 = multiply(exponential(dt_l), f_n);
          const PlaneRotation r_m = mean_rotation(polar_rotation(f_n), polar_rotation(f_n1));
          const Sym3 strain =
              unrotate(r_m, {dt_l.xx, dt_l.yy, dt_l.zz, 0.5 * (dt_l.xy + dt_l.yx), 0.0, 0.0});
          deformation(p, 0) = f_n1.xx;
          deformation(p, 1) = f_n1.xy;
          deformation(p, 2) = f_n1.yx;
          deformation(p, 3) = f_n1.yy;
          if constexpr (M::hoop) deformation(p, 4) = f_n1.zz;
          inc(p, 0) = strain.xx;
          inc(p, 1) = strain.yy;
          inc(p, 2) = strain.zz;
          inc(p, 3) = strain.xy;
          inc(p, 4) = determinant(f_n);
        }
    );
  });
}

}  // namespace barreno
