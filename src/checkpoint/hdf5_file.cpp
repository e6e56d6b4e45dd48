// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/hdf5_file.hpp"

#include "base/error.hpp"
#include "checkpoint/fletcher32.hpp"
#include "checkpoint/hdf5_handle.hpp"
#include "output/guarded_file.hpp"

#include <algorithm>
#include <cstring>
#include <fcntl.h>

namespace barreno {
namespace {

/// Numbers of a chunk: with all that is done to it, it stays in a core's cache.
constexpr std::size_t chunk_numbers = 1 << 17;
/// Written bytes that are worth to be handed to the disk.
constexpr std::size_t flush_bytes = 1 << 23;

bool put_unit(hid_t table, const std::string& unit) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), unit.size() + 1);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      H5Acreate2(table, "unit", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose
  );
  return !attribute.failed() && H5Awrite(attribute.get(), type.get(), unit.c_str()) >= 0;
}

}  // namespace

Hdf5File::Hdf5File(const std::filesystem::path& path, Mode mode)
    : path_(path), writes_(mode == Mode::create) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the sentence says it
  if (writes_) {
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_userblock(creation.get(), user_block);
    remove_leftover(path);  // a link of that name would be followed; a new file follows none
    file_ = H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.get(), H5P_DEFAULT);
  } else {
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  }
  if (file_ < 0) refuse(writes_ ? "it cannot be created" : "it is not a complete HDF5 file");
}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::refuse(const std::string& what) const {
  const std::string words = std::string("cannot ") + (writes_ ? "write" : "read") +
                            " the checkpoint '" + path_.string() + "' (" + what + ")";
  throw FileError(
      words + (writes_ ? "; free disk space or choose another folder with --out."
                       : "; the one before it is checkpoint_previous.h5.")
  );
}

void Hdf5File::close() {
  const bool fine = H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0;
  const bool closed = H5Fclose(file_) >= 0;
  file_ = -1;
  if (!fine || !closed) refuse("the disk did not accept all of it");
}

std::size_t rows_of_chunk(std::size_t rows, std::size_t columns) {
  const auto parts = [](std::size_t all, std::size_t most) { return (all + most - 1) / most; };
  const std::size_t most = chunk_numbers / std::clamp<std::size_t>(columns, 1, chunk_numbers);
  const std::size_t chunks = std::max<std::size_t>(parts(rows, most), 1);
  return std::max<std::size_t>(parts(rows, chunks), 1);
}

/// @return the table's handle
long long Hdf5File::create_table(
    const std::string& name,
    std::size_t rows,
    std::size_t columns,
    long long type,
    const std::string& unit
) {
  const hsize_t size[2] = {rows, columns};
  const hsize_t chunk[2] = {rows_of_chunk(rows, columns), std::max<hsize_t>(columns, 1)};
  const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.get(), 1);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  if (rows * columns > 0) {
    H5Pset_chunk(creation.get(), 2, chunk);
    H5Pset_fletcher32(creation.get());
  }
  const hid_t table =
      H5Dcreate2(file_, name.c_str(), type, space.get(), links.get(), creation.get(), H5P_DEFAULT);
  if (table >= 0 && (unit.empty() || put_unit(table, unit))) return table;
  if (table >= 0) H5Dclose(table);
  refuse(name);
}

void Hdf5File::put(
    const std::string& name,
    std::size_t rows,
    std::size_t columns,
    long long type,
    const void* values,
    const std::string& unit
) {
  const Hdf5Handle table(create_table(name, rows, columns, type, unit), H5Dclose);
  if (rows * columns > 0 && H5Dwrite(table.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    refuse(name);
}

template <class T>
void Hdf5File::begin_table(
    const std::string& name, std::size_t rows, std::size_t columns, const std::string& unit
) {
  const long long type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_LLONG;
  const Hdf5Handle table(create_table(name, rows, columns, type, unit), H5Dclose);
}
template void
Hdf5File::begin_table<double>(const std::string&, std::size_t, std::size_t, const std::string&);
template void
Hdf5File::begin_table<long long>(const std::string&, std::size_t, std::size_t, const std::string&);

template <class T>
void Hdf5File::write_chunk(const std::string& name, std::size_t row, std::vector<T>& chunk) {
  const std::size_t bytes = (chunk.size() - 1) * sizeof(T);
  const std::uint32_t checksum = fletcher32(chunk.data(), bytes);
  std::memcpy(&chunk.back(), &checksum, sizeof checksum);
  const hsize_t place[2] = {row, 0};
  const Hdf5Handle table(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (table.failed() ||
      H5Dwrite_chunk(table.get(), H5P_DEFAULT, 0, place, bytes + sizeof checksum, chunk.data()) < 0)
    refuse(name);
  unflushed_ += bytes;
  if (unflushed_ >= flush_bytes) begin_flush();
}
template void Hdf5File::write_chunk<double>(const std::string&, std::size_t, std::vector<double>&);
template void
Hdf5File::write_chunk<long long>(const std::string&, std::size_t, std::vector<long long>&);

/// The disk takes what is written while more is gathered. This keeps nothing safe (fsync in
/// seal_checkpoint does, and has less to wait for), so nothing is lost where it cannot be had.
void Hdf5File::begin_flush() {
  unflushed_ = 0;
#ifdef SYNC_FILE_RANGE_WRITE
  void* file = nullptr;
  if (H5Fget_vfd_handle(file_, H5P_DEFAULT, &file) >= 0 && file != nullptr)
    sync_file_range(*static_cast<int*>(file), 0, 0, SYNC_FILE_RANGE_WRITE);
#endif
}

void Hdf5File::write(
    const std::string& name, const Hdf5Table<double>& table, const std::string& unit
) {
  put(name, table.rows, table.columns, H5T_NATIVE_DOUBLE, table.values.data(), unit);
}

void Hdf5File::write(const std::string& name, const Hdf5Table<long long>& table) {
  put(name, table.rows, table.columns, H5T_NATIVE_LLONG, table.values.data(), "");
}

void Hdf5File::write(const std::string& name, const std::string& text) {
  put(name, text.size(), 1, H5T_NATIVE_CHAR, text.data(), "");
}

}  // namespace barreno
