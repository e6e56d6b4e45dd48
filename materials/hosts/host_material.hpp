// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno_material.h"

#include <string>

/// What the subroutine faces share: finding the material of a deck, and stopping the job.
namespace barreno::hosts {

/// Length of a material name in a host's list of arguments. The hidden length that Fortran adds is
/// not read, because some hosts leave it out.
inline constexpr int name_length = 80;

/// Material of a deck, opened at its first use, when one line on the screen says what it is. The
/// card is what follows the last '@' of the name ("@ABAQUS_BARRENO_UMAT@BEREA_SANDSTONE"), or all
/// of it. Safe for concurrent callers; stops the job if there is no such card.
/// @param name  name_length characters, filled with blanks; null: the variable BARRENO_CARD
const barreno_material* material_of(const char* name);

/// Stops the job, after one sentence, with the exit code that CalculiX gives failed jobs; the
/// host's own threads may still run, so nothing is torn down.
[[noreturn]] void stop(const std::string& sentence);

/// Stops the job unless the deck gave the material as many state variables as it has and, as
/// constants, nothing or the interface version.
void check_deck(
    const barreno_material* material, int state_count, int props_count, const double* props
);

}  // namespace barreno::hosts
