// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"

namespace barreno {

struct TimeSpec {
  double end_time = 0.0;  ///< [time]
};
template <>
const SectionTable<TimeSpec>& table_of<TimeSpec>();

}  // namespace barreno
