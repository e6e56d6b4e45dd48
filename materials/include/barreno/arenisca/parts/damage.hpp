// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/cap_shape.hpp"
#include "barreno/arenisca/parts/part.hpp"
#include "barreno/arenisca/parts/shear_limit.hpp"
#include "barreno/arenisca/selection.hpp"
#include "barreno/real.hpp"

#include <cmath>
#include <utility>

namespace barreno::arenisca {

/// Damage of rock that shears and opens: D from 0 to 1 takes cohesion and tensile strength and
/// leaves friction. The limit surface is that of
///
///   PEAKI1 (1 - D),   FSLOPE - D (FSLOPE - R)
///
/// with R the slope of broken rock, and D grows with the plastic strain where pressure is low:
///
///   dD = (sqrt(2/3 de_p : de_p) + max(devp, 0)/3) exp(-max(p, 0)/p_D) (1 - c)/e_f
///
/// e_p is the plastic deviator, p = -I1/3, c of the flow rule (0 on the limit surface, 1 at the end
/// of the cap). Under uniaxial tension the strain in brackets is the plastic strain along the axis.
/// Its work in a crack of width L, that of a piece or of a host's cell, is the fracture energy G of
/// a unit of area:
///
///   L e_f (mean of the uniaxial tensile strength over D from 0 to 1) = G
///
/// The strength is that of the surface or, where it is lower, the bound of parts/tension.hpp.
/// This is the crack band of Z. P. Bazant and B. H. Oh (Materiaux et Constructions 16 (1983) 155).
struct Damage {
  struct Parameters {
    double fracture_strain, fracture_energy, residual_slope, damage_pressure;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::fracture_strain,
             "Fracture strain",
             d::none,
             at_least(0.0),
             0.0,
             "e_f: plastic strain in tension of fully damaged rock, which has lost cohesion and "
             "tensile strength. 0: no damage, as published"
         ),
         optional(
             &P::fracture_energy,
             "Fracture energy",
             d::energy_per_area,
             at_least(0.0),
             0.0,
             "G: work of a crack in tension. Where a host knows the size of a piece of rock, e_f "
             "follows from it; other hosts keep Fracture strain. 0: Fracture strain for any size"
         ),
         optional(
             &P::residual_slope,
             "Residual slope",
             d::none,
             at_least(0.0),
             0.0,
             "R: FSLOPE of fully damaged rock. 0: FSLOPE"
         ),
         optional(
             &P::damage_pressure,
             "Damage pressure",
             d::stress,
             at_least(0.0),
             0.0,
             "p_D: damage grows with exp(-p/p_D), p the (effective) mean pressure. 0: the same at "
             "any pressure"
         )},
        {}};
  }
  static std::string check(const Parameters& p) {
    if (p.fracture_strain > 0.0) return {};
    const auto [name, value] =
        p.fracture_energy > 0.0  ? std::pair{"Fracture energy", p.fracture_energy}
        : p.residual_slope > 0.0 ? std::pair{"Residual slope", p.residual_slope}
                                 : std::pair{"Damage pressure", p.damage_pressure};
    if (value == 0.0) return {};
    return named(name, value) +
           " needs a Fracture strain, but that is 0 (rock without damage); set the plastic strain "
           "at which rock under tension is broken, 0.01 for example, or leave " +
           name + " out.";
  }

  double strain = 1.0;        ///< e_f where nothing else is known
  double energy = 0.0;        ///< G [stress x length]; 0: e_f does not depend on the size
  double mean_tension = 1.0;  ///< mean of the uniaxial tensile strength over D from 0 to 1 [stress]
  double slope = 0.0;         ///< R
  double per_pressure = 0.0;  ///< 1/p_D [1/stress]
  /// For fall(): FSLOPE PEAKI1, PEAKI1, FSLOPE - R, and the largest y exp(-a y) that the surface
  /// has.
  double cohesion = 0.0, peak = 0.0, loss = 0.0, longest = HUGE_VAL;

  /// @param p  of damage, of the shear limit and of the bound on tension
  template <class All>
  static Damage make(const All& p) {
    Damage d;
    constexpr double never = 1e30;  // rock without damage that has other features
    d.strain = p.fracture_strain > 0.0 ? p.fracture_strain : never;
    d.energy = p.fracture_energy;
    d.slope = p.residual_slope > 0.0 ? p.residual_slope : p.FSLOPE;
    d.per_pressure = p.damage_pressure > 0.0 ? 1.0 / p.damage_pressure : 0.0;
    d.cohesion = p.FSLOPE * p.PEAKI1;
    d.peak = p.PEAKI1;
    d.loss = p.FSLOPE - d.slope;
    constexpr double e = 2.718281828459045;
    if (p.STREN > 0.0) d.longest = p.STREN / (e * (d.slope - p.YSLOPE));
    constexpr int intervals = 64;
    double sum = 0.0;
    for (int i = 0; i <= intervals; ++i) {
      const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      const double damage = static_cast<double>(i) / intervals;
      const double surface = d.tension(p, damage), bound = (1.0 - damage) * p.tension_cutoff;
      sum += weight * (p.tension_cutoff > 0.0 && bound < surface ? bound : surface);
    }
    d.mean_tension = sum / (3.0 * intervals);
    return d;
  }
  /// Strength under uniaxial tension at a damage, where sigma/sqrt(3) = Ff(sigma) [stress].
  double tension(const ShearLimit::Parameters& p, double damage) const {
    constexpr double per_root_3 = 0.57735026918962576;
    constexpr int halvings = 60;
    const auto limit =
        ShearLimit::make(p, p.PEAKI1 * (1.0 - damage), p.FSLOPE - damage * (p.FSLOPE - slope));
    double low = 0.0, high = limit.vertex;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (limit.limit_at(middle).value > per_root_3 * middle ? low : high) = middle;
    }
    return low;
  }
  /// e_f where cracks are this wide.
  double strain_of(double width) const {
    return energy > 0.0 ? energy / (mean_tension * width) : strain;
  }
  /// A bound on what a unit of damage takes of Ff at I1 = x [stress].
  /// @param coherence  strength at the vertex over PEAKI1
  template <class R>
  BARRENO_FUNCTION R fall(const R& x, const R& coherence) const {
    const R reach = real::smaller(real::larger(R(coherence * peak - x), 0.0), longest);
    return coherence * cohesion + loss * reach;
  }
  /// Which share of a plastic strain damages.
  template <class R>
  BARRENO_FUNCTION R share(const R& x, const CapOf<R>& cap) const {
    const R pressed = real::exp(R((per_pressure / 3.0) * real::smaller(x, 0.0)));
    return pressed * (1.0 - place_on_cap(x, cap));
  }
};

}  // namespace barreno::arenisca
