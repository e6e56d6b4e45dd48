// SPDX-License-Identifier: BSD-3-Clause
// Tensor algebra of three dimensions. Expected numbers: Taylor series and Newton iteration of the
// polar decomposition with 40 digits (mpmath), of the matrices written here.
#include "shape/kinematics.hpp"
#include "shape/kinematics_3d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace barreno {
namespace {

double difference(const SpaceTensor& a, const SpaceTensor& b) {
  return largest_entry(
      {a.xx - b.xx,
       a.xy - b.xy,
       a.xz - b.xz,
       a.yx - b.yx,
       a.yy - b.yy,
       a.yz - b.yz,
       a.zx - b.zx,
       a.zy - b.zy,
       a.zz - b.zz}
  );
}

SpaceTensor random_tensor(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> in(-size, size);
  SpaceTensor a;
  for (double* x : {&a.xx, &a.xy, &a.xz, &a.yx, &a.yy, &a.yz, &a.zx, &a.zy, &a.zz}) *x = in(engine);
  return a;
}
SpaceRotation random_rotation(std::mt19937& engine) {
  std::normal_distribution<double> n;
  return unit({n(engine), n(engine), n(engine), n(engine)});
}

TEST(Exponential3d, OfASmallAndOfALargeTensor) {
  const SpaceTensor small{0.03, -0.07, 0.05, 0.09, -0.04, 0.02, -0.06, 0.08, 0.1};
  const SpaceTensor exact_small{
      1.0257798949693957,
      -0.067515684508473034,
      0.052581871928846911,
      0.08883689647827793,
      0.9585732781733507,
      0.022918061817349594,
      -0.060254823360278639,
      0.084563689883554255,
      1.1044735284106817};
  EXPECT_LT(difference(short_exponential(small), exact_small), 3e-16);
  const SpaceTensor large{0.9, -1.7, 0.4, 1.3, 0.2, -0.8, -0.5, 0.6, -1.1};
  const SpaceTensor exact_large{
      0.53534149634658967,
      -1.7292453233878993,
      0.77268453152036531,
      1.5604722419066435,
      -0.33127898412044138,
      0.0052143897623882314,
      0.046104062692105131,
      0.50206907122448974,
      0.15257064201071144};
  EXPECT_LT(difference(exponential(large), exact_large), 1e-14);
}

TEST(Exponential3d, KeepsTheVolumeOverManySteps) {
  std::mt19937 engine(7);
  double log_volume = 0.0, trace_sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const SpaceTensor a = random_tensor(engine, 0.1);
    log_volume += std::log(determinant(short_exponential(a)));
    trace_sum += a.xx + a.yy + a.zz;
  }
  EXPECT_NEAR(log_volume, trace_sum, 2e-12);
}

TEST(Exponential3d, ShorterSeriesHaveTheSameBits) {
  std::mt19937 engine(8);
  for (int i = 0; i < 100000; ++i) {
    const SpaceTensor a = random_tensor(engine, 1.02 * shorter_series);
    EXPECT_EQ(difference(short_exponential<7>(a), short_exponential(a)), 0.0);
  }
  volatile double largest = 1.02 * shorter_series;  // computed like the others, at run time
  const double most = largest;
  const SpaceTensor all{most, most, -most, most, -most, most, most, -most, -most};
  EXPECT_EQ(difference(short_exponential<7>(all), short_exponential(all)), 0.0);
}

TEST(Exponential3d, OfATensorThatIsNotFiniteIsNotFinite) {
  const SpaceTensor a{HUGE_VAL, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_FALSE(std::isfinite(determinant(exponential(a))));
}

TEST(PolarRotation3d, OfAModerateAndOfADrawnOutTensor) {
  const SpaceTensor f{1.2, 0.3, -0.4, -0.5, 0.9, 0.7, 0.2, -0.6, 1.5};
  const SpaceTensor r{
      0.93456375025817506,
      0.33940032506636464,
      -0.10676149141062728,
      -0.25596742365006564,
      0.84978008640597924,
      0.46081936024628373,
      0.24712603006021694,
      -0.403337605601923,
      0.88104909123952013};
  EXPECT_LT(difference(matrix(polar_rotation(f)), r), 1e-15);
  // Stretches 40, 0.2 and 0.1: the rotation is known to the condition of the matrix.
  const SpaceTensor needle{
      18.037341642365202,
      8.5059969281147048,
      -0.78042553096043465,
      23.621349294568034,
      10.864139832535878,
      -1.2322378485795642,
      20.710499211365978,
      9.6991175628369319,
      -1.1088339515224155};
  const SpaceTensor turned{
      0.32296570693069304,
      0.5713139504204755,
      0.75451542210991829,
      0.90732894564289079,
      -0.41364760392871308,
      -0.075165445269715414,
      0.26916042901087406,
      0.7088695435825868,
      -0.65196367508910902};
  EXPECT_LT(difference(matrix(polar_rotation(needle)), turned), 1e-13);
}

/// F = R U with known R: any rotation, stretches from 1/30 to 30.
TEST(PolarRotation3d, FindsRandomRotationsFromAnywhereAndFromNearby) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> exponent(-std::log(30.0), std::log(30.0));
  for (int i = 0; i < 20000; ++i) {
    const SpaceTensor axes = matrix(random_rotation(engine));
    const SpaceTensor stretch{
        std::exp(exponent(engine)),
        0,
        0,
        0,
        std::exp(exponent(engine)),
        0,
        0,
        0,
        std::exp(exponent(engine))};
    const SpaceRotation r = random_rotation(engine);
    const SpaceTensor f = multiply(matrix(r), multiply(axes, multiply(stretch, transpose(axes))));
    ASSERT_LT(difference(matrix(polar_rotation(f)), matrix(r)), 1e-12);
    // From a tenth of a radian away: exact, or it says that it is not.
    const SpaceRotation near = corrected(r, {0.06, -0.05, 0.06});
    double left = 0.0;
    const SpaceRotation found = near_polar_rotation(f, near, left);
    ASSERT_LT(difference(matrix(polar_rotation(f, near)), matrix(r)), 1e-12);
    if (left <= rotation_tolerance) {
      ASSERT_LT(difference(matrix(found), matrix(r)), 1e-12);
    }
  }
}

TEST(PolarRotation3d, TwoStepsAreEnoughForMostParticles) {
  std::mt19937 engine(5);
  int exact = 0;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) {
    // Strains up to 1 and a turn of 0.014 in one step.
    const SpaceRotation r = random_rotation(engine);
    const SpaceTensor f = multiply(
        short_exponential(random_tensor(engine, 0.1)),
        multiply(matrix(r), exponential(random_tensor(engine, 0.5)))
    );
    const SpaceRotation near = corrected(polar_rotation(f), {0.008, -0.008, 0.008});
    double left = 0.0;
    near_polar_rotation(f, near, left);
    exact += left <= rotation_tolerance ? 1 : 0;
  }
  EXPECT_GT(exact, 0.99 * count);
}

TEST(PolarRotation3d, OneStepFromTheSpinIsEnoughForStiffSolids) {
  std::mt19937 engine(7);
  for (int i = 0; i < 10000; ++i) {
    // Strains up to 0.01; steps strain by up to 1e-4 and turn by up to 0.01.
    const SpaceRotation r = random_rotation(engine);
    const SpaceTensor f_n = multiply(matrix(r), exponential(random_tensor(engine, 0.01)));
    const SpaceTensor spin = random_tensor(engine, 0.005);
    const SpaceTensor a =
        plus(random_tensor(engine, 1e-4), plus(spin, scaled(-1.0, transpose(spin))));
    const SpaceTensor f = multiply(exponential(a), f_n);
    double left = 0.0;
    const SpaceRotation found =
        nearer_polar_rotation(f, rotated_by_spin(polar_rotation(f_n), a), left);
    ASSERT_LE(left, rotation_tolerance);
    ASSERT_LT(difference(matrix(found), matrix(polar_rotation(f))), 1e-14);
  }
}

TEST(Rotate3d, TurnsATensorIntoTheSpaceFrameAndBack) {
  const SpaceTensor f{1.2, 0.3, -0.4, -0.5, 0.9, 0.7, 0.2, -0.6, 1.5};
  const SpaceRotation r = polar_rotation(f);
  const Sym3 t{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};  // xx yy zz xy yz zx
  const Sym3 s = rotate(r, t);
  EXPECT_NEAR(s.xx, 2.1158646513706914, 2e-15);
  EXPECT_NEAR(s.yy, 2.9072012304685901, 4e-15);
  EXPECT_NEAR(s.zz, 0.97693411816071851, 4e-15);
  EXPECT_NEAR(s.xy, 6.0955605206038523, 4e-15);
  EXPECT_NEAR(s.yz, 3.8665614955772041, 4e-15);
  EXPECT_NEAR(s.zx, 4.9952270114863833, 4e-15);
  const Sym3 back = unrotate(r, s);
  for (int c = 0; c < 6; ++c) EXPECT_NEAR((&back.xx)[c], (&t.xx)[c], 1e-14);
}

TEST(Rotate3d, TheMeanIsHalfTheTurn) {
  const SpaceRotation a = unit({0.3, -0.2, 0.7, 0.1});
  const double half = 0.4;  // of the turn from a to b, in the frame of a
  const SpaceRotation turn{std::cos(half), 0.6 * std::sin(half), 0.0, 0.8 * std::sin(half)};
  const SpaceRotation quarter{
      std::cos(half / 2), 0.6 * std::sin(half / 2), 0.0, 0.8 * std::sin(half / 2)};
  SpaceRotation b = multiply(a, turn);
  b = {-b.w, -b.x, -b.y, -b.z};  // the same rotation
  EXPECT_LT(difference(matrix(mean_rotation(a, b)), matrix(multiply(a, quarter))), 1e-15);
}

TEST(Cofactors3d, TakeAreasOfParallelograms) {
  const SpaceTensor f{1.2, 0.3, -0.4, -0.5, 0.9, 0.7, 0.2, -0.6, 1.5};
  // The face x of a unit cube becomes the cross product of the images of y and z.
  const SpaceTensor c = cofactors(f);
  EXPECT_NEAR(c.xx, f.yy * f.zz - f.zy * f.yz, 1e-15);
  EXPECT_NEAR(c.yx, f.zy * f.xz - f.xy * f.zz, 1e-15);
  EXPECT_NEAR(c.zx, f.xy * f.yz - f.yy * f.xz, 1e-15);
  // F^T cof F = det F I.
  const SpaceTensor unit = scaled(1.0 / determinant(f), multiply(transpose(f), c));
  EXPECT_LT(difference(unit, SpaceTensor{}), 1e-15);
  EXPECT_NEAR(determinant(f), 2.343, 1e-15);
}

TEST(LargestStretch3d, IsTheLargestSingularValue) {
  EXPECT_NEAR(
      largest_stretch(SpaceTensor{1.2, 0.3, -0.4, -0.5, 0.9, 0.7, 0.2, -0.6, 1.5}),
      1.7748373041846282,
      1e-14
  );
  EXPECT_NEAR(largest_stretch(SpaceTensor{3, 0, 0, 0, 3, 0, 0, 0, 3}), 3.0, 1e-15);
}

}  // namespace
}  // namespace barreno
