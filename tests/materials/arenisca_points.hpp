// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"
#include "materials/sample_models.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

/// Points of Arenisca and steps for them, for the tests of lanes and the benchmark.
namespace barreno::test {

template <class Model>
struct PointOf {
  Increment increment{};
  Sym3 stress;
  typename Model::History history;
};
using RockPoint = PointOf<Arenisca>;

/// As materials/cards/berea_sandstone.xml.
inline Arenisca::Parameters berea() {
  Arenisca::Parameters p{};
  const auto table = Arenisca::parameter_table();
  for (const auto& entry : table.numbers) p.*entry.member = entry.default_value;
  for (const auto& entry : table.choices) p.*entry.member = entry.default_index;
  p.PEAKI1 = 9.36e6;
  p.FSLOPE = 0.549;
  p.STREN = 128.5e6;
  p.YSLOPE = 0.0724;
  p.CR = 0.593;
  p.B0 = 6.74e9;
  p.B1 = 28.6e9;
  p.B2 = 264e6;
  p.G0 = 5.703e9;
  p.G1 = 0.17;
  p.G2 = 0.03;
  p.p0_crush_curve = -1.2244e9;
  p.p1_crush_curve = 5.95e-10;
  p.p3_crush_curve = 0.2231;
  return p;
}

/// Sets with every kind of surface, elasticity and cap.
inline std::vector<Arenisca::Parameters> sets_of_all_kinds() {
  std::vector<Arenisca::Parameters> sets(12, Sample<Arenisca>::parameters());
  sets[0] = berea();
  sets[1].PEAKI1 = sets[1].STREN = sets[1].YSLOPE = 0.0;   // no strength at zero pressure
  sets[2].PEAKI1 = sets[2].YSLOPE = 0.0;                   // zero vertex to von Mises
  sets[3].p3_crush_curve = 0.0;                            // no porosity
  sets[4].PEAKI1 = sets[4].FSLOPE = sets[4].YSLOPE = 0.0;  // von Mises with cap
  sets[5].BETA_nonassociativity = 0.5;
  sets[5].CR = 0.0;
  sets[6].STREN = sets[6].YSLOPE = 0.0;  // linear
  sets[7].B3 = 4e9;
  sets[7].B4 = 0.01;
  sets[8].dilatancy_limit = 0.05;
  sets[8].dilatancy_pressure = 60e6;
  sets[9] = berea();
  sets[9].strength_limit = 0.5e9;
  sets[10].STREN = sets[10].YSLOPE = 0.0;  // Lundborg's law
  sets[10].strength_limit = 0.3e9;
  sets[11].grain_stiffening = 5.0;
  sets[11].transition_strain = 0.15;  // within the pressures of these states
  sets[11].transition_start = 0.2e9;
  sets[11].transition_end = 2e9;
  return sets;
}

/// Random states and increments: on the surface, inside it and at its special places.
class RockSampler {
public:
  RockSampler(const Arenisca& model, unsigned seed) : rock_(model.rock()), random_(seed) {}

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  /// Any state, also at vertex and tip, with hardly any pores left, and increments of 10^least to
  /// 10^most.
  RockPoint anywhere(double least, double most) {
    const double evp = any_plastic_strain();
    const arenisca::Cap cap = rock_.cap_at(evp);
    const double top =
        std::isfinite(rock_.surface.vertex) ? rock_.surface.vertex : 0.1 * rock_.elasticity.B0;
    const double X = cap.present ? cap.X : -rock_.elasticity.B0;
    const double places[] = {top, X, X + (top - X) * std::pow(10.0, -12.0 * unit())};
    const auto place = random_() % 6;
    const double x = place < 3 ? places[place] : X + (top - X) * unit();
    const double shares[] = {0.0, unit(), 1.0, 1.0};
    const double share = shares[random_() % 4];
    const double volumes[] = {2.0 * unit() - 1.0, 0.0}, shears[] = {1.0, 0.0, 1e-9};
    const double volume = volumes[random_() % 2] + 1e-12;
    const Sym3 step = shears[random_() % 3] * direction() + isotropic(volume);
    const double size = std::pow(10.0, least + (most - least) * unit());
    return point(x, (share * shear_limit(x, evp)) * direction(), evp, (size / norm(step)) * step);
  }

  /// As in rock that a jet penetrates, in plane strain: two thirds dilated, up to twice its volume,
  /// the others crushed; most on the surface and sheared on in about the same direction; strain
  /// increments from 2e-5, half of them below 1e-4, few above 1e-2.
  RockPoint flowing() {
    const bool dilated = unit() < 0.64;
    const double evp = dilated ? std::pow(unit(), 3.0) : -rock_.crush.p3 * std::pow(unit(), 2.0);
    const double x = rock_.cap_at(evp).X * std::pow(unit(), 1.5);
    const double share = unit() < 0.9 ? 1.0 : unit();
    const double power = std::min(-4.7 - 0.65 * std::log(1.0 - unit()), -1.5);
    const Sym3 shear = direction(true);
    const Sym3 step = shear + isotropic(0.6 * (2.0 * unit() - 1.0));
    const Sym3 turned = shear + 0.3 * direction(true);
    const double stress = share * shear_limit(x, evp) / std::sqrt(second_invariant(turned));
    return point(x, stress * turned, evp, (std::pow(10.0, power) / norm(step)) * step);
  }

  /// Well inside the surface, with steps of a stress wave.
  RockPoint elastic() {
    const double evp = unit() < 0.8 ? 0.0 : -0.05 * unit();
    const double x = -3.0 * 68.95e6 * (0.5 + unit());
    const Sym3 stress = (0.5 * unit() * shear_limit(x, evp)) * direction(true);
    const Sym3 step = direction(true) + isotropic(2.0 * unit() - 1.0);
    return point(x, stress, evp, 1e-5 * step);
  }

private:
  Sym3 direction(bool plane = false) {
    std::normal_distribution<double> n;
    Sym3 s{n(random_), n(random_), n(random_), n(random_), n(random_), n(random_)};
    if (plane) s.yz = s.zx = 0.0;
    if (!plane && random_() % 4 == 0) s = {s.xx, s.yy, s.yy, 0.0, 0.0, 0.0};
    s = deviator(s);
    return (1.0 / std::sqrt(second_invariant(s))) * s;
  }
  double any_plastic_strain() {
    const double p3 = rock_.crush.p3;
    if (p3 == 0.0) return 0.0;
    switch (random_() % 8) {
      case 0:
        return 0.0;
      case 1:
        return -p3;
      case 2:
        return -p3 * (1.0 - std::pow(10.0, -9.0 * unit()));
      case 3:
        return 0.3 * std::pow(unit(), 3.0);
      default:
        return -p3 * unit();
    }
  }
  /// sqrt(J2) of the surface [stress]
  double shear_limit(double x, double evp) const {
    arenisca::NoCounter none;
    const auto m = rock_.surface.at(x, rock_.cap_at(evp), none);
    return std::max(m.limit, 0.0) * std::sqrt(std::max(m.cap_squared, 0.0));
  }
  static RockPoint point(double x, const Sym3& shear, double evp, const Sym3& strain) {
    RockPoint p;
    p.increment.strain = strain;
    p.increment.dt = 1e-8;
    p.increment.volume_ratio_end = std::exp(trace(strain));
    p.stress = isotropic(x / 3.0) + shear;
    p.history = {evp, 0.1};
    return p;
  }

  const arenisca::Rock& rock_;
  std::mt19937_64 random_;
};

/// Points in lanes, as the host has them.
/// @param of places in `points` of as many as there are lanes
template <class Model>
typename Model::template Points<Lanes> gather(
    const std::vector<PointOf<Model>>& points, const std::size_t* of
) {
  typename Model::template Points<Lanes> out{};
  for (int i = 0; i < lane_count; ++i) {
    const PointOf<Model>& p = points[of[i]];
    set_lane(p.increment, i, out.increment);
    set_lane(p.stress, i, out.stress);
    set_lane(p.history, i, out.history);
  }
  return out;
}

}  // namespace barreno::test
