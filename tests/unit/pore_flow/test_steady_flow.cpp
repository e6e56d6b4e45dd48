// SPDX-License-Identifier: BSD-3-Clause
// Steady flow through rings of rock against closed forms, on any number of ranks.
#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "pore_flow/steady_flow.hpp"

#include <Tpetra_Core.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

std::vector<double> even(double from, double to, std::size_t count) {
  std::vector<double> edges;
  for (std::size_t i = 0; i <= count; ++i)
    edges.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  return edges;
}

double middle(const std::vector<double>& edges, std::size_t i) {
  return 0.5 * (edges[i] + edges[i + 1]);
}

RingCells rings(double radius, std::size_t columns, double length, std::size_t rows) {
  RingCells cells{even(0.0, radius, columns), even(0.0, length, rows), {}, {}, 0.0, {}, {}, {}};
  cells.mobility.assign(columns * rows, 1.0);
  cells.hole.assign(columns * rows, 0);
  return cells;
}

double sum(const std::vector<double>& values) {
  double all = 0.0;
  for (const double value : values) all += value;
  return all;
}

SteadyFlow solved(const RingCells& cells) {
  EXPECT_EQ(problem_of(cells), "");
  SteadyFlow flow = solve_steady_flow(cells, Tpetra::getDefaultComm());
  EXPECT_TRUE(flow.report.converged) << flow.report.method << " " << flow.report.residual;
  return flow;
}

bool here() {
  return is_root(*Tpetra::getDefaultComm());
}

/// Hawkins: a hole in a ring of damaged rock, Q = 2 pi L dp / (ln(b/a) / k + ln(R/b)).
TEST(SteadyFlow, ThroughADamagedRingIsExact) {
  for (const std::size_t columns : {20U, 80U}) {
    RingCells cells = rings(0.08, columns, 0.1, columns);
    for (std::size_t c = 0; c < cells.hole.size(); ++c) {
      const double r = middle(cells.radii, c % columns);
      cells.hole[c] = r < 0.008 ? 1 : 0;
      if (r < 0.016) cells.mobility[c] = 0.2;
    }
    cells.outside.assign(cells.rows(), 3.0);
    cells.hole_pressure = 1.0;
    const SteadyFlow flow = solved(cells);
    if (!here()) continue;
    const double exact = 2.0 * pi * 0.1 * 2.0 / (std::log(2.0) / 0.2 + std::log(5.0));
    EXPECT_NEAR(sum(flow.into_hole) / exact, 1.0, 1e-10);
    EXPECT_NEAR(flow.from_outside / exact, 1.0, 1e-10);
  }
}

/// p = I0(pi r) cos(pi z), given on the side; ends closed.
double error_of_bessel(std::size_t n) {
  RingCells cells = rings(1.0, n, 1.0, n);
  const auto exact = [&](double r, std::size_t j) {
    return std::cyl_bessel_i(0.0, pi * r) * std::cos(pi * middle(cells.depths, j));
  };
  for (std::size_t j = 0; j < n; ++j) cells.outside.push_back(exact(1.0, j));
  const SteadyFlow flow = solved(cells);
  double squares = 0.0, weight = 0.0;
  for (std::size_t c = 0; here() && c < flow.pressure.size(); ++c) {
    const double r = middle(cells.radii, c % n), left = flow.pressure[c] - exact(r, c / n);
    squares += r * left * left;
    weight += r;
  }
  return std::sqrt(squares / weight);
}

TEST(SteadyFlow, IsOfSecondOrderInTheCells) {
  const double coarse = error_of_bessel(20), fine = error_of_bessel(40),
               finest = error_of_bessel(80);
  if (!here()) return;
  EXPECT_LT(finest, 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.3);
  EXPECT_NEAR(fine / finest, 4.0, 0.3);
}

/// Flow into a sphere of radius a, p = 1 - a / r given outside: Q = 4 pi a; cells make its wall of
/// steps.
double sphere_error(std::size_t n) {
  constexpr double a = 0.25;
  RingCells cells = rings(1.0, n, 2.0, 2 * n);
  const auto exact = [&](double r, double z) { return 1.0 - a / std::hypot(r, z - 1.0); };
  for (std::size_t c = 0; c < cells.hole.size(); ++c)
    if (exact(middle(cells.radii, c % n), middle(cells.depths, c / n)) < 0.0) cells.hole[c] = 1;
  for (std::size_t j = 0; j < 2 * n; ++j)
    cells.outside.push_back(exact(1.0, middle(cells.depths, j)));
  for (std::size_t i = 0; i < n; ++i) cells.above.push_back(exact(middle(cells.radii, i), 0.0));
  cells.below = cells.above;
  const SteadyFlow flow = solved(cells);
  if (!here()) return 0.0;
  const double in = flow.from_outside + flow.from_above + flow.from_below;
  EXPECT_NEAR(in / sum(flow.into_hole), 1.0, 1e-12);
  return sum(flow.into_hole) / (4.0 * pi * a) - 1.0;
}

TEST(SteadyFlow, IntoASphereTendsToTheClosedForm) {
  const double coarse = sphere_error(20), fine = sphere_error(80);
  EXPECT_LT(std::abs(coarse), 0.1);
  EXPECT_LT(std::abs(fine), 0.025);
}

TEST(SteadyFlow, RockThatNoWayLeadsToIsLeftOut) {
  RingCells cells = rings(1.0, 10, 1.0, 10);
  for (std::size_t c = 0; c < cells.hole.size(); ++c) {
    if (c % 10 == 0) cells.hole[c] = 1;
    if (c / 10 == 4) cells.mobility[c] = 0.0;  // no rock: the rows below are apart
  }
  cells.outside.assign(10, 1.0);
  for (std::size_t j = 5; j < 10; ++j)
    cells.mobility[10 * j + 9] = cells.mobility[10 * j + 1] = 0.0;
  const SteadyFlow flow = solved(cells);
  if (!here()) return;
  EXPECT_GT(flow.into_hole[3], 0.0);
  EXPECT_EQ(flow.into_hole[4], 0.0);
  EXPECT_EQ(flow.into_hole[7], 0.0);
  EXPECT_TRUE(std::isnan(flow.pressure[75]));
  EXPECT_NEAR(sum(flow.into_hole) / flow.from_outside, 1.0, 1e-12);
}

TEST(SteadyFlow, PermeabilitiesMayDifferByEightOrders) {
  RingCells cells = rings(1.0, 60, 1.0, 60);
  for (std::size_t c = 0; c < cells.hole.size(); ++c) {
    if (c % 60 < 6) cells.hole[c] = 1;
    if ((c * 7919) % 13 < 4) cells.mobility[c] = 1e-8;
  }
  cells.outside.assign(60, 1.0);
  const SteadyFlow flow = solved(cells);
  if (here()) EXPECT_NEAR(sum(flow.into_hole) / flow.from_outside, 1.0, 1e-10);
}

TEST(SteadyFlow, WrongCellsHaveASentence) {
  RingCells cells = rings(1.0, 4, 1.0, 3);
  EXPECT_EQ(problem_of(cells), "");
  cells.outside.assign(2, 1.0);
  EXPECT_EQ(problem_of(cells), "outside does not have a pressure for every row");
  cells.outside.clear();
  cells.mobility[5] = -1.0;
  EXPECT_EQ(problem_of(cells), "a mobility is negative or not finite");
  cells.radii[2] = cells.radii[1];
  EXPECT_EQ(problem_of(cells), "radii do not ascend from 0 or more");
}

}  // namespace
}  // namespace barreno
