// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/memory_file.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace barreno {

/// Length of the block before HDF5's own bytes, where seal_checkpoint() writes (H5Pset_userblock).
inline constexpr std::size_t user_block = 512;

struct Hdf5Size {
  std::size_t rows = 0, columns = 0;
};

/// A table of numbers, row after row.
template <class T>
struct Hdf5Table {
  std::size_t rows = 0, columns = 1;
  std::vector<T> values;
};

/// Rows of a chunk, the unit of checksums, writing and reading: as even as 1 MB of numbers allows.
std::size_t rows_of_chunk(std::size_t rows, std::size_t columns);

/// An HDF5 file of plain tables that one process writes or reads. Tables that it
/// writes have the fletcher32 checksum, which HDF5 compares when it reads.
///
/// Every function throws FileError with the path and the table's name if it fails.
class Hdf5File {
public:
  enum class Mode { create, read };
  Hdf5File(const std::filesystem::path& path, Mode mode);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Groups on the way are made. @param unit  kept as the attribute "unit"
  void write(const std::string& name, const Hdf5Table<double>& table, const std::string& unit);
  void write(const std::string& name, const Hdf5Table<long long>& table);
  void write(const std::string& name, const std::string& text);

  /// Makes room for a table of double or long long in one piece, without a checksum; its rows are
  /// written once this file is closed (RowFile). @return where in the file they begin, in bytes
  template <class T>
  unsigned long long lay_out(
      const std::string& name, std::size_t rows, std::size_t columns, const std::string& unit
  );

  Hdf5Table<double> read(const std::string& name) const;
  Hdf5Table<long long> read_integers(const std::string& name) const;
  Hdf5Size size_of(const std::string& name) const;
  /// So many rows of a table of double or long long.
  template <class T>
  std::vector<T> read_rows(const std::string& name, std::size_t first, std::size_t count) const;
  std::string read_text(const std::string& name) const;
  /// Reads a table chunk by chunk and keeps nothing: HDF5 compares the checksums.
  void check(const std::string& name) const;
  /// Names of what lies in a group, sorted.
  std::vector<std::string> names(const std::string& group) const;
  bool has(const std::string& name) const;
  /// Whether it is the same file as one that is open under this handle of the system.
  bool is(int file) const;

  /// Brings a new file to the disk: all is handed to the system when this returns. Without it, the
  /// file on the disk stays empty.
  void close();

private:
  void write_into_memory();
  bool close_target();
  [[noreturn]] void refuse(const std::string& what) const;
  /// @throws FileError for a table that has not two dimensions, or more numbers than its file
  long long open_table(const std::string& name, std::size_t& rows, std::size_t& columns) const;
  /// @throws FileError for a table whose numbers are not of this class, H5T_INTEGER or H5T_FLOAT,
  ///         or of another length
  void refuse_other_type(long long table, int wanted, std::size_t bytes, const std::string& name)
      const;
  void read_part(
      long long table,
      long long type,
      std::size_t first,
      std::size_t count,
      void* values,
      const std::string& name
  ) const;
  long long create_table(
      const std::string& name, std::size_t rows, std::size_t columns, long long type, bool in_chunks
  );
  void put(
      const std::string& name,
      std::size_t rows,
      std::size_t columns,
      long long type,
      const void* values,
      const std::string& unit
  );

  std::filesystem::path path_;
  bool writes_;
  int target_ = -1;                     ///< the file on the disk, while it is written
  std::unique_ptr<MemoryFile> memory_;  ///< what HDF5 writes into
  long long file_ = -1;                 ///< HDF5's handle
};

}  // namespace barreno
