// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <type_traits>
#include <utility>

namespace barreno {

/// What a step that lets fluid drain sees of a point.
///
/// At fixed strain, to first order in the volume of fluid v that comes in (per volume, at the
/// density that the fluid in the pores has):
///
///   dp = v/storage,   d sigma = -biot dp I,   d fluid_mass = v mass_per_volume
///
/// the last exactly, so a host that moves mass gives v = mass/mass_per_volume and loses none.
/// fluid_mass/mass_per_volume is all that can be taken out.
struct PorePoint {
  double pressure = 0.0;         ///< of the fluid [stress]
  double biot = 0.0;             ///< alpha [-]
  double storage = 0.0;          ///< 1/M at fixed strain [1/stress]; 0: no fluid that could flow
  double porosity = 0.0;         ///< pore volume over volume [-]
  double fluid_mass = 1.0;       ///< over the initial one of the reference volume [-]
  double mass_per_volume = 0.0;  ///< d fluid_mass for v = 1 [-]
  /// Pores that gas fills in part: volume of the gas per volume, and the rise of the fluid's
  /// pressure that closes it. Storage is the sum of full pores' storage and gap/gap_pressure.
  double gap = 0.0;
  double gap_pressure = 0.0;  ///< [stress]
};

/// True for a model whose points hold fluid that a host can move:
///
///   PorePoint pore_point(const Sym3& stress, const History& h) const
///   Outcome drain(double fluid_volume, Sym3& stress, History& h) const
///
/// drain() lets that volume of fluid in (negative: out) at fixed strain. Its elastic_work is the
/// energy that comes with the fluid, the integral of p dv, less the plastic_work of a correction;
/// both per volume, as fluid_volume. Zero changes no bit. Where it fails (bad_input also for more
/// fluid than there is, or for a point with storage = 0) stress and history stay as they were.
template <class Model, class = void>
struct IsDrainable : std::false_type {};
template <class Model>
struct IsDrainable<
    Model,
    std::void_t<
        decltype(std::declval<const Model&>().pore_point(
            std::declval<const Sym3&>(), std::declval<const typename Model::History&>()
        )),
        decltype(std::declval<const Model&>()
                     .drain(0.0, std::declval<Sym3&>(), std::declval<typename Model::History&>()))>>
    : std::true_type {};
template <class Model>
inline constexpr bool is_drainable = IsDrainable<Model>::value;

/// What history and pore points say: closed walls of empty pores press on each other, but no fluid
/// has that pressure.
BARRENO_FUNCTION double pressure_of_fluid(double pressure_in_pores, double fluid_mass) {
  return fluid_mass > 0.0 ? pressure_in_pores : 0.0;
}

/// Mass that is left when so much has come in, over the initial one; what round-off leaves of an
/// emptied point is none. Negative: there is not that much.
BARRENO_FUNCTION double fluid_mass_after(const PorePoint& point, double fluid_volume) {
  constexpr double round_off = 1e-15;
  const double mass = point.fluid_mass + fluid_volume * point.mass_per_volume;
  return std::fabs(mass) < round_off * point.fluid_mass ? 0.0 : mass;
}

}  // namespace barreno
