// SPDX-License-Identifier: BSD-3-Clause
#include "base/digest.hpp"

#include <cstdio>
#include <libdeflate.h>

namespace barreno {

std::string digest_of(const std::string& bytes) {
  char text[9];
  std::snprintf(text, sizeof text, "%08x", libdeflate_crc32(0, bytes.data(), bytes.size()));
  return text;
}

}  // namespace barreno
