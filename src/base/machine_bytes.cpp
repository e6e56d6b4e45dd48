// SPDX-License-Identifier: BSD-3-Clause
// Alone in its file: the fuzzed readers have a smaller machine (tests/fuzz/small_machine.cpp).
#include "base/process.hpp"

#include <unistd.h>

namespace barreno {

double machine_bytes() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace barreno
