// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rank_work.hpp"
#include "output/exodus_file.hpp"
#include "output/file_shares.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

#include <memory>

namespace barreno {

/// What of an old particles.e, or of its set, stays when a run is resumed.
struct KeptFields {
  int steps = 0;  ///< time steps
  int files = 0;
};

/// particles.e: every particle an element, a block per material, elements sorted by particle id.
///
/// Every particle of the run owns its place from the start. `status` is 1 while the particle exists
/// and 0 before its launch and after its removal; then all other variables are 0, and the corners
/// stay where they were last seen. Corners of a particle that did not exist at the start have their
/// initial coordinates on the axis in the launch plane.
///
/// One file is written by rank 0. With "one per rank" there are as many as the run began with
/// ranks, each with its share of the ids (see FileShares), and each rank writes its own. Particles
/// are brought to the ranks that write them.
class ExodusWriter {
public:
  /// @param ranges       all particles that the run has or will have, see particle_id_ranges
  /// @param state        at the start; where files go on, at any time
  /// @param information lines kept in the files' information records
  ExodusWriter(
      const Scene& scene,
      const std::vector<IdRange>& ranges,
      const State& state,
      const std::filesystem::path& path,
      const std::string& version,
      const std::vector<std::string>& information,
      const KeptFields& kept = {}
  );
  /// Appends the state as a time step. Collective. @throws FileError on every rank
  void write(const Scene& scene, const State& state);
  void close(const Comm& comm);
  int steps() const { return steps_; }  ///< in each file
  int files() const { return shares_.files; }

private:
  /// A file that this rank writes.
  struct OpenFile {
    int number = 0;                  ///< among the files
    std::vector<std::size_t> begin;  ///< first element of each block, then the number of all
    std::vector<std::vector<double>> start, displacement;  ///< per direction, per node
    std::unique_ptr<ExodusFile> file;
  };
  /// Rows of values of a set's particles, for the files of this rank.
  struct Rows {
    struct Row {
      std::size_t element;  ///< counted over the file's blocks
      std::size_t begin;    ///< of its values
    };
    std::vector<double> values;
    std::vector<std::vector<Row>> of_file;  ///< as open_files_
  };

  void open_files(
      const std::filesystem::path& path, const std::vector<ExodusLayout>& layouts, int kept
  );
  OpenFile open_file(int file) const;
  ExodusLayout describe(const Scene& scene, const std::string& version) const;
  ExodusLayout layout_of(const OpenFile& open, const ExodusLayout& common) const;
  std::vector<ExodusLayout> record_start(
      const Scene& scene, const State& state, const ExodusLayout& common
  );
  std::vector<ExodusLayout> read_start(
      const Comm& comm, const std::filesystem::path& path, const ExodusLayout& common
  );
  std::vector<std::string> variables(const Scene& scene, std::size_t set) const;
  /// Values of a particle on their way, see pack_rows.
  std::size_t row_width(const Scene& scene, std::size_t set) const;
  std::vector<double> pack_rows(
      const Scene& scene,
      const State& state,
      const std::vector<double>& tile_steps,
      std::size_t set,
      std::vector<int>& counts
  ) const;
  Rows bring_rows(
      const Scene& scene, const State& state, const std::vector<double>& tile_steps, std::size_t set
  ) const;
  void move_nodes(const Rows& rows, std::size_t h);
  void put_block(const Scene& scene, std::size_t set, const Rows& rows, std::size_t h);
  void end_step(const State& state, double present);
  std::size_t node_values() const {
    return static_cast<std::size_t>(dimensions_) * static_cast<std::size_t>(nodes_);
  }

  int dimensions_ = 2;
  int nodes_ = 4;  ///< per element
  int steps_ = 0;
  FileShares shares_;
  std::vector<OpenFile> open_files_;  ///< ascending, without a gap
};

}  // namespace barreno
