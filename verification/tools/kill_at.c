/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A run that gets a signal at one of its checkpoints: preloaded (LD_PRELOAD), it counts how often a file below
 * BARRENO_KILL_FOLDER is renamed to checkpoint.h5. The calls of a run do not depend on the time, so that the same
 * variables hit the same call again.
 * BARRENO_KILL_SIGNAL      the signal; without it nothing happens
 * BARRENO_KILL_CHECKPOINT  the checkpoint from which on it counts; 0: from the start of the run
 * BARRENO_KILL_CALL        0: the signal comes once that checkpoint has its name; N: before the N-th call (open, write,
 *                          fsync, rename) that writes the next one
 * BARRENO_KILL_DELAY       microseconds from there to the signal, 0: none */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

static long checkpoints = 0, calls = 0;
static int sent = 0;

static long number(const char* name) {
  const char* text = getenv(name);
  return text == NULL ? 0 : atol(text);
}

static void* send_later(void* unused) {
  const long delay = number("BARRENO_KILL_DELAY");
  const struct timespec time = {delay / 1000000, delay % 1000000 * 1000};
  nanosleep(&time, NULL);
  kill(getpid(), (int)number("BARRENO_KILL_SIGNAL"));
  return unused;
}

static void send(void) {
  pthread_t thread;
  if (sent) return;
  sent = 1;
  if (number("BARRENO_KILL_DELAY") == 0 || pthread_create(&thread, NULL, send_later, NULL) != 0)
    kill(getpid(), (int)number("BARRENO_KILL_SIGNAL"));
  else
    pthread_detach(thread);
}

/* Whether the path is that of this file in the folder. */
static int is_file(const char* path, const char* name) {
  const char* folder = getenv("BARRENO_KILL_FOLDER");
  const char* last = strrchr(path, '/');
  if (folder == NULL || last == NULL || strcmp(last + 1, name) != 0) return 0;
  return strncmp(path, folder, strlen(folder)) == 0;
}

/* Before a call on a file. */
static void count_call(const char* path) {
  if (number("BARRENO_KILL_CALL") == 0 || checkpoints < number("BARRENO_KILL_CHECKPOINT")) return;
  if (!is_file(path, "checkpoint.h5.tmp") && !is_file(path, "checkpoint.h5")) return;
  if (++calls == number("BARRENO_KILL_CALL")) send();
}

static void count_descriptor(int fd) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t length = number("BARRENO_KILL_SIGNAL") == 0 ? -1 : readlink(link, path, sizeof path - 1);
  if (length < 0) return;
  path[length] = '\0';
  count_call(path);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int fd, const void* data, size_t count) {
  count_descriptor(fd);
  return REAL(write)(fd, data, count);
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
  count_descriptor(fd);
  return REAL(writev)(fd, parts, count);
}
ssize_t pwrite(int fd, const void* data, size_t count, off_t at) {
  count_descriptor(fd);
  return REAL(pwrite)(fd, data, count, at);
}
ssize_t pwrite64(int fd, const void* data, size_t count, off64_t at) {
  count_descriptor(fd);
  return REAL(pwrite64)(fd, data, count, at);
}
int fsync(int fd) {
  count_descriptor(fd);
  return REAL(fsync)(fd);
}
int rename(const char* from, const char* to) {
  count_call(from);
  const int result = REAL(rename)(from, to);
  if (result != 0 || !is_file(to, "checkpoint.h5")) return result;
  if (++checkpoints == number("BARRENO_KILL_CHECKPOINT") && number("BARRENO_KILL_CALL") == 0) send();
  return result;
}
int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & O_ACCMODE) != O_RDONLY) count_call(path);
  return REAL(open)(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & O_ACCMODE) != O_RDONLY) count_call(path);
  return REAL(open64)(path, flags, mode);
}
