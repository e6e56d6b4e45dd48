// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/crc32.hpp"

namespace barreno {
namespace {

/// Bit 31 - k stands for x^k.
constexpr std::uint32_t polynomial = 0xedb88320U, one = 0x80000000U, x_to_8 = 0x00800000U;

/// a b modulo the polynomial.
std::uint32_t product(std::uint32_t a, std::uint32_t b) {
  std::uint32_t sum = 0;
  for (std::uint32_t bit = one; bit != 0; bit >>= 1U) {
    if ((a & bit) != 0) sum ^= b;
    b = (b & 1U) != 0 ? b >> 1U ^ polynomial : b >> 1U;  // times x
  }
  return sum;
}

}  // namespace

std::uint32_t combined_crc32(std::uint32_t first, std::uint32_t second, unsigned long long bytes) {
  std::uint32_t power = one, square = x_to_8;
  for (; bytes != 0; bytes >>= 1U) {
    if ((bytes & 1U) != 0) power = product(power, square);
    square = product(square, square);
  }
  return product(power, first) ^ second;
}

}  // namespace barreno
