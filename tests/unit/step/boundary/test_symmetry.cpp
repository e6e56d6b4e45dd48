// SPDX-License-Identifier: BSD-3-Clause
// Half a body at a symmetry plane moves like the half of the whole body, in every mode: for shape
// functions other than splines the plane is a mirror, not a wall with an error of its own.
#include "deck/shape_words.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace barreno {
namespace {

constexpr double h = 1e-3;

/// A bar that opens and closes about the middle of its axis `d`, off the cells' edges elsewhere.
Scene bar(Mode mode, const std::string& shape, bool half) {
  const std::size_t d = mode == Mode::axisymmetric ? 1 : 0;
  Vector lower{0.0, 0.0, 0.0}, upper{0.012, 0.012, 0.012};
  Vector low{0.0031, 0.0031, 0.0031}, high{0.0078, 0.0083, 0.0062};
  if (mode == Mode::axisymmetric) low[0] = 0.0;
  upper[d] = 0.016;
  lower[d] = half ? 0.0 : -0.016;
  high[d] = 0.0065;
  low[d] = half ? 0.0 : -0.0065;
  Scene scene = testing::box_scene(mode, h, lower, upper, testing::elastic(1e9, 0.3, 1000.0));
  BodySpec& body = testing::add_box(scene, "bar", low, high, 2);
  body.velocity = Vector{};
  body.velocity[d] = 60.0;
  body.velocity_wave_number = Vector{};
  body.velocity_wave_number[d] = 250.0;
  if (mode == Mode::axisymmetric) testing::add_symmetry(scene, Face::x_lower);
  if (half) testing::add_symmetry(scene, static_cast<Face>(2 * d));
  scene.step.shape = shape;
  scene.step.largest_step = scene.step.initial_step = 1e-7;
  return scene;
}

using Numbers = std::vector<std::vector<double>>;

/// Rows of the particles beyond the plane, in the order of their places at the start.
Numbers rows_after(const Scene& scene, std::size_t d, double time) {
  State state = testing::start(scene);
  const Numbers first = testing::all_rows(state);
  testing::advance_to(scene, time, state);
  const Numbers last = testing::all_rows(state);
  EXPECT_EQ(first.size(), last.size());
  const auto place = [&](std::size_t i) {
    const std::vector<double>& row = first[i];
    const auto cell = [](double x) { return std::lround(x / (1e-3 * h)); };
    return std::tuple(cell(row[0]), cell(row[1]), row.size() > 9 ? cell(row[9]) : 0L);
  };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i][d] > 0.0) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return place(a) < place(b);
  });
  Numbers out;
  for (const std::size_t i : order) out.push_back(last[i]);
  return out;
}

/// Linear functions leave nodes at a free end with next to no mass, which makes round-off large.
constexpr double linear_bound = 1e-5;

class PlaneOfSymmetry : public ::testing::TestWithParam<Mode> {};

TEST_P(PlaneOfSymmetry, IsTheMiddleOfTheWholeBody) {
  const Mode mode = GetParam();
  const std::size_t d = mode == Mode::axisymmetric ? 1 : 0;
  // A quarter of the time in which a wave goes through: half a cell, 60 steps, free ends and all.
  const double end = 6e-6;
  // x y vx vy sxx syy szz sxy detF z vz syz szx
  const double size[13] = {h, h, 60.0, 60.0, 1e7, 1e7, 1e7, 1e7, 1.0, h, 60.0, 1e7, 1e7};
  for (const std::string& shape : shape_words()) {
    SCOPED_TRACE(shape);
    const Numbers half = rows_after(bar(mode, shape, true), d, end);
    const Numbers whole = rows_after(bar(mode, shape, false), d, end);
    ASSERT_EQ(half.size(), whole.size());
    ASSERT_GT(half.size(), 50U);
    double worst = 0.0, stress = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < half.size(); ++i) {
      for (std::size_t c = 0; c < half[i].size(); ++c)
        worst = std::max(worst, std::abs(half[i][c] - whole[i][c]) / size[c]);
      stress = std::max(stress, std::abs(half[i][4 + d]));
      moved = std::max(moved, std::abs(half[i][2 + d]));
    }
    EXPECT_GT(stress, 1e7);  // there is something to agree on
    EXPECT_GT(moved, 5.0);
    EXPECT_LT(worst, shape == "linear" ? linear_bound : 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, PlaneOfSymmetry, ::testing::ValuesIn(testing::all_modes));

}  // namespace
}  // namespace barreno
