// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "files/text_file.hpp"
#include "state/state.hpp"

#include <memory>
#include <vector>

namespace barreno {

/// Loads of a scene that are the fluid of a cavity, in their order.
std::vector<int> pore_fluids(const Scene& scene);

/// cavities.csv: volume [m3] and pressure [Pa] of every pore fluid; a row per call.
class CavitiesWriter {
public:
  /// Collective. @throws FileError on every rank
  CavitiesWriter(
      const Scene& scene,
      const Comm& comm,
      const std::filesystem::path& path,
      std::uintmax_t kept = 0
  );
  /// Collective. @throws FileError on every rank; NumericalError if a cavity has closed
  void write(const Scene& scene, const State& state);

  std::uintmax_t bytes() const { return file_ ? file_->bytes() : 0; }

private:
  std::unique_ptr<LineFile> file_;  ///< root only
};

}  // namespace barreno
