// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "drive/drive_steps.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What `barreno drive` was asked for.
struct DriveRequest {
  std::string material, path, out;  ///< card, path file, answer file
  DriveSteps steps;
  std::string picture;                 ///< file of the picture; empty: none
  std::vector<std::string> overrides;  ///< "PARAMETER=value"
};

/// Drives one material point along a path and writes what it became at every row, or in every step;
/// the answer file appears whole or not at all, and last. A picture shows every step; beside it
/// lies the table of its yield surface. Collective; every rank computes the same, the root writes.
/// Throws DeckError, FileError, NumericalError.
/// @return what the screen shows, several lines
std::string drive(const DriveRequest& request, const Comm& comm);

/// The answer goes to a pipe or a device (/dev/stdout), beside which the screen must say nothing.
bool goes_to_stream(const DriveRequest& request);

}  // namespace barreno
