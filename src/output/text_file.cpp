// SPDX-License-Identifier: BSD-3-Clause
#include "output/text_file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace barreno {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* verb) {
  const std::string why = errno == 0 ? "the disk may be full" : std::strerror(errno);
  throw FileError(
      std::string("cannot ") + verb + " '" + path.string() + "' (" + why +
      "). Free the disk or give another place with --out."
  );
}

}  // namespace

std::string to_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::string number_line(const char* pattern, double a, double b, double c) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, a, b, c);
  return text;
}

void write_whole_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path aside = path.string() + ".tmp";
  errno = 0;
  std::ofstream stream(aside, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  std::error_code ignored;
  if (!stream) {
    const int why = errno;
    std::filesystem::remove(aside, ignored);
    errno = why;
    refuse(path, "write");
  }
  std::error_code error;
  std::filesystem::rename(aside, path, error);
  if (!error) return;
  std::filesystem::remove(aside, ignored);
  errno = error.value();
  refuse(path, "write");
}

LineFile::LineFile(const std::filesystem::path& path, std::uintmax_t kept)
    : path_(path), bytes_(kept) {
  errno = 0;
  if (kept == 0) {
    stream_.open(path, std::ios::binary | std::ios::trunc);
  } else {
    std::error_code error;
    if (std::filesystem::file_size(path, error) < kept || error)
      throw FileError(
          "cannot go on with '" + path.string() +
          "' (it is shorter than when the checkpoint was written); put the file back or start the "
          "run again with barreno run."
      );
    std::filesystem::resize_file(path, kept, error);
    if (error) refuse(path_, "shorten");
    stream_.open(path, std::ios::binary | std::ios::app);
  }
  if (!stream_) refuse(path_, "create");
}

void LineFile::append(const std::string& line) {
  errno = 0;
  stream_ << line << '\n' << std::flush;
  if (!stream_) refuse(path_, "write");
  bytes_ += line.size() + 1;
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
  const std::string word = !path.empty() && path.front() == '-' ? "./" + path : path;
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
