// SPDX-License-Identifier: BSD-3-Clause
#include "base/process.hpp"

#include <ctime>
#include <sys/resource.h>

namespace barreno {

double peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr double kibibyte = 1024.0;  // the unit of ru_maxrss on Linux
  return kibibyte * static_cast<double>(usage.ru_maxrss);
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace barreno
