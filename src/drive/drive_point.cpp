// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive_point.hpp"

#include "base/error.hpp"
#include "drive/compression_limit.hpp"
#include "drive/matrix.hpp"

#include <barreno/history_values.hpp>
#include <barreno/input/scan_xml.hpp>
#include <barreno/models.hpp>
#include <cmath>
#include <type_traits>

namespace barreno {
namespace {

using input::exact_text;

/// Why a model refused a step, for sentences.
const char* words_of(Status status) {
  switch (status) {
    case Status::substep_limit:
      return "it needs more substeps than are allowed";
    case Status::not_converged:
      return "its equations did not converge";
    case Status::bad_input:
      return "the strain of one step is too large for it";
    case Status::ok:
      break;
  }
  return "it gives no reason";
}

/// L dt of one of `steps` equal steps from `before` to `row`.
Mat3 step_gradient(
    const PathRow& before, const PathRow& row, int steps, const std::string& source
) {
  const Mat3& start = before.deformation_gradient;
  const auto log = logarithm_1p((row.deformation_gradient - start) * inverse(start));
  if (log) return (1.0 / steps) * *log;
  input::refuse(
      source,
      "line " + std::to_string(row.line),
      "is half a turn or more from line " + std::to_string(before.line) +
          " (there is no unique constant velocity gradient between them); add rows between them"
  );
}

template <class Model>
class Point {
public:
  Point(const Model& model, const Mat3& start)
      : model_(model),
        from_reference_(inverse(start)),
        rotation_(identity()),
        start_(model.initial_state(0.0)),
        stress_(start_.stress),
        volume_strain_(std::log(start_.volume_ratio)),
        history_(start_.history) {}

  /// One step to the deformation gradient `end`.
  Outcome step(const Mat3& gradient, const Mat3& end, double dt) {
    const Mat3 rotation = polar_rotation(end * from_reference_);
    const Mat3 mean_rotation = polar_rotation(rotation_ + rotation);
    Increment increment;
    increment.strain = unrotate(mean_rotation, symmetric_part(gradient));
    increment.dt = dt;
    increment.volume_ratio_begin = std::exp(volume_strain_);
    volume_strain_ += trace(increment.strain);
    increment.volume_ratio_end = std::exp(volume_strain_);
    rotation_ = rotation;
    return model_.update(increment, stress_, history_);
  }

  double volume_ratio() const { return std::exp(volume_strain_); }

  DrivenRow row(double time, const Mat3& f) const {
    DrivenRow row{time, f, rotate(rotation_, stress_), stress_, {}};
    const double* const values = history_values<Model>(history_);
    row.history.assign(values, values + Model::history_count);
    return row;
  }

private:
  const Model& model_;
  Mat3 from_reference_, rotation_;
  InitialStateOf<Sym3, typename Model::History>
      start_;  // as a body of a scene, without confinement
  Sym3 stress_;
  double volume_strain_;  // ln(V / V_ref)
  typename Model::History history_;
};

[[noreturn]] void refuse_step(
    const Material& material,
    const char* model,
    const PathRow& row,
    double time,
    Status status,
    const std::string& limit,
    const std::string& source
) {
  if (!limit.empty())
    throw NumericalError(
        source + ": line " + std::to_string(row.line) + " cannot be reached: at time " +
        exact_text(time) + " s '" + material.name + "' meets " + limit + "."
    );
  throw NumericalError(
      source + ": line " + std::to_string(row.line) + " cannot be reached: at time " +
      exact_text(time) + " s the " + model + " of '" + material.name + "' fails (" +
      words_of(status) + "); check F of that row, or take smaller steps with --steps-per-row."
  );
}

template <class Model>
std::vector<DrivenRow> drive_model(
    const Model& model,
    const Material& material,
    const std::vector<PathRow>& path,
    const DriveSteps& steps,
    const std::string& source
) {
  const PathRow& first = path.front();
  Point<Model> point(model, first.deformation_gradient);
  std::vector<DrivenRow> rows{point.row(first.time, first.deformation_gradient)};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathRow &before = path[i - 1], &row = path[i];
    const Mat3 gradient = step_gradient(before, row, steps.per_row, source);
    const Mat3 growth = exponential(gradient);
    const double dt = (row.time - before.time) / steps.per_row;
    Mat3 f = before.deformation_gradient;
    for (int k = 1; k <= steps.per_row; ++k) {
      const bool last = k == steps.per_row;
      const double time = last ? row.time : before.time + k * dt;
      f = last ? row.deformation_gradient : growth * f;
      const Outcome outcome = point.step(gradient, f, dt);
      if (outcome.failed()) {
        const std::string limit = beyond_compression_limit(model, point.volume_ratio());
        refuse_step(material, Model::name, row, time, outcome.status, limit, source);
      }
      if (last || steps.every) rows.push_back(point.row(time, f));
    }
  }
  return rows;
}

}  // namespace

std::vector<DrivenRow> drive_point(
    const Material& material,
    const std::vector<PathRow>& path,
    const DriveSteps& steps,
    const std::string& source
) {
  return std::visit(
      [&](const auto& model) { return drive_model(model, material, path, steps, source); },
      material.model
  );
}

}  // namespace barreno
