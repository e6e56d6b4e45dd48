// SPDX-License-Identifier: BSD-3-Clause
#include "base/utf8.hpp"

namespace barreno {

std::size_t character_bytes(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(at);
  if (first < 0x80U) return 1;
  const std::size_t bytes = first < 0xC0U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  if (bytes == 0 || first > 0xF4U) return 0;
  unsigned code = first & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(at + i) & 0x3FU);
  }
  const unsigned smallest[] = {0x80U, 0x800U, 0x10000U};
  const bool surrogate = code >= 0xD800U && code <= 0xDFFFU;
  const bool none = surrogate || code == 0xFFFEU || code == 0xFFFFU || code > 0x10FFFFU;
  return none || code < smallest[bytes - 2] ? 0 : bytes;
}

std::string as_utf8(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_bytes(text, at);
    if (bytes == 0) {
      const auto code = static_cast<unsigned char>(text[at]);  // 0x80 or more: two bytes
      out += static_cast<char>(0xC0U | (code >> 6U));
      out += static_cast<char>(0x80U | (code & 0x3FU));
    }
    out += text.substr(at, bytes);
    at += bytes == 0 ? 1 : bytes;
  }
  return out;
}

}  // namespace barreno
