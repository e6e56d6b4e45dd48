// SPDX-License-Identifier: BSD-3-Clause
// Parallelogram and parallelepiped domains: measure, dual vectors, scaling, the axis.
#include "shape/domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace barreno {
namespace {

/// Right-handed random domains, from nearly cubes to needles a hundred times as long as thick.
template <int D>
Domain<D> random_domain(std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  std::uniform_real_distribution<double> power(-1.0, 1.0);
  for (;;) {
    Domain<D> out;
    for (auto& edge : out.e) {
      const double size = std::pow(10.0, power(random));
      for (double& component : edge) component = size * entry(random);
    }
    if (measure(out) > 1e-6) return out;
  }
}

template <int D>
double longest_corner(const Domain<D>& domain) {
  double longest = 0.0;
  const CornerVectors<D> corners = corner_vectors(domain);
  for (const auto& l : corners.l) longest = std::max(longest, std::sqrt(length_squared(l)));
  return longest;
}

template <int D>
double narrowest(const Domain<D>& domain) {
  const Domain<D> slope = dual(domain);
  double least = half_width(slope, 0);
  for (int i = 1; i < D; ++i) least = std::min(least, half_width(slope, i));
  return least;
}

template <class Dimension>
class DomainContract : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(DomainContract, Dimensions);

/// Edges of a box are as far from the centre as they are long.
TYPED_TEST(DomainContract, WidthsOfABoxAreItsHalfEdges) {
  constexpr int D = TypeParam::value;
  Domain<D> box;
  for (int i = 0; i < D; ++i) box.e[i][i] = 0.1 * (i + 1);
  for (int i = 0; i < D; ++i) EXPECT_NEAR(half_width(dual(box), i), 0.1 * (i + 1), 1e-16);
}

TYPED_TEST(DomainContract, NeedlesAreWidenedAndOthersKeepTheirBits) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(23);
  int widened = 0;
  for (int n = 0; n < 10000; ++n) {
    const Domain<D> before = random_domain<D>(random);
    const Domain<D> after = widen_domain(before, 0.0625);
    EXPECT_GT(measure(after), 0.0);
    if (narrowest(before) >= 0.0625) {
      for (int i = 0; i < D; ++i)
        for (int d = 0; d < D; ++d) ASSERT_EQ(after.e[i][d], before.e[i][d]);
      continue;
    }
    ++widened;
    // A face that moves out leaves the others where they are, but for their edges.
    EXPECT_GE(narrowest(after), (D == 2 ? 0.5 : 0.25) * 0.0625);
    EXPECT_GE(measure(after), measure(before));
    EXPECT_LE(longest_corner(after), longest_corner(before) + D * 0.0625);
  }
  EXPECT_GT(widened, 100);
}

TYPED_TEST(DomainContract, DualVectorsAreThoseOfTheInverse) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(7);
  for (int n = 0; n < 1000; ++n) {
    const Domain<D> domain = random_domain<D>(random);
    const Domain<D> gradient = dual(domain);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        double product = 0.0;
        double size = 0.0;
        for (int k = 0; k < D; ++k) {
          product += gradient.e[i][k] * domain.e[j][k];
          size += std::abs(gradient.e[i][k] * domain.e[j][k]);
        }
        EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-13 * std::max(1.0, size));
      }
  }
}

TYPED_TEST(DomainContract, CornersGiveTheEdgesBack) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(11);
  for (int n = 0; n < 1000; ++n) {
    const Domain<D> domain = random_domain<D>(random);
    const Domain<D> again = rebuild_domain(corner_vectors(domain));
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
        EXPECT_NEAR(again.e[i][k], domain.e[i][k], 1e-14 * longest_corner(domain));
  }
}

TYPED_TEST(DomainContract, DomainsWithinTheLimitKeepTheirBits) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(13);
  for (int n = 0; n < 1000; ++n) {
    const Domain<D> domain = random_domain<D>(random);
    const double limit = 1.0001 * longest_corner(domain);
    EXPECT_FALSE(exceeds(domain, limit));
    const Domain<D> same = scale_domain(domain, limit);
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) EXPECT_EQ(same.e[i][k], domain.e[i][k]);
  }
}

/// 2D: no corner beyond l_crit, and those within it stay where they were. 3D: none beyond 1.5
/// l_crit, which the reach of a patch counts on. The scaled domain stays right-handed.
TYPED_TEST(DomainContract, ScaledDomainsStayWithinTheirReach) {
  constexpr int D = TypeParam::value;
  std::mt19937 random(17);
  double furthest = 0.0;
  int scaled_domains = 0;
  int left_handed = 0;
  for (int n = 0; n < 100000; ++n) {
    const Domain<D> domain = random_domain<D>(random);
    const Domain<D> scaled = scale_domain(domain, 1.0);
    scaled_domains += exceeds(domain, 1.0) ? 1 : 0;
    furthest = std::max(furthest, longest_corner(scaled));
    left_handed += measure(scaled) > 0.0 ? 0 : 1;
    if (D == 3) continue;
    const CornerVectors<D> before = corner_vectors(domain);
    const CornerVectors<D> after = corner_vectors(scaled);
    for (int i = 0; i < CornerVectors<D>::n; ++i) {
      const double ratio = std::min(1.0, 1.0 / std::sqrt(length_squared(before.l[i])));
      for (int k = 0; k < D; ++k) EXPECT_NEAR(after.l[i][k], ratio * before.l[i][k], 1e-14);
    }
  }
  EXPECT_GT(scaled_domains, 30000);
  EXPECT_LE(furthest, D == 2 ? 1.0 + 1e-14 : 1.5);
  EXPECT_EQ(left_handed, 0);
}

TEST(Domain, IsNarrowedAtTheAxisOnly) {
  const Domain<2> domain{{{0.3, 0.1}, {-0.2, 0.4}}};
  const Domain<2> away = narrow_at_axis(domain, 0.5);
  const Domain<2> cut = narrow_at_axis(domain, 0.25);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(away.e[i][0], domain.e[i][0]);
    EXPECT_NEAR(cut.e[i][0], 0.5 * domain.e[i][0], 1e-15);
    EXPECT_EQ(cut.e[i][1], domain.e[i][1]);
  }
}

TEST(Domain, WithoutNumbersCountsAsTooLarge) {
  const double none = std::nan("");
  EXPECT_TRUE(exceeds(Domain<2>{{{none, 0.0}, {0.0, 0.1}}}, 1.0));
}

}  // namespace
}  // namespace barreno
