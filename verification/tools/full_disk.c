/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A disk that fails: preloaded (LD_PRELOAD), calls on files below BARRENO_FULL_FOLDER fail from the one on that
 * BARRENO_FULL_CALL counts (1 is the first). Built by full_disk.py. Further variables, all optional:
 * BARRENO_FULL_KIND   write (the default), sync, rename or open: which calls count and fail
 * BARRENO_FULL_ERROR  errno of the failure (ENOSPC without it); 0: half of the bytes are written, which is no failure
 * BARRENO_FULL_ONCE   set: only that one call fails
 * BARRENO_FULL_COUNT  a file that gets the number of calls when the process ends */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long calls = 0;

static int counts(const char* kind) {
  const char* wanted = getenv("BARRENO_FULL_KIND");
  return strcmp(wanted == NULL ? "write" : wanted, kind) == 0;
}

static int fails_at(const char* path, const char* kind) {
  const char* folder = getenv("BARRENO_FULL_FOLDER");
  const char* call = getenv("BARRENO_FULL_CALL");
  if (folder == NULL || call == NULL || !counts(kind)) return 0;
  if (strncmp(path, folder, strlen(folder)) != 0) return 0;
  ++calls;
  return getenv("BARRENO_FULL_ONCE") != NULL ? calls == atol(call) : calls >= atol(call);
}

static int is_full(int fd, const char* kind) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return fails_at(path, kind);
}

static int chosen_error(void) {
  const char* number = getenv("BARRENO_FULL_ERROR");
  return number == NULL ? ENOSPC : atoi(number);
}

__attribute__((destructor)) static void tell_calls(void) {
  const char* path = getenv("BARRENO_FULL_COUNT");
  /* Processes that this one starts have the library too. */
  FILE* file = path == NULL || calls == 0 ? NULL : fopen(path, "w");
  if (file == NULL) return;
  fprintf(file, "%ld\n", calls);
  fclose(file);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define FAIL(condition)                 \
  if (condition) {                      \
    errno = chosen_error();             \
    if (errno == 0) errno = ENOSPC;     \
    return -1;                          \
  }
/* Fails, or writes half of the bytes. */
#define FULL(fd, count, half)                        \
  if (is_full(fd, "write")) {                        \
    if (chosen_error() == 0 && count > 1) return half; \
    if (chosen_error() != 0) {                       \
      errno = chosen_error();                        \
      return -1;                                     \
    }                                                \
  }

ssize_t write(int fd, const void* data, size_t count) {
  FULL(fd, count, REAL(write)(fd, data, count / 2));
  return REAL(write)(fd, data, count);
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
  FULL(fd, count, REAL(writev)(fd, parts, count / 2));
  return REAL(writev)(fd, parts, count);
}
ssize_t pwrite(int fd, const void* data, size_t count, off_t at) {
  FULL(fd, count, REAL(pwrite)(fd, data, count / 2, at));
  return REAL(pwrite)(fd, data, count, at);
}
ssize_t pwrite64(int fd, const void* data, size_t count, off64_t at) {
  FULL(fd, count, REAL(pwrite64)(fd, data, count / 2, at));
  return REAL(pwrite64)(fd, data, count, at);
}
int fsync(int fd) {
  FAIL(is_full(fd, "sync"));
  return REAL(fsync)(fd);
}
int rename(const char* from, const char* to) {
  FAIL(fails_at(to, "rename"));
  return REAL(rename)(from, to);
}
int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  FAIL((flags & O_ACCMODE) != O_RDONLY && fails_at(path, "open"));
  return REAL(open)(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  FAIL((flags & O_ACCMODE) != O_RDONLY && fails_at(path, "open"));
  return REAL(open64)(path, flags, mode);
}
