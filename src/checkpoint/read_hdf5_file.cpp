// SPDX-License-Identifier: BSD-3-Clause
#include "base/work_counts.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/hdf5_handle.hpp"
#include "files/guarded_file.hpp"

#include <algorithm>
#include <type_traits>

namespace barreno {
namespace {

herr_t note_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

/// @return the table's handle
long long Hdf5File::open_table(const std::string& name, std::size_t& rows, std::size_t& columns)
    const {
  const hid_t table = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
  if (table < 0) refuse(name + " is missing");
  const Hdf5Handle space(H5Dget_space(table), H5Sclose);
  hsize_t size[2] = {0, 0};
  if (H5Sget_simple_extent_ndims(space.get()) != 2 ||
      H5Sget_simple_extent_dims(space.get(), size, nullptr) < 0) {
    H5Dclose(table);
    refuse(name + " is not a table");
  }
  // What a table claims is believed only as far as its file has bytes: memory is taken for it.
  hsize_t bytes = 0;
  H5Fget_filesize(file_, &bytes);
  if (size[1] != 0 && size[0] > bytes / size[1]) {
    H5Dclose(table);
    refuse(name + " is larger than the file");
  }
  rows = size[0];
  columns = size[1];
  return table;
}

void Hdf5File::refuse_other_type(
    long long table, int wanted, std::size_t bytes, const std::string& name
) const {
  const Hdf5Handle type(H5Dget_type(table), H5Tclose);
  if (H5Tget_class(type.get()) != wanted)
    refuse(name + (wanted == H5T_FLOAT ? " does not hold numbers" : " does not hold integers"));
  const std::size_t found = H5Tget_size(type.get());
  if (found != bytes)
    refuse(
        name + " has numbers of " + std::to_string(found) + " bytes instead of " +
        std::to_string(bytes)
    );
}

/// Rows [first, first + count) of an open table.
void Hdf5File::read_part(
    long long table,
    long long type,
    std::size_t first,
    std::size_t count,
    void* values,
    const std::string& name
) const {
  const Hdf5Handle space(H5Dget_space(table), H5Sclose);
  hsize_t size[2] = {0, 0};
  H5Sget_simple_extent_dims(space.get(), size, nullptr);
  const hsize_t begin[2] = {first, 0}, part[2] = {count, size[1]};
  const Hdf5Handle rows(H5Screate_simple(2, part, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin, nullptr, part, nullptr) < 0 ||
      H5Dread(table, type, rows.get(), space.get(), H5P_DEFAULT, values) < 0)
    refuse(name + " does not match its checksum");
}

Hdf5Size Hdf5File::size_of(const std::string& name) const {
  Hdf5Size size;
  const Hdf5Handle table(open_table(name, size.rows, size.columns), H5Dclose);
  return size;
}

template <class T>
std::vector<T> Hdf5File::read_rows(const std::string& name, std::size_t first, std::size_t count)
    const {
  const long long type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_LLONG;
  Hdf5Size size;
  const Hdf5Handle table(open_table(name, size.rows, size.columns), H5Dclose);
  refuse_other_type(
      table.get(), std::is_same_v<T, double> ? H5T_FLOAT : H5T_INTEGER, sizeof(T), name
  );
  std::vector<T> values(count * size.columns);
  work_counts().checkpoint_bytes += static_cast<long long>(values.size() * sizeof(T));
  if (!values.empty()) read_part(table.get(), type, first, count, values.data(), name);
  return values;
}
template std::vector<double> Hdf5File::read_rows(const std::string&, std::size_t, std::size_t)
    const;
template std::vector<long long> Hdf5File::read_rows(const std::string&, std::size_t, std::size_t)
    const;

Hdf5Table<double> Hdf5File::read(const std::string& name) const {
  const Hdf5Size size = size_of(name);
  return {size.rows, size.columns, read_rows<double>(name, 0, size.rows)};
}

Hdf5Table<long long> Hdf5File::read_integers(const std::string& name) const {
  const Hdf5Size size = size_of(name);
  return {size.rows, size.columns, read_rows<long long>(name, 0, size.rows)};
}

std::string Hdf5File::read_text(const std::string& name) const {
  Hdf5Size size;
  const Hdf5Handle table(open_table(name, size.rows, size.columns), H5Dclose);
  refuse_other_type(table.get(), H5T_INTEGER, 1, name);
  std::string text(size.rows * size.columns, ' ');
  if (!text.empty()) read_part(table.get(), H5T_NATIVE_CHAR, 0, size.rows, text.data(), name);
  return text;
}

void Hdf5File::check(const std::string& name) const {
  Hdf5Size size;
  const Hdf5Handle table(open_table(name, size.rows, size.columns), H5Dclose);
  const Hdf5Handle type(H5Dget_type(table.get()), H5Tclose);
  const std::size_t most = rows_of_chunk(size.rows, size.columns);
  std::vector<char> values(most * size.columns * H5Tget_size(type.get()));
  for (std::size_t row = 0; row < size.rows && !values.empty(); row += most)
    read_part(table.get(), type.get(), row, std::min(most, size.rows - row), values.data(), name);
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  const Hdf5Handle handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (handle.failed()) refuse(group + " is missing");
  std::vector<std::string> found;
  H5Literate(handle.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note_name, &found);
  return found;
}

bool Hdf5File::has(const std::string& name) const {
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5File::is(int file) const {
  void* mine = nullptr;
  return H5Fget_vfd_handle(file_, H5P_DEFAULT, &mine) >= 0 && mine != nullptr &&
         id_of(*static_cast<int*>(mine)) == id_of(file);
}

}  // namespace barreno
