// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace barreno {

/// CRC-32 of a sequence of bytes whose two parts' are known: that of A B is that of A, times
/// x^(8 n) modulo the polynomial 0x04c11db7, plus that of B, where n is the length of B (sums and
/// products of polynomials over the field of two elements; W. W. Peterson, D. T. Brown, Proc. IRE
/// 49, 1961).
/// @param bytes  the length of the second part
std::uint32_t combined_crc32(std::uint32_t first, std::uint32_t second, unsigned long long bytes);

}  // namespace barreno
