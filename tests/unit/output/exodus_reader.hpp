// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exodusII.h>
#include <gtest/gtest.h>
#undef TRUE
#undef FALSE

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// Reads back with the library's own functions.
class ExodusReader {
public:
  explicit ExodusReader(const std::filesystem::path& path) {
    int computed = 8, stored = 0;
    float version = 0.0F;
    file_ = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &computed, &stored, &version);
    EXPECT_GE(file_, 0);
    EXPECT_EQ(stored, 8);
    ex_set_max_name_length(file_, 64);
    EXPECT_EQ(ex_get_init_ext(file_, &sizes), 0);
  }
  ~ExodusReader() { ex_close(file_); }
  ExodusReader(const ExodusReader&) = delete;
  ExodusReader& operator=(const ExodusReader&) = delete;

  std::string block_name(int block) const {
    char name[65] = "";
    ex_get_name(file_, EX_ELEM_BLOCK, block, name);
    return name;
  }
  long long block_size(int block) const {
    char topology[65] = "";
    int64_t elements = 0, nodes = 0, edges = 0, faces = 0, attributes = 0;
    ex_get_block(
        file_, EX_ELEM_BLOCK, block, topology, &elements, &nodes, &edges, &faces, &attributes
    );
    return elements;
  }
  std::vector<int64_t> ids() const {
    std::vector<int64_t> ids(static_cast<std::size_t>(sizes.num_elem));
    ex_get_id_map(file_, EX_ELEM_MAP, ids.data());
    return ids;
  }
  std::vector<double> x() const {
    std::vector<double> x(static_cast<std::size_t>(sizes.num_nodes)), y = x;
    ex_get_coord(file_, x.data(), y.data(), nullptr);
    return x;
  }
  std::vector<double> element(int step, int variable, int block) const {
    std::vector<double> values(static_cast<std::size_t>(block_size(block)));
    const auto count = static_cast<int64_t>(values.size());
    ex_get_var(file_, step, EX_ELEM_BLOCK, variable, block, count, values.data());
    return values;
  }
  std::vector<double> displacement(int step, int direction) const {
    std::vector<double> values(static_cast<std::size_t>(sizes.num_nodes));
    ex_get_var(file_, step, EX_NODAL, direction + 1, 1, sizes.num_nodes, values.data());
    return values;
  }
  std::vector<double> globals(int step, int count) const {
    std::vector<double> values(static_cast<std::size_t>(count));
    ex_get_var(file_, step, EX_GLOBAL, 1, 1, count, values.data());
    return values;
  }
  /// Files of the set, files in this one, nodes, elements, blocks, then elements of each block.
  std::vector<int64_t> set() const {
    int files = 0, here = 0;
    char kind[64] = "";
    ex_get_init_info(file_, &files, &here, kind);
    int64_t nodes = 0, elements = 0, blocks = 0, node_sets = 0, side_sets = 0;
    ex_get_init_global(file_, &nodes, &elements, &blocks, &node_sets, &side_sets);
    std::vector<int64_t> found{files, here, nodes, elements, blocks};
    std::vector<int64_t> ids(static_cast<std::size_t>(blocks)), counts(ids);
    ex_get_eb_info_global(file_, ids.data(), counts.data());
    found.insert(found.end(), counts.begin(), counts.end());
    return found;
  }
  int steps() const { return static_cast<int>(ex_inquire_int(file_, EX_INQ_TIME)); }

  ex_init_params sizes{};

private:
  int file_ = -1;
};

}  // namespace barreno
