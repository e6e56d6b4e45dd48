// SPDX-License-Identifier: BSD-3-Clause
// What every form of Arenisca costs against its error, over updates recorded from perforations:
//
//   barreno_feature_cost CARD DRY WET ANGLED ANGLED_WET GUDEHUS GUDEHUS_WET MOHR MOHR_WET DAMAGED
//   CRACKED HEATED HEATED_WET [CSV]
//
// for dry, wet, scattering, rate-dependent rock, with each third invariant, for cards with damage
// and heat, which lie beside CARD, and for the forms for comparison; over the tolerance. DRY and
// the others are files of points; forms with a third invariant, damage or heat update points that
// were recorded with the same (ANGLED: Willam-Warnke).
#include "rock_forms.hpp"
#include "rock_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace barreno {
namespace {

/// Points of which the forms for comparison, which are slow, are measured.
constexpr std::size_t few = 256;

/// Whether a model's update goes in lanes.
template <class Model, class = void>
inline constexpr bool in_lanes = false;
template <class Model>
inline constexpr bool in_lanes<Model, std::enable_if_t<(Model::groups_together > 0)>> = true;

/// One line of the table: a form with a tolerance.
struct Row {
  RockForm form;
  double tolerance = 0.0;
  std::string model;  ///< its name with that of the form
  double mean_error = 0.0, error_of_99_percent = 0.0, largest_error = 0.0;
  double substeps = 0.0;
  int failed = 0;  ///< updates that ran out of substeps; they have no error
  double single = HUGE_VAL, lanes = HUGE_VAL, elastic = HUGE_VAL;  ///< per update [ns]
  double slowest = 0.0;  ///< the dearest single update [ns]
  int substeps_of_slowest = 0;
};

template <class Model>
std::vector<test::PointOf<Model>> first_of(
    const Model& model,
    const RecordedPoints& from,
    const std::vector<RecordedPoint>& kind,
    std::size_t most
) {
  const auto end = kind.begin() + static_cast<std::ptrdiff_t>(std::min(kind.size(), most));
  return points_for(model, from.history_names, {kind.begin(), end});
}
/// As many points as a model is measured with.
template <class Model>
std::vector<test::PointOf<Model>> some_of(
    const Model& model, const RecordedPoints& from, const std::vector<RecordedPoint>& kind
) {
  return first_of(model, from, kind, in_lanes<Model> ? kind.size() : few);
}

/// Where updates end that are as exact as can be: a small tolerance, of the smallest ones that do
/// not run out of substeps.
template <class Point>
struct Exact {
  Point end;
  double tolerance = HUGE_VAL;  ///< infinite: none was found
};
template <class Model>
std::vector<Exact<test::PointOf<Model>>> exact_ends(
    const std::string& card, const RockForm& form, const std::vector<test::PointOf<Model>>& points
) {
  std::vector<Exact<test::PointOf<Model>>> ends(points.size());
  for (const double tolerance : {1e-8, 1e-7, 1e-6, 1e-5}) {
    const Material material = make_form(card, form, tolerance);
    const auto& model = std::get<Model>(material.model);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (ends[i].tolerance < HUGE_VAL) continue;
      test::PointOf<Model> end = points[i];
      if (model.update(end.increment, end.stress, end.history).failed()) continue;
      ends[i] = {end, tolerance};
    }
  }
  return ends;
}

template <class Model>
double effective_size(const test::PointOf<Model>& p) {
  return norm(p.stress + isotropic(PressureIn<typename Model::History>::of(p.history)));
}

/// Errors of the stress, relative to the larger of the effective stresses before and after and the
/// floor of the law's own error control.
template <class Model>
void measure_errors(
    const Model& model,
    const std::vector<test::PointOf<Model>>& points,
    const std::vector<Exact<test::PointOf<Model>>>& exact,
    Row& row
) {
  constexpr double finer = 0.2;  // than the tolerance that is judged
  const double floor = Arenisca(model.parameters(), 1.0).rock().stress_floor;
  std::vector<double> errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    test::PointOf<Model> end = points[i];
    const Outcome outcome = model.update(end.increment, end.stress, end.history);
    row.substeps += outcome.substeps / static_cast<double>(points.size());
    row.failed += outcome.failed() ? 1 : 0;
    if (outcome.failed() || exact[i].tolerance > finer * row.tolerance) continue;
    const double size = std::max({floor, effective_size(points[i]), effective_size(exact[i].end)});
    errors.push_back(norm(end.stress - exact[i].end.stress) / size);
  }
  if (errors.empty()) return;
  for (const double e : errors) row.mean_error += e / static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  row.error_of_99_percent = errors[errors.size() * 99 / 100];
  row.largest_error = errors.back();
}

/// The dearest update of one point, of which each has the least time of several runs.
template <class Model>
void find_slowest(
    const Model& model, const std::vector<test::PointOf<Model>>& points, int runs, Row& row
) {
  double sum = 0.0;
  for (const auto& p : points) {
    int substeps = 0;
    const double time = min_time(runs, [&] {
      auto stress = p.stress;
      auto history = p.history;
      substeps = model.update(p.increment, stress, history).substeps;
      sum += stress.xx;
    });
    if (time <= row.slowest) continue;
    row.slowest = time;
    row.substeps_of_slowest = substeps;
  }
  read_sum(sum);
}

/// The rows of a form, which are next to each other: errors, and the dearest update.
template <class Model>
void judge(
    const Model& any_tolerance,
    const std::string& card,
    const RecordedPoints& recorded,
    Row* rows,
    std::size_t count
) {
  const auto points = some_of(any_tolerance, recorded, recorded.flowing);
  const auto hardest = first_of(any_tolerance, recorded, recorded.hardest, few);
  const auto exact = exact_ends<Model>(card, rows[0].form, points);
  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    const Material material = make_form(card, row.form, row.tolerance);
    const auto& model = std::get<Model>(material.model);
    row.model = FullName<Model>::of();
    measure_errors(model, points, exact, row);
    constexpr double worth = 1e-4;
    const int runs = in_lanes<Model> && row.tolerance >= worth ? 15 : 3;
    find_slowest(model, points, runs, row);
    find_slowest(model, hardest, runs, row);
  }
}

/// Times per update, each the least of what it was and of some more runs.
template <class Model>
void measure_times(const Model& model, const RecordedPoints& recorded, Row& row) {
  const int runs = row.tolerance >= 1e-3 ? 15 : row.tolerance >= 1e-5 ? 4 : 1;
  const auto points = some_of(model, recorded, recorded.flowing);
  const auto elastic = some_of(model, recorded, recorded.elastic);
  if constexpr (in_lanes<Model>) {
    row.single = std::min(row.single, cost_of_single_points(model, points, runs).nanoseconds);
    row.lanes = std::min(row.lanes, cost_in_lanes(model, points, runs));
    row.elastic = std::min(row.elastic, cost_in_lanes(model, elastic, runs));
  } else {
    row.single = std::min(row.single, cost_of_single_points(model, points, 1).nanoseconds);
    row.elastic = std::min(row.elastic, cost_of_single_points(model, elastic, 3).nanoseconds);
  }
}

/// Calls f with the model of a row.
template <class F>
void with_model(const std::string& card, const Row& row, const F& f) {
  const Material material = make_form(card, row.form, row.tolerance);
  std::visit(
      [&](const auto& model) {
        if constexpr (is_arenisca<std::decay_t<decltype(model)>>) f(model);
      },
      material.model
  );
}

constexpr double tolerances[] = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5, 1e-6};

/// All forms, each over the tolerance.
std::vector<Row> rows_to_measure() {
  std::vector<Row> rows;
  for (const RockForm& form : rock_forms())
    for (const double tolerance : tolerances) {
      Row row;
      row.form = form;
      row.tolerance = tolerance;
      rows.push_back(row);
    }
  return rows;
}

void print_row(std::FILE* out, const char* format, const Row& r) {
  const bool lanes = r.lanes < HUGE_VAL;
  std::fprintf(
      out,
      format,
      r.form.name.c_str(),
      r.model.c_str(),
      words_of(r.form).c_str(),
      r.tolerance,
      r.mean_error,
      r.error_of_99_percent,
      r.largest_error,
      r.substeps,
      r.failed,
      r.single,
      lanes ? r.lanes : r.single,
      r.elastic,
      r.slowest,
      r.substeps_of_slowest
  );
}

/// Recorded points, and what a table calls them.
struct PointsFile {
  std::string name;
  const char* file;
  RecordedPoints points;
};

int write_csv(
    const char* file,
    const std::string& card,
    const std::vector<PointsFile>& files,
    const std::vector<Row>& rows
) {
  std::FILE* out = std::fopen(file, "w");
  if (out == nullptr) {
    std::cerr << "cannot write '" << file << "'; check that its folder exists.\n";
    return 2;
  }
  std::fprintf(out, "# card: %s\n", card.c_str());
  for (const PointsFile& f : files)
    std::fprintf(
        out,
        "# %s points: %zu that flow, %zu elastic, %zu hardest\n",
        f.name.c_str(),
        f.points.flowing.size(),
        f.points.elastic.size(),
        f.points.hardest.size()
    );
  std::fprintf(
      out,
      "form;model;card;tolerance;mean_error;error_of_99_percent;largest_error;substeps;failed;"
      "ns_single;ns_lanes;ns_elastic;ns_slowest;substeps_of_slowest\n"
  );
  for (const Row& row : rows)
    print_row(out, "%s;%s;%s;%g;%.4g;%.4g;%.4g;%.5g;%d;%.5g;%.5g;%.5g;%.5g;%d\n", row);
  return std::fclose(out) == 0 ? 0 : 2;
}

bool are_enough(const PointsFile& f) {
  const RecordedPoints& p = f.points;
  if (p.flowing.size() >= few && p.elastic.size() >= few && !p.hardest.empty()) return true;
  std::cerr << "'" << f.file
            << "' holds too few points; record at least 256 that flow, 256 that do not and one of "
               "the hardest.\n";
  return false;
}

/// The points that a form updates.
const RecordedPoints& points_of_form(const std::vector<PointsFile>& files, const RockForm& form) {
  for (const PointsFile& f : files)
    if (f.name == form.points) return f.points;
  throw std::runtime_error("no file holds points for '" + form.name + "'; correct rock_forms.cpp.");
}

int run(const std::string& card, std::vector<PointsFile>& files, const char* csv) {
  for (PointsFile& f : files) {
    f.points = read_rock_points(f.file);
    if (!are_enough(f)) return 2;
  }
  const auto points_of_row = [&](const Row& row) -> const RecordedPoints& {
    return points_of_form(files, row.form);
  };
  std::vector<Row> rows = rows_to_measure();
  // In rounds, so that what else the machine does meets all forms alike.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round)
    for (Row& row : rows)
      with_model(card, row, [&](const auto& m) { measure_times(m, points_of_row(row), row); });
  constexpr std::size_t of_form = std::size(tolerances);
  for (std::size_t first = 0; first < rows.size(); first += of_form) {
    Row* const form = &rows[first];
    with_model(card, form[0], [&](const auto& m) {
      judge(m, card, points_of_row(form[0]), form, of_form);
    });
    for (std::size_t i = 0; i < of_form; ++i)
      print_row(
          stdout,
          "%-24s %-20s (%s) %8.3g %9.2e %9.2e %9.2e %8.2f %4d %9.0f %9.0f %7.1f %9.0f %5d\n",
          form[i]
      );
    std::fflush(stdout);
  }
  return csv != nullptr ? write_csv(csv, card, files, rows) : 0;
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const std::vector<const char*> names = {
      "dry",
      "wet",
      "angled",
      "angled wet",
      "Gudehus",
      "Gudehus wet",
      "Mohr-Coulomb",
      "Mohr-Coulomb wet",
      "damaged",
      "cracked",
      "heated",
      "heated wet"};
  const int first = 2, end = first + static_cast<int>(names.size());
  if (argc < end) {
    std::cerr
        << "barreno_feature_cost needs a card of dry rock and twelve files of points: dry and "
           "wet, both with Willam-Warnke, Gudehus and Mohr-Coulomb, then damaged, with "
           "tension cutoff, heated, heated and wet.\n";
    return 1;
  }
  std::vector<barreno::PointsFile> files;
  for (int i = first; i < end; ++i)
    files.push_back({names[static_cast<std::size_t>(i - first)], argv[i], {}});
  try {
    return barreno::run(argv[1], files, argc > end ? argv[end] : nullptr);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
