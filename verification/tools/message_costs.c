// SPDX-License-Identifier: BSD-3-Clause
// Counts what a program sends through MPI, by the profiling interface: preload it, and every rank leaves
// $MESSAGES_FILE.RANK with lines "what calls bytes seconds cpu" when it ends. Of point to point bytes are those sent; of
// collective calls those that this rank gives; seconds and processor time are inside the call, waiting included. The last line
// has those of everything.
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { sends, waits, reductions, others, kinds };
static const char *names[kinds] = {"sends", "waits", "reductions", "others"};
static double calls[kinds], bytes[kinds], seconds[kinds], cpu[kinds], begun;

static double size_of(MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return size;
}

static double processor_time(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define COUNTED(kind, given, call)          \
  const double begin = PMPI_Wtime();        \
  const double worked = processor_time();   \
  const int result = call;                  \
  seconds[kind] += PMPI_Wtime() - begin;    \
  cpu[kind] += processor_time() - worked;   \
  calls[kind] += 1.0;                       \
  bytes[kind] += (given);                   \
  return result

#define SEND(name)                                                                              \
  int MPI_##name(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {           \
    COUNTED(sends, n *size_of(t), PMPI_##name(b, n, t, to, tag, c));                            \
  }
SEND(Send)
SEND(Rsend)
SEND(Ssend)
#define START(name)                                                                             \
  int MPI_##name(                                                                               \
      const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request *r) {      \
    COUNTED(sends, n *size_of(t), PMPI_##name(b, n, t, to, tag, c, r));                         \
  }
START(Isend)
START(Irsend)
START(Issend)

int MPI_Wait(MPI_Request *r, MPI_Status *s) {
  COUNTED(waits, 0, PMPI_Wait(r, s));
}
int MPI_Waitall(int n, MPI_Request *r, MPI_Status *s) {
  COUNTED(waits, 0, PMPI_Waitall(n, r, s));
}
int MPI_Recv(void *b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Status *s) {
  COUNTED(waits, 0, PMPI_Recv(b, n, t, from, tag, c, s));
}
int MPI_Allreduce(const void *b, void *o, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  COUNTED(reductions, n *size_of(t), PMPI_Allreduce(b, o, n, t, op, c));
}
int MPI_Reduce(const void *b, void *o, int n, MPI_Datatype t, MPI_Op op, int to, MPI_Comm c) {
  COUNTED(others, n *size_of(t), PMPI_Reduce(b, o, n, t, op, to, c));
}
int MPI_Bcast(void *b, int n, MPI_Datatype t, int from, MPI_Comm c) {
  COUNTED(others, n *size_of(t), PMPI_Bcast(b, n, t, from, c));
}
int MPI_Barrier(MPI_Comm c) {
  COUNTED(others, 0, PMPI_Barrier(c));
}
int MPI_Alltoall(
    const void *b, int n, MPI_Datatype t, void *o, int m, MPI_Datatype u, MPI_Comm c) {
  COUNTED(others, n *size_of(t), PMPI_Alltoall(b, n, t, o, m, u, c));
}
int MPI_Gather(
    const void *b, int n, MPI_Datatype t, void *o, int m, MPI_Datatype u, int to, MPI_Comm c) {
  COUNTED(others, n *size_of(t), PMPI_Gather(b, n, t, o, m, u, to, c));
}
int MPI_Gatherv(
    const void *b, int n, MPI_Datatype t, void *o, const int *m, const int *at, MPI_Datatype u, int to,
    MPI_Comm c) {
  COUNTED(others, n *size_of(t), PMPI_Gatherv(b, n, t, o, m, at, u, to, c));
}

int MPI_Init_thread(int *argc, char ***argv, int required, int *provided) {
  const int result = PMPI_Init_thread(argc, argv, required, provided);
  begun = PMPI_Wtime();
  return result;
}
int MPI_Init(int *argc, char ***argv) {
  const int result = PMPI_Init(argc, argv);
  begun = PMPI_Wtime();
  return result;
}

int MPI_Finalize(void) {
  const char *file = getenv("MESSAGES_FILE");
  if (file) {
    int rank = 0;
    char name[4096];
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    snprintf(name, sizeof name, "%s.%d", file, rank);
    FILE *out = fopen(name, "w");
    for (int k = 0; out && k < kinds; ++k)
      fprintf(out, "%s %.0f %.0f %.9g %.9g\n", names[k], calls[k], bytes[k], seconds[k], cpu[k]);
    if (out) fprintf(out, "all 0 0 %.9g %.9g\n", PMPI_Wtime() - begun, processor_time());
    if (out) fclose(out);
  }
  return PMPI_Finalize();
}
