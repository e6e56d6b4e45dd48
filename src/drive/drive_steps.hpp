// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// How a path is walked, and what the answer tells of it.
struct DriveSteps {
  int per_row = 1;     ///< equal steps between two rows of the path
  bool every = false;  ///< the answer has a row for each of them, not for rows of the path alone
};

}  // namespace barreno
