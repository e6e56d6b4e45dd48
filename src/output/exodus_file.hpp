// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/guarded_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// One element block: its elements' ids and the names of the variables that it carries.
struct ExodusBlock {
  std::string name;
  std::vector<long long> ids;  ///< positive, ascending
  std::vector<std::string> variables;
};

/// What a file says of the set that it belongs to: the information of Nemesis, by which ParaView
/// and epu take its files as one. Files of a set share no nodes.
struct ExodusSet {
  int files = 1;                          ///< 1: a file by itself, which does not state it
  int file = 0;                           ///< from 0
  std::vector<long long> block_elements;  ///< in all files
};

/// All that stays the same during a run. Elements share no nodes: node a of an element is entry
/// `element * nodes_per_element + a` of the nodal arrays, elements counted block after block.
struct ExodusLayout {
  std::string title;
  std::string version;   ///< of the code
  std::string topology;  ///< QUAD4, HEX8 or SPHERE
  int nodes_per_element = 4;
  std::vector<std::vector<double>> coordinates;  ///< one array per direction: x, y and perhaps z
  std::vector<double> radius;                    ///< per element, SPHERE only
  std::vector<ExodusBlock> blocks;
  std::vector<std::string> global_variables;
  std::vector<std::string> information;  ///< lines of any length
  long long largest_id = 0;              ///< of all files of the set
  ExodusSet set;
};

/// An Exodus II file that is being written: 64-bit offsets, 8-byte reals, readable while it grows.
///
/// The file gets its final name when its first time steps are complete.
/// Every function throws FileError with Exodus' own words if it fails.
class ExodusFile {
public:
  /// @param first_steps  so many that the file is of use: one, or those of an old file of that name
  ExodusFile(const std::filesystem::path& path, const ExodusLayout& layout, int first_steps = 1);
  ~ExodusFile();
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  void begin_step(double time);
  void put_globals(const std::vector<double>& values);
  void put_displacement(int direction, const std::vector<double>& values);
  void put_variable(std::size_t block, const std::string& name, const std::vector<double>& values);
  /// The place of an element variable among all, from 1.
  int index_of(const std::string& name) const;
  /// The step is on disk when this returns.
  void end_step();
  void close();

private:
  void create(const ExodusLayout& layout);
  void define(const ExodusLayout& layout);
  void put_sizes(const ExodusLayout& layout);
  void put_texts(const ExodusLayout& layout);
  void put_set(const ExodusLayout& layout);
  void define_blocks(const ExodusLayout& layout);
  void put_elements(const ExodusLayout& layout);
  void define_variables(const ExodusLayout& layout);
  void put_truth_table(const ExodusLayout& layout);
  void put_ids(const ExodusLayout& layout);
  void check(int code, const char* what) const;

  std::filesystem::path path_, aside_;
  FileId id_;
  int file_ = -1;
  int step_ = 0, first_steps_;
  std::vector<std::string> variables_;  ///< of all blocks, in the order of the file
};

}  // namespace barreno
