// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/hdf5_file.hpp"

#include "base/error.hpp"
#include "checkpoint/hdf5_handle.hpp"
#include "files/guarded_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace barreno {
namespace {

/// Numbers of a chunk: with all that is done to it, it stays in a core's cache.
constexpr std::size_t chunk_numbers = 1 << 17;

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
    if (file_ < 0) refuse("it cannot be created");
    write_into_memory();
  } else {
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  }
  if (file_ < 0) refuse("it is not a complete HDF5 file");
}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
  close_target();
}

/// From here on HDF5's writes go into memory, and close() copies them to the disk.
void Hdf5File::write_into_memory() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  target_ = open(path_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  const bool opened = target_ >= 0;
  const int why = errno;
  memory_ = std::make_unique<MemoryFile>();
  void* handle = nullptr;
  const bool fine = opened && !memory_->failed() &&
                    H5Fget_vfd_handle(file_, H5P_DEFAULT, &handle) >= 0 &&
                    memory_->replace(*static_cast<int*>(handle));
  if (fine) return;
  H5Fclose(file_);  // no destructor runs
  file_ = -1;
  close_target();
  refuse(opened ? "this machine has no memory for its tables" : std::strerror(why));
}

/// @return false, with errno, if the system had to report a write that failed late
bool Hdf5File::close_target() {
  const bool fine = target_ < 0 || ::close(target_) == 0;
  target_ = -1;
  return fine;
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
  if (!fine || !closed) refuse("this machine has no memory for its tables");
  if (!memory_) return;
  const bool copied = memory_->copy_to(target_);
  const int why = errno;
  memory_.reset();
  const bool kept = close_target();
  if (!copied || !kept) refuse(std::strerror(copied ? errno : why));
}

std::size_t rows_of_chunk(std::size_t rows, std::size_t columns) {
  const auto parts = [](std::size_t all, std::size_t most) { return (all + most - 1) / most; };
  const std::size_t most = chunk_numbers / std::clamp<std::size_t>(columns, 1, chunk_numbers);
  const std::size_t chunks = std::max<std::size_t>(parts(rows, most), 1);
  return std::max<std::size_t>(parts(rows, chunks), 1);
}

/// @return the table's handle
long long Hdf5File::create_table(
    const std::string& name, std::size_t rows, std::size_t columns, long long type, bool in_chunks
) {
  const hsize_t size[2] = {rows, columns};
  const hsize_t chunk[2] = {rows_of_chunk(rows, columns), std::max<hsize_t>(columns, 1)};
  const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.get(), 1);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  if (rows * columns > 0 && in_chunks) {
    H5Pset_chunk(creation.get(), 2, chunk);
    H5Pset_fletcher32(creation.get());
  } else {
    H5Pset_alloc_time(creation.get(), H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER);
  }
  const hid_t table =
      H5Dcreate2(file_, name.c_str(), type, space.get(), links.get(), creation.get(), H5P_DEFAULT);
  if (table < 0) refuse(name);
  return table;
}

void Hdf5File::put(
    const std::string& name,
    std::size_t rows,
    std::size_t columns,
    long long type,
    const void* values,
    const std::string& unit
) {
  const Hdf5Handle table(create_table(name, rows, columns, type, true), H5Dclose);
  if (!unit.empty() && !put_unit(table.get(), unit)) refuse(name);
  if (rows * columns > 0 && H5Dwrite(table.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    refuse(name);
}

template <class T>
unsigned long long Hdf5File::lay_out(
    const std::string& name, std::size_t rows, std::size_t columns, const std::string& unit
) {
  const long long type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_LLONG;
  const Hdf5Handle table(create_table(name, rows, columns, type, false), H5Dclose);
  if (!unit.empty() && !put_unit(table.get(), unit)) refuse(name);
  if (rows * columns == 0) return 0;
  const haddr_t place = H5Dget_offset(table.get());  // from the file's first byte
  if (place == HADDR_UNDEF) refuse(name);
  return place;
}
template unsigned long long
Hdf5File::lay_out<double>(const std::string&, std::size_t, std::size_t, const std::string&);
template unsigned long long
Hdf5File::lay_out<long long>(const std::string&, std::size_t, std::size_t, const std::string&);

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
