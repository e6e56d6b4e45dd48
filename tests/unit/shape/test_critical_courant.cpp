// SPDX-License-Identifier: BSD-3-Clause
// The critical Courant numbers that the shape functions state, against those of their own weights.
#include "shape/visit_kernels.hpp"

#include <Teuchos_LAPACK.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace barreno {
namespace {

/// Far more than any shape function needs, so that neither the bar nor its nodes meet an end.
constexpr int margin = 8;
constexpr int bar_cells = 8;
constexpr int offsets = 1000;

/// Largest eigenvalue of a symmetric matrix.
double largest_eigenvalue(std::vector<double> matrix, int n) {
  std::vector<double> values(static_cast<std::size_t>(n)), work(static_cast<std::size_t>(10 * n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV(
      'N', 'U', n, matrix.data(), n, values.data(), work.data(), 10 * n, &info
  );
  EXPECT_EQ(info, 0);
  return values.back();
}

/// c dt / h = 2 / omega of the highest frequency of K v = omega^2 M v, M_i = sum V S_i lumped and
/// K_ij = sum V S'_i S'_j, of a free bar of `count` particles that begins `offset` cells
/// after a node; h = c = 1.
template <class S>
double critical_courant(int per_cell, double offset, int count) {
  const Patch patch = make_patch(2, margin);
  const int n = patch.nodes;
  const auto at = [n](int i, int j) {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(n) + static_cast<std::size_t>(j);
  };
  std::vector<double> mass(static_cast<std::size_t>(n), 0.0), stiffness(at(n, 0), 0.0);
  for (int p = 0; p < count; ++p) {
    ParticleGeometry particle;
    particle.x[0] = margin + offset + (p + 0.5) / per_cell;
    particle.x[1] = margin + 0.37;
    particle.half[0] = particle.half[1] = 0.5 / per_cell;
    particle.high[0] = particle.high[1] = particle.last = n - 1;
    particle.row = n;
    // Summed along y, where the weights of a row are one function of x.
    std::vector<double> s(mass.size(), 0.0), g(mass.size(), 0.0);
    S::template support<PlaneStrain>(particle).for_each_node(
        patch,
        [&](int slot, double value, const double(&gradient)[2], double) {
          s[static_cast<std::size_t>(slot % n)] += value;
          g[static_cast<std::size_t>(slot % n)] += gradient[0];
        }
    );
    for (int i = 0; i < n; ++i) {
      mass[at(0, i)] += s[at(0, i)] / per_cell;
      for (int j = 0; j < n; ++j) stiffness[at(i, j)] += g[at(0, i)] * g[at(0, j)] / per_cell;
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double m = mass[at(0, i)] * mass[at(0, j)];
      stiffness[at(i, j)] = m > 1e-26 ? stiffness[at(i, j)] / std::sqrt(m) : 0.0;
    }
  return 2.0 / std::sqrt(largest_eigenvalue(stiffness, n));
}

/// The smallest over the places of the particles in their cells; the median for a shape function
/// that has none and says so in its warning.
template <class S>
double measure(int per_cell, int count) {
  std::vector<double> found;
  found.reserve(offsets);
  for (int k = 0; k < offsets; ++k)
    found.push_back(critical_courant<S>(per_cell, (k + 0.5) / offsets, count));
  std::sort(found.begin(), found.end());
  return S::warning == nullptr ? found.front() : found[offsets / 2];
}

TEST(CriticalCourant, IsThatOfTheWeights) {
  for_each_shape([](auto shape) {
    using S = decltype(shape);
    std::string row;
    double worst = 0.0;
    for (const int per_cell : {1, 2, 3, 4, 8, 16}) {
      const double found = measure<S>(per_cell, bar_cells * per_cell);
      worst = std::max(worst, std::abs(S::critical_courant(0.5 / per_cell) / found - 1.0));
      char number[16];
      std::snprintf(number, sizeof number, "%s%.3f", row.empty() ? "" : ", ", found);
      row += number;
    }
    EXPECT_LT(worst, 0.01) << "the weights of '" << S::word << "' give CourantTable{{" << row
                           << "}}: write that row into its critical_courant";
  });
}

/// Stress last decays to w = 2 where a particle is alone, instead of swinging to w = 4.
TEST(CriticalCourant, OfAParticleAloneIsThatOfItsWeights) {
  for_each_shape([](auto shape) {
    using S = decltype(shape);
    for (const int per_cell : {1, 2, 3, 4, 8}) {
      const double found = measure<S>(per_cell, 1) / std::sqrt(2.0);
      EXPECT_NEAR(S::isolated_courant(0.5 / per_cell) / found, 1.0, 0.01)
          << "a particle alone, " << per_cell << " per cell, of '" << S::word << "' has " << found;
    }
  });
}

}  // namespace
}  // namespace barreno
