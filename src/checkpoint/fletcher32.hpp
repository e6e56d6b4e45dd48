// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace barreno {

/// The checksum that HDF5's filter fletcher32 appends to a chunk, here in vector instructions: with
/// 16-bit words w_1 ... w_n, high byte first, sum w_i and sum (n + 1 - i) w_i modulo 65535
/// (J. G. Fletcher, IEEE Trans. Commun. 30, 1982), the second one in the high half.
/// @param count  of bytes, even
std::uint32_t fletcher32(const void* bytes, std::size_t count);

}  // namespace barreno
