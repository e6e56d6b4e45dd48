// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace barreno {

/// Bytes of the UTF-8 character that begins at `at`; 0 if none does (RFC 3629: no overlong form, no
/// surrogate, nothing beyond U+10FFFF), or if XML has no such character (U+FFFE, U+FFFF).
std::size_t character_bytes(const std::string& text, std::size_t at);

/// The text with every byte that is not UTF-8 (of a file name in another encoding, say) as the
/// character that it is in Latin-1.
std::string as_utf8(const std::string& text);

}  // namespace barreno
