// SPDX-License-Identifier: BSD-3-Clause
// What an Exodus file says once, before its first time step.
#include "files/text_file.hpp"
#include "output/exodus_file.hpp"

#include <exodusII.h>
// The header defines these two words as numbers, TRUE even as -1.
#undef TRUE
#undef FALSE

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <numeric>

namespace barreno {
namespace {

constexpr std::size_t name_length = 64;
constexpr std::size_t information_length = 80;  // longer lines are truncated by the library
constexpr std::size_t record_length = 32;       // of a QA entry; longer ones are an error
constexpr std::size_t title_length = 80;

/// The library takes non-const arrays of C strings.
class NameList {
public:
  NameList(std::vector<std::string> names, std::size_t length) : names_(std::move(names)) {
    for (std::string& name : names_) {
      name = cut_text(name, length);
      pointers_.push_back(name.data());
    }
  }
  char** data() { return pointers_.data(); }
  int size() const { return static_cast<int>(pointers_.size()); }

private:
  std::vector<std::string> names_;
  std::vector<char*> pointers_;
};

std::string now_as(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  char text[record_length];
  std::strftime(text, sizeof text, format, &parts);
  return text;
}

const char* const directions[3] = {"x", "y", "z"};

}  // namespace

void ExodusFile::define(const ExodusLayout& layout) {
  check(ex_set_max_name_length(file_, static_cast<int>(name_length)), "ex_set_max_name_length");
  put_sizes(layout);
  put_texts(layout);
  if (layout.set.files > 1) put_set(layout);
  define_blocks(layout);
  put_elements(layout);
  put_ids(layout);
  define_variables(layout);
  check(ex_update(file_), "ex_update");
}

void ExodusFile::put_sizes(const ExodusLayout& layout) {
  ex_init_params sizes;
  std::memset(&sizes, 0, sizeof sizes);
  std::snprintf(
      sizes.title, sizeof sizes.title, "%s", cut_text(layout.title, title_length).c_str()
  );
  for (const ExodusBlock& block : layout.blocks)
    sizes.num_elem += static_cast<int64_t>(block.ids.size());
  sizes.num_dim = static_cast<int64_t>(layout.coordinates.size());
  sizes.num_nodes = sizes.num_elem * layout.nodes_per_element;
  sizes.num_elem_blk = static_cast<int64_t>(layout.blocks.size());
  check(ex_put_init_ext(file_, &sizes), "ex_put_init_ext");
}

void ExodusFile::put_texts(const ExodusLayout& layout) {
  NameList record(
      {"Barreno", layout.version, now_as("%Y/%m/%d"), now_as("%H:%M:%S")}, record_length
  );
  char* records[1][4] = {{record.data()[0], record.data()[1], record.data()[2], record.data()[3]}};
  check(ex_put_qa(file_, 1, records), "ex_put_qa");
  std::vector<std::string> lines;
  for (const std::string& line : layout.information)
    for (std::string& part : split_lines(line, information_length)) lines.push_back(part);
  NameList information(lines, information_length);
  if (information.size() > 0)
    check(ex_put_info(file_, information.size(), information.data()), "ex_put_info");
  NameList axes(
      std::vector<std::string>(directions, directions + layout.coordinates.size()), name_length
  );
  check(ex_put_coord_names(file_, axes.data()), "ex_put_coord_names");
}

/// Files share no nodes: all nodes and elements are inner ones, and no file is another's neighbour.
void ExodusFile::put_set(const ExodusLayout& layout) {
  const ExodusSet& set = layout.set;
  std::vector<int64_t> blocks, counts(set.block_elements.begin(), set.block_elements.end());
  int64_t mine = 0, all = 0;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    blocks.push_back(static_cast<int64_t>(b) + 1);
    mine += static_cast<int64_t>(layout.blocks[b].ids.size());
    all += counts[b];
  }
  const int64_t per_element = layout.nodes_per_element;
  char kind[] = "p";  // one file for each rank
  check(ex_put_init_info(file_, set.files, 1, kind), "ex_put_init_info");
  check(
      ex_put_init_global(file_, all * per_element, all, static_cast<int64_t>(blocks.size()), 0, 0),
      "ex_put_init_global"
  );
  if (!blocks.empty())
    check(ex_put_eb_info_global(file_, blocks.data(), counts.data()), "ex_put_eb_info_global");
  check(
      ex_put_loadbal_param(file_, mine * per_element, 0, 0, mine, 0, 0, 0, set.file),
      "ex_put_loadbal_param"
  );
  if (mine == 0) return;
  std::vector<int64_t> inner(static_cast<std::size_t>(mine * per_element));
  std::iota(inner.begin(), inner.end(), 1);
  check(
      ex_put_processor_node_maps(file_, inner.data(), nullptr, nullptr, set.file),
      "ex_put_processor_node_maps"
  );
  check(
      ex_put_processor_elem_maps(file_, inner.data(), nullptr, set.file),
      "ex_put_processor_elem_maps"
  );
}

void ExodusFile::define_blocks(const ExodusLayout& layout) {
  const bool points = layout.topology == "SPHERE";
  std::vector<std::string> names;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    names.push_back(layout.blocks[b].name);
    const auto count = static_cast<int64_t>(layout.blocks[b].ids.size());
    check(
        ex_put_block(
            file_,
            EX_ELEM_BLOCK,
            static_cast<int64_t>(b) + 1,
            layout.topology.c_str(),
            count,
            layout.nodes_per_element,
            0,
            0,
            points ? 1 : 0
        ),
        "ex_put_block"
    );
  }
  NameList block_names(names, name_length);
  check(ex_put_names(file_, EX_ELEM_BLOCK, block_names.data()), "ex_put_names");
}

void ExodusFile::put_elements(const ExodusLayout& layout) {
  const bool points = layout.topology == "SPHERE";
  const auto& x = layout.coordinates;
  if (!x[0].empty()) {
    const double* z = x.size() > 2 ? x[2].data() : nullptr;
    check(ex_put_coord(file_, x[0].data(), x[1].data(), z), "ex_put_coord");
  }
  int64_t node = 1;
  std::size_t element = 0;
  NameList attribute({"radius"}, name_length);
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const std::size_t count = layout.blocks[b].ids.size();
    if (count == 0) continue;
    const auto block = static_cast<int64_t>(b) + 1;
    std::vector<int64_t> nodes(count * static_cast<std::size_t>(layout.nodes_per_element));
    for (int64_t& n : nodes) n = node++;
    check(ex_put_conn(file_, EX_ELEM_BLOCK, block, nodes.data(), nullptr, nullptr), "ex_put_conn");
    if (points) {
      check(ex_put_attr(file_, EX_ELEM_BLOCK, block, &layout.radius[element]), "ex_put_attr");
      check(ex_put_attr_names(file_, EX_ELEM_BLOCK, block, attribute.data()), "ex_put_attr_names");
    }
    element += count;
  }
}

void ExodusFile::put_ids(const ExodusLayout& layout) {
  // Persistent ids: readers and comparison tools match particles and corners by them.
  std::vector<int64_t> elements, nodes;
  for (const ExodusBlock& block : layout.blocks) {
    for (const long long id : block.ids) {
      elements.push_back(id);
      for (int a = 0; a < layout.nodes_per_element; ++a)
        nodes.push_back(layout.nodes_per_element * (id - 1) + a + 1);
    }
  }
  if (elements.empty()) return;
  check(ex_put_id_map(file_, EX_ELEM_MAP, elements.data()), "ex_put_id_map");
  check(ex_put_id_map(file_, EX_NODE_MAP, nodes.data()), "ex_put_id_map");
}

void ExodusFile::define_variables(const ExodusLayout& layout) {
  for (const ExodusBlock& block : layout.blocks)
    for (const std::string& name : block.variables)
      if (std::find(variables_.begin(), variables_.end(), name) == variables_.end())
        variables_.push_back(name);
  const auto put_names = [&](ex_entity_type type, const std::vector<std::string>& names) {
    if (names.empty()) return;
    NameList list(names, name_length);
    check(ex_put_variable_param(file_, type, list.size()), "ex_put_variable_param");
    check(ex_put_variable_names(file_, type, list.size(), list.data()), "ex_put_variable_names");
  };
  put_names(EX_GLOBAL, layout.global_variables);
  // Names of nodal variables are an error in a file without nodes.
  if (!layout.coordinates[0].empty()) {
    std::vector<std::string> displacements;
    for (std::size_t d = 0; d < layout.coordinates.size(); ++d)
      displacements.push_back(std::string("displacement_") + directions[d]);
    put_names(EX_NODAL, displacements);
  }
  put_names(EX_ELEM_BLOCK, variables_);
  if (!variables_.empty()) put_truth_table(layout);
}

void ExodusFile::put_truth_table(const ExodusLayout& layout) {
  std::vector<int> carries;
  for (const ExodusBlock& block : layout.blocks)
    for (const std::string& name : variables_)
      carries.push_back(
          std::find(block.variables.begin(), block.variables.end(), name) != block.variables.end()
      );
  check(
      ex_put_truth_table(
          file_,
          EX_ELEM_BLOCK,
          static_cast<int>(layout.blocks.size()),
          static_cast<int>(variables_.size()),
          carries.data()
      ),
      "ex_put_truth_table"
  );
}

}  // namespace barreno
