// SPDX-License-Identifier: BSD-3-Clause
#include "deck/touching_duration.hpp"

namespace barreno {

std::optional<double> touching_duration(const std::vector<JetSlug>& slugs, std::size_t i) {
  const bool ahead = i > 0 && !slugs[i - 1].piece;
  const bool behind = i + 1 < slugs.size() && !slugs[i + 1].piece;
  if (slugs[i].piece || !(ahead || behind)) return {};
  const double before =
      ahead ? slugs[i].time - slugs[i - 1].time : slugs[i + 1].time - slugs[i].time;
  const double after = behind ? slugs[i + 1].time - slugs[i].time : before;
  return 0.5 * (before + after);
}

}  // namespace barreno
