// SPDX-License-Identifier: BSD-3-Clause
#include "files/text_file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace barreno {

std::string to_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::string number_line(const char* pattern, double a, double b, double c) {
  char text[240];
  std::snprintf(text, sizeof text, pattern, a, b, c);
  return text;
}

std::string counted(double count, std::string things) {
  const std::size_t end = std::min(things.find(' '), things.size());
  if (count == 1.0 && end > 0 && things[end - 1] == 's') things.erase(end - 1, 1);
  return number_line("%.0f ", count) + things;
}

void write_into(const std::filesystem::path& path, const std::string& text) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int handle = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (handle < 0) refuse_file(path, "write");
  const bool fine = write_all(handle, text);
  const int why = errno;
  const bool closed = close(handle) == 0;
  if (!fine) errno = why;
  if (!fine || !closed) refuse_file(path, "write");
}

void write_whole_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path aside = path.string() + ".tmp";
  const int handle = create_file(aside, path);
  bool fine = write_all(handle, text);
  int why = errno;
  if (close(handle) != 0 && fine) {
    fine = false;
    why = errno;
  }
  if (fine && std::rename(aside.c_str(), path.c_str()) == 0) return;
  if (fine) why = errno;
  unlink(aside.c_str());
  errno = why;
  refuse_file(path, "write");
}

namespace {

/// Whether the first `kept` bytes are lines as a run writes them. An editor, or a copy to another
/// system, that put other ends to lines has moved all that follows them.
bool holds_lines(int handle, std::uintmax_t kept) {
  std::string part(1 << 16, '\0');
  char last = '\0';
  for (std::uintmax_t at = 0; at < kept;) {
    const std::size_t wanted = std::min<std::uintmax_t>(part.size(), kept - at);
    const ssize_t count = pread(handle, part.data(), wanted, static_cast<off_t>(at));
    if (count <= 0 || std::memchr(part.data(), '\r', static_cast<std::size_t>(count)) != nullptr)
      return false;
    last = part[static_cast<std::size_t>(count) - 1];
    at += static_cast<std::uintmax_t>(count);
  }
  return last == '\n';
}

[[noreturn]] void refuse_to_continue(const std::filesystem::path& path, const char* why) {
  throw FileError(
      "cannot continue '" + path.string() + "' (" + why +
      "); put the file back or start the run again with barreno run."
  );
}

/// A new, empty file. Nothing is followed, and a pipe does not open without a reader, instead of
/// waiting for one.
int open_new_lines(const std::filesystem::path& path) {
  constexpr mode_t mode = 0666;  // less what the user's mask forbids
  constexpr int how = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_APPEND | O_CREAT | O_TRUNC;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int handle = open(path.c_str(), how, mode);
  if (handle < 0) refuse_file(path, "create");
  return handle;
}

/// A file of that name cut to its first bytes.
int open_kept_lines(const std::filesystem::path& path, std::uintmax_t kept, bool rows) {
  constexpr int how = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_APPEND;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int handle = open(path.c_str(), how);
  if (handle < 0 && errno != ENOENT) refuse_file(path, "continue");
  struct stat found {};
  if (handle < 0 || fstat(handle, &found) != 0 ||
      static_cast<std::uintmax_t>(found.st_size) < kept) {
    if (handle >= 0) close(handle);
    refuse_to_continue(path, "it is shorter than when the checkpoint was written");
  }
  if (rows && !holds_lines(handle, kept)) {
    close(handle);
    refuse_to_continue(path, "its lines are not what the run wrote");
  }
  if (ftruncate(handle, static_cast<off_t>(kept)) == 0) return handle;
  const int why = errno;
  close(handle);
  errno = why;
  refuse_file(path, "shorten");
}

}  // namespace

LineFile::LineFile(const std::filesystem::path& path, std::uintmax_t kept, bool rows)
    : path_(path),
      bytes_(kept),
      handle_(kept == 0 ? open_new_lines(path) : open_kept_lines(path, kept, rows)),
      id_(id_of(handle_)) {}

LineFile::~LineFile() {
  close(handle_);
}

void LineFile::append(const std::string& line) {
  if (!write_all(handle_, line + '\n')) {
    const int why = errno;
    // No half line stays in a file; what went to a pipe or device cannot be undone.
    if (ftruncate(handle_, static_cast<off_t>(bytes_)) != 0) errno = why;
    errno = why;
    refuse_file(path_, "write");
  }
  bytes_ += line.size() + 1;
  refuse_if_gone(path_, id_);
}

std::string column_name(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

std::string csv_line(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) {
    if (!line.empty()) line += ',';
    line += to_text(value);
  }
  return line;
}

std::string shell_word(const std::string& path) {
  const std::string plain = "_./@%+=:,-";
  const auto is_plain = [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || plain.find(c) != std::string::npos;
  };
  // A word that begins with a dash would be an option.
  std::string word = !path.empty() && path.front() == '-' ? "./" + path : path;
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  }
  return quoted + "'";
}

std::string cut_text(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end > 0 ? end : bytes);
}

std::vector<std::string> split_lines(const std::string& text, std::size_t bytes) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    do {
      lines.push_back(cut_text(line, bytes));
      line.erase(0, lines.back().size());
    } while (!line.empty());
  }
  return lines;
}

}  // namespace barreno
