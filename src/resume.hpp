// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/build_facts.hpp"
#include "base/gather.hpp"

#include <Teuchos_RCP.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// Goes on with the run of a folder from its last whole checkpoint, to its end time or the one that
/// `overrides` assign; its files are continued. Collective.
///
/// @param build  of this program, for summary.json
/// @return the exit code
/// @throws DeckError if the deck is not that of the checkpoint, or the run is at its end
/// @throws FileError if there is no whole checkpoint, or other files of the run are not as it left
///         them
int resume(
    const std::filesystem::path& folder,
    const std::vector<std::string>& overrides,
    const BuildFacts& build,
    const Teuchos::RCP<const Comm>& comm
);

}  // namespace barreno
