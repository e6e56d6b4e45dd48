// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/multigrid.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Operator.hpp>

#include <MueLu_CreateTpetraPreconditioner.hpp>

namespace barreno {
namespace {

using Hierarchy = MueLu::TpetraOperator<double, int, long long>;

Teuchos::ParameterList defaults() {
  Teuchos::ParameterList list;
  list.set("verbosity", std::string("none"));
  list.set("multigrid algorithm", std::string("sa"));
  list.set("reuse: type", std::string("S"));
  list.set("max levels", 10);
  list.set("coarse: max size", 500);
  list.set("smoother: type", std::string("CHEBYSHEV"));
  // The packages' 10 iterations and 1.1 miss the largest eigenvalue where most rows stand alone.
  Teuchos::ParameterList& smoother = list.sublist("smoother: params");
  smoother.set("chebyshev: degree", 2);
  smoother.set("chebyshev: eigenvalue max iterations", 50);
  smoother.set("chebyshev: boost factor", 1.3);
  list.set("coarse: type", std::string("RELAXATION"));
  Teuchos::ParameterList& coarse = list.sublist("coarse: params");
  coarse.set("relaxation: type", std::string("Symmetric Gauss-Seidel"));
  coarse.set("relaxation: sweeps", 20);
  return list;
}

Teuchos::RCP<SparseOperator> make(
    const Teuchos::RCP<SparseMatrix>& matrix,
    const Teuchos::ParameterList& lists,
    const Teuchos::RCP<SparseOperator>& old
) {
  if (const auto hierarchy = Teuchos::rcp_dynamic_cast<Hierarchy>(old); !hierarchy.is_null()) {
    MueLu::ReuseTpetraPreconditioner(matrix, *hierarchy);
    return hierarchy;
  }
  Teuchos::ParameterList list = lists, usual = defaults();
  // Another smoother does not know these parameters.
  for (const std::string name : {"smoother", "coarse"})
    if (lists.isParameter(name + ": type")) usual.remove(name + ": params");
  list.setParametersNotAlreadySet(usual);
  const Teuchos::RCP<SparseOperator> as_operator = matrix;
  return MueLu::CreateTpetraPreconditioner<double, int, long long>(as_operator, list);
}

}  // namespace
}  // namespace barreno

/// What load_multigrid.cpp looks for.
extern "C" {
extern const barreno::MakeMultigrid barreno_multigrid;
const barreno::MakeMultigrid barreno_multigrid = &barreno::make;
}
