// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

struct Clock {
  double time = 0.0;
  double dt = 0.0;  ///< of the last step
  long step = 0;
};

}  // namespace barreno
