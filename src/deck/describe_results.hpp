// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// What a column of a run's tables, a field of particles.e or a number of summary.json means:
/// "channel_depth", "stress_xx", "penetration.depth_error.low" or one of the names that its dots
/// part.
/// @param page  text of docs/output.md, whose tables define these words
/// @return  empty where the page has no such word
std::string describe_result(const std::string& page, const std::string& name);

/// docs/output.md of the source tree or of the installation that this program is in; empty where
/// it is not there.
std::string result_page();

}  // namespace barreno
