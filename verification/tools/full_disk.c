/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A disk that fills up: preloaded (LD_PRELOAD), every write to a file below BARRENO_FULL_FOLDER fails with ENOSPC
 * from the one on that BARRENO_FULL_CALL counts (1 is the first). Built by full_disk.py. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long calls = 0;

static int is_full(int fd) {
  const char* folder = getenv("BARRENO_FULL_FOLDER");
  const char* call = getenv("BARRENO_FULL_CALL");
  char link[64], path[4096];
  if (folder == NULL || call == NULL) return 0;
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  if (strncmp(path, folder, strlen(folder)) != 0) return 0;
  return ++calls >= atol(call);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define FULL(fd)       \
  if (is_full(fd)) {   \
    errno = ENOSPC;    \
    return -1;         \
  }

ssize_t write(int fd, const void* data, size_t count) {
  FULL(fd);
  return REAL(write)(fd, data, count);
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
  FULL(fd);
  return REAL(writev)(fd, parts, count);
}
ssize_t pwrite(int fd, const void* data, size_t count, off_t at) {
  FULL(fd);
  return REAL(pwrite)(fd, data, count, at);
}
ssize_t pwrite64(int fd, const void* data, size_t count, off64_t at) {
  FULL(fd);
  return REAL(pwrite64)(fd, data, count, at);
}
