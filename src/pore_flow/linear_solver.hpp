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

/// @param lists  Belos, Ifpack2 and MueLu, a sublist each; empty ones mean the defaults
/// @throws std::exception of the packages if one does not know what its list says
std::shared_ptr<LinearSolver> make_linear_solver(
    const Teuchos::RCP<const Teuchos::Comm<int>>& comm, const Teuchos::ParameterList& lists
);

/// Names that a method of Belos knows. @throws std::exception if Belos has no such method
std::vector<std::string> known_names(const std::string& method);

/// Solve from x = 0. Collective. The graph of the last call is kept where `same_graph` holds on
/// every rank, and with it what the preconditioner knows of the graph.
///
/// @param[out] solution  of the own rows
SolveReport solve(
    const LinearSystem& system, bool same_graph, LinearSolver& solver, std::vector<double>& solution
);

}  // namespace barreno
