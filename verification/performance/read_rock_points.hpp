// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"

#include <algorithm>
#include <barreno/history_values.hpp>
#include <string>
#include <vector>

namespace barreno {

/// A recorded point update, see record_rock_points.cpp: the state before it and its increment.
struct RecordedPoint {
  Increment increment{};
  Sym3 stress;
  std::vector<double> history;  ///< in the order of the table's columns
};
struct RecordedPoints {
  std::vector<std::string> history_names;
  std::vector<RecordedPoint> flowing, elastic, hardest;
};

/// @throws std::runtime_error if there is no such file or a line is not as it was written
RecordedPoints read_rock_points(const std::string& file);

/// Recorded points as a model has them: internal variables by name; those that were not recorded
/// have the values of virgin rock.
template <class Model>
std::vector<test::PointOf<Model>> points_of(
    const Model& model,
    const std::vector<std::string>& names,
    const std::vector<RecordedPoint>& recorded
) {
  std::vector<test::PointOf<Model>> points;
  const std::vector<HistoryField> table = Model::history_table();
  for (const RecordedPoint& from : recorded) {
    test::PointOf<Model> p{from.increment, from.stress, model.initial_history()};
    for (std::size_t c = 0; c < table.size(); ++c) {
      const auto found = std::find(names.begin(), names.end(), table[c].name);
      if (found != names.end())
        history_values<Model>(p.history)[c] =
            from.history[static_cast<std::size_t>(found - names.begin())];
    }
    points.push_back(p);
  }
  return points;
}

}  // namespace barreno
