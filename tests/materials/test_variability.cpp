// SPDX-License-Identifier: BSD-3-Clause
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno::test {
namespace {

constexpr double reference = 1e-6;  // volume [m3]

Arenisca::Parameters varied(double modulus) {
  auto p = Sample<Arenisca>::parameters();
  p.weibull_modulus = modulus;
  p.weibull_reference_volume = reference;
  p.weibull_seed = 7;
  return p;
}

/// PEAKI1 over its mean of pieces whose cube has this volume.
std::vector<double> factors(const ScatteredArenisca& model, double volume, int count) {
  std::vector<double> all;
  for (int id = 1; id <= count; ++id) {
    ScatteredArenisca::History h = model.initial_history();
    model.vary(h, {static_cast<std::uint64_t>(id), 1.0, std::pow(volume, 2.0 / 3.0)});
    all.push_back(h.coherence);
  }
  return all;
}

/// Mean and spread of Weibull's distribution, and its whole shape (Kolmogorov and Smirnov).
TEST(Variability, StrengthsHaveTheDistributionOfWeibull) {
  constexpr int count = 40000;
  for (const double m : {2.0, 6.0, 20.0}) {
    auto p = varied(m);
    p.YSLOPE = 0.0;  // no bound
    const ScatteredArenisca model(p, 2300.0);
    std::vector<double> sample = factors(model, reference, count);
    const double gamma = std::tgamma(1.0 + 1.0 / m);
    const double spread = std::sqrt(std::tgamma(1.0 + 2.0 / m) / (gamma * gamma) - 1.0);
    double mean = 0.0, square = 0.0;
    for (const double f : sample) mean += f / count;
    for (const double f : sample) square += (f - mean) * (f - mean) / count;
    EXPECT_NEAR(mean, 1.0, 4.0 * spread / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(square) / spread, 1.0, 0.03);
    std::sort(sample.begin(), sample.end());
    double apart = 0.0;
    for (int i = 0; i < count; ++i) {
      const double exact = -std::expm1(-std::pow(gamma * sample[static_cast<std::size_t>(i)], m));
      apart = std::max(apart, std::fabs(exact - (i + 0.5) / count));
    }
    constexpr double one_in_ten_thousand = 2.23;  // of sqrt(count) times the distance
    EXPECT_LE(apart * std::sqrt(count), one_in_ten_thousand);
  }
}

/// (V/Vref)^(-1/m), of every piece.
TEST(Variability, SmallPiecesAreStronger) {
  const double m = 6.0;
  auto p = varied(m);
  p.YSLOPE = 0.0;
  const ScatteredArenisca model(p, 2300.0);
  const auto at_reference = factors(model, reference, 100), at_small = factors(model, 1e-9, 100);
  for (std::size_t i = 0; i < at_small.size(); ++i) {
    EXPECT_NEAR(at_small[i] / at_reference[i], std::pow(1e-3, -1.0 / m), 1e-12);
  }
  p.weibull_scatter = Arenisca::scale_only;
  for (const double f : factors(ScatteredArenisca(p, 2300.0), 1e-9, 10)) {
    EXPECT_NEAR(f, std::pow(1e-3, -1.0 / m), 1e-12);
  }
  // A ring's own volume instead of the cube over its face.
  p.weibull_volume = Arenisca::ring_volume;
  const ScatteredArenisca ring(p, 2300.0);
  auto h = ring.initial_history();
  ring.vary(h, {1, 64.0 * reference, 1.0});
  EXPECT_NEAR(h.coherence, 0.5, 1e-12);
}

/// Ids that follow each other, and seeds, have nothing to do with each other.
TEST(Variability, NeighboursAreIndependent) {
  constexpr int count = 40000;
  auto p = varied(6.0);
  const ScatteredArenisca model(p, 2300.0);
  p.weibull_seed = 8;
  const ScatteredArenisca other(p, 2300.0);
  const auto u = [&](const ScatteredArenisca& of, int id) {
    return of.weibull().uniform(static_cast<std::uint64_t>(id)) - 0.5;
  };
  double neighbours = 0.0, seeds = 0.0;
  for (int id = 1; id <= count; ++id) {
    neighbours += 12.0 * u(model, id) * u(model, id + 1) / count;
    seeds += 12.0 * u(model, id) * u(other, id) / count;
  }
  EXPECT_LE(std::fabs(neighbours), 4.0 / std::sqrt(count));
  EXPECT_LE(std::fabs(seeds), 4.0 / std::sqrt(count));
}

/// The strongest of tiny pieces would open the surface backwards.
TEST(Variability, StrengthIsBounded) {
  const auto p = varied(2.0);
  const ScatteredArenisca model(p, 2300.0);
  double strongest = 0.0;
  for (const double f : factors(model, 1e-15, 100)) strongest = std::max(strongest, f);
  EXPECT_LT(p.YSLOPE * p.PEAKI1 * strongest, p.STREN);
  EXPECT_DOUBLE_EQ(strongest, model.weibull().bound);
}

/// Tension breaks the piece at its own strength.
TEST(Variability, TheVertexIsThatOfThePiece) {
  auto p = varied(6.0);
  const ScatteredArenisca model(p, 2300.0);
  Point<ScatteredArenisca> point(model);
  model.vary(point.history, {3, 1.0, 1e-4});
  const double factor = point.history.coherence;
  EXPECT_GT(std::fabs(factor - 1.0), 1e-3);
  for (int i = 0; i < 20; ++i) ASSERT_FALSE(point.apply(isotropic(1e-4), 1e-6).failed());
  EXPECT_NEAR(trace(point.stress) / (factor * p.PEAKI1), 1.0, 1e-12);
}

}  // namespace
}  // namespace barreno::test
