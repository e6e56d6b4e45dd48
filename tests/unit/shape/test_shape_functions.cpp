// SPDX-License-Identifier: BSD-3-Clause
// What every shape function owes in every mode, at 1 to 4 particles per cell, everywhere in a cell,
// at the ends of the grid and at the axis.
#include "shape/patch_frame.hpp"
#include "unit/shape/face_balance.hpp"
#include "unit/shape/reference_means.hpp"
#include "unit/shape/shape_cases.hpp"
#include "unit/shape/shape_pairs.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace barreno {
namespace {

using testing::cell;
using testing::find_means;
using testing::Means;
using testing::Pair;
using testing::position;
using testing::shape_cases;
using testing::ShapeCase;

template <class P>
class ShapeFunctionContract : public ::testing::Test {};
TYPED_TEST_SUITE(ShapeFunctionContract, testing::AllPairs, testing::PairNames);

template <class P, class Test>
void for_each_case(Test&& test) {
  for (const double first : {0.0, 31.0})
    for (const ShapeCase& c : shape_cases<typename P::Mode, typename P::Shape>(first)) test(c);
}

/// Nodes further out would lie in no patch or in another row of it; those with a weight of zero
/// are read and written too. Rows are far apart here, so that none of them is taken for another.
template <class M, class S>
void expect_nodes_within_reach(const Scene& scene, bool faces) {
  const int reach = S::reach(scene);
  const Patch own = make_patch(M::dimensions, reach);
  Patch wide = own;
  wide.nodes = 1000;
  bool inside = true;
  const auto look = [&](int slot, double, const auto&, double) {
    for (int d = 0; d < M::dimensions; ++d, slot /= wide.nodes)
      inside = inside && slot >= 0 && slot % wide.nodes < own.nodes;
  };
  for_each_case<Pair<M, S>>([&](const ShapeCase& c) {
    ParticleGeometry particle = testing::place_in_patch<M>(c, reach);
    particle.row = wide.nodes;
    S::template support<M>(particle).for_each_node(wide, look);
    for (int face = 0; faces && face < 2 * M::dimensions; ++face)
      S::template face_support<M>(particle, face).for_each_node(wide, look);
  });
  EXPECT_TRUE(inside) << "'" << S::word << "' touches nodes further than " << reach
                      << " from the cells of its tile, which is its reach() in a scene "
                      << (faces ? "with loads" : "without loads");
}
TYPED_TEST(ShapeFunctionContract, NodesLieWithinTheReach) {
  using M = typename TypeParam::Mode;
  using S = typename TypeParam::Shape;
  Scene scene;
  scene.grid.mode = M::dimensions == 3 ? Mode::three_dimensional : Mode::plane_strain;
  expect_nodes_within_reach<M, S>(scene, false);
  scene.loads.emplace_back();
  expect_nodes_within_reach<M, S>(scene, true);
  EXPECT_LE(S::reach(scene), testing::reach) << "the patches of these tests are too small for '"
                                             << S::word << "': raise `reach` in shape_cases.hpp";
}

TYPED_TEST(ShapeFunctionContract, SumsToOneAndGradientsToZero) {
  using M = typename TypeParam::Mode;
  for_each_case<TypeParam>([](const ShapeCase& c) {
    const Means one =
        find_means<M, typename TypeParam::Shape>(c.particle, [](const auto&) { return 1.0; });
    EXPECT_NEAR(one.value, 1.0, 1e-13);
    for (const double g : one.gradient) EXPECT_NEAR(g * cell, 0.0, 1e-12);
  });
}

/// v = A x is found exactly, entry by entry. In axisymmetry v_r = a r is the uniform strain a, a
/// (hoop), and v_r = a z no motion that the axis allows.
TYPED_TEST(ShapeFunctionContract, UniformStrainIsExact) {
  using M = typename TypeParam::Mode;
  constexpr double a = 0.7;
  for_each_case<TypeParam>([](const ShapeCase& c) {
    for (int k = 0; k < M::dimensions; ++k) {
      const Means linear = find_means<M, typename TypeParam::Shape>(c.particle, [k](const auto& x) {
        return a * x[k];
      });
      for (int d = 0; d < M::dimensions; ++d)
        EXPECT_NEAR(linear.gradient[d], d == k ? a : 0.0, 1e-10);
      if (M::hoop) {
        EXPECT_NEAR(linear.hoop, k == 0 ? a : linear.hoop, 1e-12);
      } else {
        EXPECT_NEAR(linear.value, a * position(c.particle, k, c.particle.x[k]), 1e-12);
      }
    }
  });
}

/// The product of two coordinates sees a gradient without its radial weighting, which linear fields
/// cannot. Expected are the means over the particle, found by Gauss points in its domain, or the
/// values at x_p for shape functions without one.
TYPED_TEST(ShapeFunctionContract, MeansOfABilinearField) {
  using M = typename TypeParam::Mode;
  using S = typename TypeParam::Shape;
  const auto product = [](const auto& x) { return x[0] * x[1]; };
  for_each_case<TypeParam>([&](const ShapeCase& c) {
    const Means found = find_means<M, S>(c.particle, product);
    const Means expected = testing::reference_means<M, S>(c);
    const double r = position(c.particle, 0, c.particle.x[0]) + cell;
    const double z = position(c.particle, 1, c.particle.x[1]) + cell;
    EXPECT_NEAR(found.value, expected.value, 1e-12 * r * z);
    EXPECT_NEAR(found.gradient[0], expected.gradient[0], 1e-10 * z);
    EXPECT_NEAR(found.gradient[1], expected.gradient[1], 1e-10 * r);
    EXPECT_NEAR(M::hoop ? found.hoop : 0.0, expected.hoop, 1e-11 * z);
  });
}

/// The weights are those of nodes inside the patch, and none is negative.
TYPED_TEST(ShapeFunctionContract, WeightsAreNotNegative) {
  using M = typename TypeParam::Mode;
  const Patch patch = make_patch(M::dimensions, testing::reach);
  for_each_case<TypeParam>([&](const ShapeCase& c) {
    TypeParam::Shape::template support<M>(c.particle)
        .for_each_node(patch, [&](int slot, double s, const auto&, double) {
          EXPECT_GE(slot, 0);
          EXPECT_LT(slot, patch.size);
          EXPECT_GE(s, -1e-15);
        });
  });
}

/// Fast sums over the nodes agree with the weights one by one.
TYPED_TEST(ShapeFunctionContract, SumsAgreeWithTheWeights) {
  using M = typename TypeParam::Mode;
  constexpr int D = M::dimensions;
  const Patch patch = make_patch(D, testing::reach);
  std::vector<double> nodes(static_cast<std::size_t>(patch.size));
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = std::sin(1.0 + 7.3 * double(i));
  const double given = 1.3, at_gradient[3] = {-0.4, 0.9, 0.3}, at_hoop = M::hoop ? 0.6 : 0.0;
  for_each_case<TypeParam>([&](const ShapeCase& c) {
    const auto support = TypeParam::Shape::template support<M>(c.particle);
    const auto found = support.template interpolate<M::hoop>(nodes.data(), patch);
    std::vector<double> gave(nodes.size(), 0.0), expected(nodes.size(), 0.0);
    double gradient[extent<D>] = {};
    for (int d = 0; d < D; ++d) gradient[d] = at_gradient[d];
    support.template add_to<M::hoop>(gave.data(), patch, given, gradient, at_hoop);
    Means means;
    support.for_each_node(patch, [&](int slot, double s, const double(&g)[extent<D>], double t) {
      const auto i = static_cast<std::size_t>(slot);
      means.value += s * nodes[i];
      means.hoop += t * nodes[i];
      expected[i] += s * given + t * at_hoop;
      for (int d = 0; d < D; ++d) means.gradient[d] += g[d] * nodes[i];
      for (int d = 0; d < D; ++d) expected[i] += g[d] * gradient[d];
    });
    EXPECT_NEAR(found.value, means.value, 1e-14);
    for (int d = 0; d < D; ++d) EXPECT_NEAR(found.d[d] * cell, means.gradient[d] * cell, 1e-12);
    EXPECT_NEAR(M::hoop ? found.hoop * cell : 0.0, means.hoop * cell, 1e-11);
    const double scale = 1.0 + (M::hoop ? 1.0 / (c.particle.axis + c.particle.x[0]) : 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(gave[i], expected[i], 1e-12 * scale);
  });
}

/// V grad S = sum over the faces of n A S_face, node by node: the divergence theorem on one
/// particle, which makes a body under uniform pressure an exact equilibrium. A shape function says
/// where it holds (balanced_part: the particle's box lies in one such part of a cell), and what one
/// point leaves of the integrals elsewhere (unbalanced).
TYPED_TEST(ShapeFunctionContract, FacesBalanceAUniformStress) {
  using M = typename TypeParam::Mode;
  using S = typename TypeParam::Shape;
  const bool everywhere = !M::hoop || S::balanced_in_axisymmetry;
  int balanced = 0;
  int unbalanced = 0;
  double worst = 0.0;
  for_each_case<TypeParam>([&](const ShapeCase& c) {
    if (!testing::has_own_faces<M, S>(c)) return;
    const double error = testing::face_error<M, S>(c);
    if (everywhere && testing::in_balanced_part<M, S>(c)) {
      EXPECT_NEAR(error, 0.0, 1e-12);
      ++balanced;
    } else {
      const double size = 2.0 * c.particle.half[0];
      EXPECT_LT(error, S::unbalanced(size))
          << "of a face's force is left by a particle of " << size << " cells, more than '"
          << S::word << "' says (unbalanced)";
      worst = std::max(worst, error / S::unbalanced(size));
      ++unbalanced;
    }
  });
  // A bound, but no idle one: the axis is where most is left.
  if (M::hoop && unbalanced > 0) {
    EXPECT_GT(worst, 0.5) << "what '" << S::word << "' says is left (unbalanced) is " << 1.0 / worst
                          << " times the most that is";
  }
  EXPECT_EQ(balanced > 0, everywhere && S::balanced_part > 0.0)
      << "no particle of these tests lies within balanced_part of a cell, or one does that is not "
         "to be balanced";
}

/// A load drives a node with S_face^2 / S: bounded, or a node with next to no mass would be torn
/// off with the particle's strain.
TYPED_TEST(ShapeFunctionContract, FacesDriveNodesWithinReason) {
  using M = typename TypeParam::Mode;
  using S = typename TypeParam::Shape;
  const Patch patch = make_patch(M::dimensions, testing::reach);
  double worst = 0.0, least_sum = 1.0;
  for_each_case<TypeParam>([&](const ShapeCase& c) {
    if (!testing::has_own_faces<M, S>(c)) return;
    std::vector<double> mass(static_cast<std::size_t>(patch.size), 0.0);
    S::template support<M>(c.particle)
        .for_each_node(patch, [&](int slot, double s, const auto&, double) {
          mass[static_cast<std::size_t>(slot)] += s;
        });
    for (int face = 0; face < 2 * M::dimensions; ++face) {
      std::vector<double> of_face(mass.size(), 0.0);
      S::template face_support<M>(c.particle, face)
          .for_each_node(patch, [&](int slot, double s, const auto&, double) {
            of_face[static_cast<std::size_t>(slot)] += s;
          });
      double sum = 0.0;
      for (std::size_t i = 0; i < mass.size(); ++i) {
        sum += of_face[i];
        if (of_face[i] > 0.0) worst = std::max(worst, of_face[i] * of_face[i] / mass[i]);
      }
      least_sum = std::min(least_sum, sum);
    }
  });
  EXPECT_LT(worst, 64.0) << "of the weight 1";
  EXPECT_NEAR(least_sum, 1.0, 1e-12);
}

/// Domains that leave the limit are counted, others are not.
TYPED_TEST(ShapeFunctionContract, CountsClippedDomains) {
  using M = typename TypeParam::Mode;
  using S = typename TypeParam::Shape;
  if constexpr (S::follows_deformation) {
    const double middle[3] = {3.3, 2.9, 1.6};
    ShapeCase c = testing::particle_at<M>(middle, 2, 5.0);
    EXPECT_FALSE(S::template clipped<M>(c.particle));
    testing::deform(c, 0.0, 2.0, 1.0, 0.0);
    EXPECT_FALSE(S::template clipped<M>(c.particle));
    testing::deform(c, 0.3, 4.1, 1.0, 0.0);
    EXPECT_TRUE(S::template clipped<M>(c.particle));
    c.particle.f[0][0] = std::nan("");
    EXPECT_TRUE(S::template clipped<M>(c.particle));
  } else {
    for_each_case<TypeParam>([](const ShapeCase& c) { EXPECT_EQ(c.particle.f[0][0], 1.0); });
  }
}

/// The diagonal of U from F = R U, R a turn about z, on which particles' boxes stand.
template <class M>
void expect_stretches() {
  constexpr unsigned D = M::dimensions;
  for (const double angle : {0.0, 0.4, -2.0}) {
    ShapeCase c;
    testing::deform(c, angle, 1.7, 0.8, 0.3);
    const FieldView rotation("rotation", 1, 4);
    rotation(0, 0) = std::cos(0.5 * angle);
    rotation(0, 3) = std::sin(0.5 * angle);
    c.particle.stretch[0] = c.particle.stretch[1] = c.particle.stretch[2] = 0.0;
    PatchFrame<D>::find_stretches(rotation, 0, c.particle);
    for (unsigned d = 0; d < D; ++d) EXPECT_NEAR(c.particle.stretch[d], c.stretch[d], 1e-14);
  }
}
/// A box that just reaches into a cell gives its far node a force of the reach and a mass of the
/// reach's square: were the mass lost in round-off, the node would fly away.
TEST(AverageHats, WhatTouchesACellHasItsMass) {
  for (const double reach : {1e-15, 3e-14, 1e-12, 1e-9, 1e-6}) {
    const double low = 3.0 - reach, high = 4.0 + reach;
    const double below = 3.0 - low, above = high - 4.0;  // as they are stored
    const AxisWeights<4> plane = average_hats<false, 4>(low, high, 2, 0.0, 1.0);
    const double size = high - low;
    EXPECT_NEAR(plane.s[0] * size / (0.5 * below * below), 1.0, 1e-6) << reach;
    EXPECT_NEAR(plane.s[3] * size / (0.5 * above * above), 1.0, 1e-6) << reach;
    EXPECT_NEAR(plane.g[0] * size / below, -1.0, 1e-6) << reach;
    const AxisWeights<4> radial = average_hats<true, 4>(low, high, 2, 0.0, 1.0);
    const double area = 0.5 * (high * high - low * low);
    EXPECT_NEAR(radial.s[0] * area / (0.5 * below * below * 3.0), 1.0, 1e-5) << reach;
    EXPECT_NEAR(radial.s[3] * area / (0.5 * above * above * 4.0), 1.0, 1e-5) << reach;
  }
}

TEST(Stretches, AreTheDiagonalOfU) {
  expect_stretches<PlaneStrain>();
  expect_stretches<ThreeDimensional>();
}

/// Decks of every number of particles per cell find a positive number. What it should be is held by
/// test_critical_courant.cpp.
TYPED_TEST(ShapeFunctionContract, CriticalCourantNumbersArePositiveAndContinuous) {
  double last = TypeParam::Shape::critical_courant(1e-3);
  EXPECT_GT(last, 0.0);
  for (double half = 1e-3; half < 0.5; half *= 1.01) {
    const double limit = TypeParam::Shape::critical_courant(half);
    EXPECT_GT(limit, 0.0);
    EXPECT_NEAR(limit, last, 0.05);  // no jump
    last = limit;
  }
}

}  // namespace
}  // namespace barreno
