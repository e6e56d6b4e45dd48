// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/first_fault.hpp"

#include "base/error.hpp"
#include "files/text_file.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <array>
#include <limits>

namespace barreno {
namespace {

constexpr long long nowhere = std::numeric_limits<long long>::max();

struct MetFault {
  long long row = nowhere;
  std::string words;
  bool is_of_file = false;
};

MetFault fault_in(std::size_t begin, const std::function<void()>& check) {
  try {
    check();
  } catch (const WrongTable& found) {
    return {static_cast<long long>(found.row), found.words, false};
  } catch (const FileError& error) {
    return {static_cast<long long>(begin), error.what(), true};
  }
  return {};
}

std::string broadcast_from(const Comm& comm, int rank, std::string text) {
  auto length = static_cast<int>(text.size());
  Teuchos::broadcast<int, int>(comm, rank, 1, &length);
  text.resize(static_cast<std::size_t>(length));
  if (length > 0) Teuchos::broadcast<int, char>(comm, rank, length, text.data());
  return text;
}

}  // namespace

void refuse_value(const std::string& name, std::size_t row, double value) {
  std::string words = name;
  words.append(" is ").append(to_text(value)).append(" in row ").append(std::to_string(row));
  throw WrongTable{words, row};
}

void check_together(const Comm& comm, std::size_t begin, const std::function<void()>& check) {
  const MetFault mine = fault_in(begin, check);
  std::array<long long, 1> row{mine.row};
  min_over_ranks(comm, row);
  if (row[0] == nowhere) return;
  std::array<long long, 1> rank{mine.row == row[0] ? comm.getRank() : comm.getSize()};
  min_over_ranks(comm, rank);
  const auto from = static_cast<int>(rank[0]);
  const std::string words = broadcast_from(comm, from, mine.words);
  const bool is_of_file = broadcast_from(comm, from, mine.is_of_file ? "file" : "") == "file";
  if (is_of_file) throw FileError(words);
  throw WrongTable{words, static_cast<std::size_t>(row[0])};
}

}  // namespace barreno
