// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>

#include <cstddef>
#include <vector>

namespace barreno {

/// Equations of this rank: A x = b with a symmetric positive definite A. Unknowns have ids that are
/// unique over the ranks; columns say them.
struct LinearSystem {
  std::vector<long long> ids;      ///< of own unknowns, one row each
  std::vector<std::size_t> begin;  ///< first entry of every row, and the end
  std::vector<long long> column;
  std::vector<double> value;
  std::vector<double> right_side;

  /// Forgets the rows, keeps the memory.
  void clear() {
    ids.clear();
    begin.assign(1, 0);
    column.clear();
    value.clear();
    right_side.clear();
  }
  void add(long long to, double a) {
    column.push_back(to);
    value.push_back(a);
  }
  void end_row(long long id, double b) {
    ids.push_back(id);
    begin.push_back(column.size());
    right_side.push_back(b);
  }
};

/// Greatest flow to neighbours over storage of all rows that store anything, sum of |a_ij| over
/// a_ii less that sum: 2 d c dt/h^2 of a uniform rock in d dimensions. Collective.
double flow_over_storage(const LinearSystem& system, const Teuchos::Comm<int>& comm);

}  // namespace barreno
