// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/linear_system.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <memory>
#include <string>

namespace barreno {

/// Matrix, preconditioner and Krylov method (Tpetra, Ifpack2 or MueLu, Belos); hidden to keep
/// compile times low.
struct LinearSolver;

/// How a solve ended. It has converged only if the true residual |b - A x| / |b|, found afresh from
/// the solution, is below the tolerance too.
struct SolveReport {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;
  std::string method;  ///< for sentences: "Pseudoblock CG with MueLu"
};

/// What the deck's sublists say; an empty list means the defaults.
struct SolverLists {
  Teuchos::ParameterList belos, ifpack2, muelu;
};

std::shared_ptr<LinearSolver> make_linear_solver(
    const Teuchos::RCP<const Teuchos::Comm<int>>& comm, const SolverLists& lists
);

/// Solve from x = 0. Collective. The graph of the last call is kept where `same_graph` holds on
/// every rank, and with it what the preconditioner knows of the graph.
///
/// @param[out] solution  of the own rows
SolveReport solve(
    const LinearSystem& system, bool same_graph, LinearSolver& solver, std::vector<double>& solution
);

}  // namespace barreno
