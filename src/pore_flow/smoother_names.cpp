// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/smoother_names.hpp"

#include "pore_flow/multigrid.hpp"

#include <Ifpack2_Factory.hpp>
#include <Ifpack2_Preconditioner.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>

namespace barreno {
namespace {

using RowMatrix = Tpetra::RowMatrix<double, int, long long>;

/// One equation: all that a preconditioner needs to read its list.
Teuchos::RCP<const RowMatrix> one_row() {
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::rcp(new Teuchos::SerialComm<int>);
  const auto map = Teuchos::rcp(new Tpetra::Map<int, long long>(1, 0, comm));
  const auto matrix = Teuchos::rcp(new SparseMatrix(map, 1));
  const long long id = 0;
  const double one = 1.0;
  matrix->insertGlobalValues(id, 1, &one, &id);
  matrix->fillComplete();
  return matrix;
}

}  // namespace

SmootherNames smoother_names(const std::string& kind, const Teuchos::ParameterList& list) {
  Teuchos::ParameterList fresh;  // none of its entries is marked as read yet
  for (auto item = list.begin(); item != list.end(); ++item)
    fresh.setEntry(list.name(item), Teuchos::ParameterEntry(list.entry(item).getAny(false)));
  Ifpack2::Factory::create<RowMatrix>(kind, one_row())->setParameters(fresh);
  SmootherNames names;
  // Kinds that read with a default leave their names in the list, the factorisations do not.
  names.known = {
      "fact: iluk level-of-fill",
      "fact: ilut level-of-fill",
      "fact: drop tolerance",
      "fact: relax value",
      "fact: absolute threshold",
      "fact: relative threshold"};
  for (auto item = fresh.begin(); item != fresh.end(); ++item) {
    const bool given = list.isParameter(fresh.name(item));
    if (!given) names.known.push_back(fresh.name(item));
    if (given && !fresh.entry(item).isUsed()) names.unread.push_back(fresh.name(item));
  }
  return names;
}

}  // namespace barreno
