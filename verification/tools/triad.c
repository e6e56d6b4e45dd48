// SPDX-License-Identifier: BSD-3-Clause
// Memory bandwidth of one process, a = b + s c over arrays beyond every cache, for so many seconds: triad SECONDS. Prints GB/s,
// the mean, so that processes that run together are seen together.
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv) {
  const size_t n = 8000000;
  const double wanted = argc > 1 ? atof(argv[1]) : 1.0;
  double *a = malloc(n * sizeof *a), *b = malloc(n * sizeof *b), *c = malloc(n * sizeof *c);
  if (!a || !b || !c) return 1;
  for (size_t i = 0; i < n; ++i) a[i] = b[i] = c[i] = (double)i;
  long passes = 0;
  double seconds = 0.0;
  for (const double begin = now(); seconds < wanted; seconds = now() - begin, ++passes)
    for (size_t i = 0; i < n; ++i) a[i] = b[i] + (3.0 + (double)passes) * c[i];
  printf("%.4f\n", a[n / 2] > 0.0 ? 24e-9 * (double)n * (double)passes / seconds : 0.0);
  return 0;
}
