// SPDX-License-Identifier: BSD-3-Clause
#include "read_rock_points.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace barreno {
namespace {

constexpr std::size_t stress_columns = 4, increment_columns = 5;

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

RecordedPoint point_of(
    const std::string& file, const std::string& line, std::size_t history_count
) {
  std::vector<double> v;
  for (const std::string& word : words_of(line.substr(line.find(',') + 1))) {
    char* end = nullptr;
    v.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0') v.push_back(NAN);  // one too many
  }
  if (v.size() != stress_columns + history_count + increment_columns)
    throw std::runtime_error(
        "'" + file + "' has a line without a number for each of its columns: '" + line +
        "'; record it again with barreno_record_rock_points."
    );
  RecordedPoint p;
  p.stress = {v[0], v[1], v[2], v[3], 0.0, 0.0};
  const auto history = v.begin() + stress_columns;
  const auto increment = history + static_cast<std::ptrdiff_t>(history_count);
  p.history.assign(history, increment);
  p.increment.strain = {increment[0], increment[1], increment[2], increment[3], 0.0, 0.0};
  p.increment.dt = increment[4];
  p.increment.volume_ratio_end = std::exp(trace(p.increment.strain));
  return p;
}

/// Names of the internal variables between stress and increment.
std::vector<std::string> history_names_of(const std::string& file, const std::string& header) {
  const std::vector<std::string> words = words_of(header);
  const std::size_t begin = 1 + stress_columns;
  if (words.size() <= begin + increment_columns || words.back() != "dt")
    throw std::runtime_error(
        "'" + file + "' has columns that are not known here: '" + header +
        "'; record it again with barreno_record_rock_points."
    );
  return {words.begin() + begin, words.end() - increment_columns};
}

}  // namespace

RecordedPoints read_rock_points(const std::string& file) {
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(
        "cannot read '" + file + "'; record it with barreno_record_rock_points."
    );
  RecordedPoints points;
  for (std::string line; std::getline(in, line);) {
    const std::string kind = line.substr(0, line.find(','));
    if (kind == "kind") {
      points.history_names = history_names_of(file, line);
      continue;
    }
    std::vector<RecordedPoint>* rows = kind == "flows"     ? &points.flowing
                                       : kind == "elastic" ? &points.elastic
                                       : kind == "hardest" ? &points.hardest
                                                           : nullptr;
    if (rows != nullptr) rows->push_back(point_of(file, line, points.history_names.size()));
  }
  return points;
}

}  // namespace barreno
