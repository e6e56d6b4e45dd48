// SPDX-License-Identifier: BSD-3-Clause
// What accuracy costs in Arenisca's plastic update, over updates recorded from a penetration:
//
//   barreno_solver_cost POINTS [CSV]
//
// error against a reference of very small steps, yield-function evaluations, substeps and time per
// update, for the default solver over its tolerance and for the published nested bisection over its
// number of equal substeps.
#include "read_rock_points.hpp"
#include "rock_points.hpp"
#include "small_steps.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace barreno {
namespace {

using arenisca::PointState;
using test::RockPoint;

/// Updates whose error is measured.
constexpr std::size_t judged = 256;

/// Exact ends of updates and the stress that errors are measured by.
struct Reference {
  std::vector<PointState> ends;
  std::vector<double> sizes;
  double mean_error = 0.0, largest_error = 0.0;  ///< its own, from its last doubling
};

double size_of(const PointState& s) {
  return arenisca::size_of_stress(s.x, second_invariant(s.s));
}

/// The last of two step numbers; second order, so its error is a third of their difference.
Reference find_reference(const Arenisca& model, const std::vector<RockPoint>& points) {
  constexpr int steps = 32768;
  Reference reference;
  for (std::size_t i = 0; i < judged; ++i) {
    const PointState coarse = take_exact_steps(model.rock(), points[i], steps / 2);
    const PointState fine = take_exact_steps(model.rock(), points[i], steps);
    const double size =
        std::max({size_of(state_of(points[i])), size_of(fine), model.rock().stress_floor});
    const double error = distance(coarse, fine) / (3.0 * size);
    reference.ends.push_back(fine);
    reference.sizes.push_back(size);
    reference.mean_error += error / static_cast<double>(judged);
    reference.largest_error = std::max(reference.largest_error, error);
  }
  return reference;
}

/// One line of the table; times are per update [ns].
struct Row {
  std::string solver;
  double knob = 0.0;
  double mean_error = 0.0, largest_error = 0.0;
  double error_of_99_percent = 0.0;  ///< 99 of 100 errors are below
  double evaluations = 0.0, substeps = 0.0;
  int failed = 0;  ///< updates that ran out of substeps; they have no error
  double single = 0.0, lanes = 0.0;
};

void set_errors(std::vector<double> errors, Row& row) {
  for (const double e : errors) row.mean_error += e / static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  row.error_of_99_percent = errors[errors.size() * 99 / 100];
  row.largest_error = errors.back();
}

test::ScalarArenisca with_tolerance(double tolerance, int solver) {
  auto p = test::berea();
  p.tolerance = tolerance;
  p.return_solver = solver;
  return {p, 2120.0};
}

/// Error-controlled substeps, with either return.
Row error_controlled(
    const std::string& name,
    const test::ScalarArenisca& model,
    double tolerance,
    const std::vector<RockPoint>& points,
    const Reference& reference
) {
  Row row;
  row.solver = name;
  row.knob = tolerance;
  arenisca::EvaluationCounter counter;
  std::vector<double> errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    RockPoint end = points[i];
    const Outcome outcome =
        model.update_counted(points[i].increment, end.stress, end.history, counter);
    row.failed += outcome.failed() ? 1 : 0;
    row.substeps += outcome.substeps / static_cast<double>(points.size());
    if (i < judged && !outcome.failed())
      errors.push_back(distance(state_of(end), reference.ends[i]) / reference.sizes[i]);
  }
  row.evaluations = static_cast<double>(counter.evaluations) / static_cast<double>(points.size());
  set_errors(errors, row);
  const int runs = row.evaluations > 200.0 ? 2 : 15;
  row.single = cost_of_single_points(model, points, runs).nanoseconds;
  row.lanes = model.rock().bisection ? row.single : cost_in_lanes<Arenisca>(model, points, runs);
  return row;
}

/// The published scheme: equal substeps of the nested bisection.
Row equal_steps(
    const std::string& name,
    arenisca::Rock rock,
    int count,
    const std::vector<RockPoint>& points,
    const Reference& reference
) {
  Row row;
  row.solver = name;
  row.knob = row.substeps = count;
  arenisca::EvaluationCounter counter;
  std::vector<double> errors;
  for (std::size_t i = 0; i < judged; ++i) {
    const PointState end = take_equal_steps(rock, points[i], count, counter);
    errors.push_back(distance(end, reference.ends[i]) / reference.sizes[i]);
  }
  arenisca::NoCounter none;
  double sum = 0.0, least = HUGE_VAL;
  for (int i = 0; i < 2; ++i) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < judged; ++k)
      sum += take_equal_steps(rock, points[k], count, none).x;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  if (!std::isfinite(sum)) std::printf("not finite\n");
  row.evaluations = static_cast<double>(counter.evaluations) / static_cast<double>(judged);
  row.single = row.lanes = least * 1e9 / static_cast<double>(judged);
  set_errors(errors, row);
  return row;
}

void print_row(std::FILE* out, const char* format, const Row& r) {
  std::fprintf(
      out,
      format,
      r.solver.c_str(),
      r.knob,
      r.mean_error,
      r.error_of_99_percent,
      r.largest_error,
      r.evaluations,
      r.substeps,
      r.failed,
      r.single,
      r.lanes
  );
}

std::vector<Row> measure(const std::vector<RockPoint>& points, const Reference& reference) {
  std::vector<Row> rows;
  const auto keep = [&rows](const Row& row) {
    print_row(stdout, "%-22s %8.3g %9.2e %9.2e %9.2e %12.1f %9.2f %6d %12.1f %12.1f\n", row);
    std::fflush(stdout);
    rows.push_back(row);
  };
  for (const double t : {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
    keep(error_controlled("fast", with_tolerance(t, 0), t, points, reference));
  const std::vector<RockPoint> few(points.begin(), points.begin() + judged);
  for (const double t : {1e-2, 1e-4, 1e-6})
    keep(error_controlled("bisected returns", with_tolerance(t, 1), t, few, reference));
  arenisca::Rock rock = with_tolerance(1e-2, 1).rock();
  for (const double resolution : {1e-9, 0.0}) {
    rock.resolution = resolution;
    const int most = resolution > 0.0 ? 1024 : 64;
    for (int n = 1; n <= most; n *= 4)
      keep(equal_steps(
          resolution > 0.0 ? "nested bisection" : "nested to last bit", rock, n, points, reference
      ));
  }
  return rows;
}

int write_csv(
    const char* file, const Reference& reference, double elastic, const std::vector<Row>& rows
) {
  std::FILE* out = std::fopen(file, "w");
  if (out == nullptr) {
    std::cerr << "cannot write '" << file << "'; check that its folder exists.\n";
    return 2;
  }
  std::fprintf(
      out,
      "# reference: mean error %.2e, largest %.2e\n",
      reference.mean_error,
      reference.largest_error
  );
  std::fprintf(out, "# elastic point in lanes: %.1f ns\n", elastic);
  std::fprintf(
      out,
      "solver,knob,mean_error,error_of_99_percent,largest_error,evaluations,substeps,"
      "failed,ns_single,ns_lanes\n"
  );
  for (const Row& row : rows) print_row(out, "%s,%g,%.4g,%.4g,%.4g,%.5g,%.5g,%d,%.5g,%.5g\n", row);
  return std::fclose(out) == 0 ? 0 : 2;
}

int run(const char* file, const char* csv) {
  const RecordedPoints recorded = read_rock_points(file);
  if (recorded.flowing.size() < judged || recorded.elastic.size() < lane_count) {
    std::cerr << "'" << file << "' holds too few points; record at least 256 that flow.\n";
    return 2;
  }
  const Arenisca model = with_tolerance(1e-2, 0);
  const auto elastic_points = points_of(model, recorded.history_names, recorded.elastic);
  const auto flowing = points_of(model, recorded.history_names, recorded.flowing);
  const double elastic = cost_in_lanes(model, elastic_points, 50);
  std::printf("elastic points in lanes: %.1f ns\n", elastic);
  const Reference reference = find_reference(model, flowing);
  std::printf(
      "reference: mean error %.1e, largest %.1e\n", reference.mean_error, reference.largest_error
  );
  std::printf(
      "%-22s %8s %9s %9s %9s %12s %9s %6s %12s %12s\n",
      "solver",
      "knob",
      "mean err",
      "99 %",
      "largest",
      "evaluations",
      "substeps",
      "failed",
      "ns single",
      "ns lanes"
  );
  const std::vector<Row> rows = measure(flowing, reference);
  return csv != nullptr ? write_csv(csv, reference, elastic, rows) : 0;
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "barreno_solver_cost needs a file of recorded points.\n";
    return 1;
  }
  try {
    return barreno::run(argv[1], argc > 2 ? argv[2] : nullptr);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
