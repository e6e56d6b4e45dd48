// SPDX-License-Identifier: BSD-3-Clause
#include "base/exchange.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <mpi.h>

#include <map>

namespace barreno {
namespace {

/// Messages of one exchange cannot be taken for those of the next: who is done may send the next
/// ones already to who is not, but no rank can be two exchanges ahead.
int next_tag() {
  static int calls = 0;
  constexpr int first_tag = 4711;
  return first_tag + (calls++ & 1);
}

/// A message for each rank that gets something. Its request ends once it is being received.
std::vector<MPI_Request> begin_sends(
    MPI_Comm comm, int tag, const std::vector<double>& send, const std::vector<int>& counts
) {
  int me = 0;
  MPI_Comm_rank(comm, &me);
  std::vector<MPI_Request> requests;
  std::size_t begin = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    const int to = static_cast<int>(rank);
    if (counts[rank] > 0 && to != me) {
      requests.push_back(MPI_REQUEST_NULL);
      MPI_Issend(&send[begin], counts[rank], MPI_DOUBLE, to, tag, comm, &requests.back());
    }
    begin += static_cast<std::size_t>(counts[rank]);
  }
  return requests;
}

/// What this rank sends to itself.
std::vector<double> own_part(
    MPI_Comm comm, const std::vector<double>& send, const std::vector<int>& counts
) {
  int me = 0;
  MPI_Comm_rank(comm, &me);
  std::ptrdiff_t begin = 0;
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(me); ++rank) begin += counts[rank];
  const auto first = send.begin() + begin;
  return {first, first + counts[static_cast<std::size_t>(me)]};
}

/// A message that has arrived, if there is one.
void receive_one(MPI_Comm comm, int tag, std::map<int, std::vector<double>>& arrived) {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, tag, comm, &there, &status);
  if (there == 0) return;
  int count = 0;
  MPI_Get_count(&status, MPI_DOUBLE, &count);
  std::vector<double>& rows = arrived[status.MPI_SOURCE];
  rows.resize(static_cast<std::size_t>(count));
  MPI_Recv(rows.data(), count, MPI_DOUBLE, status.MPI_SOURCE, tag, comm, MPI_STATUS_IGNORE);
}

}  // namespace

std::vector<double> exchange(
    const Teuchos::Comm<int>& comm, const std::vector<double>& send, const std::vector<int>& counts
) {
  if (comm.getSize() == 1) return send;  // a rank that is alone may be asked out of turn
  MPI_Comm mpi = *dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm();
  const int tag = next_tag();
  std::vector<MPI_Request> sends = begin_sends(mpi, tag, send, counts);
  std::map<int, std::vector<double>> arrived{{comm.getRank(), own_part(mpi, send, counts)}};
  // A rank whose messages have all been taken says so; once all ranks have, none is on its way.
  MPI_Request all_taken = MPI_REQUEST_NULL;
  bool said = false;
  for (int over = 0; over == 0;) {
    receive_one(mpi, tag, arrived);
    if (said) {
      MPI_Test(&all_taken, &over, MPI_STATUS_IGNORE);
      continue;
    }
    int taken = 0;
    MPI_Testall(static_cast<int>(sends.size()), sends.data(), &taken, MPI_STATUSES_IGNORE);
    if (taken == 0) continue;
    MPI_Ibarrier(mpi, &all_taken);
    said = true;
  }
  std::vector<double> received;
  for (const auto& [rank, rows] : arrived)
    received.insert(received.end(), rows.begin(), rows.end());
  return received;
}

std::vector<double> exchange_rows(
    const Teuchos::Comm<int>& comm, const std::vector<std::vector<double>>& outgoing
) {
  std::vector<int> counts;
  std::vector<double> send;
  counts.reserve(outgoing.size());
  for (const std::vector<double>& rows : outgoing) {
    counts.push_back(static_cast<int>(rows.size()));
    send.insert(send.end(), rows.begin(), rows.end());
  }
  return exchange(comm, send, counts);
}

}  // namespace barreno
