// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno::c_interface {

/// File of a card that a host names: a path, or a name, in any case and without ".xml" if you like
/// (hosts turn names to upper case), in the directories of BARRENO_MATERIALS and then among the
/// installed cards. Throws FileError.
std::string card_file(const std::string& name);

}  // namespace barreno::c_interface
