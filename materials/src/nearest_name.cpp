// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace barreno::input {
namespace {

/// Case, blanks, '_' and '-' are what people get wrong first; they cost nothing.
std::string plain(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (c == ' ' || c == '_' || c == '-') continue;
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

/// Levenshtein distance: insertions, deletions and substitutions.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  // A long name from a hostile file must not cost a quadratic comparison.
  if (name.size() > 100) return {};
  std::string nearest;
  std::size_t fewest = name.size() / 3 + 1;
  for (const std::string& candidate : known) {
    if (candidate.size() > 100) continue;
    const std::size_t n = edits(plain(name), plain(candidate));
    if (n < fewest || (n == fewest && nearest.empty())) {
      fewest = n;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggest_name(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  if (!nearest.empty()) return "did you mean '" + nearest + "'?";
  if (known.empty()) return "remove it.";
  std::string list;
  for (const std::string& candidate : known) {
    list += (list.empty() ? "'" : ", '") + candidate + "'";
  }
  return "choose one of " + list + ".";
}

}  // namespace barreno::input
