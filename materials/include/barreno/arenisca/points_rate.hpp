// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/rate.hpp"
#include "barreno/arenisca/points_shear.hpp"

namespace barreno::arenisca {

// Overstress of points (parts/rate.hpp) as steps and histories hold it.

/// What a step of rated rock keeps: the changes that it left of elastic ones [stress], and moduli.
template <class R, class Law, bool rated>
struct Missed {};
template <class R, class Law>
struct Missed<R, Law, true> {
  R missed_x{};
  ShearIn<R, Law> missed_s{};
  ModuliOf<R> mean_moduli;  ///< of the skeleton over the step so far, times its fraction
};

template <class R, class History>
BARRENO_FUNCTION Sym3Of<R> overstress_of(const History& h) {
  return {
      h.overstress_xx,
      h.overstress_yy,
      h.overstress_zz,
      h.overstress_xy,
      h.overstress_yz,
      h.overstress_zx};
}
template <class R, class History>
BARRENO_FUNCTION void set_overstress(const MaskOf<R>& choice, const Sym3Of<R>& over, History& h) {
  h.overstress_xx = real::select(choice, over.xx, h.overstress_xx);
  h.overstress_yy = real::select(choice, over.yy, h.overstress_yy);
  h.overstress_zz = real::select(choice, over.zz, h.overstress_zz);
  h.overstress_xy = real::select(choice, over.xy, h.overstress_xy);
  h.overstress_yz = real::select(choice, over.yz, h.overstress_yz);
  h.overstress_zx = real::select(choice, over.zx, h.overstress_zx);
}

}  // namespace barreno::arenisca
