// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Operator_fwd.hpp>

namespace barreno {

using SparseMatrix = Tpetra::CrsMatrix<double, int, long long>;
using SparseOperator = Tpetra::Operator<double, int, long long>;

/// Smoothed aggregation (MueLu) for a diffusion operator.
///
/// The coarsest grid is smoothed, not factorised: the packaged direct solver of Debian 12
/// (Amesos2's KLU2) gives wrong answers on two or more ranks.
///
/// MueLu is loaded with the first call: its libraries take two thirds of what a program that is
/// linked with them needs to start, and few runs need them.
///
/// @param lists  the deck's MueLu list; what it does not say is taken from the defaults
/// @param old    a preconditioner of the same graph whose aggregates are kept; null: from nothing
/// @throws FileError  if MueLu or Barreno's part that calls it is missing
Teuchos::RCP<SparseOperator> make_multigrid(
    const Teuchos::RCP<SparseMatrix>& matrix,
    const Teuchos::ParameterList& lists,
    const Teuchos::RCP<SparseOperator>& old
);

/// What the library `multigrid` (multigrid.cpp) offers under the name `barreno_multigrid`: the
/// function above.
using MakeMultigrid = decltype(&make_multigrid);

}  // namespace barreno
