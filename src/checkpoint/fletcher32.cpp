// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/fletcher32.hpp"

#include <algorithm>
#include <cstring>

namespace barreno {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "words are read low byte first");

/// The most words whose weighted sum, 65535 block (block + 1) / 2, 32 bits hold.
constexpr std::uint32_t block = 256;

/// The remainder modulo 65535, but 65535 for a multiple that is not 0, as HDF5 has it.
std::uint64_t fold(std::uint64_t sum) {
  while (sum > 0xffff) sum = (sum & 0xffff) + (sum >> 16);
  return sum;
}

/// 2^8 s modulo 2^16 - 1: the sum of words that were read with their bytes the wrong way round.
std::uint32_t swap_bytes(std::uint64_t sum) {
  return static_cast<std::uint32_t>((sum & 0xff) << 8 | sum >> 8);
}

}  // namespace

std::uint32_t fletcher32(const void* bytes, std::size_t count) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  std::uint64_t sum = 0, weighted = 0;
  for (std::size_t left = count / 2; left > 0;) {
    const auto words = static_cast<std::uint32_t>(std::min<std::size_t>(left, block));
    std::uint16_t word[block] = {};  // zeros in front of the words change nothing
    std::memcpy(word + (block - words), next, 2 * words);
    std::uint32_t part = 0, weighted_part = 0;
    for (std::uint32_t i = 0; i < block; ++i) {
      part += word[i];
      weighted_part += (block - i) * word[i];
    }
    weighted = fold(weighted + sum * words + weighted_part);
    sum = fold(sum + part);
    next += std::size_t{2} * words;
    left -= words;
  }
  return swap_bytes(weighted) << 16 | swap_bytes(sum);
}

}  // namespace barreno
