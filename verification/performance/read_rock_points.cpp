// SPDX-License-Identifier: BSD-3-Clause
#include "read_rock_points.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace barreno {
namespace {

test::RockPoint point_of(const std::string& file, const std::string& numbers) {
  double v[10];
  const int count = std::sscanf(
      numbers.c_str(),
      "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf",
      v,
      v + 1,
      v + 2,
      v + 3,
      v + 4,
      v + 5,
      v + 6,
      v + 7,
      v + 8,
      v + 9
  );
  if (count != 10)
    throw std::runtime_error(
        "'" + file + "' has a line without ten numbers: '" + numbers +
        "'; record it again with barreno_record_rock_points."
    );
  test::RockPoint p;
  p.stress = {v[0], v[1], v[2], v[3], 0.0, 0.0};
  p.history = {v[4], v[5]};
  p.increment.strain = {v[6], v[7], v[8], v[9], 0.0, 0.0};
  p.increment.volume_ratio_end = std::exp(trace(p.increment.strain));
  return p;
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
    const auto comma = line.find(',');
    const std::string kind = line.substr(0, comma);
    if (kind == "flows") points.flowing.push_back(point_of(file, line.substr(comma + 1)));
    if (kind == "elastic") points.elastic.push_back(point_of(file, line.substr(comma + 1)));
  }
  return points;
}

}  // namespace barreno
