// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_EReductionType.hpp>

#include <functional>
#include <string>
#include <vector>

namespace barreno {

using Comm = Teuchos::Comm<int>;

/// Rank 0 reads decks and writes files.
inline bool is_root(const Comm& comm) {
  return comm.getRank() == 0;
}

/// The ranks' values one after the other in rank order; empty on all ranks but the root.
std::vector<double> gather_to_root(const Comm& comm, const std::vector<double>& mine);
std::vector<long long> gather_to_root(const Comm& comm, const std::vector<long long>& mine);

namespace detail {
void reduce(const Comm& comm, Teuchos::EReductionType operation, double* values, std::size_t count);
void reduce(
    const Comm& comm, Teuchos::EReductionType operation, long long* values, std::size_t count
);
inline void reduce(
    const Comm& comm, Teuchos::EReductionType operation, ReproducibleSum* values, std::size_t count
) {
  static_assert(sizeof(ReproducibleSum) == ReproducibleSum::parts * sizeof(long long));
  if (count > 0) reduce(comm, operation, values->part, count * ReproducibleSum::parts);
}
}  // namespace detail

/// Entry by entry over the ranks, the result on every rank; all ranks give the same number of
/// entries.
/// @param values  a std::vector or, without any allocation, a std::array: of double, of long long
///                or, to be added, of ReproducibleSum
template <class Values>
auto sum_over_ranks(const Comm& comm, Values& values) -> decltype(void(values.data())) {
  detail::reduce(comm, Teuchos::REDUCE_SUM, values.data(), values.size());
}
template <class Values>
auto min_over_ranks(const Comm& comm, Values& values) -> decltype(void(values.data())) {
  detail::reduce(comm, Teuchos::REDUCE_MIN, values.data(), values.size());
}
template <class Values>
auto max_over_ranks(const Comm& comm, Values& values) -> decltype(void(values.data())) {
  detail::reduce(comm, Teuchos::REDUCE_MAX, values.data(), values.size());
}

/// The root's text on every rank.
std::string broadcast_from_root(const Comm& comm, const std::string& text);

/// Work on files that only the root does, between collective calls that every rank must reach.
///
/// A FileError of the root is kept, later work is skipped, and agree() throws it on every rank, so
/// that no rank waits for one that has left.
class RootWork {
public:
  explicit RootWork(const Comm& comm) : comm_(comm) {}
  /// Runs on the root only.
  void run(const std::function<void()>& work);
  /// Collective. @throws FileError on every rank if the root met one
  void agree() const;

private:
  const Comm& comm_;
  std::string sentence_;
};

}  // namespace barreno
