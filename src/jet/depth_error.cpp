// SPDX-License-Identifier: BSD-3-Clause
#include "jet/depth_error.hpp"

#include "jet/divided_error.hpp"
#include "jet/failure.hpp"
#include "jet/path.hpp"

#include <algorithm>
#include <barreno/describe.hpp>
#include <cmath>
#include <cstdio>

namespace barreno {
namespace {

const MeasuredDepths& finest(const DepthTables& tables) {
  return tables.depths.back();
}

double error_at(const DepthTables& tables, const MeasuredDepths& row, std::size_t time) {
  return row.depth[time] / finest(tables).depth[time] - 1.0;
}

/// Error of one row along the path, linear between its measurements.
/// @param depth  in tip radii, as a run with these cells has it, or as estimated
double error_along(
    const DepthTables& tables, const MeasuredDepths& row, double depth, DepthOf whose
) {
  double last_depth = 0.0, last = 0.0;
  bool first = true;
  for (std::size_t t = 0; t < tables.times.size(); ++t) {
    if (row.depth[t] == 0.0) continue;
    const double here =
        (whose == DepthOf::run ? row.depth[t] : tables.estimated[t]) / measured_radius;
    const double error = error_at(tables, row, t);
    if (depth <= here)
      return first ? error : last + (error - last) * (depth - last_depth) / (here - last_depth);
    last_depth = here;
    last = error;
    first = false;
  }
  return last;
}

/// How far the finest row is from half its cells, the most where that was measured.
double doubt(const DepthTables& tables) {
  double most = 0.0;
  for (std::size_t t = 0; t < tables.times.size(); ++t)
    if (tables.finest[t] > 0.0)
      most = std::max(most, std::abs(finest(tables).depth[t] / tables.finest[t] - 1.0));
  return most;
}

/// All errors that were measured with the cells of a row.
DepthError row_error(const DepthTables& tables, std::size_t index, double depth, DepthOf whose) {
  const MeasuredDepths& row = tables.depths[index];
  DepthError error{
      error_along(tables, row, depth, whose), tables.steady[index].low, tables.steady[index].high};
  if (index + 1 == tables.depths.size()) return {0.0, -doubt(tables), doubt(tables)};
  for (std::size_t t = 0; t < tables.times.size(); ++t) {
    if (row.depth[t] == 0.0) continue;
    error.low = std::min(error.low, error_at(tables, row, t));
    error.high = std::max(error.high, error_at(tables, row, t));
  }
  return error;
}

/// How far a jet may be from the measured one, in density and velocity.
constexpr double largest_ratio = 1.3;
bool is_near(double ratio) {
  return is_within(ratio, largest_ratio);
}

/// Densities of jet over rock as measured, tungsten over Berea, by less than a third.
bool is_measured_pair(const MaterialSpec& jet, const MaterialSpec& target) {
  constexpr double measured = 8.3;
  return is_metal(jet) && target.model_name().rfind("Arenisca", 0) == 0 &&
         is_near(jet.density() / target.density() / measured);
}

std::string number(const char* pattern, double x) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, x);
  return text;
}

}  // namespace

const char* const depth_error_source =
    "measured with tungsten jets in dry Berea sandstone (docs/trade.md)";

const char* const unknown_error_advice =
    "barreno converge compares three sizes of cells, and the error is at least their spread";

bool is_within(double ratio, double factor) {
  return ratio < factor && ratio > 1.0 / factor;
}

DepthError error_between(
    double cells, double from, const DepthError& coarse, double to, const DepthError& fine
) {
  const double part = std::log(cells / from) / std::log(to / from);
  const auto between = [&](double a, double b) { return a + part * (b - a); };
  return {
      between(coarse.value, fine.value),
      between(coarse.low, fine.low),
      between(coarse.high, fine.high)};
}

CellRange measured_cells(const DepthTables& tables) {
  return {tables.steady.front().cells_per_radius, tables.steady.back().cells_per_radius};
}

DepthError measured_depth_error(
    const DepthTables& tables, double cells_per_radius, double depth_over_radius, DepthOf whose
) {
  std::size_t upper = 1;
  while (upper + 1 < tables.steady.size() &&
         cells_per_radius > tables.steady[upper].cells_per_radius)
    ++upper;
  const DepthError coarse = row_error(tables, upper - 1, depth_over_radius, whose);
  const DepthError fine = row_error(tables, upper, depth_over_radius, whose);
  return error_between(
      cells_per_radius,
      tables.steady[upper - 1].cells_per_radius,
      coarse,
      tables.steady[upper].cells_per_radius,
      fine
  );
}

namespace {

/// What shorter or longer slugs change, with the n-th of length_error_cells.
double change_by_length(const DepthTables& tables, std::size_t n, double length_over_radius) {
  const auto error = [&](std::size_t i) { return tables.lengths[i].error[n]; };
  const auto place = [&](std::size_t i) { return std::log(tables.lengths[i].length_over_radius); };
  const double last = place(tables.lengths.size() - 1);
  const double at = std::clamp(std::log(length_over_radius), place(0), last);
  std::size_t upper = 1;
  while (upper + 1 < tables.lengths.size() && at > place(upper)) ++upper;
  const double part = (at - place(upper - 1)) / (place(upper) - place(upper - 1));
  return error(upper - 1) + part * (error(upper) - error(upper - 1)) - error(tables.own_length);
}

}  // namespace

double shortest_measured_length(const DepthTables& tables) {
  constexpr double round_off = 1e-3;  // of a table's digits
  return tables.lengths.front().length_over_radius * (1.0 - round_off);
}

DepthError with_length(
    const DepthTables& tables, DepthError error, double cells_per_radius, double length_over_radius
) {
  // Cells that are still smaller leave nothing to change.
  const double from = std::log(tables.length_cells[0]), to = std::log(tables.length_cells[1]);
  const double at = std::max(from, std::log(cells_per_radius));
  const double coarse = change_by_length(tables, 0, length_over_radius);
  const double fine = change_by_length(tables, 1, length_over_radius);
  const double end = std::log(measured_cells(tables).most);
  const double change = at <= to ? coarse + (at - from) / (to - from) * (fine - coarse)
                                 : fine * std::max(0.0, (end - at) / (end - to));
  return {
      error.value + change,
      std::min(error.low, error.low + change),
      std::max(error.high, error.high + change)};
}

MeasuredReach measured_reach(const DepthTables& tables) {
  return {finest(tables).depth.back() / measured_radius, tables.times.back()};
}

std::string why_reach_unknown(
    const DepthTables& tables, double time, double radius, double velocity, double depth
) {
  if (!is_near(velocity / measured_velocity))
    return "it was measured with a tip of " + number("%g m/s only", measured_velocity);
  const MeasuredReach reach = measured_reach(tables);
  // A time that a step has met is not met to the last digit, and finer cells go a little deeper.
  constexpr double round_off = 1e-6, finer = 1.05;
  const double scale = radius / measured_radius * measured_velocity / velocity;
  if (time > scale * reach.time * (1.0 + round_off))
    return "it was measured until " + number("%.3g us only", 1e6 * scale * reach.time);
  if (depth > finer * reach.depth_over_radius * radius)
    return "it was measured to a depth of " +
           number("%.4g mm only", 1e3 * reach.depth_over_radius * radius);
  return {};
}

std::string why_slugs_unknown(
    const DepthTables& tables, double length_over_radius, double slowest, double least_filled
) {
  if (length_over_radius < shortest_measured_length(tables))
    return "it was measured with slugs that are at least half as long as their radius";
  if (slowest * largest_ratio < measured_slowest)
    return "it was measured with slugs faster than " + number("%.0f m/s only", measured_slowest);
  if (least_filled * largest_ratio < measured_least_filled)
    return "it was measured with slugs that fill at least " +
           number("%.2g of their flight only", measured_least_filled);
  return {};
}

/// With fewer the error of one particle per cell and direction exceeds that of two by far: 15 %
/// with 1.4, where it is 7 % (docs/verification/fidelities.md).
constexpr double fewest_cells_of_one = 1.8;

namespace {

/// Why the measurements say nothing of a step or contact; empty if they do.
std::string why_method_unknown(const Scene& scene) {
  const StepSpec& step = scene.step;
  if (step.transfer != Transfer::flip || step.pic_fraction > 0.0)
    return "it was measured with Transfer FLIP only";
  if (step.shape != StepSpec{}.shape)
    return "it was measured with Shape Function " + StepSpec{}.shape + " only";
  if (step.order != Order::stress_last)
    return "it was measured with Order " + word_of(Order::stress_last) + " only";
  // Of divided particles it was measured with and without (verification/results/depth_shots.json).
  if (step.return_losses && !is_divided(scene)) return "it was measured without Return Losses only";
  for (const ContactSpec& contact : scene.contacts)
    if (contact.materials[0] == scene.jet.material || contact.materials[1] == scene.jet.material)
      return "it was measured without contact of the jet only";
  return {};
}

}  // namespace

std::string why_scene_unmeasured(const DepthTables& tables, const Scene& scene) {
  if (!tables.problem.empty()) return tables.problem;
  if (scene.grid.mode == Mode::plane_strain) return "it was measured with round jets only";
  if (scene.grid.mode == Mode::three_dimensional) return "it was measured in axisymmetry only";
  if (scene.jet.kind != JetKind::discrete) return "it was measured with discrete jets only";
  std::string why = why_method_unknown(scene);
  if (!why.empty()) return why;
  const std::vector<PathLayer> layers = path_layers(scene, widest_radius(scene));
  const std::vector<PathLayer> solids = solid_layers(layers);
  if (solids.empty()) return "the jet meets no target";
  if (solids.size() < layers.size()) return "it was measured without liquids in the jet's path";
  const MaterialSpec& jet = scene.materials[static_cast<std::size_t>(scene.jet.material)];
  const BodySpec& body = longest_body(scene, solids);
  const MaterialSpec& target = scene.materials[static_cast<std::size_t>(body.material)];
  if (target.is_porous()) return "it was measured in dry rock only";
  if (!is_measured_pair(jet, target))
    return "it was measured with tungsten in dry Berea sandstone only, not with " + jet.name() +
           " in " + target.name();
  return {};
}

std::string why_depth_error_unknown(
    const DepthTables& tables, const Scene& scene, double cells_per_radius
) {
  std::string why = why_scene_unmeasured(tables, scene);
  if (!why.empty()) return why;
  const MaterialSpec& jet = scene.materials[static_cast<std::size_t>(scene.jet.material)];
  const BodySpec& body = *longest_solid(scene);  // the scene is as measured, with one
  if (breaks(jet))
    return "it was measured with tungsten that does not break only, not with the Spall Stress or "
           "damage of " +
           jet.name() + " (but for particles that are divided 4 times, Jet/Splits)";
  const CellRange range = measured_cells(tables);
  // A table's last digit must not decide.
  constexpr double round_off = 1e-6;
  if (cells_per_radius < range.fewest * (1.0 - round_off) ||
      cells_per_radius > range.most * (1.0 + round_off))
    return "it was measured with " + number("%g", range.fewest) + " to " +
           number("%g cells per radius only", range.most);
  if (body.particles_per_cell == 1 && cells_per_radius < fewest_cells_of_one * (1.0 - round_off))
    return "with one particle per cell and direction it was measured from " +
           number("%g cells per radius on only", fewest_cells_of_one);
  return {};
}

std::string depth_error_text(const DepthError& error) {
  const auto percent = [](double x) {
    const double rounded = std::round(100.0 * x);
    return rounded == 0.0 ? std::string("0") : number("%+.0f", rounded);
  };
  return percent(error.value) + " % (" + percent(error.low) + " to " + percent(error.high) + " %)";
}

}  // namespace barreno
