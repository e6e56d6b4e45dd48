// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "output/exodus_file.hpp"
#include "scene/scene.hpp"
#include "state/slots.hpp"
#include "state/state.hpp"

#include <memory>

namespace barreno {

/// particles.e: every particle an element, a block per material, elements sorted by particle id.
///
/// Every particle of the run owns its place from the start. `status` is 1 while the particle exists
/// and 0 before its launch and after its removal; then all other variables are 0, and the corners
/// stay where they were last seen. Corners of a particle that did not exist at the start have their
/// initial coordinates on the axis in the launch plane.
///
/// The data are gathered on rank 0, which alone holds a file.
class ExodusWriter {
public:
  /// @param slots       all particles that the run has or will have, see all_slots
  /// @param information lines kept in the file's information records
  /// @param kept        time steps of an old file of that name that stay
  ExodusWriter(
      const Scene& scene,
      const std::vector<SlotRange>& slots,
      const State& state,
      const std::filesystem::path& path,
      const std::string& version,
      const std::vector<std::string>& information,
      int kept = 0
  );
  /// Appends the state as a time step. Collective. @throws FileError on every rank
  void write(const Scene& scene, const State& state);
  void close(const Comm& comm);
  int steps() const { return steps_; }  ///< in the file

private:
  /// Consecutive ids and the element of the first one within its block.
  struct Range {
    ParticleId first;
    long long count;
    std::size_t begin;
  };
  struct Block {
    std::vector<Range> ranges;  ///< ascending
    std::size_t begin = 0;      ///< element of the block's first one, counted over all blocks
    std::size_t count = 0;
  };
  /// One row of values per particle of a set, on the root only.
  struct Rows {
    std::vector<std::size_t> elements;  ///< counted over all blocks
    std::vector<double> values;
    std::size_t width = 0;
  };

  void lay_out(const Scene& scene, const std::vector<SlotRange>& slots);
  ExodusLayout describe(const Scene& scene, const std::string& version) const;
  void record_start(const Scene& scene, const State& state, ExodusLayout& layout);
  Rows gather_rows(const Scene& scene, const State& state, std::size_t set) const;
  void move_nodes(const Rows& rows);
  void put_block(const Scene& scene, std::size_t set, const Rows& rows);
  std::size_t element(const Block& block, ParticleId id) const;
  std::size_t node_values() const {
    return static_cast<std::size_t>(dimensions_) * static_cast<std::size_t>(nodes_);
  }

  int dimensions_ = 2;
  int nodes_ = 4;  ///< per element
  int steps_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::vector<double>> start_, displacement_;  ///< per direction, per node; root only
  std::unique_ptr<ExodusFile> file_;                       ///< root only
};

}  // namespace barreno
