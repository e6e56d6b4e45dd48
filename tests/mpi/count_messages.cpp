// SPDX-License-Identifier: BSD-3-Clause
/// Stands between a program and MPI (LD_PRELOAD), and tells at MPI_Finalize what was left over: for
/// every pair of ranks messages sent and received, requests that nobody completed, communicators
/// that nobody freed. One line, appended by rank 0 to the file that BARRENO_MESSAGES names.
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace {

/// A receive that was posted, or a send.
struct Open {
  MPI_Comm comm = MPI_COMM_NULL;
  bool receive = false;
};

struct Ledger {
  std::mutex lock;
  std::map<int, long> sent, received;  ///< by the other's rank in the world
  std::map<MPI_Request, Open> open;
  std::set<MPI_Comm> communicators;
};
Ledger& ledger() {
  static Ledger all;
  return all;
}

int world_rank(MPI_Comm comm, int rank) {
  MPI_Group group = MPI_GROUP_NULL, world = MPI_GROUP_NULL;
  PMPI_Comm_group(comm, &group);
  PMPI_Comm_group(MPI_COMM_WORLD, &world);
  int result = rank;
  PMPI_Group_translate_ranks(group, 1, &rank, world, &result);
  PMPI_Group_free(&group);
  PMPI_Group_free(&world);
  return result;
}

void note_send(MPI_Comm comm, int to) {
  if (to == MPI_PROC_NULL) return;
  const std::lock_guard<std::mutex> guard(ledger().lock);
  ++ledger().sent[world_rank(comm, to)];
}
void note_receive(MPI_Comm comm, const MPI_Status& status) {
  if (status.MPI_SOURCE == MPI_PROC_NULL) return;
  const std::lock_guard<std::mutex> guard(ledger().lock);
  ++ledger().received[world_rank(comm, status.MPI_SOURCE)];
}
void note_open(MPI_Request request, MPI_Comm comm, bool receive) {
  const std::lock_guard<std::mutex> guard(ledger().lock);
  ledger().open[request] = {comm, receive};
}
/// @param request  as it was before MPI completed it
void note_completed(MPI_Request request, const MPI_Status& status) {
  Open found;
  {
    const std::lock_guard<std::mutex> guard(ledger().lock);
    const auto at = ledger().open.find(request);
    if (at == ledger().open.end()) return;
    found = at->second;
    ledger().open.erase(at);
  }
  if (found.receive) note_receive(found.comm, status);
}
int note_communicator(int error, const MPI_Comm* made) {
  const std::lock_guard<std::mutex> guard(ledger().lock);
  if (error == MPI_SUCCESS && *made != MPI_COMM_NULL) ledger().communicators.insert(*made);
  return error;
}

/// Messages that were sent and not received, or received and not sent, over all pairs.
long unmatched(int ranks, long& messages) {
  const auto size = static_cast<std::size_t>(ranks);
  std::vector<long> sent(size), theirs(size);
  for (const auto& [rank, count] : ledger().sent) sent[static_cast<std::size_t>(rank)] = count;
  PMPI_Alltoall(sent.data(), 1, MPI_LONG, theirs.data(), 1, MPI_LONG, MPI_COMM_WORLD);
  long sums[2] = {0, 0}, all[2] = {0, 0};
  for (std::size_t r = 0; r < size; ++r) {
    sums[0] += std::labs(theirs[r] - ledger().received[static_cast<int>(r)]);
    sums[1] += sent[r];
  }
  PMPI_Allreduce(sums, all, 2, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  messages = all[1];
  return all[0];
}

void report() {
  int rank = 0, ranks = 1;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
  long messages = 0;
  const long left = unmatched(ranks, messages);
  const long mine[2] = {
      static_cast<long>(ledger().open.size()), static_cast<long>(ledger().communicators.size())};
  long all[2] = {0, 0};
  PMPI_Allreduce(mine, all, 2, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  const char* const name = std::getenv("BARRENO_MESSAGES");
  if (rank != 0 || name == nullptr) return;
  std::FILE* const file = std::fopen(name, "a");
  if (file == nullptr) return;
  std::fprintf(
      file,
      "ranks %d messages %ld unmatched %ld requests_left %ld communicators_left %ld\n",
      ranks,
      messages,
      left,
      all[0],
      all[1]
  );
  std::fclose(file);
}

}  // namespace

extern "C" {

int MPI_Send(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  note_send(comm, to);
  return PMPI_Send(data, n, type, to, tag, comm);
}
int MPI_Ssend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  note_send(comm, to);
  return PMPI_Ssend(data, n, type, to, tag, comm);
}
int MPI_Rsend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  note_send(comm, to);
  return PMPI_Rsend(data, n, type, to, tag, comm);
}
int MPI_Isend(
    const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request
) {
  note_send(comm, to);
  const int error = PMPI_Isend(data, n, type, to, tag, comm, request);
  note_open(*request, comm, false);
  return error;
}
int MPI_Issend(
    const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request
) {
  note_send(comm, to);
  const int error = PMPI_Issend(data, n, type, to, tag, comm, request);
  note_open(*request, comm, false);
  return error;
}
int MPI_Irecv(
    void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Request* request
) {
  const int error = PMPI_Irecv(data, n, type, from, tag, comm, request);
  note_open(*request, comm, true);
  return error;
}
int MPI_Recv(
    void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Status* status
) {
  MPI_Status own;
  const int error = PMPI_Recv(data, n, type, from, tag, comm, &own);
  note_receive(comm, own);
  if (status != MPI_STATUS_IGNORE) *status = own;
  return error;
}
// NOLINTNEXTLINE(readability-function-size): the arguments are those of MPI
int MPI_Sendrecv(
    const void* data,
    int n,
    MPI_Datatype type,
    int to,
    int tag,
    void* into,
    int m,
    MPI_Datatype other,
    int from,
    int other_tag,
    MPI_Comm comm,
    MPI_Status* status
) {
  MPI_Status own;
  note_send(comm, to);
  const int error =
      PMPI_Sendrecv(data, n, type, to, tag, into, m, other, from, other_tag, comm, &own);
  note_receive(comm, own);
  if (status != MPI_STATUS_IGNORE) *status = own;
  return error;
}
int MPI_Wait(MPI_Request* request, MPI_Status* status) {
  MPI_Request before = *request;
  MPI_Status own;
  const int error = PMPI_Wait(request, &own);
  note_completed(before, own);
  if (status != MPI_STATUS_IGNORE) *status = own;
  return error;
}
int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  const std::vector<MPI_Request> before(requests, requests + count);
  std::vector<MPI_Status> own(static_cast<std::size_t>(count));
  const int error = PMPI_Waitall(count, requests, own.data());
  for (std::size_t i = 0; i < own.size(); ++i) {
    note_completed(before[i], own[i]);
    if (statuses != MPI_STATUSES_IGNORE) statuses[i] = own[i];
  }
  return error;
}
int MPI_Waitany(int count, MPI_Request* requests, int* index, MPI_Status* status) {
  const std::vector<MPI_Request> before(requests, requests + count);
  MPI_Status own;
  const int error = PMPI_Waitany(count, requests, index, &own);
  if (*index != MPI_UNDEFINED) note_completed(before[static_cast<std::size_t>(*index)], own);
  if (status != MPI_STATUS_IGNORE) *status = own;
  return error;
}
int MPI_Test(MPI_Request* request, int* done, MPI_Status* status) {
  MPI_Request before = *request;
  MPI_Status own;
  const int error = PMPI_Test(request, done, &own);
  if (*done != 0) note_completed(before, own);
  if (status != MPI_STATUS_IGNORE && *done != 0) *status = own;
  return error;
}

int MPI_Testall(int count, MPI_Request* requests, int* done, MPI_Status* statuses) {
  const std::vector<MPI_Request> before(requests, requests + count);
  std::vector<MPI_Status> own(static_cast<std::size_t>(count));
  const int error = PMPI_Testall(count, requests, done, own.data());
  for (std::size_t i = 0; i < own.size() && *done != 0; ++i) {
    note_completed(before[i], own[i]);
    if (statuses != MPI_STATUSES_IGNORE) statuses[i] = own[i];
  }
  return error;
}

int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* made) {
  return note_communicator(PMPI_Comm_dup(comm, made), made);
}
int MPI_Comm_split(MPI_Comm comm, int colour, int key, MPI_Comm* made) {
  return note_communicator(PMPI_Comm_split(comm, colour, key, made), made);
}
int MPI_Comm_create(MPI_Comm comm, MPI_Group group, MPI_Comm* made) {
  return note_communicator(PMPI_Comm_create(comm, group, made), made);
}
int MPI_Comm_free(MPI_Comm* comm) {
  {
    const std::lock_guard<std::mutex> guard(ledger().lock);
    ledger().communicators.erase(*comm);
  }
  return PMPI_Comm_free(comm);
}

int MPI_Finalize() {
  report();
  return PMPI_Finalize();
}

}  // extern "C"
