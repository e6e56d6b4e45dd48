// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive_mixed.hpp"

#include "base/error.hpp"
#include "drive/compression_limit.hpp"

#include <algorithm>
#include <array>
#include <barreno/history_values.hpp>
#include <barreno/input/scan_xml.hpp>
#include <barreno/pore_point.hpp>
#include <barreno/tangent.hpp>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace barreno {
namespace {

using input::exact_text;
using Six = std::array<double, 6>;

Six six_of(const Sym3& s) {
  return {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
}
Sym3 tensor_of(const Six& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[5]};
}
double largest_of(const Six& values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::fabs(v));
  return largest;
}

/// Solution of the equations in which `unknown`, by elimination with pivots; zero elsewhere.
Six solve(std::array<Six, 6> a, Six b, const std::array<bool, 6>& unknown) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < 6; ++i)
    if (unknown[i]) left.push_back(i);
  for (std::size_t k = 0; k < left.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < left.size(); ++i)
      if (std::fabs(a[left[i]][left[k]]) > std::fabs(a[left[pivot]][left[k]])) pivot = i;
    std::swap(a[left[k]], a[left[pivot]]);
    std::swap(b[left[k]], b[left[pivot]]);
    for (std::size_t i = k + 1; i < left.size(); ++i) {
      const double factor = a[left[i]][left[k]] / a[left[k]][left[k]];
      for (std::size_t j = k; j < left.size(); ++j)
        a[left[i]][left[j]] -= factor * a[left[k]][left[j]];
      b[left[i]] -= factor * b[left[k]];
    }
  }
  Six x{};
  for (std::size_t k = left.size(); k-- > 0;) {
    double sum = b[left[k]];
    for (std::size_t j = k + 1; j < left.size(); ++j) sum -= a[left[k]][left[j]] * x[left[j]];
    x[left[k]] = sum / a[left[k]][left[k]];
  }
  return x;
}

template <class Model>
struct PointState {
  Sym3 strain{}, stress{};
  double volume_strain = 0.0;  ///< ln(V / V_ref)
  typename Model::History history{};
};

/// What is asked of the end of a step.
struct Goal {
  Six target{};
  std::array<bool, 6> by_stress{};
  bool drained = false;
  double pore_pressure = 0.0;
  double dt = 0.0;
};

/// A step that was tried: its end, and how the stress there follows the strain.
template <class Model>
struct Tried {
  PointState<Model> end;
  std::array<Six, 6> stiffness{};
};

/// Lets fluid in or out until its pressure is this.
/// @return false where that fails
template <class Model>
bool drain_to(const Model& model, double pressure, double scale, PointState<Model>& point) {
  constexpr int most = 60;
  constexpr double exact = 1e-10;
  for (int i = 0; i < most; ++i) {
    const PorePoint pores = model.pore_point(point.stress, point.history);
    const double missing = pressure - pores.pressure;
    if (std::fabs(missing) <= exact * scale) return true;
    // Gas first: its room is in the storage, and it gives way without pressure.
    const double full =
        pores.gap > 0.0 ? pores.storage - pores.gap / pores.gap_pressure : pores.storage;
    const double volume = missing * full + (missing > 0.0 ? pores.gap : 0.0);
    if (model.drain(volume, point.stress, point.history).failed()) return false;
  }
  return false;
}

template <class Model>
std::optional<Tried<Model>> try_step(
    const Model& model, const PointState<Model>& start, const Six& strain, const Goal& goal
) {
  Tried<Model> tried{start, {}};
  PointState<Model>& end = tried.end;
  Increment increment;
  increment.strain = tensor_of(strain);
  increment.dt = goal.dt;
  increment.volume_ratio_begin = std::exp(start.volume_strain);
  end.volume_strain += trace(increment.strain);
  increment.volume_ratio_end = std::exp(end.volume_strain);
  end.strain = end.strain + increment.strain;
  Tangent tangent;
  if (update_with_tangent(model, increment, end.stress, end.history, tangent).failed())
    return std::nullopt;
  double borne = 0.0;
  if constexpr (is_drainable<Model>) {
    if (goal.drained) {
      const PorePoint pores = model.pore_point(end.stress, end.history);
      if (pores.storage > 0.0) borne = pores.biot * pores.biot / pores.storage;
      const double scale = model.longitudinal_modulus(end.stress, end.history, 1.0) * 1e-3;
      if (!drain_to(model, goal.pore_pressure, scale, end)) return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      tried.stiffness[i][j] =
          tangent.c[i][j] * (j < 3 ? 1.0 : 2.0) - (i < 3 && j < 3 ? borne : 0.0);
  return tried;
}

/// What the stress misses of the goal, in the components that are asked for.
Six missed(const Sym3& stress, const Goal& goal) {
  Six miss = six_of(stress);
  for (std::size_t i = 0; i < 6; ++i) miss[i] = goal.by_stress[i] ? miss[i] - goal.target[i] : 0.0;
  return miss;
}

template <class Model>
class MixedDriver {
public:
  explicit MixedDriver(const Model& model) : model_(model), initial_(model.initial_state(0.0)) {
    point_.stress = initial_.stress;
    point_.history = initial_.history;
    point_.volume_strain = std::log(initial_.volume_ratio);
  }

  const PointState<Model>& point() const { return point_; }
  /// From the targets `begin` to `end`, in halves where that fails.
  bool reach(const Goal& begin, const Goal& end, int halvings = 10) {
    if (step(begin, end)) return true;
    if (halvings == 0) return false;
    Goal middle = end;
    for (std::size_t i = 0; i < 6; ++i) middle.target[i] = 0.5 * (begin.target[i] + end.target[i]);
    middle.pore_pressure = 0.5 * (begin.pore_pressure + end.pore_pressure);
    middle.dt = 0.5 * end.dt;
    Goal second = end;
    second.dt = 0.5 * end.dt;
    return reach(begin, middle, halvings - 1) && reach(middle, second, halvings - 1);
  }

private:
  bool step(const Goal& begin, const Goal& goal) {
    constexpr int most = 40;
    constexpr double exact = 1e-8;
    Six strain{};
    for (std::size_t i = 0; i < 6; ++i)
      if (!goal.by_stress[i]) strain[i] = goal.target[i] - begin.target[i];
    auto tried = try_step(model_, point_, strain, goal);
    for (int i = 0; i < most && tried; ++i) {
      const Six miss = missed(tried->end.stress, goal);
      const double modulus =
          model_.longitudinal_modulus(tried->end.stress, tried->end.history, 1.0);
      const double scale = std::max(largest_of(six_of(tried->end.stress)), 1e-3 * modulus);
      if (largest_of(miss) <= exact * scale) {
        point_ = tried->end;
        return true;
      }
      tried = improve(strain, miss, goal, *tried);
    }
    return false;
  }

  /// A Newton step, shortened until the miss does not grow.
  std::optional<Tried<Model>> improve(
      Six& strain, const Six& miss, const Goal& goal, const Tried<Model>& from
  ) {
    constexpr int most = 8;
    const Six correction = solve(from.stiffness, miss, goal.by_stress);
    double part = 1.0;
    for (int i = 0; i < most; ++i, part *= 0.5) {
      Six next = strain;
      for (std::size_t c = 0; c < 6; ++c) next[c] -= part * correction[c];
      if (!(largest_of(next) < 1.0)) continue;
      auto tried = try_step(model_, point_, next, goal);
      if (!tried) continue;
      const Six left = missed(tried->end.stress, goal);
      if (largest_of(left) > largest_of(miss) && i + 1 < most) continue;
      strain = next;
      return tried;
    }
    return std::nullopt;
  }

  const Model& model_;
  InitialStateOf<Sym3, typename Model::History> initial_;
  PointState<Model> point_;
};

template <class Model>
MixedAnswer answer_of(double time, const PointState<Model>& point) {
  const double* const values = history_values<Model>(point.history);
  return {time, point.strain, point.stress, {values, values + Model::history_count}};
}

void check_start(
    const MixedPath& path, const Sym3& stress, double pore_pressure, const std::string& source
) {
  constexpr double round_off = 1e-9;
  const MixedRow& first = path.rows.front();
  const std::string line = "line " + std::to_string(first.line) + ", ";
  const auto refuse_start = [&](const std::string& column, double asked, double is) {
    if (std::fabs(asked - is) <= round_off * std::fabs(is)) return;
    input::refuse_value(
        source,
        line + column,
        exact_text(asked),
        "is not that of the virgin point, " + exact_text(is) +
            " Pa (a path begins there); write that, and the first load in the next row"
    );
  };
  const Six is = six_of(stress);
  for (std::size_t c = 0; c < 6; ++c)
    if (first.by_stress[c])
      // Without the sign of a zero.
      refuse_start(std::string("stress_") + component_names[c], first.target[c], is[c] + 0.0);
  if (first.drained) refuse_start("pore_pressure", first.pore_pressure, pore_pressure);
}

/// Few digits: where a strength lies is known to the halvings of a step.
std::string rounded(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

/// The component that misses most, for the sentence.
[[noreturn]] void refuse_stress(
    const Material& material,
    const MixedRow& row,
    const Goal& goal,
    const Sym3& reached,
    double time,
    const std::string& limit,
    const std::string& source
) {
  const Six miss = missed(reached, goal);
  std::size_t worst = 0;
  for (std::size_t c = 0; c < 6; ++c)
    if (std::fabs(miss[c]) > std::fabs(miss[worst])) worst = c;
  const std::string where = source + ": line " + std::to_string(row.line) + " cannot be reached: ";
  if (!limit.empty())
    throw NumericalError(
        where + "at time " + rounded(time) + " s '" + material.name + "' meets " + limit + "."
    );
  if (!goal.by_stress[worst]) {
    throw NumericalError(
        where + "at time " + rounded(time) + " s the update of '" + material.name +
        "' fails; take smaller steps with --steps-per-row."
    );
  }
  throw NumericalError(
      where + "'" + material.name + "' cannot sustain stress_" + component_names[worst] + " = " +
      rounded(goal.target[worst]) + " Pa at time " + rounded(time) +
      " s (highest value reached: " + rounded(six_of(reached)[worst]) + " Pa); prescribe strain_" +
      component_names[worst] + " to go beyond the strength."
  );
}

template <class Model>
double pore_pressure_of(const Model& model, const PointState<Model>& point) {
  if constexpr (is_drainable<Model>)
    return model.pore_point(point.stress, point.history).pressure;
  else
    return 0.0;
}

/// Where the way to a row begins: at what the row before asked for, and for a component whose
/// control changes at what the point has become.
template <class Model>
Goal start_of(
    const Model& model, const MixedRow& from, const MixedRow& row, const PointState<Model>& point
) {
  Goal start{from.target, row.by_stress, row.drained, from.pore_pressure, 0.0};
  const Six stress = six_of(point.stress), strain = six_of(point.strain);
  for (std::size_t c = 0; c < 6; ++c)
    if (row.by_stress[c] != from.by_stress[c])
      start.target[c] = row.by_stress[c] ? stress[c] : strain[c];
  if (row.drained && !from.drained) start.pore_pressure = pore_pressure_of(model, point);
  return start;
}

/// The limit of compression that a failed step met. Where the volume is prescribed it is known;
/// else the point has come close, since a step that fails is halved.
template <class Model>
std::string limit_of(const Model& model, const PointState<Model>& point, const Goal& goal) {
  constexpr double close = 0.97;
  double asked = point.volume_strain;
  const Six strain = six_of(point.strain);
  for (std::size_t c = 0; c < 3; ++c)
    if (!goal.by_stress[c]) asked += goal.target[c] - strain[c];
  const std::string found = beyond_compression_limit(model, std::exp(asked));
  return found.empty() ? beyond_compression_limit(model, std::exp(point.volume_strain), close)
                       : found;
}

/// So far along a row.
Goal goal_at(double part, const Goal& start, const MixedRow& row, double dt) {
  Goal goal = start;
  goal.dt = dt;
  for (std::size_t c = 0; c < 6; ++c)
    goal.target[c] = start.target[c] + part * (row.target[c] - start.target[c]);
  goal.pore_pressure = start.pore_pressure + part * (row.pore_pressure - start.pore_pressure);
  return goal;
}

void check_fluid(
    const Material& material,
    const std::string& model,
    const MixedPath& path,
    const std::string& source
) {
  const auto drained = [](const MixedRow& row) { return row.drained; };
  if (std::none_of(path.rows.begin(), path.rows.end(), drained)) return;
  input::refuse(
      source,
      "pore_pressure:",
      "the " + model + " of '" + material.name +
          "' holds no fluid that could flow; give it a fluid or take the column out"
  );
}

template <class Model>
std::vector<MixedAnswer> drive_model(
    const Model& model,
    const Material& material,
    const MixedPath& path,
    const DriveSteps& steps,
    const std::string& source
) {
  if (!is_drainable<Model>) check_fluid(material, FullName<Model>::of(), path, source);
  MixedDriver<Model> driver(model);
  check_start(path, driver.point().stress, pore_pressure_of(model, driver.point()), source);
  std::vector<MixedAnswer> answers{answer_of<Model>(path.rows.front().time, driver.point())};
  for (std::size_t i = 1; i < path.rows.size(); ++i) {
    const MixedRow &from = path.rows[i - 1], &row = path.rows[i];
    const Goal start = start_of(model, from, row, driver.point());
    Goal before = start;
    for (int k = 1; k <= steps.per_row; ++k) {
      const bool last = k == steps.per_row;
      const double part = static_cast<double>(k) / steps.per_row, duration = row.time - from.time;
      const double time = last ? row.time : from.time + part * duration;
      const Goal goal = goal_at(part, start, row, duration / steps.per_row);
      if (!driver.reach(before, goal)) {
        const std::string limit = limit_of(model, driver.point(), goal);
        refuse_stress(material, row, goal, driver.point().stress, time, limit, source);
      }
      before = goal;
      if (last || steps.every) answers.push_back(answer_of<Model>(time, driver.point()));
    }
  }
  return answers;
}

}  // namespace

std::vector<MixedAnswer> drive_mixed(
    const Material& material,
    const MixedPath& path,
    const DriveSteps& steps,
    const std::string& source
) {
  return std::visit(
      [&](const auto& model) { return drive_model(model, material, path, steps, source); },
      material.model
  );
}

}  // namespace barreno
