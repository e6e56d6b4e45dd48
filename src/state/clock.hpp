// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

struct Clock {
  double time = 0.0;
  double dt = 0.0;  ///< of the last step; of its last part with Subcycles
  long step = 0;
  double begin = 0.0;  ///< time at which the last step began, with all of its parts
};

}  // namespace barreno
