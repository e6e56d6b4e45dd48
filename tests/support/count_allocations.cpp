// SPDX-License-Identifier: BSD-3-Clause
// Takes the place of glibc's allocation functions and passes on to them.
#include "support/count_allocations.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdlib>

// What glibc calls its own.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

namespace barreno::testing {
namespace {

long requests = 0;
bool aborts = false;

void count() {
  ++requests;
  if (aborts) std::abort();
}

}  // namespace

long allocations() {
  return requests;
}
void abort_on_allocation(bool on) {
  aborts = on;
}

}  // namespace barreno::testing

extern "C" {

void* malloc(std::size_t size) {
  barreno::testing::count();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  barreno::testing::count();
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  barreno::testing::count();
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  barreno::testing::count();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  barreno::testing::count();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  barreno::testing::count();
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
}
