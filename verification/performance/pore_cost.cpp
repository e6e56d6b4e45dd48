// SPDX-License-Identifier: BSD-3-Clause
// What a solve of the pore flow costs against its size and its time step:
//
//   mpirun -n RANKS barreno_pore_cost [LARGEST [PACKAGE]]
//
// cubes of rock, drained on one side, of 1e4 unknowns and ten times more each up to LARGEST (1e6);
// c dt/h^2 = 1 is what the code waits for by default, 1e4 nearly a steady state. First solves with
// a graph of its own, then with that graph and new values, as most of a run does.
#include "base/gather.hpp"
#include "pore_flow/linear_solver.hpp"

#include <Tpetra_Core.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace barreno {
namespace {

/// Backward Euler on n^3 cells, layers of z per rank, drained where x ends. Conductances vary by a
/// factor of four from place to place.
LinearSystem cube(const Comm& comm, long long n, double diffusion_number) {
  LinearSystem system;
  system.clear();
  const long long rank = comm.getRank(), ranks = comm.getSize();
  const auto soft = [](long long i, long long j, long long k) {
    return 1.0 + 0.6 * std::sin(0.7 * static_cast<double>(i + 2 * j + 3 * k));
  };
  for (long long k = rank * n / ranks; k < (rank + 1) * n / ranks; ++k)
    for (long long j = 0; j < n; ++j)
      for (long long i = 0; i < n; ++i) {
        double diagonal = 1.0 / diffusion_number;
        const auto link = [&](long long a, long long b, long long c) {
          if (a < 0 || b < 0 || c < 0 || b >= n || c >= n) return;
          const double g = a < n ? 2.0 / (1.0 / soft(i, j, k) + 1.0 / soft(a, b, c)) : 2.0;
          diagonal += g;
          if (a < n) system.add((c * n + b) * n + a, -g);
        };
        link(i - 1, j, k);
        link(i + 1, j, k);
        link(i, j - 1, k);
        link(i, j + 1, k);
        link(i, j, k - 1);
        link(i, j, k + 1);
        const long long id = (k * n + j) * n + i;
        system.add(id, diagonal);
        system.end_row(id, i + 1 == n ? -1.0 : 0.01 * std::sin(static_cast<double>(id)));
      }
  return system;
}

struct Cost {
  double seconds;  ///< of the processor, on this rank: others may share the machine
  SolveReport report;
};

Cost timed_solve(
    const Comm& comm, const LinearSystem& system, bool same_graph, LinearSolver& solver
) {
  std::vector<double> solution;
  comm.barrier();
  const std::clock_t begin = std::clock();
  const SolveReport report = solve(system, same_graph, solver, solution);
  return {static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, report};
}

void print_row(const Comm& comm, long long n, double number, const char* package) {
  Teuchos::ParameterList lists;
  if (std::string(package) == "MueLu") lists.sublist("MueLu").set("verbosity", std::string("none"));
  if (std::string(package) == "Ifpack2")
    lists.sublist("Ifpack2").set("Type", std::string("RELAXATION"));
  const auto solver = make_linear_solver(Teuchos::rcpFromRef(comm), lists);
  const Cost first = timed_solve(comm, cube(comm, n, number), false, *solver);
  Cost again = timed_solve(comm, cube(comm, n, 1.1 * number), true, *solver);
  const Cost third = timed_solve(comm, cube(comm, n, number), true, *solver);
  if (third.seconds < again.seconds) again = third;
  if (comm.getRank() != 0) return;
  const double unknowns = std::pow(static_cast<double>(n), 3);
  std::printf(
      "%9.0f %8g %-8s %5d %10.1e %9.2f %9.2f %10.0f\n",
      unknowns,
      number,
      package,
      again.report.iterations,
      again.report.residual,
      1e6 * first.seconds / unknowns,
      1e6 * again.seconds / unknowns,
      again.report.converged ? unknowns / again.seconds : 0.0
  );
  std::fflush(stdout);
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard guard(&argc, &argv);
  using namespace barreno;
  const auto comm = Tpetra::getDefaultComm();
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  const std::string only = argc > 2 ? argv[2] : "MueLu and Ifpack2";
  if (comm->getRank() == 0)
    std::printf(
        "%d ranks\n unknowns  c dt/hh package iterations residual  new graph kept graph  "
        "unknowns/s\n"
        "                                              [us per unknown]\n",
        comm->getSize()
    );
  for (const long long n : {22LL, 46LL, 100LL})
    for (const double number : {1.0, 10.0, 100.0, 1e4})
      for (const char* package : {"MueLu", "Ifpack2"})
        if (std::pow(static_cast<double>(n), 3) <= 1.1 * largest && only.find(package) != only.npos)
          print_row(*comm, n, number, package);
  return 0;
}
