// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace barreno {

/// Something that the user wrote is wrong; the text is the one sentence that the user reads.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written; the text is the one sentence that the user reads.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace barreno
