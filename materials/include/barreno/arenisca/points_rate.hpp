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
  Sym3Of<R> missed_before{};  ///< by cracks that open before it flows
  ModuliOf<R> mean_moduli;    ///< of the skeleton over the step so far, times its fraction
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

/// Viscoplastic strain of a step, which damages rated rock: a share of the plastic strain of the
/// quasi-static answer, and what the overstress from before gives up. Together they are what the
/// dynamic stress leaves of the strain (docs/method.md 20).
template <class R, bool asked>
struct ViscoplasticStrain {};
template <class R>
struct ViscoplasticStrain<R, true> {
  R taken = R{} + 1.0;    ///< share of the plastic strain
  ShearOf<R> released{};  ///< deviator that overstress gives up, in the plane of the step
  R beside{};             ///< half the square of the rest of it
  R released_volume{};
};

/// What overstress gives up in a step, as a strain.
/// @param m  moduli of the skeleton
template <class R>
BARRENO_FUNCTION Sym3Of<R> released_strain(
    const RelaxationOf<R>& r, const Sym3Of<R>& over, const ModuliOf<R>& m
) {
  const R gone = real::select(r.moves, 1.0 - r.left, 0.0);
  return gone * elastic_strain(over, m);
}
/// Which share of the plastic strain of a step's quasi-static answer the dynamic one takes at once.
template <class R>
BARRENO_FUNCTION R share_taken(const RelaxationOf<R>& r) {
  return real::select(r.moves, 1.0 - r.mean, 1.0);
}

/// Strain that damages, of a plastic strain's deviator and volume: sqrt(2/3 e : e) + max(v, 0)/3.
/// @param squares  half the square of the deviator
template <class R>
BARRENO_FUNCTION R damaging_strain(const R& squares, const R& volume) {
  return real::sqrt(R((4.0 / 3.0) * squares)) + real::larger(volume, 0.0) * (1.0 / 3.0);
}

}  // namespace barreno::arenisca
