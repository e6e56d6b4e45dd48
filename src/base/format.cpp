// SPDX-License-Identifier: BSD-3-Clause
#include "base/format.hpp"

#include <cstdarg>
#include <cstdio>

namespace barreno {

std::string format(const char* pattern, ...) {
  char text[256];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text, sizeof(text), pattern, values);
  va_end(values);
  return text;
}

}  // namespace barreno
