// SPDX-License-Identifier: BSD-3-Clause
// What every shape function owes, at 1 to 4 particles per cell, everywhere in a cell and at the
// axis.
#include "shape/visit_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace barreno {
namespace {

constexpr double cell = 0.37;
constexpr double axis_in_patch =
    -1.0;  ///< the first node of a patch at the axis is one cell outside

using NodeField = std::function<double(double r, double z)>;

struct Averages {
  double value = 0.0, d_r = 0.0, d_z = 0.0, hoop = 0.0;
};

const Patch patch = make_patch(2, 1);

/// Interpolates a nodal field at a particle, with positions of the nodes in lengths.
template <class M, class S>
Averages average(const ParticlePlace& place, const NodeField& field) {
  Averages out;
  S::template support<M>(place).for_each_node(
      patch,
      [&](int slot, double s, const double(&g)[2], double t) {
        const double r = (place.axis + slot % patch.nodes) * cell;
        const int row = slot / patch.nodes;
        const double z = row * cell;
        const double v = field(r, z);
        out.value += s * v;
        out.d_r += g[0] * v;
        out.d_z += g[1] * v;
        out.hoop += t * v;
      }
  );
  return out;
}

/// Particles of all sizes and places of a patch that begins `first` cells from the axis.
std::vector<ParticlePlace> places(double first) {
  std::vector<ParticlePlace> out;
  for (const int per_cell : {1, 2, 3, 4})
    for (const double shift : {0.0, 0.13, 0.5, 0.77})
      for (int i = 0; i < 2 * per_cell; ++i) {
        const double half = 0.5 / per_cell;
        out.push_back(
            {{1.0 + half + i / static_cast<double>(per_cell) + shift, 3.0 + shift},
             {half, half},
             first,
             1.0 / cell,
             patch.nodes}
        );
      }
  // Cut by the axis, and barely off it.
  for (const double r : {0.01, 0.1, 0.24})
    out.push_back({{1.0 + r, 2.5}, {0.25, 0.25}, axis_in_patch, 1.0 / cell, patch.nodes});
  return out;
}

template <class S>
class ShapeFunctionContract : public ::testing::Test {};
using AllShapes = ::testing::Types<Gimp>;
TYPED_TEST_SUITE(ShapeFunctionContract, AllShapes);

TYPED_TEST(ShapeFunctionContract, SumsToOneAndGradientsToZero) {
  for (const ParticlePlace& place : places(axis_in_patch)) {
    const Averages axisymmetric =
        average<Axisymmetric, TypeParam>(place, [](double, double) { return 1.0; });
    EXPECT_NEAR(axisymmetric.value, 1.0, 1e-14);
    EXPECT_NEAR(axisymmetric.d_r * cell, 0.0, 1e-14);
    EXPECT_NEAR(axisymmetric.d_z * cell, 0.0, 1e-14);
    const Averages plane =
        average<PlaneStrain, TypeParam>(place, [](double, double) { return 1.0; });
    EXPECT_NEAR(plane.value, 1.0, 1e-14);
    EXPECT_NEAR(plane.d_r * cell, 0.0, 1e-14);
    EXPECT_NEAR(plane.d_z * cell, 0.0, 1e-14);
  }
}

TYPED_TEST(ShapeFunctionContract, UniformStrainIsExact) {
  constexpr double a = 0.7;
  constexpr double b = -0.4;
  for (const double first : {axis_in_patch, 31.0})
    for (const ParticlePlace& place : places(first)) {
      const Averages radial =
          average<Axisymmetric, TypeParam>(place, [=](double r, double) { return a * r; });
      EXPECT_NEAR(radial.d_r, a, 1e-12);
      EXPECT_NEAR(radial.hoop, a, 1e-12);
      EXPECT_NEAR(radial.d_z, 0.0, 1e-12);
      const Averages axial =
          average<Axisymmetric, TypeParam>(place, [=](double, double z) { return b * z; });
      EXPECT_NEAR(axial.d_z, b, 1e-12);
      EXPECT_NEAR(axial.d_r, 0.0, 1e-12);
      EXPECT_NEAR(axial.value, b * place.x[1] * cell, 1e-12);
    }
}

/// v_z = r z sees a gradient without its radial weighting, which linear fields cannot: the averages
/// are those of the r-weighted box, r_bar = int r^2 dr / int r dr.
TYPED_TEST(ShapeFunctionContract, BilinearFieldIsWeightedWithTheRadius) {
  for (const double first : {axis_in_patch, 31.0})
    for (const ParticlePlace& place : places(first)) {
      const double r_p = (place.axis + place.x[0]) * cell;
      const double r1 = r_p + place.half[0] * cell;
      const double r0 = std::max(0.0, r_p - place.half[0] * cell);
      const double r_bar = 2.0 / 3.0 * (r1 * r1 * r1 - r0 * r0 * r0) / (r1 * r1 - r0 * r0);
      const double z = place.x[1] * cell;
      const Averages found =
          average<Axisymmetric, TypeParam>(place, [](double r, double y) { return r * y; });
      EXPECT_NEAR(found.value, r_bar * z, 1e-12 * r_bar * z);
      EXPECT_NEAR(found.d_z, r_bar, 1e-12 * r_bar);
      EXPECT_NEAR(found.d_r, z, 1e-12 * z);
      EXPECT_NEAR(found.hoop, z, 1e-12 * z);
    }
}

/// V grad S_p = sum over the faces of n A S_face, node by node: the divergence theorem on one
/// particle, which makes a body under uniform pressure an exact equilibrium.
TYPED_TEST(ShapeFunctionContract, FacesBalanceAUniformStress) {
  const double two_pi = 2.0 * std::acos(-1.0);
  for (const ParticlePlace& place : places(axis_in_patch)) {
    const double lr = place.half[0] * cell;
    const double lz = place.half[1] * cell;
    const double r_p = (place.axis + place.x[0]) * cell;
    if (r_p < lr) continue;  // a cut particle has no inner face and no volume of its own kind
    const double volume = two_pi * r_p * 4.0 * lr * lz;
    const auto size = static_cast<std::size_t>(patch.size);
    std::vector<double> radial(size, 0.0), axial(size, 0.0);
    TypeParam::template support<Axisymmetric>(place).for_each_node(
        patch,
        [&](int slot, double, const double(&g)[2], double t) {
          radial[static_cast<std::size_t>(slot)] += volume * (g[0] + t);
          axial[static_cast<std::size_t>(slot)] += volume * g[1];
        }
    );
    for (int face = 0; face < 4; ++face) {
      const double side = face % 2 == 0 ? -1.0 : 1.0;
      const double area =
          face < 2 ? two_pi * (r_p + side * lr) * 2.0 * lz : two_pi * r_p * 2.0 * lr;
      TypeParam::template face_support<Axisymmetric>(place, face)
          .for_each_node(patch, [&](int slot, double s, const double*, double) {
            (face < 2 ? radial : axial)[static_cast<std::size_t>(slot)] -= side * area * s;
          });
    }
    for (std::size_t i = 0; i < radial.size(); ++i) {
      EXPECT_NEAR(radial[i], 0.0, 1e-13 * volume / cell);
      EXPECT_NEAR(axial[i], 0.0, 1e-13 * volume / cell);
    }
  }
}

const Patch space_patch = make_patch(3, 1);

std::vector<ParticlePlace> places_in_space() {
  std::vector<ParticlePlace> out;
  for (const int per_cell : {1, 2, 3, 4})
    for (const double shift : {0.0, 0.13, 0.5, 0.77}) {
      const double h = 0.5 / per_cell;
      out.push_back(
          {{1.0 + h + shift, 2.0 + h, 1.4 + shift},
           {h, h, 0.8 * h},
           0.0,
           1.0 / cell,
           space_patch.nodes}
      );
    }
  return out;
}

/// Averages over the box of 1, x, y, z and x y z, and their gradients, are exact.
TYPED_TEST(ShapeFunctionContract, FieldsInSpaceAreExact) {
  const int n = space_patch.nodes;
  for (const ParticlePlace& place : places_in_space()) {
    double one = 0.0, product = 0.0, slope[3][3] = {}, none[3] = {}, product_slope[3] = {};
    TypeParam::template support<ThreeDimensional>(place).for_each_node(
        space_patch,
        [&](int slot, double s, const double(&g)[3], double) {
          const int node[3] = {slot % n, slot / n % n, slot / (n * n)};
          const double x[3] = {node[0] * cell, node[1] * cell, node[2] * cell};
          one += s;
          product += s * x[0] * x[1] * x[2];
          for (int i = 0; i < 3; ++i) {
            none[i] += g[i];
            product_slope[i] += g[i] * x[0] * x[1] * x[2];
            for (int j = 0; j < 3; ++j) slope[i][j] += g[j] * x[i];
          }
        }
    );
    const double p[3] = {place.x[0] * cell, place.x[1] * cell, place.x[2] * cell};
    EXPECT_NEAR(one, 1.0, 1e-14);
    EXPECT_NEAR(product, p[0] * p[1] * p[2], 1e-13);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(none[i] * cell, 0.0, 1e-14);
      EXPECT_NEAR(product_slope[i], p[0] * p[1] * p[2] / p[i], 1e-12);
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(slope[i][j], i == j ? 1.0 : 0.0, 1e-13);
    }
  }
}

/// Sums in product form are those over the nodes one by one.
TYPED_TEST(ShapeFunctionContract, ProductFormIsTheSumOverTheNodes) {
  using Value = double;
  const auto size = static_cast<std::size_t>(space_patch.size);
  for (const ParticlePlace& place : places_in_space()) {
    const auto support = TypeParam::template support<ThreeDimensional>(place);
    const Value a = 0.7, b[3] = {-1.3, 0.4, 2.1};
    std::vector<Value> field(size), added(size, 0.0), expected(size, 0.0);
    for (std::size_t i = 0; i < size; ++i) field[i] = std::sin(1.7 * static_cast<double>(i));
    support.template add_to<false>(added.data(), space_patch, a, b, 0.0);
    Value value = 0.0, slope[3] = {};
    support.for_each_node(space_patch, [&](int slot, double s, const double(&g)[3], double) {
      const auto i = static_cast<std::size_t>(slot);
      expected[i] += s * a + g[0] * b[0] + g[1] * b[1] + g[2] * b[2];
      value += s * field[i];
      for (int d = 0; d < 3; ++d) slope[d] += g[d] * field[i];
    });
    const auto found = support.template interpolate<false>(field.data(), space_patch);
    EXPECT_NEAR(found.value, value, 1e-14);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(found.d[d], slope[d], 1e-13);
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(added[i], expected[i], 1e-14);
  }
}

TYPED_TEST(ShapeFunctionContract, FacesBalanceAUniformStressInSpace) {
  const auto size = static_cast<std::size_t>(space_patch.size);
  for (const ParticlePlace& place : places_in_space()) {
    double edge[3];
    for (int d = 0; d < 3; ++d) edge[d] = 2.0 * place.half[d] * cell;
    const double volume = edge[0] * edge[1] * edge[2];
    std::vector<double> sums[3];
    for (auto& sum : sums) sum.assign(size, 0.0);
    TypeParam::template support<ThreeDimensional>(place).for_each_node(
        space_patch,
        [&](int slot, double, const double(&g)[3], double) {
          for (int d = 0; d < 3; ++d) sums[d][static_cast<std::size_t>(slot)] += volume * g[d];
        }
    );
    for (int face = 0; face < 6; ++face) {
      const int d = face / 2;
      const double area = (face % 2 == 0 ? -1.0 : 1.0) * volume / edge[d];
      TypeParam::template face_support<ThreeDimensional>(place, face)
          .for_each_node(space_patch, [&](int slot, double s, const double*, double) {
            sums[d][static_cast<std::size_t>(slot)] -= area * s;
          });
    }
    for (const auto& sum : sums)
      for (const double x : sum) EXPECT_NEAR(x, 0.0, 1e-13 * volume / cell);
  }
}

TYPED_TEST(ShapeFunctionContract, CriticalCourantNumberFallsWithTheParticleSize) {
  double last = 0.0;
  for (const double half : {0.05, 0.125, 1.0 / 6.0, 0.25, 0.5}) {
    const double limit = TypeParam::critical_courant(half);
    EXPECT_GT(limit, last);
    last = limit;
  }
}

}  // namespace
}  // namespace barreno
