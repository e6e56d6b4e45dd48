// SPDX-License-Identifier: BSD-3-Clause
#include "output/exodus_file.hpp"

#include "base/error.hpp"

#include <exodusII.h>
// The header defines these two words as numbers, TRUE even as -1.
#undef TRUE
#undef FALSE

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace barreno {

ExodusFile::ExodusFile(
    const std::filesystem::path& path, const ExodusLayout& layout, int first_steps
)
    : path_(path), aside_(path.string() + ".tmp"), first_steps_(first_steps) {
  create(layout);
  try {
    define(layout);
  } catch (const FileError&) {
    ex_close(file_);
    std::error_code ignored;
    std::filesystem::remove(aside_, ignored);
    throw;
  }
}

void ExodusFile::create(const ExodusLayout& layout) {
  const auto nodes_per_element = static_cast<long long>(layout.nodes_per_element);
  int mode = EX_NOCLOBBER | EX_LARGE_MODEL | EX_ALL_INT64_API;
  // Ids beyond 32 bits need the netCDF-4 form, which readers must open without file locks while it
  // grows.
  if (layout.largest_id > std::numeric_limits<int>::max() / nodes_per_element)
    mode |= EX_ALL_INT64_DB;
  int computed_size = 8, stored_size = 8;  // 0 would mean 4-byte reals
  ex_opts(EX_DEFAULT);
  remove_leftover(aside_);  // the library would follow a link of that name; a new file follows none
  file_ = ex_create(aside_.c_str(), mode, &computed_size, &stored_size);
  check(file_, "ex_create");
  id_ = id_of(aside_);
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
      "). Free disk space or choose another folder with --out."
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
  refuse_if_gone(step_ < first_steps_ ? aside_ : path_, id_);
  if (++step_ != first_steps_) return;
  std::error_code error;
  std::filesystem::rename(aside_, path_, error);
  if (error)
    throw FileError(
        "cannot rename the temporary file of '" + path_.string() + "' (" + error.message() + ")."
    );
}

void ExodusFile::close() {
  const int file = file_;
  file_ = -1;
  check(ex_close(file), "ex_close");
}

}  // namespace barreno
