// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/guarded_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// Shortest decimal text that reads back as the same double; `nan` and `inf` as such.
std::string to_text(double value);

/// Up to three numbers in a printf pattern.
std::string number_line(const char* pattern, double a, double b = 0.0, double c = 0.0);

/// A count with its things, in the plural as the first word: "1 particle removed", "2 particles
/// removed".
std::string counted(double count, std::string things);

/// Writes aside (path.tmp, whatever had that name before) and renames, so that the final name never
/// holds half a file. @throws FileError
void write_whole_file(const std::filesystem::path& path, const std::string& text);

/// Writes into a pipe or a device that is there, such as /dev/stdout. @throws FileError
void write_into(const std::filesystem::path& path, const std::string& text);

/// A text file that grows line by line, each at once in the file, so that it can be read during the
/// run.
class LineFile {
public:
  /// @param kept  bytes of a file of that name that stay, what follows them is cut off; 0: a new
  ///              file
  /// @param rows  of a table, which a changed file would tear; a log takes more lines whatever it
  /// is
  /// @throws FileError if it cannot be created, is a symbolic link, or no longer begins with so
  /// many
  ///         bytes of whole lines
  explicit LineFile(const std::filesystem::path& path, std::uintmax_t kept = 0, bool rows = true);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;
  /// @throws FileError if the line did not reach the file, or the file is no longer at its path
  void append(const std::string& line);
  std::uintmax_t bytes() const { return bytes_; }

private:
  std::filesystem::path path_;
  std::uintmax_t bytes_ = 0;
  int handle_;
  FileId id_;
};

/// The values as one line of a CSV file.
std::string csv_line(const std::vector<double>& values);

/// A name of the deck as part of a column's: letters and digits, others as '_'.
std::string column_name(std::string name);

/// A path as one word of a command line: as it is, or in quotes where a shell would take it apart.
std::string shell_word(const std::string& path);

/// At most `bytes` bytes of a text, not cut inside a UTF-8 character.
std::string cut_text(const std::string& text, std::size_t bytes);

/// A text as lines of at most `bytes` bytes.
std::vector<std::string> split_lines(const std::string& text, std::size_t bytes);

}  // namespace barreno
