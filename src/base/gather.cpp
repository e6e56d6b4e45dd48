// SPDX-License-Identifier: BSD-3-Clause
#include "base/gather.hpp"

#include "base/error.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <mpi.h>

namespace barreno {
namespace {

constexpr int root = 0;

template <class T>
std::vector<T> gather(const Comm& comm, const std::vector<T>& mine, MPI_Datatype type) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (mpi == nullptr) return mine;  // a communicator of one process without MPI
  MPI_Comm raw = *mpi->getRawMpiComm();
  const int count = static_cast<int>(mine.size());
  const auto ranks = static_cast<std::size_t>(comm.getSize());
  std::vector<int> counts(ranks), begins(ranks, 0);
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, root, raw);
  for (std::size_t r = 1; r < counts.size(); ++r) begins[r] = begins[r - 1] + counts[r - 1];
  std::vector<T> all;
  if (is_root(comm))
    all.resize(static_cast<std::size_t>(begins.back()) + static_cast<std::size_t>(counts.back()));
  MPI_Gatherv(mine.data(), count, type, all.data(), counts.data(), begins.data(), type, root, raw);
  return all;
}

MPI_Op operation_of(Teuchos::EReductionType operation) {
  if (operation == Teuchos::REDUCE_SUM) return MPI_SUM;
  return operation == Teuchos::REDUCE_MIN ? MPI_MIN : MPI_MAX;
}

void reduce_raw(
    const Comm& comm,
    Teuchos::EReductionType operation,
    void* values,
    std::size_t count,
    MPI_Datatype type
) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (mpi == nullptr || comm.getSize() == 1) return;
  MPI_Allreduce(
      MPI_IN_PLACE,
      values,
      static_cast<int>(count),
      type,
      operation_of(operation),
      *mpi->getRawMpiComm()
  );
}

}  // namespace

std::vector<double> gather_to_root(const Comm& comm, const std::vector<double>& mine) {
  return gather(comm, mine, MPI_DOUBLE);
}
std::vector<long long> gather_to_root(const Comm& comm, const std::vector<long long>& mine) {
  return gather(comm, mine, MPI_LONG_LONG);
}

namespace detail {

void reduce(
    const Comm& comm, Teuchos::EReductionType operation, double* values, std::size_t count
) {
  reduce_raw(comm, operation, values, count, MPI_DOUBLE);
}
void reduce(
    const Comm& comm, Teuchos::EReductionType operation, long long* values, std::size_t count
) {
  reduce_raw(comm, operation, values, count, MPI_LONG_LONG);
}

}  // namespace detail

std::string broadcast_from_root(const Comm& comm, const std::string& text) {
  int length = static_cast<int>(text.size());
  Teuchos::broadcast<int, int>(comm, root, 1, &length);
  std::string received = text;
  received.resize(static_cast<std::size_t>(length));
  if (length > 0) Teuchos::broadcast<int, char>(comm, root, length, received.data());
  return received;
}

void RootWork::run(const std::function<void()>& work) {
  if (!is_root(comm_) || !sentence_.empty()) return;
  try {
    work();
  } catch (const FileError& error) {
    sentence_ = error.what();
  }
}

void RootWork::agree() const {
  const std::string sentence = broadcast_from_root(comm_, sentence_);
  if (!sentence.empty()) throw FileError(sentence);
}

}  // namespace barreno
