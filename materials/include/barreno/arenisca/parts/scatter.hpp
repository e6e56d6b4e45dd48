// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"

#include <cmath>
#include <cstdint>

namespace barreno {

/// A piece of material as its host cuts it, for properties that vary from piece to piece.
struct Specimen {
  std::uint64_t id = 0;  ///< the same for any number of ranks and any order
  double volume = 0.0;  ///< full circle in axisymmetry, per unit thickness in plane strain [volume]
  double face = 0.0;    ///< area in the plane [area]
  double per_crack = 1.0;  ///< pieces that lie side by side in a crack, across it
};

namespace arenisca {

/// Scatter of the strength with its scale effect: the weakest flaw of a volume V decides,
///
///   PEAKI1 = mean / Gamma(1 + 1/m) (Vref/V)^(1/m) (-ln U)^(1/m),   U uniform in (0, 1)
///
/// with the mean that of pieces of the reference volume. U comes from the piece's id and the seed
/// alone, not from a sequence of draws: the same specimen for any number of ranks and any order of
/// particles. W. Weibull, J. Appl. Mech. 18 (1951).
struct Weibull {
  struct Parameters {
    double weibull_modulus, weibull_reference_volume, weibull_seed;
    int weibull_volume, weibull_scatter;

    static constexpr int ring_volume = 1, scale_only = 1;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::weibull_modulus,
             "Weibull modulus",
             d::none,
             at_least(0.0),
             0.0,
             "m: PEAKI1 varies from particle to particle, less with larger m; 0: no variation"
         ),
         optional(
             &P::weibull_reference_volume,
             "Weibull reference volume",
             d::volume,
             at_least(0.0),
             0.0,
             "volume of the specimens whose mean strength is PEAKI1; smaller particles are stronger"
         ),
         optional(
             &P::weibull_seed,
             "Weibull seed",
             d::none,
             at_least(0.0),
             0.0,
             "whole number; each gives another specimen of the same rock"
         )},
        {{&P::weibull_volume,
          "Weibull volume",
          {"cube", "ring"},
          0,
          "volume of a particle for the scale effect: the cube over its face in the plane, the "
          "same "
          "at "
          "any distance from the axis; ring: its own (full circle, or per unit thickness)"},
         {&P::weibull_scatter,
          "Weibull scatter",
          {"random", "scale only"},
          0,
          "scale only: every particle has the mean of its size"}}};
  }
  static std::string check(const Parameters& p) {
    constexpr double max_seeds = 9007199254740992.0;  // 2^53: whole numbers that a double holds
    if (!(p.weibull_seed < max_seeds && p.weibull_seed == std::floor(p.weibull_seed))) {
      return named("Weibull seed", p.weibull_seed) +
             " is not a whole number below 2^53 (it numbers specimens); take 0, 1, 2 and so on.";
    }
    if (p.weibull_modulus == 0.0) {
      if (p.weibull_reference_volume == 0.0) return {};
      return named("Weibull reference volume", p.weibull_reference_volume) +
             " has no effect without a Weibull modulus (0: no scatter); set the modulus, or the "
             "volume to "
             "0.";
    }
    if (p.weibull_reference_volume == 0.0) {
      return named("Weibull modulus", p.weibull_modulus) +
             " needs a Weibull reference volume (strength depends on size); set that of the "
             "specimens that PEAKI1 was measured on.";
    }
    return {};
  }

  double modulus = 0.0;           ///< m; 0: every piece has the mean
  double reference_volume = 0.0;  ///< Vref [volume]
  std::uint64_t seed = 0;
  bool ring = false;        ///< V is the piece's own volume; else the cube over its face
  bool scale_only = false;  ///< the random part is replaced by its mean
  double bound = HUGE_VAL;  ///< largest factor: the surface must not open backwards

  /// @param largest_factor  of the limit, see ShearLimit
  static Weibull make(const Parameters& p, double largest_factor) {
    return {
        p.weibull_modulus,
        p.weibull_reference_volume,
        static_cast<std::uint64_t>(p.weibull_seed),
        p.weibull_volume == Parameters::ring_volume,
        p.weibull_scatter == Parameters::scale_only,
        largest_factor};
  }

  bool present() const { return modulus > 0.0; }

  /// Steele's, Lea's and Flood's mixing function (OOPSLA 2014): every bit of the result depends on
  /// every bit of the argument.
  static std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// In (0, 1), both ends excluded.
  double uniform(std::uint64_t id) const {
    constexpr double step = 1.0 / 9007199254740992.0;  // 2^-53
    return (static_cast<double>(mix(mix(seed) ^ id) >> 11U) + 0.5) * step;
  }
  /// A cube's volume for a particle of a plane: its strength must not depend on how far from the
  /// axis it is.
  double volume_of(const Specimen& piece) const {
    return ring ? piece.volume : piece.face * std::sqrt(piece.face);
  }
  /// PEAKI1 of the piece over the mean.
  double factor(const Specimen& piece) const {
    if (!present()) return 1.0;
    const double power = 1.0 / modulus;
    const double scale = std::pow(reference_volume / volume_of(piece), power);
    if (scale_only) return std::fmin(scale, bound);
    const double random = std::pow(-std::log(uniform(piece.id)), power) / std::tgamma(1.0 + power);
    return std::fmin(scale * random, bound);
  }
};

}  // namespace arenisca
}  // namespace barreno
