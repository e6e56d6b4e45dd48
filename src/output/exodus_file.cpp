// SPDX-License-Identifier: BSD-3-Clause
#include "output/exodus_file.hpp"

#include "base/error.hpp"
#include "output/text_file.hpp"

#include <exodusII.h>
// The header defines these two words as numbers, TRUE even as -1.
#undef TRUE
#undef FALSE

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <limits>
#include <stdexcept>

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

ExodusFile::ExodusFile(
    const std::filesystem::path& path, const ExodusLayout& layout, int first_steps
)
    : path_(path), aside_(path.string() + ".tmp"), first_steps_(first_steps) {
  const auto nodes_per_element = static_cast<long long>(layout.nodes_per_element);
  long long largest_id = 0;
  for (const ExodusBlock& block : layout.blocks)
    for (const long long id : block.ids) largest_id = std::max(largest_id, id);
  int mode = EX_CLOBBER | EX_LARGE_MODEL | EX_ALL_INT64_API;
  // Ids beyond 32 bits need the netCDF-4 form, which readers must open without file locks while it
  // grows.
  if (largest_id > std::numeric_limits<int>::max() / nodes_per_element) mode |= EX_ALL_INT64_DB;
  int computed_size = 8, stored_size = 8;  // 0 would mean 4-byte reals
  ex_opts(EX_DEFAULT);
  file_ = ex_create(aside_.c_str(), mode, &computed_size, &stored_size);
  check(file_, "ex_create");
  try {
    define(layout);
  } catch (const FileError&) {
    ex_close(file_);
    std::error_code ignored;
    std::filesystem::remove(aside_, ignored);
    throw;
  }
}

ExodusFile::~ExodusFile() {
  if (file_ < 0) return;
  ex_close(file_);
  std::error_code ignored;
  if (step_ < first_steps_) std::filesystem::remove(aside_, ignored);
}

void ExodusFile::check(int code, const char* what) const {
  if (code >= 0) return;  // positive codes are warnings, such as for an empty block
  const char* message = "";
  const char* function = "";
  int number = 0;
  ex_get_err(&message, &function, &number);
  // Positive numbers are the system's, and its words tell the user more.
  const std::string words = number > 0 ? std::strerror(number) : message == nullptr ? "" : message;
  throw FileError(
      "cannot write '" + path_.string() + "' (" + what + ": " + words +
      "). Free the disk or give another place with --out."
  );
}

void ExodusFile::define(const ExodusLayout& layout) {
  check(ex_set_max_name_length(file_, static_cast<int>(name_length)), "ex_set_max_name_length");
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

  define_blocks(layout);
  define_variables(layout);
  check(ex_update(file_), "ex_update");
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
  put_ids(layout);
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
  std::vector<int> carries;
  for (const ExodusBlock& block : layout.blocks)
    for (const std::string& name : variables_)
      carries.push_back(
          std::find(block.variables.begin(), block.variables.end(), name) != block.variables.end()
      );

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
  if (variables_.empty()) return;
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

void ExodusFile::begin_step(double time) {
  check(ex_put_time(file_, step_ + 1, &time), "ex_put_time");
}

void ExodusFile::put_globals(const std::vector<double>& values) {
  const auto count = static_cast<int64_t>(values.size());
  check(ex_put_var(file_, step_ + 1, EX_GLOBAL, 1, 1, count, values.data()), "ex_put_var");
}

void ExodusFile::put_displacement(int direction, const std::vector<double>& values) {
  if (values.empty()) return;
  const auto count = static_cast<int64_t>(values.size());
  check(
      ex_put_var(file_, step_ + 1, EX_NODAL, direction + 1, 1, count, values.data()), "ex_put_var"
  );
}

int ExodusFile::index_of(const std::string& name) const {
  const auto found = std::find(variables_.begin(), variables_.end(), name);
  // The library would answer an unknown index with success and a stray variable.
  if (found == variables_.end()) throw std::logic_error("no element variable " + name);
  return static_cast<int>(found - variables_.begin()) + 1;
}

void ExodusFile::put_variable(
    std::size_t block, const std::string& name, const std::vector<double>& values
) {
  const int index = index_of(name);
  if (values.empty()) return;
  const auto count = static_cast<int64_t>(values.size());
  check(
      ex_put_var(
          file_,
          step_ + 1,
          EX_ELEM_BLOCK,
          index,
          static_cast<int64_t>(block) + 1,
          count,
          values.data()
      ),
      "ex_put_var"
  );
}

void ExodusFile::end_step() {
  check(ex_update(file_), "ex_update");
  if (++step_ != first_steps_) return;
  std::error_code error;
  std::filesystem::rename(aside_, path_, error);
  if (error) throw FileError("cannot name '" + path_.string() + "' (" + error.message() + ").");
}

void ExodusFile::close() {
  const int file = file_;
  file_ = -1;
  check(ex_close(file), "ex_close");
}

}  // namespace barreno
