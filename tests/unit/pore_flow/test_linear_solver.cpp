// SPDX-License-Identifier: BSD-3-Clause
#include "base/gather.hpp"
#include "pore_flow/linear_solver.hpp"

#include <Tpetra_Core.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// Diffusion on n x n cells, drained at x = n, rows in strips of y per rank; b is A times the
/// solution that is wanted.
struct Strip {
  LinearSystem system;
  std::vector<double> wanted;
};

double solution(long long i, long long j) {
  return std::sin(0.3 * static_cast<double>(i)) + 0.1 * static_cast<double>(j % 5);
}

Strip make_strip(const Comm& comm, long long n, double storage) {
  Strip strip;
  strip.system.clear();
  const long long rank = comm.getRank(), ranks = comm.getSize();
  for (long long j = rank * n / ranks; j < (rank + 1) * n / ranks; ++j)
    for (long long i = 0; i < n; ++i) {
      double diagonal = storage, b = 0.0;
      const auto link = [&](long long to_i, long long to_j) {
        if (to_i < 0 || to_j < 0 || to_j >= n) return;
        diagonal += 1.0;
        if (to_i >= n) return;
        strip.system.add(to_j * n + to_i, -1.0);
        b -= solution(to_i, to_j);
      };
      link(i - 1, j);
      link(i + 1, j);
      link(i, j - 1);
      link(i, j + 1);
      strip.system.add(j * n + i, diagonal);
      strip.system.end_row(j * n + i, b + diagonal * solution(i, j));
      strip.wanted.push_back(solution(i, j));
    }
  return strip;
}

double worst(const Comm& comm, const Strip& strip, const std::vector<double>& found) {
  std::array<double, 1> error{found.size() == strip.wanted.size() ? 0.0 : HUGE_VAL};
  for (std::size_t i = 0; i < std::min(found.size(), strip.wanted.size()); ++i)
    error[0] = std::max(error[0], std::abs(found[i] - strip.wanted[i]));
  max_over_ranks(comm, error);
  return error[0];
}

/// A smoother below 2000 unknowns, grids above: both must be right on every number of ranks, which
/// packaged direct solvers are not.
TEST(LinearSolver, FindsTheSolution) {
  const auto comm = Tpetra::getDefaultComm();
  for (const long long n : {20, 60, 100}) {
    const Strip strip = make_strip(*comm, n, 1e-3);
    const auto solver = make_linear_solver(comm, {});
    std::vector<double> found;
    const SolveReport report = solve(strip.system, false, *solver, found);
    EXPECT_TRUE(report.converged) << report.method << " " << report.residual;
    EXPECT_LT(worst(*comm, strip, found), 1e-6) << report.method;
    EXPECT_LT(report.iterations, 150) << report.method;
    EXPECT_NE(report.method.find(n == 20 ? "Ifpack2" : "MueLu"), std::string::npos);
  }
}

TEST(LinearSolver, KeepsTheGraphWithNewValues) {
  const auto comm = Tpetra::getDefaultComm();
  for (const long long n : {20, 60, 100}) {
    const auto solver = make_linear_solver(comm, {});
    std::vector<double> found;
    for (const double storage : {1e-3, 0.5, 20.0}) {
      const Strip strip = make_strip(*comm, n, storage);
      const SolveReport report = solve(strip.system, storage != 1e-3, *solver, found);
      EXPECT_TRUE(report.converged) << report.method << " storage " << storage;
      EXPECT_LT(worst(*comm, strip, found), 1e-6) << report.method << " storage " << storage;
    }
  }
}

TEST(LinearSolver, SaysThatItDidNotConverge) {
  const auto comm = Tpetra::getDefaultComm();
  Teuchos::ParameterList lists;
  lists.sublist("Belos").set("Maximum Iterations", 2);
  const auto solver = make_linear_solver(comm, lists);
  std::vector<double> found;
  const SolveReport report = solve(make_strip(*comm, 60, 1e-3).system, false, *solver, found);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 4);  // two with the default multigrid, two with Gauss-Seidel
  EXPECT_GT(report.residual, 1e-6);
}

}  // namespace
}  // namespace barreno
