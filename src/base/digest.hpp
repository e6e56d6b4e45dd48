// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// CRC-32 (ISO-HDLC, as of zip) of a text's bytes, eight hexadecimal digits: tells a file that has
/// changed, not one that was forged.
std::string digest_of(const std::string& bytes);

}  // namespace barreno
