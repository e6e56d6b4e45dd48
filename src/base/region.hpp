// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// Seconds and calls under one label since the start of the process; the label is the verb's name.
struct PhaseTime {
  const char* label = "";
  std::string name;  ///< the same, as Kokkos wants it
  double seconds = 0.0;
  long calls = 0;
};

/// All labels that ran on this rank, in the order of their first call.
const std::vector<PhaseTime>& phase_times();
void clear_phase_times();

/// Times a verb and names it to Kokkos' tools for the life of the object.
class Region {
public:
  /// @param label a string literal: it is kept by address
  explicit Region(const char* label);
  ~Region();
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

private:
  std::size_t index_;
  double start_;
};

}  // namespace barreno
